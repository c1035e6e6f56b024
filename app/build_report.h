// SPDX-License-Identifier: GPL-3.0-or-later
// What a build puts into its report, and the report's files.
#pragma once

#include <string>
#include <vector>

#include "report/report_page.h"

namespace latticast {

struct BuildOrder;
struct Delivered;
class PreparedResponses;
struct ReportData;
struct ReportView;

/// Fills in the response, or why there is none.
void predict_report(PreparedResponses& responses, ReportData& report);

/// Fills in what the order says, design, plan and checks, and what was delivered.
void complete_report(const BuildOrder& order, const Delivered& delivered, ReportData& report);

struct ReportFile {
  std::string name;
  std::string bytes;
  std::string meaning;  ///< for people, a few words
};

/// The page, with pictures, its numbers as JSON, and the response as CSV where there is one. Adds
/// their names to the report's files before anything is written.
std::vector<ReportFile> report_files(ReportData& report, const ReportView& view,
                                     const BuildOrder& order,
                                     const std::vector<ReportPicture>& pictures);

}  // namespace latticast
