// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <stdexcept>

#include "export/mesh/mesh_checks.h"
#include "export/mesh/text_writer.h"
#include "export/mesh/three_mf_file.h"
#include "export/mesh/zip_archive.h"
#include "files/atomic_file.h"

namespace latticast {
namespace {

constexpr std::string_view content_types =
    "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
    "<Types xmlns=\"http://schemas.openxmlformats.org/package/2006/content-types\">\n"
    " <Default Extension=\"rels\" "
    "ContentType=\"application/vnd.openxmlformats-package.relationships+xml\"/>\n"
    " <Default Extension=\"model\" "
    "ContentType=\"application/vnd.ms-package.3dmanufacturing-3dmodel+xml\"/>\n"
    "</Types>\n";

constexpr std::string_view relationships =
    "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
    "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">\n"
    " <Relationship Target=\"/3D/3dmodel.model\" Id=\"rel0\" "
    "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/>\n"
    "</Relationships>\n";

/// How many bytes the UTF-8 character at the front of `text` has; 0 when there is none.
std::size_t character_size(std::string_view text) {
  const auto byte = [&](std::size_t i) {
    return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U;
  };
  const auto follows = [&](std::size_t i) { return (byte(i) & 0xC0U) == 0x80U; };
  const unsigned first = byte(0);
  if (first < 0x80) {
    return 1;
  }
  if (first >= 0xC2 && first <= 0xDF && follows(1)) {
    return 2;
  }
  const unsigned pair = first << 8U | byte(1);
  const bool surrogate = pair >= 0xEDA0 && pair <= 0xEDBF;
  const bool noncharacter = first == 0xEF && byte(1) == 0xBF && byte(2) >= 0xBE;
  if (pair >= 0xE0A0 && pair <= 0xEFBF && follows(1) && follows(2) && !surrogate && !noncharacter) {
    return 3;
  }
  const bool four = pair >= 0xF090 && pair <= 0xF48F;
  return four && follows(1) && follows(2) && follows(3) ? 4 : 0;
}

std::string escaped(std::string_view name) {
  std::string text;
  while (!name.empty()) {
    const std::size_t size = character_size(name);
    const char first = name.front();
    if (size == 0 || static_cast<unsigned char>(first) < 0x20) {
      throw std::invalid_argument("a part's name that is not plain UTF-8 text");
    }
    switch (first) {
      case '&':
        text += "&amp;";
        break;
      case '<':
        text += "&lt;";
        break;
      case '>':
        text += "&gt;";
        break;
      case '"':
        text += "&quot;";
        break;
      default:
        text += name.substr(0, size);
    }
    name.remove_prefix(size);
  }
  return text;
}

/// As in "#C08040".
std::string display_colour(const Colour& colour) {
  constexpr std::string_view digits = "0123456789ABCDEF";
  std::string text = "#";
  for (const double x : {colour.red, colour.green, colour.blue}) {
    const double level = x > 0 ? std::min(x, 1.0) : 0;
    const auto byte = static_cast<std::size_t>(std::lround(255 * level));
    text += digits[byte / 16];
    text += digits[byte % 16];
  }
  return text;
}

void append_mesh(std::string& text, const TriangleMesh& mesh) {
  constexpr std::array<std::string_view, 3> axes{"<vertex x=\"", "\" y=\"", "\" z=\""};
  constexpr std::array<std::string_view, 3> corners{"<triangle v1=\"", "\" v2=\"", "\" v3=\""};
  text += "<mesh>\n<vertices>\n";
  for (const Point& vertex : mesh.vertices) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      text += axes[axis];
      append_number(text, static_cast<float>(vertex[axis]));
    }
    text += "\"/>\n";
  }
  text += "</vertices>\n<triangles>\n";
  for (const Triangle& triangle : mesh.triangles) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      text += corners[corner];
      append_number(text, triangle[corner]);
    }
    text += "\"/>\n";
  }
  text += "</triangles>\n</mesh>\n";
}

/// Resource 1 are the colours, resource i + 2 is part i.
std::string model_text(std::span<const NamedMesh> parts) {
  std::string text =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<model unit=\"millimeter\" xml:lang=\"en-US\" "
      "xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\">\n"
      "<metadata name=\"Application\">latticast " LATTICAST_VERSION
      "</metadata>\n<resources>\n<basematerials id=\"1\">\n";
  for (const NamedMesh& part : parts) {
    text += "<base name=\"" + escaped(part.name) + "\" displaycolor=\"" +
            display_colour(part.colour) + "\"/>\n";
  }
  text += "</basematerials>\n";
  for (std::size_t i = 0; i < parts.size(); ++i) {
    text += "<object id=\"" + std::to_string(i + 2) + "\" type=\"model\" name=\"" +
            escaped(parts[i].name) + "\" pid=\"1\" pindex=\"" + std::to_string(i) + "\">\n";
    append_mesh(text, parts[i].mesh);
    text += "</object>\n";
  }
  text += "</resources>\n<build>\n";
  for (std::size_t i = 0; i < parts.size(); ++i) {
    text += "<item objectid=\"" + std::to_string(i + 2) + "\"/>\n";
  }
  return text + "</build>\n</model>\n";
}

}  // namespace

std::string encode_three_mf(std::span<const NamedMesh> parts) {
  if (parts.empty()) {
    throw std::invalid_argument("a 3MF file without parts");
  }
  for (const NamedMesh& part : parts) {
    require_valid(part.mesh);
    require_finite(part.mesh.vertices);
  }
  const std::string model = model_text(parts);
  const std::array<ZipEntry, 3> entries{{{"[Content_Types].xml", content_types},
                                         {"_rels/.rels", relationships},
                                         {"3D/3dmodel.model", model}}};
  return zip(entries);
}

void write_three_mf(const std::filesystem::path& file, std::span<const NamedMesh> parts) {
  write_file_atomically(file, encode_three_mf(parts));
}

}  // namespace latticast
