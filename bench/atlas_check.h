// SPDX-License-Identifier: GPL-3.0-or-later
// Whether what `predict` answers at a point of the atlas is right, judged without its word: states
// and ends of branches are put to energies, a path and eigenvalues of this file's own.
#pragma once

#include <string>
#include <vector>

#include "design/design.h"
#include "model/equilibrium/state.h"

namespace latticast {

/// A segment under pressures, all of one sign, and how it is held.
struct AtlasDesign {
  Segment segment;
  ModelChoice model;
  Held held;
  std::vector<double> pressures_kpa;
};

enum class Verdict {
  verified,  ///< an equilibrium, connected to rest, its stability as stated
  refused,   ///< no state, for a reason that is named and holds
  wrong      ///< anything else
};

/// One answer. `kind` is short and one of few: "stable", "unstable", "limit point", "asymptote",
/// "closure", "stretch limit", "law's end", "instability", "unsupported", or what is wrong.
struct Judgement {
  Verdict verdict = Verdict::wrong;
  std::string kind;
  std::string detail;
};

/// One finding for each pressure.
///   state:       the Newton step that it still lacks under a finer quadrature is within its error
///                estimate; load stepping from rest with plain Newton steps, in coordinates that
///                symmetry may have left out, arrives there too; `stable` agrees with the
///                eigenvalues of the 5 x 5 stiffness
///   limit point: the stiffness is singular there, positive on one side of it along the branch and
///                negative on the other, and load stepping ends there; asymptote and closure: load
///                stepping gets there and no further
///   otherwise:   the message names the reason, and load stepping agrees with it
std::vector<Judgement> examine(const AtlasDesign& design);

/// Pressure in kPa that strains the section by about a tenth, from the stiffness at rest; where
/// that cannot be prepared, what strains the liner alone.
double fitting_pressure_kpa(const AtlasDesign& design);

/// The pressure at which the branch ends, or where there is no end, the fitting pressure, kPa.
double reference_pressure_kpa(const AtlasDesign& design);

}  // namespace latticast
