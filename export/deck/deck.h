// SPDX-License-Identifier: GPL-3.0-or-later
// Input decks of a wedge mesh for finite-element programs: Abaqus' and CalculiX' .inp, gmsh's .msh
// (docs/decks.md).
#pragma once

#include <string>
#include <vector>

#include "design/material/law.h"
#include "geometry/mesh/wedge_mesh.h"

namespace latticast {

/// What a deck says besides its mesh.
struct DeckJob {
  std::string title;
  Law liner;
  Linear lattice;
  std::vector<double> pressures_kpa;  ///< a step each
};

/// Why a deck cannot hold this liner law: "Gent"; empty where it can.
std::string law_without_deck(const Law& liner);

/// Keyword deck in mm, N and MPa: node sets BASE, TIP, BOND, element sets LINER, LATTICE and CAVITY
/// (whose first faces are the bore), rigid ends, closed by a force on the tip's reference node, a
/// step for each pressure, and for a sector the equations that make its sides images of each other.
/// The liner is nearly incompressible, D1 = 0.001/mu; strips and rings are neo-Hookean, mu and bulk
/// modulus from E and nu. Precondition: law_without_deck() is empty.
std::string inp_deck(const WedgeMesh& mesh, const DeckJob& job);

/// Mesh in gmsh's format 2.2: volumes LINER and LATTICE, surfaces CAVITY, BASE, TIP.
std::string msh_deck(const WedgeMesh& mesh);

}  // namespace latticast
