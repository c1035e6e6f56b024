// SPDX-License-Identifier: GPL-3.0-or-later
// The page of a report: one HTML file that holds its data, scripts and 3-D view.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace latticast {

struct ReportPicture {
  std::string title;  ///< plain text, UTF-8
  std::string png;    ///< bytes of the file
};

/// What a page is made of, as texts: this folder's page knows neither the model nor the meshes.
struct ReportParts {
  std::string title;        ///< shown by the browser's window; plain text, UTF-8
  std::string report_json;  ///< the report, as docs/report.md describes it; JSON, UTF-8
  std::string view_json;    ///< bodies, states and markers of the 3-D view; JSON, UTF-8
  std::string model_glb;    ///< meshes of the 3-D view, bytes of a binary glTF file; may be empty
  std::vector<ReportPicture> pictures = {};
};

/// One HTML file that needs no other file, no server and no network.
///
/// Whatever the texts hold, they stay data: no text of `report_json` or `view_json` ends the
/// element that carries it, and `title` is escaped. Both JSON texts are taken as valid; an invalid
/// one gives a page that says that its data cannot be read. The same parts give the same bytes.
std::string report_page(const ReportParts& parts);

/// Whether the 3-D view was built in; without it a page says so where the view would be.
bool has_viewer();

/// `text` so that it can stand in HTML, between tags or inside a quoted attribute.
std::string escaped_html(std::string_view text);

/// `json` so that it can stand in a script element: "<", ">" and "&" as \u003c and so on, and the
/// two line separators that are no white space to JavaScript. The value that a JSON reader sees
/// stays the same, since these characters occur inside JSON strings only.
std::string escaped_json(std::string_view json);

/// Base64 of RFC 4648, section 4, padded, without line breaks.
std::string base64(std::string_view bytes);

}  // namespace latticast
