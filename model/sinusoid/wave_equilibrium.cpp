// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/sinusoid/wave_equilibrium.h"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

#include "design/units.h"
#include "model/law/link_steps.h"

namespace latticast {
namespace {

constexpr int most_wave_iterations = 10;
constexpr double lost_digits = 36;  // ln(1e16), nearly: what the series must fall by
constexpr int fewest_terms = 16;

double grading(const Wave& wave) {
  return std::pow(1 + wave.slope * wave.slope, -0.25);
}

double largest(const std::vector<double>& numbers) {
  double most = 0;
  for (const double x : numbers) most = std::max(most, std::abs(x));
  return most;
}

}  // namespace

// Of V = integral of (theta' - kappa0)^2/2 - beta cos(theta) - beta delta cos^2(theta)/2: gradient,
// Hessian and mixed derivatives, and the chord that is missing.
struct WaveSolver::Sums {
  Eigen::MatrixXd jacobian;  // of (gradient, chord) by (turn, force)
  Eigen::VectorXd residual;
};

WaveSolver::WaveSolver(const Wave& wave, int terms) : wave_(wave), terms_(terms) {
  const int count = 2 * terms;
  const double ratio = grading(wave);
  stations_.reserve(count);
  for (int i = 0; i < count; ++i) {
    const double y = (i + 0.5) * pi / (2 * count);
    const double square = std::pow(std::cos(y), 2) + std::pow(ratio * std::sin(y), 2);
    const double slope = wave.slope * ratio * std::sin(y) / std::sqrt(square);  // a sin(x)
    stations_.push_back({.stretch = std::hypot(1, slope) * ratio / square,
                         .weight = pi / (2 * count),
                         .slope = std::atan(slope)});
    for (int k = 0; k < terms; ++k) {
      sines_.push_back(std::sin((2 * k + 1) * y) / (2 * k + 1));
      cosines_.push_back(std::cos((2 * k + 1) * y));
    }
  }
  rest_.turn.assign(terms, 0);
  const Sums sums = sums_at(rest_);
  Eigen::VectorXd load = Eigen::VectorXd::Zero(terms + 1);
  load[terms] = 0.5 * pi;
  const Eigen::VectorXd slope = sums.jacobian.partialPivLu().solve(load);
  rest_.turn_by_strain.assign(slope.data(), slope.data() + terms);
  rest_.force_by_strain = slope[terms];
}

/// Of the sums over stations, at each of them.
struct WaveSolver::Terms {
  Eigen::VectorXd bending, pull, stiffening, by_force;
  double chord = 0;
  double chord_by_force = 0;
};

WaveSolver::Terms WaveSolver::terms_at(double force, std::span<const double> change) const {
  const auto count = static_cast<Eigen::Index>(stations_.size());
  const double compliance = wave_.compliance;
  Terms terms{Eigen::VectorXd(count), Eigen::VectorXd(count), Eigen::VectorXd(count),
              Eigen::VectorXd(count)};
  for (Eigen::Index i = 0; i < count; ++i) {
    const Station& station = stations_[i];
    const double theta = station.slope + change[i];
    const double sine = std::sin(theta);
    const double cosine = std::cos(theta);
    const double length = station.weight * station.stretch;
    const double pull = compliance * force;
    terms.bending[i] = station.weight / station.stretch;
    terms.pull[i] = force * sine * (1 + pull * cosine) * length;
    terms.stiffening[i] = force * (cosine + pull * (2 * cosine * cosine - 1)) * length;
    terms.by_force[i] = sine * (1 + 2 * pull * cosine) * length;
    // cos(theta) - cos(theta0), without a difference of nearly equal numbers.
    const double lengthening =
        -2 * std::sin(station.slope + 0.5 * change[i]) * std::sin(0.5 * change[i]);
    terms.chord += (lengthening + pull * cosine * cosine) * length;
    terms.chord_by_force += compliance * cosine * cosine * length;
  }
  return terms;
}

WaveSolver::Sums WaveSolver::sums_at(const WaveEquilibrium& at) const {
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const auto count = static_cast<Eigen::Index>(stations_.size());
  const Eigen::Map<const Rows> sines(sines_.data(), count, terms_);
  const Eigen::Map<const Rows> cosines(cosines_.data(), count, terms_);
  const Eigen::Map<const Eigen::VectorXd> turn(at.turn.data(), terms_);
  const Eigen::VectorXd change = sines * turn;
  const Eigen::VectorXd change_by_y = cosines * turn;
  const Terms terms = terms_at(at.force, {change.data(), stations_.size()});
  Sums sums;
  sums.residual.resize(terms_ + 1);
  sums.jacobian.resize(terms_ + 1, terms_ + 1);
  sums.residual.head(terms_) = cosines.transpose() * terms.bending.cwiseProduct(change_by_y) +
                               sines.transpose() * terms.pull;
  sums.residual[terms_] = terms.chord - 0.5 * pi * at.strain;
  sums.jacobian.topLeftCorner(terms_, terms_) =
      cosines.transpose() * terms.bending.asDiagonal() * cosines +
      sines.transpose() * terms.stiffening.asDiagonal() * sines;
  const Eigen::VectorXd mixed = sines.transpose() * terms.by_force;
  sums.jacobian.topRightCorner(terms_, 1) = mixed;
  sums.jacobian.bottomLeftCorner(1, terms_) = -mixed.transpose();
  sums.jacobian(terms_, terms_) = terms.chord_by_force;
  return sums;
}

std::optional<WaveEquilibrium> WaveSolver::corrected(WaveEquilibrium at) const {
  at.turn.resize(terms_, 0);
  bool nearly_there = false;
  Eigen::MatrixXd columns(terms_ + 1, 2);
  for (int iteration = 0; iteration < most_wave_iterations; ++iteration) {
    const Sums sums = sums_at(at);
    columns.col(0) = -sums.residual;
    columns.col(1).setZero();
    columns(terms_, 1) = 0.5 * pi;
    const Eigen::MatrixXd solved = sums.jacobian.partialPivLu().solve(columns);
    double step = 0;
    for (int k = 0; k < terms_; ++k) {
      at.turn[k] += solved(k, 0);
      step = std::max(step, std::abs(solved(k, 0)));
    }
    at.force += solved(terms_, 0);
    if (!std::isfinite(at.force) || !std::isfinite(step)) return {};
    if (nearly_there) {
      at.force_by_strain = solved(terms_, 1);
      at.turn_by_strain.assign(solved.col(1).data(), solved.col(1).data() + terms_);
      return at;
    }
    nearly_there = step <= small_step * largest(at.turn) &&
                   std::abs(solved(terms_, 0)) <= small_step * std::abs(at.force);
  }
  return {};
}

std::optional<WaveEquilibrium> WaveSolver::step(const WaveEquilibrium& here, double strain) const {
  const double length = strain - here.strain;
  WaveEquilibrium guess = here;
  guess.strain = strain;
  guess.force += length * here.force_by_strain;
  for (int k = 0; k < terms_; ++k) guess.turn[k] += length * here.turn_by_strain[k];
  std::optional<WaveEquilibrium> found = corrected(guess);
  if (!found) return {};
  const double scale = std::max(
      {std::abs(found->force), std::abs(here.force), 1e-3 * std::abs(here.force_by_strain)});
  double moved = 0;
  for (int k = 0; k < terms_; ++k) {
    moved = std::max(moved, std::abs(found->turn[k] - guess.turn[k]));
  }
  const double room = largest_correction * std::max(largest(guess.turn), 0.1 * wave_.slope);
  const bool small =
      std::abs(found->force - guess.force) <= largest_correction * scale && moved <= room;
  return small ? found : std::nullopt;
}

std::optional<WaveEquilibrium> WaveSolver::advance(const WaveEquilibrium& from,
                                                   double strain) const {
  return advance_link(
      from, strain, [this](const WaveEquilibrium& here, double next) { return step(here, next); });
}

double WaveSolver::fibre_strain(const WaveEquilibrium& at, double half_width) const {
  const double delta = wave_.compliance * at.force;
  double crest_turn = 0;
  for (const double turn : at.turn) crest_turn += turn;
  double most = delta + half_width * std::abs(crest_turn) / grading(wave_);
  for (std::size_t i = 0; i < stations_.size(); ++i) {
    double theta = stations_[i].slope;
    double curvature = 0;
    for (int k = 0; k < terms_; ++k) {
      theta += at.turn[k] * sines_[i * terms_ + k];
      curvature += at.turn[k] * cosines_[i * terms_ + k] / stations_[i].stretch;
    }
    most = std::max(most, delta * std::cos(theta) + half_width * std::abs(curvature));
  }
  return most;
}

// The nearest singularities of the graded wave lie artanh((1 + a^2)^(-1/4)) off the real axis, and
// successive terms are two frequencies apart.
int enough_terms(const Wave& wave) {
  const double distance = std::atanh(grading(wave));
  const double needed = std::min(200.0, lost_digits / (2 * distance));
  return std::max(fewest_terms, static_cast<int>(std::ceil(1.25 * needed)));
}

}  // namespace latticast
