// SPDX-License-Identifier: GPL-3.0-or-later
// What a design needs to have done, and why the rest is left out.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace latticast {

struct Design;

enum class Stage {
  prediction,
  horseshoe_law,
  bending,
  lattice,
  liner,
  flat_pattern,
  preview,
  lattice_mold,
  liner_mold,
  deck,
  report,
};

/// The name as the command line and the plan write it.
std::string_view name(Stage stage);

struct PlannedStage {
  Stage stage;
  bool runs = false;
  std::string reason;  ///< why it runs or is skipped
};

/// One entry for every stage, in the order of work.
struct Plan {
  std::vector<PlannedStage> stages;

  bool runs(Stage stage) const;
};

/// The stages that `latticast build` runs for a design. `only` narrows [make] down to the parts
/// named (as in name(); "molds" means both molds); empty means all of [make]. Throws
/// std::invalid_argument for a name that is no part, or that [make] does not ask for.
Plan plan_build(const Design& design, const std::vector<std::string>& only);

/// What the plan runs that this program cannot do, one sentence each with its remedy; empty when it
/// can do everything.
std::vector<std::string> unavailable(const Plan& plan);

/// The plan as text for people, a line a stage.
std::string describe(const Plan& plan);

}  // namespace latticast
