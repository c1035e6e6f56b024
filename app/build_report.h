// SPDX-License-Identifier: GPL-3.0-or-later
// What a build puts into its report, and the report's files.
#pragma once

#include <string>
#include <vector>

#include "app/builder.h"
#include "geometry/solid/audit.h"
#include "geometry/solid/solid_error.h"
#include "report/report_data.h"
#include "report/report_view.h"
#if LATTICAST_HAS_MOLDS
#include "app/mold_set.h"
#endif

namespace latticast {

ReportMesh report_mesh(const Audit& audited, const SolidError& error);

#if LATTICAST_HAS_MOLDS
/// What is cast in a mold; null for a flexible mold, whose rubber is the workshop's choice.
const Material* poured_material(const Design& design, const PlannedMold& planned);
#endif

/// Fills in the response, or why there is none.
void predict_report(PreparedResponses& responses, ReportData& report);

/// Fills in what the order says: design, plan, checks.
void complete_report(const BuildOrder& order, ReportData& report);

struct ReportFile {
  std::string name;
  std::string bytes;
  std::string meaning;  ///< for people, a few words
};

/// The page, its numbers as JSON, and the response as CSV where there is one. Adds their names to
/// the report's files before anything is written.
std::vector<ReportFile> report_files(ReportData& report, const ReportView& view,
                                     const BuildOrder& order);

}  // namespace latticast
