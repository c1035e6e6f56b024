// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/report_page.h"

#include <algorithm>
#include <array>
#include <cstdint>

#include "report/page_assets.h"

namespace latticast {
namespace {

std::string_view html_of(char character) {
  switch (character) {
    case '&':
      return "&amp;";
    case '<':
      return "&lt;";
    case '>':
      return "&gt;";
    case '"':
      return "&quot;";
    case '\'':
      return "&#39;";
    default:
      return {};
  }
}

std::string_view json_of(char character) {
  switch (character) {
    case '<':
      return "\\u003c";
    case '>':
      return "\\u003e";
    case '&':
      return "\\u0026";
    default:
      return {};
  }
}

/// U+2028 or U+2029 in UTF-8 at the beginning of `text`.
bool begins_with_separator(std::string_view text) {
  return text.size() > 2 && text.substr(0, 2) == "\xe2\x80" &&
         (text[2] == '\xa8' || text[2] == '\xa9');
}

std::string_view text_of_place(std::string_view name, const PageAssets& assets,
                               const std::array<std::string, 6>& blocks) {
  if (name == "title") return blocks[0];
  if (name == "report") return blocks[1];
  if (name == "view") return blocks[2];
  if (name == "model") return blocks[3];
  if (name == "pictures") return blocks[4];
  if (name == "pictures-link") return blocks[5];
  if (name == "style") return assets.style;
  if (name == "script") return assets.script;
  if (name == "viewer") return assets.viewer;
  if (name == "policy") return assets.policy;
  return {};
}

std::string pictures_section(const std::vector<ReportPicture>& pictures) {
  if (pictures.empty()) return "";
  std::string html =
      "  <section id=\"pictures\" aria-labelledby=\"pictures-head\">"
      "<h2 id=\"pictures-head\">Pictures</h2>\n";
  for (const ReportPicture& picture : pictures) {
    const std::string title = escaped_html(picture.title);
    html += "  <figure class=\"made-picture\"><img alt=\"";
    html += title;
    html += "\" src=\"data:image/png;base64,";
    html += base64(picture.png);
    html += "\"><figcaption>";
    html += title;
    html += "</figcaption></figure>\n";
  }
  return html + "  </section>\n";
}

}  // namespace

std::string escaped_html(std::string_view text) {
  std::string result;
  result.reserve(text.size());
  for (const char character : text) {
    const std::string_view replacement = html_of(character);
    if (replacement.empty()) {
      result += character;
    } else {
      result += replacement;
    }
  }
  return result;
}

std::string escaped_json(std::string_view json) {
  std::string result;
  result.reserve(json.size() + json.size() / 16);
  for (std::size_t i = 0; i < json.size(); ++i) {
    const std::string_view replacement = json_of(json[i]);
    if (!replacement.empty()) {
      result += replacement;
    } else if (begins_with_separator(json.substr(i))) {
      result += json[i + 2] == '\xa8' ? "\\u2028" : "\\u2029";
      i += 2;
    } else {
      result += json[i];
    }
  }
  return result;
}

std::string base64(std::string_view bytes) {
  constexpr std::string_view digits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string result;
  result.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t word = 0;
    for (std::size_t j = 0; j < 3; ++j) {
      word = word << 8 | (j < count ? static_cast<unsigned char>(bytes[i + j]) : 0U);
    }
    for (std::size_t j = 0; j < 4; ++j) {
      result += j <= count ? digits[word >> (18 - 6 * j) & 63U] : '=';
    }
  }
  return result;
}

bool has_viewer() {
  return !page_assets().viewer.empty();
}

std::string report_page(const ReportParts& parts) {
  const PageAssets assets = page_assets();
  const bool has_pictures = !parts.pictures.empty();
  const std::array<std::string, 6> blocks = {
      escaped_html(parts.title),
      escaped_json(parts.report_json),
      escaped_json(parts.view_json),
      base64(parts.model_glb),
      pictures_section(parts.pictures),
      has_pictures ? "  <li><a href=\"#pictures\">Pictures</a></li>\n" : ""};
  std::string result;
  result.reserve(assets.page.size() + assets.style.size() + assets.script.size() +
                 assets.viewer.size() + blocks[1].size() + blocks[2].size() + blocks[3].size() +
                 blocks[4].size());
  // A place is looked for in the template alone, never in what was put into it.
  std::string_view rest = assets.page;
  for (auto open = rest.find("{{"); open != std::string_view::npos; open = rest.find("{{")) {
    const auto close = rest.find("}}", open);
    result += rest.substr(0, open);
    result += text_of_place(rest.substr(open + 2, close - open - 2), assets, blocks);
    rest.remove_prefix(close + 2);
  }
  result += rest;
  return result;
}

}  // namespace latticast
