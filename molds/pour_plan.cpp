// SPDX-License-Identifier: GPL-3.0-or-later
#include "molds/pour_plan.h"

#include <algorithm>
#include <iterator>
#include <numbers>

#include <fmt/core.h>

#include "design/text/printable.h"
#include "design/text/written_number.h"
#include "design/units.h"
#include "molds/print_size.h"

namespace latticast {
namespace {

constexpr double mm3_per_ml = 1000;

bool has_piece(const Mold& mold, std::string_view name) {
  return std::any_of(mold.pieces.begin(), mold.pieces.end(),
                     [&](const MoldPiece& piece) { return piece.name == name; });
}

// Pieces' names come from the makers of molds; what they do not know is taken to be inside.
int turn_of(const MoldPiece& piece) {
  if (piece.name == "cap") return 0;
  if (piece.name == "base") return 1;
  return piece.pulls_sideways ? 2 : 3;
}

double pull_deg(const MoldPiece& piece) {
  return degrees(piece.pull_rad);
}

std::string numbered(const std::vector<std::string>& steps) {
  std::string text;
  for (std::size_t i = 0; i < steps.size(); ++i) text += fmt::format("{}. {}\n", i + 1, steps[i]);
  return text;
}

// A material's words are its author's: none of them becomes markup, HTML or a line of its own.
std::string as_plain_text(std::string_view words) {
  std::string text;
  for (const char c : words) {
    if (c == '<') {
      text += "&lt;";
    } else if (c == '&') {
      text += "&amp;";
    } else if (c == '\n' || c == '\r' || c == '\t') {
      text += ' ';
    } else {
      if (std::string_view("\\`*_{}[]()>#+!|~").find(c) != std::string_view::npos) text += '\\';
      text += c;
    }
  }
  return printable(text);
}

std::string bill(const Casting& casting) {
  std::string text =
      "## Pieces\n\nSizes as they are printed, standing on their end, the cap on its outer face, "
      "without support.\n\n"
      "| piece | what it is | width x depth x height, mm | volume, ml |\n|---|---|---|---|\n";
  const auto add = [&](const MoldPiece& piece) {
    const PrintSize size = print_size(piece);
    fmt::format_to(std::back_inserter(text), "| {} | {} | {:.1f} x {:.1f} x {:.1f} | {:.1f} |\n",
                   piece.name, piece.use, size.width_mm, size.depth_mm, size.height_mm,
                   piece.solid.volume_mm3 / mm3_per_ml);
  };
  for (const MoldPiece& piece : casting.mold.pieces) add(piece);
  for (const MoldPiece& piece : casting.extras) add(piece);
  return text;
}

std::string amounts(const Casting& casting, const PourAllowance& allowance) {
  const PourAmount amount = pour_amount(casting.mold.cavity_mm3, casting.material, allowance);
  std::string text =
      fmt::format("\n## Rubber\n\n{}: the cavity holds {:.1f} ml. Mix {:.1f} ml",
                  as_plain_text(casting.material.name), amount.cavity_ml, amount.mixed_ml);
  if (amount.mixed_g) {
    text += fmt::format(", {:.1f} g at {} g/cm3", *amount.mixed_g,
                        written(*casting.material.density_g_per_cm3, 4));
  }
  text += fmt::format(", which is {:.0f} % more and {} ml that stay in the cup.",
                      100 * allowance.waste_share, written(allowance.residue_ml, 3));
  if (!amount.mixed_g) text += " The material's density is not known: measure by volume.";
  if (!casting.material.note.empty()) {
    text += fmt::format("\n\nThe library says of it: {}", as_plain_text(casting.material.note));
  }
  return text + "\n";
}

std::string preparation(const Casting& casting) {
  std::vector<std::string> steps = {
      "Print the pieces and clear them of strings and support. Try every fit dry; a piece that "
      "binds is sanded, not forced."};
  if (casting.process == Process::sla) {
    steps.emplace_back(
        "Wash and post-cure the prints fully. Platinum-cured silicone may stay sticky on printed "
        "resin: try a drop on a scrap of the same print first, and seal the surfaces that touch "
        "rubber with clear acrylic lacquer.");
  } else {
    steps.emplace_back(
        "Printed layers leave ridges in the rubber, and cracks begin there: smooth the surfaces "
        "that "
        "touch rubber, above all the core. Seal their pores, and let the sealer dry.");
  }
  steps.emplace_back(
      "Polyurethane needs a release agent on every surface that it touches: brush it on, mist once "
      "more, and let it dry for 30 minutes. For silicone, follow its data sheet.");
  steps.emplace_back(
      "With platinum-cured silicone, keep latex gloves, tin-cured silicone and sulfur clay away.");
  if (casting.into_lattice) {
    steps.emplace_back(
        "Keep release agent off the lattice. Urethane rubber can inhibit platinum-cured silicone: "
        "try a drop on the lattice first.");
  }
  return "\n## Prepare\n\n" + numbered(steps);
}

std::string assembly(const Casting& casting) {
  const Mold& mold = casting.mold;
  std::vector<std::string> steps;
  if (has_piece(mold, "core")) {
    steps.push_back(fmt::format("Set the {} into the socket of the base.", casting.inside));
  } else {
    steps.emplace_back("Set the base down, its core upwards.");
  }
  if (casting.into_lattice) {
    steps.emplace_back("Slip the finished lattice over the core, until it stands on the base.");
  }
  steps.emplace_back(
      "Close the shell's pieces around it, tooth into tooth, in the order of their numbers, and "
      "stand them in the base's rim. Strap them in their grooves.");
  steps.emplace_back(
      "Seal the seams and the joint at the base from outside with tape or plasticine without "
      "sulfur.");
  if (has_piece(mold, "core")) {
    steps.push_back(fmt::format("Press on the cap: its socket takes the {}, its rim the shell.",
                                casting.inside));
  } else {
    steps.emplace_back("Press on the cap: its rim takes the shell.");
  }
  return "\n## Assemble\n\n" + numbered(steps);
}

std::string filling_step(const Casting& casting) {
  if (casting.through_bores) {
    return "Stand the mold upright and level. Press the rubber in through the lowest bore with a "
           "syringe, slowly, so that air leaves above, and plug each vent when rubber stands in "
           "it. "
           "Then plug the lowest bore.";
  }
  const bool has_core = has_piece(casting.mold, "core");
  return fmt::format(
      "Stand the mold upright and level. Pour a thin stream through {}, so that air leaves by the "
      "others, until rubber rises in all of them.",
      has_core ? "one opening only" : "the hole in the middle of the cap");
}

std::string pouring(const Casting& casting, const PourAmount& amount) {
  std::vector<std::string> steps = {
      fmt::format("Mix {:.1f} ml as the rubber's data sheet says, and degas it under vacuum if you "
                  "can. Mind its pot life.",
                  amount.mixed_ml),
      filling_step(casting)};
  if (!casting.through_bores) {
    steps.emplace_back("Tap the mold, wait until bubbles have risen, and top up.");
  }
  steps.emplace_back("Cure as the data sheet says, upright.");
  return "\n## Pour\n\n" + numbered(steps);
}

std::string demolding(const Casting& casting) {
  std::vector<std::string> steps = {"Take off straps and tape; cut the rubber in the openings."};
  for (const MoldPiece* piece : demolding_order(casting.mold)) {
    if (piece->name == "cap") {
      steps.emplace_back("Pull the cap upwards.");
    } else if (piece->name == "base") {
      steps.emplace_back(
          has_piece(casting.mold, "core")
              ? "Pull the base downwards."
              : "Pull the base downwards, and its core with it; air or water between "
                "core and rubber helps.");
    } else if (piece->pulls_sideways) {
      steps.push_back(fmt::format("Pull {} sideways, towards {:.0f} degrees around the axis.",
                                  piece->name, pull_deg(*piece)));
    } else if (piece->name == "pattern") {
      steps.emplace_back(
          "Slit the rubber along the axis, between gates, down to the pattern, and peel it off.");
    } else if (piece->name == casting.inside) {
      steps.push_back(
          fmt::format("Push the {} out along the axis; air or water between it and the "
                      "rubber helps.",
                      piece->name));
    }
  }
  steps.emplace_back("Trim what stood in the openings and at the seams.");
  for (const MoldPiece& plug : casting.extras) {
    steps.push_back(
        fmt::format("Press {} into its end, up to the flange, with an adhesive that holds on both.",
                    plug.name));
  }
  return "\n## Demold\n\n" + numbered(steps);
}

}  // namespace

double mold_growth(const Material& material) {
  return 1 / (1 - material.shrinkage.value_or(0));
}

PourAmount pour_amount(double cavity_mm3, const Material& material,
                       const PourAllowance& allowance) {
  PourAmount amount;
  amount.cavity_ml = cavity_mm3 / mm3_per_ml;
  amount.mixed_ml = amount.cavity_ml * (1 + allowance.waste_share) + allowance.residue_ml;
  if (material.density_g_per_cm3) amount.mixed_g = amount.mixed_ml * *material.density_g_per_cm3;
  return amount;
}

std::vector<const MoldPiece*> demolding_order(const Mold& mold) {
  std::vector<const MoldPiece*> order;
  for (const MoldPiece& piece : mold.pieces) order.push_back(&piece);
  std::stable_sort(order.begin(), order.end(), [](const MoldPiece* a, const MoldPiece* b) {
    return turn_of(*a) < turn_of(*b);
  });
  return order;
}

std::string pour_procedure(const Casting& casting, const PourAllowance& allowance) {
  const PourAmount amount = pour_amount(casting.mold.cavity_mm3, casting.material, allowance);
  std::string text = fmt::format("# {}\n\n", casting.title) + bill(casting) +
                     amounts(casting, allowance) + preparation(casting) + assembly(casting) +
                     pouring(casting, amount) + demolding(casting);
  if (!casting.mold.notes.empty()) {
    text += "\n## Notes\n\n";
    for (const std::string& note : casting.mold.notes) text += fmt::format("- {}\n", note);
  }
  return text;
}

}  // namespace latticast
