// SPDX-License-Identifier: GPL-3.0-or-later
// One maker a product of the plan: each says what it will take, and leaves its files with the
// delivery.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "app/builder.h"
#include "app/delivery.h"
#include "export/mesh/three_mf_file.h"
#include "report/report_page.h"

namespace latticast {

/// What makers work on: what was asked, what is prepared, where files go.
struct Build {
  const BuildOrder& order;
  Delivery& delivery;
  std::vector<NamedMesh> together;  ///< parts at rest, for the 3MF file of all of them
  std::size_t expected_together = 0;
  std::vector<Failure> failures = {};        ///< so far
  std::vector<ReportPicture> pictures = {};  ///< for the report

  const Design& design() const { return order.design; }
  double start_z_mm(std::size_t segment) const;  ///< where it begins along the actuator
};

/// A piece of a maker's work.
struct Task {
  std::size_t round = 0;  ///< tasks run in the order of rounds, and as they were added within one
  std::function<void()> run;
};

/// Tells the progress how many steps to expect, and adds its tasks. What is known to be impossible
/// is thrown here, before any file is written.
using Maker = std::function<void(Build& build, std::vector<Task>& tasks)>;

void make_lattices(Build& build, std::vector<Task>& tasks);
void make_liners(Build& build, std::vector<Task>& tasks);
void make_flat_patterns(Build& build, std::vector<Task>& tasks);
void make_rest_together(Build& build, std::vector<Task>& tasks);  ///< after lattices and liners
void make_molds(Build& build, std::vector<Task>& tasks);          ///< with LATTICAST_MOLDS
void make_preview(Build& build, std::vector<Task>& tasks);        ///< with LATTICAST_PREDICT
void make_decks(Build& build, std::vector<Task>& tasks);          ///< with LATTICAST_PREDICT
void make_report(Build& build, std::vector<Task>& tasks);         ///< with LATTICAST_PREDICT

}  // namespace latticast
