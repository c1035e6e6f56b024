// SPDX-License-Identifier: GPL-3.0-or-later
#include "checks/check_finding.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace latticast {
namespace {

constexpr double rounding = 1e-9;  // relative; far below what any machine resolves

constexpr std::array codes = {
    // Printing.
    CheckCode{"strand-too-thin", Severity::error,
              "a strand is narrower than the printer's least wall, or its groove than the least "
              "gap, at its inner radius"},
    CheckCode{"ring-too-thin", Severity::error,
              "rings are narrower than the printer's least wall, or their grooves than the least "
              "gap"},
    CheckCode{"layer-too-thin", Severity::error,
              "the lattice, or a printed liner, is thinner than the printer's least wall"},
    CheckCode{"gap-too-small", Severity::error,
              "neighbouring strands or rings are closer than the printer's least gap, or the land "
              "between their grooves is thinner than its least wall; a warning where the design "
              "does not state the limit"},
    CheckCode{
        "cell-too-small", Severity::warning,
        "openings between crossing strands are smaller than the printer's least gap, or lands "
        "than its least wall"},
    CheckCode{
        "acute-corner", Severity::warning,
        "grooves graze: the land's tip is too thin for longer than a strand is wide; a note for "
        "the gap between printed strands, which fills"},
    CheckCode{
        "gap-closed", Severity::note,
        "curved outlines come nearer than the tolerance without meeting: such gaps are closed"},
    CheckCode{"loose-part", Severity::error,
              "part of the lattice is not connected to the rest; a warning for rings alone"},
    CheckCode{"overhang", Severity::note,
              "strands are flatter than the process prints without supports"},
    CheckCode{"long-bridge", Severity::note,
              "an underside runs level for longer than the process prints without supports"},
    CheckCode{"exceeds-bed", Severity::error, "a part is larger than the printer's bed"},
    CheckCode{"cannot-draw", Severity::error, "the lattice cannot be drawn as asked"},
    CheckCode{"columns-fused", Severity::warning, "columns overlap and are drawn as one net"},
    // Casting.
    CheckCode{"mold-impossible", Severity::error, "a mold cannot be made as asked"},
    CheckCode{"mold-wall-too-thin", Severity::error,
              "a mold's wall is thinner under its strap grooves than the printer's least wall"},
    CheckCode{"groove-too-deep", Severity::warning, "a groove is deeper than 3 times its width"},
    CheckCode{
        "demolding-strain", Severity::warning,
        "taking a piece off strains the casting more than it should bear; an error beyond its "
        "elongation at break"},
    CheckCode{"trapped-air", Severity::error,
              "a bore that lets air out is so narrow that it prints shut"},
    CheckCode{"many-vents", Severity::warning, "a lattice mold needs more than 24 vents"},
    CheckCode{"pour-volume", Severity::warning,
              "cavity, film and bores take more than the amount that is mixed"},
    // Inflating.
    CheckCode{"not-predictable", Severity::warning,
              "the model does not cover the segment, so that nothing under load is checked"},
    CheckCode{"limit-point", Severity::error,
              "no equilibrium at an asked pressure: the segment balloons or collapses before"},
    CheckCode{"limit-point-near", Severity::warning,
              "the largest asked pressure is within a margin of 1.25 of that end"},
    CheckCode{"unstable-state", Severity::error,
              "the predicted shape is unstable within the load: the segment buckles"},
    CheckCode{"not-followed", Severity::error,
              "the equilibrium could not be followed to an asked pressure"},
    CheckCode{"liner-balloons", Severity::error, "the liner balloons through a gap of the lattice"},
    CheckCode{"liner-balloons-near", Severity::warning,
              "the liner is within a margin of 1.25 of ballooning through a gap"},
    CheckCode{"liner-bulges", Severity::note,
              "the liner stands out beyond the lattice in its gaps"},
    CheckCode{"rings-too-far", Severity::warning, "the liner between two rings does not feel them"},
    CheckCode{"liner-overstrained", Severity::error,
              "the liner is stretched beyond its elongation at break"},
    CheckCode{"liner-law-exceeded", Severity::warning,
              "the liner is stretched beyond the range of its law"},
    CheckCode{"liner-law-unstable", Severity::warning,
              "the liner is stretched to where its law loses Drucker's stability"},
    CheckCode{"strand-overstrained", Severity::error,
              "a strand or ring is strained beyond its elongation at break"},
    CheckCode{"strand-law-exceeded", Severity::warning,
              "a strand or ring is strained beyond the range of its law"},
    CheckCode{"fibre-lock", Severity::warning,
              "strands lie along the tube, or horseshoes are straight: hardly more motion"},
    CheckCode{"strands-touch-inflated", Severity::error,
              "neighbouring strands, rings or arcs touch in the inflated shape"},
    CheckCode{"folds", Severity::warning, "the liner's shortened side creases"},
    CheckCode{"angle-out-of-range", Severity::warning,
              "strands nearer to the circumference than the model is valid"},
    CheckCode{
        "rings-in-step", Severity::note,
        "all rings cross curved strands at the same place of their waves, which kind = layered "
        "does not see"},
    CheckCode{"modulus-band", Severity::note,
              "the material is known too roughly to predict the motion within a fifth"},
    // Files.
    CheckCode{"mesh-not-finite", Severity::error, "a coordinate is not a finite number"},
    CheckCode{"mesh-degenerate", Severity::error, "triangles have no area"},
    CheckCode{"mesh-open-edge", Severity::error, "the surface has holes"},
    CheckCode{"mesh-crowded-edge", Severity::error, "more than two triangles share an edge"},
    CheckCode{"mesh-inconsistent-edge", Severity::error,
              "neighbouring triangles face opposite sides"},
    CheckCode{"mesh-pinched-vertex", Severity::error, "the surface touches itself in a point"},
    CheckCode{"mesh-self-intersection", Severity::error, "the surface crosses itself"},
    CheckCode{"mesh-inside-out", Severity::error, "a body faces the wrong way"},
    CheckCode{"mesh-thin-wall", Severity::warning, "walls are thinner than melted plastic prints"},
    CheckCode{"enclosed-void", Severity::warning, "a cavity has no way out"},
    CheckCode{"mesh-too-small", Severity::warning,
              "a file is so small that its unit may be another"},
    CheckCode{"parts-overlap", Severity::note, "two parts of a file claim the same room"},
};

}  // namespace

std::string_view name(Severity severity) {
  switch (severity) {
    case Severity::note:
      return "note";
    case Severity::warning:
      return "warning";
    case Severity::error:
      return "error";
  }
  return "";
}

bool has_error(const CheckFindings& findings) {
  return std::any_of(findings.begin(), findings.end(), [](const CheckFinding& finding) {
    return finding.severity == Severity::error;
  });
}

std::span<const CheckCode> all_check_codes() {
  return codes;
}

CheckFinding check_finding(std::string_view code) {
  const auto known = std::find_if(codes.begin(), codes.end(),
                                  [&](const CheckCode& entry) { return entry.code == code; });
  if (known == codes.end()) throw std::logic_error("no check code " + std::string(code));
  CheckFinding finding;
  finding.code = known->code;
  finding.severity = known->severity;
  return finding;
}

bool clearly_below(double value, double limit) {
  return value < limit - rounding * std::abs(limit);
}

bool clearly_above(double value, double limit) {
  return value > limit + rounding * std::abs(limit);
}

}  // namespace latticast
