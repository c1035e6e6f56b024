// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/atlas_check.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <variant>

#include "bench/plain_path.h"
#include "model/section/section_energy.h"
#include "model/segment_response.h"
#include "model/strand/links.h"

namespace latticast {
namespace {

constexpr double kpa_per_mpa = 1000;

Judgement verified(const std::string& kind) {
  return {Verdict::verified, kind, ""};
}

Judgement refused(const std::string& kind, const std::string& detail) {
  return {Verdict::refused, kind, detail};
}

Judgement wrong(const std::string& kind, const std::string& detail = "") {
  return {Verdict::wrong, kind, detail};
}

std::string numbers(const char* format, double a, double b, double c = 0) {
  char text[200];
  std::snprintf(text, sizeof text, format, a, b, c);
  return text;
}

double size(const ScaledState& x) {
  double largest = 1;
  for (const double value : x) largest = std::max(largest, std::abs(value));
  return largest;
}

double distance(const ScaledState& a, const ScaledState& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

bool is_finite(const State& state) {
  for (const double value :
       {state.stretch, state.twist_rad_per_mm, state.bend_rad_per_mm[0], state.bend_rad_per_mm[1],
        state.inner_radius_mm, state.outer_radius_mm, state.torque_nmm, state.moment_nmm[0],
        state.moment_nmm[1], state.force_n, state.residual, state.error_estimate}) {
    if (!std::isfinite(value)) return false;
  }
  return !std::isnan(state.smallest_eigenvalue);
}

Judgement judge_state(const PlainPath& path, const State& state) {
  if (!is_finite(state)) return wrong("not a number");
  const double pressure = state.pressure_kpa / kpa_per_mpa;
  const ScaledState x = path.scaled(state);
  // Where the stiffness is all but singular, rounding of the forces moves the state by more.
  const double rounding = 1e-14 / std::max(1e-8, std::abs(state.smallest_eigenvalue));
  const double allowed = (1e-9 + rounding) * size(x) + 3 * state.error_estimate;
  if (!(state.error_estimate < 1e-5 * size(x))) {
    return wrong("poor state", numbers("error estimate %g", state.error_estimate, 0));
  }
  const auto missing = path.missing_step(x, pressure);
  if (!missing || !(*missing <= allowed)) {
    return wrong("unbalanced",
                 numbers("lacks a step of %g, allowed %g", missing.value_or(NAN), allowed));
  }
  PlainPath::End end = path.follow_to(pressure);
  double apart = 1e-6;
  if (!end.arrived) {
    // At a limit point load stepping comes close, but not to the point itself, where the state goes
    // with the square root of the pressure that is left.
    apart = 0.02;
    end = path.follow_to(pressure * (1 - 1e-6));
  }
  if (!end.arrived) {
    return wrong("not connected", numbers("load stepping ends at %g kPa of %g",
                                          end.pressure_mpa * kpa_per_mpa, state.pressure_kpa));
  }
  if (distance(end.x, x) > apart * size(x) + allowed) {
    return wrong("other root", numbers("apart by %g", distance(end.x, x), 0));
  }
  const auto stiffness = path.stiffness(x, pressure);
  if (!stiffness) return wrong("no stiffness");
  const double unclear =
      1e-3 * std::abs(state.smallest_eigenvalue) + 1e-12 * stiffness->norm + 1e-6;
  if (std::abs(stiffness->smallest) > unclear && state.stable != (stiffness->smallest > 0)) {
    return wrong("stability", numbers("eigenvalue %g, stated %g", stiffness->smallest,
                                      state.smallest_eigenvalue));
  }
  return verified(state.stable ? "stable" : "unstable");
}

/// Along the direction in which the stiffness is least, it passes through zero there, so that the
/// pressure is largest. On the curve of equilibria P'' = d(v.H v)/ds / (v.push).
bool turns_there(const PlainPath& path, const ScaledState& x, double pressure,
                 const PlainPath::Stiffness& at) {
  for (const double step : {1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10}) {
    ScaledState ahead = x;
    ScaledState behind = x;
    for (std::size_t i = 0; i < x.size(); ++i) {
      ahead[i] += step * size(x) * at.nearest[i];
      behind[i] -= step * size(x) * at.nearest[i];
    }
    const auto after = path.curvature(ahead, pressure, at.nearest);
    const auto before = path.curvature(behind, pressure, at.nearest);
    if (!after || !before || *after * *before >= 0) continue;
    if ((*after - *before) * at.push * pressure > 0) return false;
    if (std::abs(at.nearest_value) < 0.3 * std::min(std::abs(*after), std::abs(*before))) {
      return true;
    }
  }
  return false;
}

Judgement judge_turning_back(const PlainPath& path, const CriticalPoint& limit) {
  const double pressure = limit.pressure_kpa / kpa_per_mpa;
  const ScaledState x = path.scaled(limit.state);
  const auto at = path.stiffness(x, pressure);
  if (!at) return wrong("limit point cannot exist");
  if (!turns_there(path, x, pressure, *at)) {
    return wrong("limit point", numbers("eigenvalue %g there", at->nearest_value, 0));
  }
  const PlainPath::End before = path.follow_to(pressure * (1 - 1e-4));
  if (!before.arrived || distance(before.x, x) > 0.6 * size(x)) {
    return wrong("limit point", numbers("load stepping ends at %g kPa, not at %g; apart by %g",
                                        before.pressure_mpa * kpa_per_mpa, limit.pressure_kpa,
                                        distance(before.x, x)));
  }
  const PlainPath::End after = path.follow_to(pressure * (1 + 1e-3), false);
  if (after.arrived && distance(after.x, x) < 0.3 * size(x)) {
    return wrong("limit point", "load stepping goes on beyond it");
  }
  return refused("limit point", limit.name);
}

/// Load stepping gets there; beyond, it does not arrive, or where nothing can be.
Judgement judge_end(const PlainPath& path, const CriticalPoint& limit) {
  if (!is_finite(limit.state) || limit.name.empty()) return wrong("not a number");
  if (limit.kind == CriticalKind::limit_point) return judge_turning_back(path, limit);
  const double pressure = limit.pressure_kpa / kpa_per_mpa;
  const PlainPath::End before = path.follow_to(0.99 * pressure);
  const PlainPath::End after = path.follow_to(1.02 * pressure, false);
  const bool closure = limit.kind == CriticalKind::closure;
  const char* kind = closure ? "closure" : "asymptote";
  if (!before.arrived) {
    return wrong(kind, numbers("load stepping ends at %g of %g kPa",
                               before.pressure_mpa * kpa_per_mpa, limit.pressure_kpa));
  }
  const bool closed = after.x[coordinate::inner_growth] < -0.99;
  const bool endless = size(after.x) > 300;
  if (after.arrived && !(closure ? closed : endless)) return wrong(kind, "there are states beyond");
  return refused(kind, limit.name);
}

Judgement judge_loss(const PlainPath& path, const Section& section, double pressure_kpa,
                     const std::string& message) {
  const PlainPath::End end = path.follow_to(pressure_kpa / kpa_per_mpa, false);
  const std::string stepped = numbers("; load stepping comes to %g of %g kPa",
                                      end.pressure_mpa * kpa_per_mpa, pressure_kpa);
  const Deformation q{end.x[0], end.x[1] / section.outer_radius_mm,
                      end.x[2] * section.inner_radius_mm, end.x[3] / section.outer_radius_mm,
                      end.x[4] / section.outer_radius_mm};
  if (message.find("stretch limit") != std::string::npos) {
    if (stretch_limit_used(section, q) > 0.9) return refused("stretch limit", message);
    return wrong("stretch limit not reached", message + stepped);
  }
  if (message.find("horseshoe strand") != std::string::npos) {
    if (!end.arrived) return refused("law's end", message);
    return wrong("gave up", message + stepped);
  }
  if (message.find("hundredfold") != std::string::npos) {
    if (!end.arrived || size(end.x) > 50) return refused("growth", message);
    return wrong("gave up", message + stepped);
  }
  if (end.arrived) return wrong("gave up", message + stepped);
  if (message.find(" kPa: ") == std::string::npos) return wrong("no reason", message + stepped);
  return refused("instability", message);
}

Judgement judge(const PlainPath& path, const Section& section, const Response& response,
                std::size_t i, double pressure_kpa) {
  if (response.states[i]) return judge_state(path, *response.states[i]);
  for (const CriticalPoint& limit : response.critical_points) {
    const bool ends = limit.kind != CriticalKind::bifurcation;
    if (ends && limit.pressure_kpa * pressure_kpa > 0 &&
        std::abs(limit.pressure_kpa) <= std::abs(pressure_kpa)) {
      return judge_end(path, limit);
    }
  }
  if (response.status != Status::not_converged) return wrong("no reason", response.message);
  return judge_loss(path, section, pressure_kpa, response.message);
}

/// Both balances of model/effective_rods/rods.h, each against its liner's share, put to the columns
/// one by one.
Judgement judge_rods_state(const Rods& rods, Held held, const State& state) {
  if (!is_finite(state)) return wrong("not a number");
  const double e0 = state.stretch - 1;
  const double bend = state.bend_rad_per_mm[1] * rods.liner_outer_radius_mm;
  std::array<double, 2> force{};
  std::array<double, 2> stiffness{};
  for (const int half : {0, 1}) {
    const double strain = half == 0 ? e0 + bend : e0 - bend;
    force[half] = rods.halves[half].straight_stiffness_n * strain;
    stiffness[half] = rods.halves[half].straight_stiffness_n;
    for (const auto& [law, count] : rods.halves[half].columns) {
      const auto arc = law->at(strain);
      if (!arc) return wrong("beyond the law's end");
      force[half] += count * arc->force_n;
      stiffness[half] += count * arc->slope_n;
    }
  }
  const double axial = rods.axial_stiffness_n();
  const double push = state.pressure_kpa / kpa_per_mpa * rods.bore_area_mm2();
  const double pull = axial * e0 + force[0] + force[1] - push;
  const double turn =
      rods.bending_stiffness_nmm2() * state.bend_rad_per_mm[1] / rods.arm_mm + force[0] - force[1];
  const double sum = axial + stiffness[0] + stiffness[1];
  const double worst = std::max(held.stretch ? 0 : std::abs(pull), held.bend ? 0 : std::abs(turn));
  if (!(state.stretch > 0)) {
    return wrong("turned inside out", numbers("stretch %g", state.stretch, 0));
  }
  if (worst > 1e-9 * (sum * std::max(1e-3, std::abs(e0) + std::abs(bend)) + std::abs(push))) {
    return wrong("unbalanced", numbers("%g N of %g", worst, push));
  }
  return verified(state.stable ? "stable" : "unstable");
}

/// The last pressure with a state must have a column at its law's end, or a wall without length.
Judgement judge_rods_refusal(const PreparedSegment& segment, Held held, double pressure_kpa,
                             const std::string& message) {
  if (message.empty()) return wrong("no reason");
  double low = 0;
  double high = 1;
  for (int i = 0; i < 50; ++i) {
    const double middle = 0.5 * (low + high);
    const double pressure = middle * pressure_kpa;
    const Response response = predict(segment, std::span(&pressure, 1), held);
    (response.states[0] ? low : high) = middle;
  }
  const double last = low * pressure_kpa;
  const Response response = predict(segment, std::span(&last, 1), held);
  const double e0 = response.states[0]->stretch - 1;
  const Rods& rods = std::get<Rods>(segment.section);
  const double bend = response.states[0]->bend_rad_per_mm[1] * rods.liner_outer_radius_mm;
  for (const int half : {0, 1}) {
    const double strain = half == 0 ? e0 + bend : e0 - bend;
    for (const auto& column : rods.halves[half].columns) {
      const StrainRange& range = column.law->range();
      if (strain > 0.999 * range.highest || strain < 0.999 * range.lowest) {
        return refused("law's end", message);
      }
    }
  }
  const double thinnest =
      1 + e0 -
      std::abs(response.states[0]->bend_rad_per_mm[1]) * response.states[0]->outer_radius_mm;
  if (thinnest < 1e-3) return refused("no length left", message);
  return wrong("gave up", message);
}

std::vector<Judgement> all(const AtlasDesign& design, const Judgement& finding) {
  return std::vector<Judgement>(design.pressures_kpa.size(), finding);
}

}  // namespace

std::vector<Judgement> examine(const AtlasDesign& design) {
  Response response;
  std::optional<PreparedSegment> prepared;
  try {
    prepared = prepare_segment(design.segment, design.model);
    response = predict(*prepared, design.pressures_kpa, design.held);
  } catch (const UnsupportedDesign& reason) {
    const std::string words = reason.what();
    return all(design, words.size() > 20 ? refused("unsupported", words) : wrong("no reason"));
  } catch (const std::exception& reason) {
    return all(design, wrong("exception", reason.what()));
  }
  std::vector<Judgement> findings;
  if (const auto* rods = std::get_if<Rods>(&prepared->section)) {
    for (std::size_t i = 0; i < response.states.size(); ++i) {
      findings.push_back(response.states[i]
                             ? judge_rods_state(*rods, design.held, *response.states[i])
                             : judge_rods_refusal(*prepared, design.held, design.pressures_kpa[i],
                                                  response.message));
    }
    return findings;
  }
  const Section& section = std::get<Section>(prepared->section);
  const PlainPath path(section, design.held);
  for (std::size_t i = 0; i < response.states.size(); ++i) {
    findings.push_back(judge(path, section, response, i, design.pressures_kpa[i]));
  }
  return findings;
}

double fitting_pressure_kpa(const AtlasDesign& design) {
  double pressure = rest_shear_modulus_mpa(design.segment.liner.material.law) * kpa_per_mpa *
                    design.segment.liner.thickness_mm / design.segment.inner_radius_mm();
  try {
    const double little = 1e-6 * pressure;
    const Response response =
        predict(design.segment, design.model, std::span(&little, 1), design.held);
    if (!response.states[0]) return pressure;
    const State& state = *response.states[0];
    const double strain =
        std::max({std::abs(state.stretch - 1),
                  std::abs(state.inner_radius_mm / design.segment.inner_radius_mm() - 1),
                  state.bend_magnitude_rad_per_mm() * design.segment.outer_radius_mm(),
                  std::abs(state.twist_rad_per_mm) * design.segment.outer_radius_mm()});
    if (strain > 0) pressure = 0.1 * little / strain;
  } catch (const std::exception&) {
    return pressure;
  }
  return pressure;
}

double reference_pressure_kpa(const AtlasDesign& design) {
  const double fitting = fitting_pressure_kpa(design);
  try {
    const double far = 1e3 * fitting;
    const Response response =
        predict(design.segment, design.model, std::span(&far, 1), design.held);
    for (const CriticalPoint& limit : response.critical_points) {
      if (limit.kind != CriticalKind::bifurcation) return limit.pressure_kpa;
    }
  } catch (const std::exception&) {
    return fitting;
  }
  return fitting;
}

}  // namespace latticast
