// SPDX-License-Identifier: GPL-3.0-or-later
// Pour plan of a casting: amounts to mix and steps to take, as a page for the workshop.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "design/design.h"
#include "molds/mold_piece.h"

namespace latticast {

/// The factor that a cavity is made larger by, 1 / (1 - shrinkage); 1 where the material does not
/// state any.
double mold_growth(const Material& material);

/// What is mixed beyond the cavity. Conventions of a bench, not properties of a rubber.
struct PourAllowance {
  double waste_share = 0.15;  ///< of the cavity: windows, sprues, overflow
  double residue_ml = 5;      ///< what stays in the cup
};

struct PourAmount {
  double cavity_ml = 0;
  double mixed_ml = 0;
  std::optional<double> mixed_g;  ///< absent where the material's density is not known
};

/// mixed = cavity (1 + waste) + residue. 1 ml = 1000 mm3.
PourAmount pour_amount(double cavity_mm3, const Material& material,
                       const PourAllowance& allowance = {});

/// In which order the pieces come off: cap, base, the shell's pieces, and then what is inside.
/// Pointers into `mold`.
std::vector<const MoldPiece*> demolding_order(const Mold& mold);

/// What is cast, and in what.
struct Casting {
  std::string title;  ///< "Liner of segment 1"
  const Mold& mold;
  const Material& material;
  Process process = Process::fdm;
  bool into_lattice = false;        ///< the finished lattice is put into the mold (keyed)
  std::string inside = "core";      ///< the piece that stands in the base's socket
  bool through_bores = false;       ///< filled from the shell's lowest bore, not through the cap
  std::vector<MoldPiece> extras{};  ///< printed with the mold: plugs
};

/// Bill of pieces, amounts, preparation, assembly, pouring and demolding as a Markdown page.
/// Grams are stated only where the density is known; the facts about inhibition and release and
/// their sources are in docs/casting.md.
std::string pour_procedure(const Casting& casting, const PourAllowance& allowance = {});

}  // namespace latticast
