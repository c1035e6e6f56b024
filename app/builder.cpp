// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/builder.h"

#include <algorithm>

#include <fmt/core.h>

#include "app/delivery.h"
#include "app/interrupt.h"
#include "app/makers.h"
#include "app/plan.h"
#include "design/design.h"

namespace latticast {
namespace {

struct MakerOf {
  std::vector<Stage> stages;  // any of which calls for it
  Maker make;
};

// Molds first: whether they can be made is known before anything else is drawn.
std::vector<MakerOf> makers() {
  return {
#if LATTICAST_HAS_MOLDS
    {{Stage::lattice_mold, Stage::liner_mold}, make_molds},
#endif
        {{Stage::lattice}, make_lattices}, {{Stage::liner}, make_liners},
        {{Stage::flat_pattern}, make_flat_patterns},
        {{Stage::lattice, Stage::liner}, make_rest_together},
#if LATTICAST_HAS_PREDICT
        {{Stage::deck}, make_decks}, {{Stage::preview}, make_preview},
        {{Stage::report}, make_report},
#endif
  };
}

// Its files stay, or none of them.
template <class Work>
void attempt(Build& build, const Work& work) {
  const Delivery::Mark before = build.delivery.mark();
  try {
    work();
  } catch (const std::exception&) {
    build.failures.push_back(product_failure());
    build.delivery.take_back(before);
  }
}

void make_all(Build& build) {
  std::vector<Task> tasks;
  for (const MakerOf& maker : makers()) {
    const auto runs = [&](Stage stage) { return build.order.plan.runs(stage); };
    if (!std::any_of(maker.stages.begin(), maker.stages.end(), runs)) continue;
    attempt(build, [&] { maker.make(build, tasks); });
  }
  std::stable_sort(tasks.begin(), tasks.end(),
                   [](const Task& a, const Task& b) { return a.round < b.round; });
  for (const Task& task : tasks) attempt(build, task.run);
}

}  // namespace

double Build::start_z_mm(std::size_t segment) const {
  double start = 0;
  for (std::size_t s = 0; s < segment; ++s) start += design().segments[s].length_mm;
  return start;
}

BuildResult build_parts(const BuildOrder& order, const Console& console) {
  Delivery delivery(order.design, order.folder, console);
  Build build{order, delivery, {}};
  try {
    make_all(build);
    delivery.progress().finish();
  } catch (const Interrupted&) {
    console.end_progress();
    throw Interrupted(
        fmt::format("interrupted at {} %: {} files were ready and have been discarded; {} is as "
                    "it was before",
                    delivery.progress().percent(), delivery.ready(), order.folder.string()));
  }
  if (delivery.ready() > 0) delivery.commit();
  return {delivery.summary(), std::move(build.failures)};
}

}  // namespace latticast
