// SPDX-License-Identifier: GPL-3.0-or-later
// Everything that a report tells of a build (docs/report.md).
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "design/design.h"
#include "report/report_curves.h"

namespace latticast {

struct CheckFinding;

struct ReportStage {
  std::string name;
  bool runs = false;
  std::string reason;
};

/// What the audit of a written mesh found.
struct ReportMesh {
  std::size_t triangles = 0;
  int components = 0;
  int genus = 0;
  std::array<double, 3> size_mm{};  ///< along x, y, z of the file
  double surface_error_mm = 0;
  double volume_error_mm3 = 0;
};

/// A part that was made, or that is poured into a mold that was made.
struct ReportPiece {
  std::string name;
  std::string kind;  ///< "lattice", "liner", "lattice-mold", "liner-mold", "pour"
  int segment = 1;
  std::vector<std::string> files;
  const Material* material = nullptr;  ///< into the design; none for what the printer prints
  double volume_mm3 = 0;
  int prints = 1;                  ///< how many of it are needed
  std::optional<ReportMesh> mesh;  ///< absent for what is poured
};

struct ReportTime {
  std::string stage;
  double seconds = 0;
};

struct ReportData {
  const Design* design = nullptr;  ///< must outlive this
  std::string program_version;
  std::vector<ReportStage> plan;
  std::optional<ReportCurves> curves;  ///< absent without a load, or where nothing can be predicted
  std::string curves_missing;          ///< why
  const std::vector<CheckFinding>* findings = nullptr;  ///< must outlive this; none: nothing was
                                                        ///< found
  std::vector<ReportPiece> pieces;
  std::vector<std::string> files;
  std::vector<ReportTime> times;
};

/// Grams of a piece; empty where its material's density is not known.
std::optional<double> mass_g(const ReportPiece& piece);

/// The report for programs, one JSON object: docs/report.md describes it, "schema_version" names
/// the description. The same for the same data; `with_times` adds the times.
std::string report_json(const ReportData& data, bool with_times);

/// The response as CSV: a row for every state of every curve, with the columns of `latticast
/// predict
/// --format csv` that do not change from run to run, and "asked". Empty without curves.
std::string response_csv(const ReportData& data);

}  // namespace latticast
