// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/build_report.h"

#include <utility>

#include "design/unsupported_design.h"
#include "report/report_page.h"

namespace latticast {

ReportMesh report_mesh(const Audit& audited, const SolidError& error) {
  ReportMesh mesh{audited.triangles, audited.components, audited.genus, {},
                  error.surface_mm,  error.volume_mm3};
  for (std::size_t i = 0; i < 3; ++i) mesh.size_mm[i] = audited.highest[i] - audited.lowest[i];
  return mesh;
}

#if LATTICAST_HAS_MOLDS
const Material* poured_material(const Design& design, const PlannedMold& planned) {
  const Segment& segment = design.segments[planned.segment];
  if (planned.kind == "liner-mold") return &segment.liner.material;
  if (design.make.lattice_mold->method == MoldMethod::replica) return nullptr;
  return &segment.lattice->material;
}
#endif

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

void complete_report(const BuildOrder& order, ReportData& report) {
  report.design = &order.design;
  report.program_version = LATTICAST_VERSION;
  for (const PlannedStage& stage : order.plan.stages) {
    report.plan.push_back({std::string(name(stage.stage)), stage.runs, stage.reason});
  }
  report.findings = order.findings;
}

std::vector<ReportFile> report_files(ReportData& report, const ReportView& view,
                                     const BuildOrder& order) {
  const std::string stem = order.design.name;
  std::vector<ReportFile> files = {{stem + "-report.html", "", "everything at a glance"},
                                   {stem + "-report.json", "", "the same for programs"}};
  if (report.curves) files.push_back({stem + "-response.csv", "", "the response to pressure"});
  for (const ReportFile& file : files) report.files.push_back(file.name);
  files[0].bytes = report_page({stem, report_json(report, true),
                                view_json(view, order.design, order.findings), view_glb(view)});
  files[1].bytes = report_json(report, order.times_in_report);
  if (report.curves) files[2].bytes = response_csv(report);
  return files;
}

}  // namespace latticast
