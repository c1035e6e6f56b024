// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/horseshoe/arc_integrals.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "model/numerics/gauss.h"

namespace latticast {
namespace {

// Below this kappa^2 the slope grows too slowly along an arc of 1 rad for a boundary layer.
constexpr double weak_pull = 1;

// A thin arc that is pulled hard bends only near its end, and the rest falls off exponentially.
// Integrals stop this many decay lengths away from the end; what they leave out is below exp(-40)
// of the whole.
constexpr double layer_lengths = 20;

// kappa^2 and what goes with it.
struct Pull {
  double beta;
  double delta;
  double rate_squared;           // kappa^2
  double rate_squared_by_force;  // d kappa^2 / d beta
};

Pull pull_of(const Arc& arc, double beta) {
  const double delta = arc.compliance * beta;
  return {beta, delta, 4 * beta * (1 + delta), 4 * (1 + 2 * delta)};
}

// W(theta) by z = sin^2(theta/2).
double potential(const Pull& pull, double z) {
  return pull.rate_squared * z - 4 * pull.beta * pull.delta * z * z;
}

// A stretch of v and what the pendulum does on it.
class Pendulum {
 public:
  Pendulum(const Pull& pull, double v_end)
      : rate_(std::sqrt(std::abs(pull.rate_squared))),
        pulled_(pull.rate_squared > 0),
        v_end_(v_end),
        sign_(pulled_ ? 1 : -1),
        end_(pulled_ ? std::exp(-2 * rate_ * v_end) : std::cos(rate_ * v_end)) {}

  // How much of v, counted back from the end, has to be walked: before that, the arc lies along the
  // force line to within rounding.
  double reach() const { return pulled_ ? std::min(v_end_, layer_lengths / rate_) : v_end_; }

  struct State {
    double q;      // Q
    double slope;  // theta' = dQ/dv
  };

  State at(double before_end) const {
    if (!pulled_) {
      const double phase = rate_ * (v_end_ - before_end);
      return {std::sin(phase) / (rate_ * end_), std::cos(phase) / end_};
    }
    // Both sinh and cosh may overflow; their ratios to cosh at the end do not.
    const double decay = std::exp(-rate_ * before_end);
    const double reflected = end_ / decay;
    const double factor = 1 / (1 + end_);
    return {(decay - reflected) * factor / rate_, (decay + reflected) * factor};
  }

  // d log Q^2 / d kappa^2 at fixed v and v_end.
  double log_by_rate_squared(const State& state, double before_end, double q_end) const {
    const double v = v_end_ - before_end;
    return (v * state.slope / state.q - 1) / (sign_ * rate_ * rate_) - v_end_ * q_end;
  }

  // No arc beyond a quarter of the period.
  bool exists() const { return pulled_ || (end_ > 0 && rate_ * v_end_ < 1.6); }

 private:
  double rate_;  // |kappa|
  bool pulled_;
  double v_end_;
  double sign_;  // of kappa^2
  double end_;   // exp(-2 kappa v_end), or cos(|kappa| v_end)
};

// z from Q^2 = z (1 - ratio z), with ratio = delta/(1 + delta), and d alpha / dv.
struct Turned {
  double z;
  double root;    // 1 - 2 ratio z
  double length;  // d alpha / dv
};

Turned turned(double q_squared, double ratio) {
  const double z = 2 * q_squared / (1 + std::sqrt(1 - 4 * ratio * q_squared));
  const double root = 1 - 2 * ratio * z;
  return {z, root, 2 * std::sqrt((1 - ratio * z) / (1 - z)) / root};
}

}  // namespace

ArcQuadrature::ArcQuadrature(int points) {
  const GaussRule rule = gauss_legendre(points);
  const std::size_t n = rule.points.size();
  for (std::size_t i = 0; i < n; ++i) {
    points_.push_back((1 + rule.points[i]) / 2);
    weights_.push_back(rule.weights[i] / 2);
  }
  std::vector<double> legendre((n + 1) * n, 1.0);  // legendre[k n + i] = P_k(x_i)
  for (std::size_t i = 0; i < n; ++i) legendre[n + i] = rule.points[i];
  for (std::size_t k = 1; k < n; ++k) {
    for (std::size_t i = 0; i < n; ++i) {
      const auto degree = static_cast<double>(k);
      legendre[(k + 1) * n + i] = ((2 * degree + 1) * rule.points[i] * legendre[k * n + i] -
                                   degree * legendre[(k - 1) * n + i]) /
                                  (degree + 1);
    }
  }
  // The interpolant's Legendre series, integrated term by term:
  // (2k+1) times the integral of P_k from x to 1 is P_(k-1)(x) - P_(k+1)(x).
  to_end_.resize(n * n);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      double sum = 1 - rule.points[i];
      for (std::size_t k = 1; k < n; ++k) {
        sum += legendre[k * n + j] * (legendre[(k - 1) * n + i] - legendre[(k + 1) * n + i]);
      }
      to_end_[i * n + j] = weights_[j] * sum / 2;
    }
  }
}

ArcIntegrals ArcQuadrature::integrals(const Arc& arc, const BentArc& bent) const {
  return bent.chart == ArcChart::slope ? along_slope(arc, bent) : along_pendulum(arc, bent);
}

ArcIntegrals ArcQuadrature::along_slope(const Arc& arc, const BentArc& bent) const {
  const Pull pull = pull_of(arc, bent.force);
  const auto potential_by_force = [&arc, &pull](double z) {
    return 4 * z * (1 + 2 * pull.delta) - 8 * arc.compliance * pull.beta * z * z;
  };
  const double end_cosine = std::cos(bent.end);
  const double end_sine = std::sin(bent.end);
  const double end_z = (1 - end_cosine) / 2;
  const double end_potential = potential(pull, end_z);
  const double end_potential_by_force = potential_by_force(end_z);
  const double end_rise = 2 * pull.beta * end_sine * (1 + pull.delta * end_cosine);  // dW/dtheta

  ArcIntegrals sum;
  double steep = 0;
  double steep_lag = 0;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const double half_sine = std::sin(bent.end * points_[i] / 2);
    const double z = half_sine * half_sine;
    const double square = 1 - end_potential + potential(pull, z);
    const double length = bent.end * weights_[i] / std::sqrt(square);
    const double bend = 2 * z * (1 + 2 * pull.delta * (1 - z));
    const double by_force = (end_potential_by_force - potential_by_force(z)) / (2 * square);
    sum.angle += length;
    sum.angle_by_force += by_force * length;
    sum.lag += bend * length;
    sum.lag_by_force += (4 * arc.compliance * z * (1 - z) + bend * by_force) * length;
    steep += length / square;
    steep_lag += bend * length / square;
  }
  sum.angle_by_end = 1 + end_rise / 2 * steep;
  sum.lag_by_end = 2 * end_z * (1 + 2 * pull.delta * (1 - end_z)) + end_rise / 2 * steep_lag;
  return sum;
}

ArcIntegrals ArcQuadrature::along_pendulum(const Arc& arc, const BentArc& bent) const {
  const Pull pull = pull_of(arc, bent.force);
  const double ratio = pull.delta / (1 + pull.delta);
  const double ratio_by_force = arc.compliance / ((1 + pull.delta) * (1 + pull.delta));
  const Pendulum pendulum(pull, bent.end);
  if (!pendulum.exists()) return {.angle = std::nan("")};
  const double reach = pendulum.reach();
  const double q_end = pendulum.at(0).q;
  const double log_by_end = -2 * pull.rate_squared * q_end;  // d log Q^2 / d v_end

  ArcIntegrals sum;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const double before_end = reach * (1 - points_[i]);
    const double weight = reach * weights_[i];
    const Pendulum::State state = pendulum.at(before_end);
    const double q_squared = state.q * state.q;
    const auto [z, root, length] = turned(q_squared, ratio);
    const double length_by_z =
        length / 2 * (1 / (1 - z) - ratio / (1 - ratio * z) + 4 * ratio / root);
    const double length_by_ratio = length * z * (2 / root - 0.5 / (1 - ratio * z));
    const double bend = 2 * z * (1 + 2 * pull.delta * (1 - z));
    const double bend_by_z = 2 + 4 * pull.delta * (1 - 2 * z);
    const double log_by_force =
        pendulum.log_by_rate_squared(state, before_end, q_end) * pull.rate_squared_by_force;
    const double z_by_force = (q_squared * log_by_force + z * z * ratio_by_force) / root;
    const double z_by_end = q_squared * log_by_end / root;
    const double length_by_force = length_by_z * z_by_force + length_by_ratio * ratio_by_force;
    sum.angle += weight * (length - 2);
    sum.angle_by_force += weight * length_by_force;
    sum.angle_by_end += weight * length_by_z * z_by_end;
    sum.lag += weight * length * bend;
    sum.lag_by_force +=
        weight * (length_by_force * bend +
                  length * (bend_by_z * z_by_force + 4 * arc.compliance * z * (1 - z)));
    sum.lag_by_end += weight * z_by_end * (length_by_z * bend + length * bend_by_z);
  }
  const auto [z, root, length] = turned(q_end * q_end, ratio);
  sum.angle += 2 * bent.end;
  sum.angle_by_end += length;
  sum.lag_by_end += length * 2 * z * (1 + 2 * pull.delta * (1 - z));
  return sum;
}

double ArcQuadrature::invariant_defect(const Arc& arc, const BentArc& bent) const {
  const Pull pull = pull_of(arc, bent.force);
  const Pendulum pendulum(pull, bent.end);
  const double ratio = pull.delta / (1 + pull.delta);
  const bool by_slope = bent.chart == ArcChart::slope;
  const double end_potential = potential(pull, end_sine_squared(arc, bent));
  const double reach = by_slope ? bent.end : pendulum.reach();
  const std::size_t n = points_.size();
  std::vector<double> turning(n);    // theta'' d alpha
  std::vector<double> invariant(n);  // theta'^2 as the invariant has it
  for (std::size_t i = 0; i < n; ++i) {
    const double before_end = reach * (1 - points_[i]);
    double z = 0;
    double length = 0;
    if (by_slope) {
      z = std::pow(std::sin((bent.end - before_end) / 2), 2);
      length = 1 / std::sqrt(1 - end_potential + potential(pull, z));
    } else {
      const Turned at = turned(std::pow(pendulum.at(before_end).q, 2), ratio);
      z = at.z;
      length = at.length;
    }
    invariant[i] = 1 - end_potential + potential(pull, z);
    turning[i] =
        pull.beta * 2 * std::sqrt(z * (1 - z)) * (1 + pull.delta * (1 - 2 * z)) * length * reach;
  }
  double largest = 0;
  double scale = 1;
  for (std::size_t i = 0; i < n; ++i) {
    double slope = 1;
    for (std::size_t j = 0; j < n; ++j) slope -= to_end_[i * n + j] * turning[j];
    largest = std::max(largest, std::abs(slope * slope - invariant[i]));
    scale = std::max(scale, slope * slope);
  }
  return largest / scale;
}

double end_sine_squared(const Arc& arc, const BentArc& bent) {
  if (bent.chart == ArcChart::slope) return std::pow(std::sin(bent.end / 2), 2);
  const Pull pull = pull_of(arc, bent.force);
  const double q = Pendulum(pull, bent.end).at(0).q;
  return turned(q * q, pull.delta / (1 + pull.delta)).z;
}

ArcChart better_chart(const Arc& arc, const BentArc& bent) {
  const double strength =
      pull_of(arc, bent.force).rate_squared * arc.half_angle_rad * arc.half_angle_rad;
  const bool pulled = std::abs(strength) > weak_pull && end_sine_squared(arc, bent) < 0.5;
  return pulled ? ArcChart::pendulum : ArcChart::slope;
}

BentArc rewritten(const Arc& arc, const BentArc& bent, ArcChart chart) {
  if (chart == bent.chart) return bent;
  const double z = end_sine_squared(arc, bent);
  if (chart == ArcChart::slope) return {chart, bent.force, 2 * std::asin(std::sqrt(z))};
  const Pull pull = pull_of(arc, bent.force);
  const double rate = std::sqrt(std::abs(pull.rate_squared));
  const double q = std::sqrt(potential(pull, z) / pull.rate_squared);  // tanh(kappa v_end)/kappa
  const double v = pull.rate_squared > 0 ? std::atanh(rate * q) : std::atan(rate * q);
  return {chart, bent.force, v / rate};
}

}  // namespace latticast
