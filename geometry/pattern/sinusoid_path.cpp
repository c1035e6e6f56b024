// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/pattern/sinusoid_path.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/core.h>

#include "design/text/written_number.h"
#include "design/units.h"
#include "geometry/pattern/link_chain.h"
#include "numerics/root_search.h"

namespace latticast {
namespace {

constexpr double widest_phase_step = 0.4;  // in rad of the wave's phase
constexpr int samples_per_wave = 96;
constexpr double sample_step = 0.1;         // in rad, between trial feet of a perpendicular
constexpr double fully_stretched = 1.001;   // length over chord that is left
constexpr double measured_to_worst = 1.05;  // chords are measured at a few places only
constexpr double amplitude_step = 0.02;     // of the amplitude, between remedies that are tried

// One half wave with s = scale x, t = scale slope sin(x), x from 0 to pi.
struct Wave {
  double scale = 0;  // c/pi
  double slope = 0;  // pi A/c, the largest

  double amplitude() const { return scale * slope; }
  // ds/dx over the scale: square root of 1 + t'^2.
  double speed(double x) const { return std::hypot(1, slope * std::cos(x)); }
  double curvature(double x) const { return slope * std::sin(x) / std::pow(speed(x), 3) / scale; }
  double length() const {
    const double modulus = slope / std::hypot(1, slope);
    return 2 * scale * std::hypot(1, slope) * std::comp_ellint_2(modulus);
  }
};

Wave wave_of(const SinusoidStrand& strand) {
  const double scale = link_chord_mm(strand) / pi;
  return {scale, strand.shape.amplitude_mm / scale};
}

// A point of the offset curve at `offset` from the centre line, outwards positive.
PlanePoint beside(const Wave& wave, double x, double offset) {
  const double turn = std::atan(wave.slope * std::cos(x));
  return {wave.scale * x - offset * std::sin(turn),
          wave.amplitude() * std::sin(x) + offset * std::cos(turn)};
}

// Between the offset curve of a half wave and the chord line.
double area_below(const Wave& wave, double offset) {
  const double turn = std::atan(wave.slope);
  return 2 * wave.amplitude() * wave.scale + offset * wave.length() +
         offset * offset * (turn + 0.5 * std::sin(2 * turn));
}

// One edge of a half wave as chords. Inner corners are moved outwards by about a twelfth of the
// local chord squared times the curvature, all by one factor, which makes the area exact.
class Edge {
 public:
  Edge(const Wave& wave, double offset, int steps) : wave_(wave), offset_(offset), steps_(steps) {
    const double wanted = area_below(wave, offset);
    double factor = 1;
    double before = 0;
    double area_before = area_with(0);
    for (int i = 0; i < 6; ++i) {
      const double area = area_with(factor);
      if (area == area_before) break;
      const double next = factor + (wanted - area) * (factor - before) / (area - area_before);
      before = factor;
      area_before = area;
      factor = next;
    }
    points_ = corners(factor);
  }

  const std::vector<PlanePoint>& points() const { return points_; }

  // Between chords and curve, at most.
  double distance() const {
    double worst = 0;
    for (int i = 0; i < steps_; ++i) {
      for (const double part : {0.0, 0.25, 0.5, 0.75}) {
        const PlanePoint on = beside(wave_, (i + part) * pi / steps_, offset_);
        worst = std::max(worst, distance_to_chord(points_[i], points_[i + 1], on));
      }
    }
    return measured_to_worst * worst;
  }

  double longest_chord() const {
    double longest = 0;
    for (int i = 0; i < steps_; ++i) {
      const PlanePoint& a = points_[i];
      const PlanePoint& b = points_[i + 1];
      longest = std::max(longest, std::hypot(b.u - a.u, b.z - a.z));
    }
    return longest;
  }

 private:
  static double distance_to_chord(const PlanePoint& a, const PlanePoint& b, const PlanePoint& p) {
    const double length = std::hypot(b.u - a.u, b.z - a.z);
    if (length == 0) return std::hypot(p.u - a.u, p.z - a.z);
    return std::abs((b.u - a.u) * (p.z - a.z) - (b.z - a.z) * (p.u - a.u)) / length;
  }

  std::vector<PlanePoint> corners(double factor) const {
    std::vector<PlanePoint> result;
    result.reserve(steps_ + 1);
    const double step = pi / steps_;
    for (int i = 0; i <= steps_; ++i) {
      const double x = i * step;
      const double chord = wave_.scale * wave_.speed(x) * step;
      const double curvature = i == 0 || i == steps_ ? 0 : wave_.curvature(x);
      const double out = curvature * (1 + offset_ * curvature) * chord * chord / 12;
      result.push_back(beside(wave_, x, offset_ + factor * out));
    }
    return result;
  }

  double area_with(double factor) const {
    const std::vector<PlanePoint> corner = corners(factor);
    double area = 0;
    for (int i = 0; i < steps_; ++i) {
      area += 0.5 * (corner[i].z + corner[i + 1].z) * (corner[i + 1].u - corner[i].u);
    }
    return area;
  }

  Wave wave_;
  double offset_;
  int steps_;
  std::vector<PlanePoint> points_;
};

// Both edges, with as few steps as the flatness allows.
struct Edges {
  int steps = 0;
  Edge outer;
  Edge inner;

  double distance() const { return std::max(outer.distance(), inner.distance()); }
};

Edges edges_of(const SinusoidStrand& strand, double flatness) {
  const Wave wave = wave_of(strand);
  const double half = 0.5 * strand.width_mm;
  const double bend = wave.amplitude() * (1 + half * wave.curvature(0.5 * pi));
  const double widest = widest_phase_step / std::max(1.0, wave.slope);
  const double guess = std::max(pi / widest, pi * std::sqrt(bend / (12 * flatness)));
  for (int steps = std::max(4, static_cast<int>(guess));; steps += 1 + steps / 16) {
    Edges edges{steps, Edge(wave, half, steps), Edge(wave, -half, steps)};
    if (edges.distance() <= flatness) return edges;
  }
}

bool folds_over(const SinusoidStrand& strand) {
  return strand.width_mm >= 2 * smallest_radius_mm(strand);
}

std::string fold_problem(const SinusoidStrand& strand) {
  const double radius = smallest_radius_mm(strand);
  // The radius falls with the amplitude, and with the square of the number of waves.
  const double amplitude = 0.999 * strand.shape.amplitude_mm * 2 * radius / strand.width_mm;
  const double waves = strand.shape.waves * std::sqrt(2 * radius / strand.width_mm);
  const double whole = 0.5 * (std::ceil(2 * waves) - 1);
  std::string remedy = fmt::format("amplitude {} mm, or a width below {} mm", written(amplitude, 4),
                                   written(2 * radius, 6));
  if (whole >= 0.5) remedy = fmt::format("{} waves, or ", written(whole, 6)) + remedy;
  return fmt::format(
      "{} mm wide, it folds over itself at its crests, which have a radius of {} mm: {}, "
      "avoids it",
      written(strand.width_mm, 6), written(radius, 4), remedy);
}

bool in_one_piece(const SinusoidStrand& strand) {
  return draw_strand(strand, trial_flatness_mm(strand.width_mm)).in_one_piece;
}

std::string parted_problem(const SinusoidStrand& strand) {
  std::string remedy = "use a smaller amplitude or a steeper angle";
  for (int step = 1; step * amplitude_step < 1 - 0.5 * amplitude_step; ++step) {
    const double part = 1 - step * amplitude_step;
    SinusoidStrand smaller = strand;
    smaller.shape.amplitude_mm *= part;
    if (!in_one_piece(smaller)) continue;
    remedy = fmt::format("amplitude {} mm keeps it whole", written(smaller.shape.amplitude_mm, 4));
    break;
  }
  return "its waves reach past the segment's end, and the level cut there parts it; " + remedy;
}

// Of a place (s, t) from the endless wave. The nearest point is at most half a wave away along the
// chord line, since one a whole wave nearer lies as far across.
double distance_to_wave(const Wave& wave, double s, double t) {
  const double amplitude = wave.amplitude();
  const double middle = s / wave.scale;
  const auto squared = [&](double x) {
    const double along = wave.scale * x - s;
    const double across = amplitude * std::sin(x) - t;
    return along * along + across * across;
  };
  double nearest = middle;
  double least = squared(middle);
  const double reach = std::min(pi, std::sqrt(least) / wave.scale);
  const int samples = static_cast<int>(std::ceil(reach / sample_step));
  for (int i = 1; i <= samples; ++i) {
    for (const double x : {middle - reach * i / samples, middle + reach * i / samples}) {
      const double here = squared(x);
      if (here >= least) continue;
      least = here;
      nearest = x;
    }
  }
  // Newton's method for the foot of the perpendicular, as long as it comes nearer.
  double x = nearest;
  for (int i = 0; i < 8; ++i) {
    const double across = amplitude * std::sin(x) - t;
    const double slope = amplitude * std::cos(x);
    const double first = wave.scale * (wave.scale * x - s) + slope * across;
    const double second =
        wave.scale * wave.scale + slope * slope - amplitude * std::sin(x) * across;
    if (!(second > 0)) break;
    const double next = x - first / second;
    const double here = squared(next);
    if (!(here < least)) break;
    least = here;
    x = next;
  }
  return std::sqrt(least);
}

/// Which way a link bulges.
int bulge_of(int link) {
  return link % 2 == 0 ? 1 : -1;
}

struct EdgeStep {
  int link;
  int step;
  bool outer;
};

/// Both ends of a joint are the same for both its half waves.
PlanePoint edge_point(const SinusoidStrand& strand, const StrandFrame& frame, const Edges& edges,
                      const EdgeStep& at) {
  const double chord = link_chord_mm(strand);
  const int side = bulge_of(at.link);
  if (at.step == 0 || at.step == edges.steps) {
    const double turn = std::atan(wave_of(strand).slope);
    const double offset = (at.outer ? 0.5 : -0.5) * strand.width_mm;
    const double along = (at.step == 0 ? -offset : offset) * std::sin(turn);
    return frame.at((at.link + (at.step == 0 ? 0 : 1)) * chord + along,
                    offset * side * std::cos(turn));
  }
  const PlanePoint& point = (at.outer ? edges.outer : edges.inner).points()[at.step];
  return frame.at(at.link * chord + point.u, side * point.z);
}

DrawnCurve edge_curve(const SinusoidStrand& strand, const StrandFrame& frame, int link,
                      bool outer) {
  const double chord = link_chord_mm(strand);
  const int side = bulge_of(link);
  return DrawnCurve{.shape = SinusoidOffset{.start = frame.at(link * chord, 0),
                                            .along = frame.along,
                                            .bulge = {side * frame.right.u, side * frame.right.z},
                                            .chord_mm = chord,
                                            .amplitude_mm = strand.shape.amplitude_mm,
                                            .offset_mm = (outer ? 0.5 : -0.5) * strand.width_mm},
                    .part = CurvePart::strand,
                    .link = link,
                    .side = outer ? side : -side};
}

}  // namespace

double link_chord_mm(const SinusoidStrand& strand) {
  return strand.length_mm / (2 * strand.shape.waves * std::sin(radians(strand.angle_deg)));
}

double link_length_mm(const SinusoidStrand& strand) {
  return wave_of(strand).length();
}

double largest_slope_deg(const SinusoidStrand& strand) {
  return degrees(std::atan(wave_of(strand).slope));
}

double reach_mm(const SinusoidStrand& strand) {
  return strand.shape.amplitude_mm;
}

double smallest_radius_mm(const SinusoidStrand& strand) {
  return 1 / wave_of(strand).curvature(0.5 * pi);
}

SinusoidStrand closed(SinusoidStrand strand) {
  return strand;
}

Sinusoid stretched(const SinusoidStrand& strand, double stretch) {
  const double chord = stretch * link_chord_mm(strand);
  const double ratio = std::max(fully_stretched, link_length_mm(strand) / chord);
  const auto excess = [&](double slope) { return Wave{1 / pi, slope}.length() - ratio; };
  const double highest = 0.5 * pi * ratio;  // a half wave is longer than twice its amplitude
  const double slope = bracketed_root(excess, 0, excess(0), highest, excess(highest), 0);
  return {.amplitude_mm = slope * chord / pi, .waves = strand.shape.waves};
}

double gap_within_mm(const SinusoidStrand& strand) {
  return 2 * smallest_radius_mm(strand) - strand.width_mm;
}

double centre_line_distance_mm(const SinusoidStrand& strand, double along_mm, double across_mm) {
  return distance_to_wave(wave_of(strand), along_mm, across_mm);
}

double centre_distance_mm(const SinusoidStrand& strand, double spacing_u_mm) {
  const Wave wave = wave_of(strand);
  const StrandFrame frame = strand_frame(0, strand.angle_deg);
  const auto at = [&](double x) {
    return distance_to_wave(wave, wave.scale * x - spacing_u_mm * frame.along.u,
                            wave.amplitude() * std::sin(x) - spacing_u_mm * frame.right.u);
  };
  const double step = 2 * pi / samples_per_wave;
  double nearest = 0;
  double least = HUGE_VAL;
  for (int i = 0; i < samples_per_wave; ++i) {
    const double here = at(i * step);
    if (here >= least) continue;
    least = here;
    nearest = i * step;
  }
  double reach = step;
  for (int i = 0; i < 12; ++i) {
    for (const double x : {nearest - 0.5 * reach, nearest + 0.5 * reach}) {
      const double here = at(x);
      if (here >= least) continue;
      least = here;
      nearest = x;
    }
    reach *= 0.5;
  }
  return least;
}

std::optional<std::string> closing_problem(const SinusoidStrand& /*strand*/) {
  return std::nullopt;
}

std::optional<std::string> own_problem(const SinusoidStrand& strand) {
  if (folds_over(strand)) return fold_problem(strand);
  if (!in_one_piece(strand)) return parted_problem(strand);
  return std::nullopt;
}

DrawnStrand draw_strand(const SinusoidStrand& strand, double flatness_mm) {
  const Edges edges = edges_of(strand, flatness_mm);
  const StrandFrame frame = strand_frame(strand.start_u_mm, strand.angle_deg);
  LinkChain chain{.frame = frame,
                  .link_chord_mm = link_chord_mm(strand),
                  .length_mm = strand.length_mm,
                  .flatness_mm = flatness_mm,
                  .steps = edges.steps,
                  .edge = {},
                  .side = {},
                  .corner = {}};
  chain.edge = [&](int link, int step, bool outer) {
    return edge_point(strand, frame, edges, {link, step, outer});
  };
  chain.side = [&](int link, bool outer) { return edge_curve(strand, frame, link, outer); };
  DrawnStrand drawn = draw_chain(chain);
  const double off = edges.distance();
  const double longest = std::max(edges.outer.longest_chord(), edges.inner.longest_chord());
  drawn.error = {off, static_cast<double>(drawn.links.size()) * off * longest};
  return drawn;
}

}  // namespace latticast
