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
    CheckCode{"strand-too-thin", Severity::error,
              "a strand is narrower than the printer's least wall, at its inner or outer radius"},
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
    CheckCode{"modulus-band", Severity::note,
              "the material is known too roughly to predict the motion within a fifth"},
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
