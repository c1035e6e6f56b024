// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/build_report.h"

#include <utility>

#include "app/builder.h"
#include "app/delivery.h"
#include "app/plan.h"
#include "design/design.h"
#include "design/unsupported_design.h"
#include "prepared/prepared_responses.h"
#include "report/report_data.h"
#include "report/report_page.h"
#include "report/report_view.h"
#include "report/view_json.h"

namespace latticast {

namespace {

ReportMesh report_mesh(const DeliveredMesh& delivered) {
  const Audit& audited = delivered.audited;
  ReportMesh mesh{.triangles = audited.triangles,
                  .components = audited.components,
                  .genus = audited.genus,
                  .surface_error_mm = delivered.error.surface_mm,
                  .volume_error_mm3 = delivered.error.volume_mm3};
  for (std::size_t i = 0; i < 3; ++i) mesh.size_mm[i] = audited.highest[i] - audited.lowest[i];
  return mesh;
}

ReportPiece report_piece(const DeliveredPiece& piece) {
  ReportPiece reported{.name = piece.name,
                       .kind = piece.kind,
                       .segment = static_cast<int>(piece.segment) + 1,
                       .files = piece.files,
                       .material = piece.material,
                       .volume_mm3 = piece.volume_mm3,
                       .prints = piece.prints,
                       .mesh = {}};
  if (piece.mesh) reported.mesh = report_mesh(*piece.mesh);
  return reported;
}

}  // namespace

void predict_report(PreparedResponses& responses, ReportData& report) {
  if (responses.design().load.empty()) {
    report.curves_missing = "the design names no load";
    return;
  }
  try {
    report.curves = predict_curves(responses);
  } catch (const UnsupportedDesign& reason) {
    report.curves_missing = reason.what();
  }
}

void complete_report(const BuildOrder& order, const Delivered& delivered, ReportData& report) {
  report.design = &order.design;
  report.program_version = LATTICAST_VERSION;
  for (const PlannedStage& stage : order.plan.stages) {
    report.plan.push_back({std::string(name(stage.stage)), stage.runs, stage.reason});
  }
  report.findings = &order.findings;
  report.files = delivered.files;
  for (const DeliveredPiece& piece : delivered.pieces) {
    report.pieces.push_back(report_piece(piece));
  }
  for (const auto& [stage, seconds] : delivered.seconds) report.times.push_back({stage, seconds});
}

std::vector<ReportFile> report_files(ReportData& report, const ReportView& view,
                                     const BuildOrder& order,
                                     const std::vector<ReportPicture>& pictures) {
  const std::string stem = order.design.name;
  std::vector<ReportFile> files = {{stem + "-report.html", "", "everything at a glance"},
                                   {stem + "-report.json", "", "the same for programs"}};
  if (report.curves) files.push_back({stem + "-response.csv", "", "the response to pressure"});
  for (const ReportFile& file : files) report.files.push_back(file.name);
  files[0].bytes =
      report_page({stem, report_json(report, order.times_in_report),
                   view_json(view, order.design, order.findings), view_glb(view), pictures});
  files[1].bytes = report_json(report, order.times_in_report);
  if (report.curves) files[2].bytes = response_csv(report);
  return files;
}

}  // namespace latticast
