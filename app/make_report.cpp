// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include "app/build_report.h"
#include "app/makers.h"
#include "prepared/prepared_design.h"
#include "report/report_data.h"
#include "report/report_view.h"

namespace latticast {
namespace {

void report(Build& build) {
  Delivery& delivery = build.delivery;
  ReportData report;
  delivery.progress().begin("report: response");
  predict_report(build.order.prepared.responses, report);
  delivery.note_time("report, response");
  delivery.progress().begin("report: view");
  const ReportView view =
      make_view(build.order.prepared, report.curves ? &*report.curves : nullptr);
  delivery.note_time("report, view");
  delivery.progress().begin("report: page");
  complete_report(build.order, delivery.delivered(), report);
  for (const ReportFile& file : report_files(report, view, build.order, build.pictures)) {
    delivery.write_listed(file.name, file.bytes);
    delivery.tell(fmt::format("{}: {}\n", file.name, file.meaning));
  }
  delivery.note_time("report, page");
}

}  // namespace

void make_report(Build& build, std::vector<Task>& tasks) {
  build.delivery.progress().expect(3);
  tasks.push_back({build.design().segments.size() + 3, [&build] { report(build); }});
}

}  // namespace latticast
