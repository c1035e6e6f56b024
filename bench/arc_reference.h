// SPDX-License-Identifier: GPL-3.0-or-later
// Reference solution of the pulled arc (docs/horseshoe.md#equation) in extended precision, by two
// independent ways.
#pragma once

#include "model/horseshoe/arc_equilibrium.h"

namespace latticast {

/// beta at one strain.
struct ArcReference {
  long double force = 0;
  long double disagreement = 0;  ///< relative, between the two ways; infinite where one failed
};

/// beta at `near.strain`, from the first integral and from the initial-value problem, both in long
/// double; `near` says where to look. The first way has the squared rate of turning in the middle
/// as unknown instead of the end's slope, and integrates over a variable whose sinh (pulled) or
/// sine (pushed) is the slope, in which boundary layers are smooth. The second way walks by Taylor
/// series from the middle of the arc. The first one's force is given. Precondition: the strain is
/// not 0.
ArcReference arc_reference(const Arc& arc, const ArcEquilibrium& near);

/// The first way alone: faster.
long double arc_reference_force(const Arc& arc, const ArcEquilibrium& near);

}  // namespace latticast
