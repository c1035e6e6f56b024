// SPDX-License-Identifier: GPL-3.0-or-later
// Tip of an inflated chain: the closed form against frames integrated along it.
//   shape_methods  for the page: what each method needs for a tip good to 0.01 mm and to 1e-9 mm
//   shape          every point of the plot
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Dense>
#include <fmt/format.h>

#include "bench/cvode_path.h"
#include "bench/study.h"
#include "model/chain.h"
#include "model/segment_response.h"
#include "model/shape/shape.h"
#include "tests/unit/model/segments.h"

namespace {

using namespace latticast;
using Vector = Eigen::Vector3d;
using Matrix = Eigen::Matrix3d;

/// One segment's inflated state as an integrator sees it: the Darboux vector at height z in the
/// section's own axes, per reference length.
struct Stretch {
  double length_mm;
  double stretch;
  std::array<double, 3> first;  // Darboux vector in the turning frame
  double turn;                  // of that frame against the material

  Vector darboux(double z) const {
    const double c = std::cos(turn * z);
    const double s = std::sin(turn * z);
    return {c * first[0] - s * first[1], s * first[0] + c * first[1], first[2] - turn};
  }
};

struct Case {
  std::string name;
  std::vector<Segment> segments;
  std::vector<State> states;
};

struct Pose {
  Vector origin = Vector::Zero();
  Matrix rotation = Matrix::Identity();
};

std::vector<Stretch> stretches(const Case& what) {
  std::vector<Stretch> result;
  for (std::size_t i = 0; i < what.states.size(); ++i) {
    const State& state = what.states[i];
    result.push_back({what.segments[i].length_mm,
                      state.stretch,
                      {state.bend_rad_per_mm[1], -state.bend_rad_per_mm[0],
                       state.twist_rad_per_mm + state.frame_turn_rad_per_mm},
                      state.frame_turn_rad_per_mm});
  }
  return result;
}

Matrix crossed(const Vector& v) {
  Matrix m;
  m << 0, -v[2], v[1], v[2], 0, -v[0], -v[1], v[0], 0;
  return m;
}

/// exp of a rotation vector.
Matrix turned_by(const Vector& v) {
  const double angle = v.norm();
  if (angle == 0) return Matrix::Identity();
  return Eigen::AngleAxisd(angle, v / angle).toRotationMatrix();
}

Pose rate(const Stretch& along, double z, const Pose& at) {
  return {along.stretch * at.rotation.col(2), at.rotation * crossed(along.darboux(z))};
}

Pose moved(const Pose& at, const Pose& by, double h) {
  return {at.origin + h * by.origin, at.rotation + h * by.rotation};
}

using Step = Pose (*)(const Stretch&, double z, double h, const Pose&);

Pose euler(const Stretch& along, double z, double h, const Pose& at) {
  return moved(at, rate(along, z, at), h);
}

Pose midpoint(const Stretch& along, double z, double h, const Pose& at) {
  const Pose middle = moved(at, rate(along, z, at), h / 2);
  return moved(at, rate(along, z + h / 2, middle), h);
}

Pose runge_kutta(const Stretch& along, double z, double h, const Pose& at) {
  const Pose a = rate(along, z, at);
  const Pose b = rate(along, z + h / 2, moved(at, a, h / 2));
  const Pose c = rate(along, z + h / 2, moved(at, b, h / 2));
  const Pose d = rate(along, z + h, moved(at, c, h));
  return moved(moved(at, a, h / 6), moved(moved(b, c, 1), d, 0.5), h / 3);
}

/// Rotations stay rotations: the Darboux vector of the middle, exponentiated.
Pose lie_midpoint(const Stretch& along, double z, double h, const Pose& at) {
  const Vector v = along.darboux(z + h / 2);
  const Matrix middle = at.rotation * turned_by(v * (h / 2));
  return {at.origin + h * along.stretch * middle.col(2), at.rotation * turned_by(v * h)};
}

Vector walked(const std::vector<Stretch>& all, Step step, int steps) {
  Pose at;
  for (const Stretch& along : all) {
    const double h = along.length_mm / steps;
    for (int i = 0; i < steps; ++i) at = step(along, i * h, h, at);
  }
  return at.origin;
}

/// The same by CVODE.
Vector walked(const std::vector<Stretch>& all, double tolerance) {
  std::array<double, 12> y = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
  CvodePath path(12, tolerance, tolerance / 100);
  for (const Stretch& along : all) {
    const auto equation = [&along](double z, const double* from, double* to) {
      Pose at;
      at.origin = Eigen::Map<const Vector>(from);
      at.rotation = Eigen::Map<const Matrix>(from + 3);
      const Pose by = rate(along, z, at);
      Eigen::Map<Vector>{to} = by.origin;
      Eigen::Map<Matrix>(to + 3) = by.rotation;
    };
    if (!path.walk(equation, along.length_mm, y)) return Vector::Constant(NAN);
  }
  return Eigen::Map<const Vector>(y.data());
}

/// The tip in long double: Taylor series of the frame along the material, 4 mm at a time.
Vector reference_tip(const std::vector<Stretch>& all) {
  using Real = long double;
  using LongVector = Eigen::Matrix<Real, 3, 1>;
  using LongMatrix = Eigen::Matrix<Real, 3, 3>;
  constexpr int order = 30;
  LongVector origin = LongVector::Zero();
  LongMatrix rotation = LongMatrix::Identity();
  for (const Stretch& along : all) {
    const int steps = static_cast<int>(std::ceil(along.length_mm / 4));
    const Real h = Real{along.length_mm} / steps;
    const Real turn = along.turn;
    for (int n = 0; n < steps; ++n) {
      // Terms of the Darboux matrix, whose cosine and sine turn by a quarter at each derivative.
      std::array<LongMatrix, order> twist;
      Real factor = 1;
      for (int k = 0; k < order; ++k) {
        const Real phase = turn * n * h + k * std::acos(Real{-1}) / 2;
        const Real c = factor * std::cos(phase);
        const Real s = factor * std::sin(phase);
        const Real x = c * along.first[0] - s * along.first[1];
        const Real y = s * along.first[0] + c * along.first[1];
        const Real t = k == 0 ? along.first[2] - turn : 0;
        twist[k] << 0, -t, y, t, 0, -x, -y, x, 0;
        factor *= turn / (k + 1);
      }
      std::array<LongMatrix, order + 1> terms;
      terms[0] = rotation;
      Real power = 1;
      LongMatrix next = rotation;
      for (int k = 0; k < order; ++k) {
        LongMatrix sum = LongMatrix::Zero();
        for (int j = 0; j <= k; ++j) sum += terms[j] * twist[k - j];
        origin += along.stretch * (power * h / (k + 1)) * terms[k].col(2);
        terms[k + 1] = sum / (k + 1);
        power *= h;
        next += power * terms[k + 1];
      }
      rotation = next;
    }
  }
  return origin.cast<double>();
}

std::vector<Case> cases() {
  Segment twisting = testing::paper_segment({36});
  Segment bending = testing::columns(testing::halves(16, 3.5, 2));
  twisting.length_mm = bending.length_mm = 100;
  Segment helix = testing::columns(testing::halves(8, 3.5, 2), 60);
  helix.length_mm = 400;
  const auto state = [](const Segment& segment, double pressure_kpa) {
    return predict(segment, {}, std::vector<double>{pressure_kpa}).states[0].value();
  };
  return {{"manipulator (twist 60 kPa + bend 40 kPa)",
           {twisting, bending},
           {state(twisting, 60), state(bending, 40)}},
          {"superimposed helix (400 mm at 40 kPa)", {helix}, {state(helix, 40)}}};
}

struct Trial {
  double setting;
  double error_mm;
  double seconds;
};

class Comparison {
 public:
  explicit Comparison(const Case& what)
      : what_(what), all_(stretches(what)), reference_(reference_tip(all_)) {}

  std::vector<std::pair<std::string, std::vector<Trial>>> trials() const {
    std::vector<std::pair<std::string, std::vector<Trial>>> result;
    const std::pair<const char*, Step> steps[] = {{"explicit Euler", euler},
                                                  {"midpoint", midpoint},
                                                  {"Runge-Kutta 4", runge_kutta},
                                                  {"exponential midpoint", lie_midpoint}};
    for (const auto& named : steps) {
      const Step step = named.second;
      std::vector<Trial> trials;
      for (const int count : {10, 30, 100, 300, 1000, 3000, 10000, 100000, 1000000}) {
        trials.push_back(tried(count, [&, count] { return walked(all_, step, count); }));
      }
      result.emplace_back(named.first, trials);
    }
    std::vector<Trial> trials;
    for (int digits = 3; digits <= 13; ++digits) {
      const double tolerance = std::pow(10, -digits);
      trials.push_back(tried(tolerance, [&] { return walked(all_, tolerance); }));
    }
    result.emplace_back("CVODE", trials);
    const auto closed = [&] {
      const Point tip = Shape(what_.segments, what_.states).tip().origin;
      return Vector(tip[0], tip[1], tip[2]);
    };
    result.emplace_back("closed form", std::vector{tried(0, closed)});
    return result;
  }

 private:
  Trial tried(double setting, const std::function<Vector()>& method) const {
    const double error = (method() - reference_).norm();
    Vector kept;
    return {setting, error, processor_seconds([&] { kept = method(); }, 0.005)};
  }

  Case what_;
  std::vector<Stretch> all_;
  Vector reference_;
};

/// The cheapest trial within an error, as time and setting.
std::string cheapest(const std::vector<Trial>& trials, double error_mm) {
  const Trial* best = nullptr;
  for (const Trial& trial : trials) {
    if (!(trial.error_mm <= error_mm)) continue;
    if (best == nullptr || trial.seconds < best->seconds) best = &trial;
  }
  return best == nullptr ? "not reached" : fmt::format("{:.3g} us", best->seconds * 1e6);
}

}  // namespace

// What is thrown ends the study with its message.
// NOLINTNEXTLINE(bugprone-exception-escape)
int main(int count, char** arguments) {
  const std::filesystem::path folder = study_folder(count, arguments);
  StudyTable points("shape", {"case", "method", "setting", "error_mm", "seconds"});
  StudyTable page("shape_methods",
                  {"chain", "method", "for 0.01 mm", "for 1e-9 mm", "least error (mm)"});
  for (const Case& what : cases()) {
    for (const auto& [method, trials] : Comparison(what).trials()) {
      double least = INFINITY;
      for (const Trial& trial : trials) {
        points.add({what.name, method, trial.setting, trial.error_mm, trial.seconds});
        least = std::min(least, trial.error_mm);
      }
      page.add({what.name, method, cheapest(trials, 1e-2), cheapest(trials, 1e-9), least});
    }
  }
  points.write(folder, false);
  page.write(folder);
}
