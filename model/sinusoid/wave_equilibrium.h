// SPDX-License-Identifier: GPL-3.0-or-later
// Equilibria of a half sine wave pulled or pushed along its chord: the planar extensible elastica
// with variable natural curvature, by a spectral Ritz method (docs/sinusoid.md#method). Free of
// units: lengths over c/pi, c the chord at rest.
#pragma once

#include <optional>
#include <span>
#include <vector>

namespace latticast {

/// A half wave with ends free to turn. It is pulled by beta = f (c/pi)^2/(E I);
/// delta = f/(E A) = compliance * beta.
struct Wave {
  double slope = 0;       ///< a = pi A/c, the largest at rest, > 0
  double compliance = 0;  ///< I/(A (c/pi)^2) = (pi w/c)^2/12 for a rectangular strip, > 0
};

/// One equilibrium. strain = chord / rest chord - 1.
struct WaveEquilibrium {
  double strain = 0;
  double force = 0;            ///< beta, positive when pulled
  double force_by_strain = 0;  ///< d beta / d strain
  double defect = 0;           ///< of the force, relative: against more terms (WaveBranch::check)
  std::vector<double> turn;    ///< coefficients of the slope's change, see WaveSolver
  std::vector<double> turn_by_strain;
};

/// Solves theta'' - kappa0' = beta sin(theta)(1 + delta cos(theta)) on a quarter wave, theta = 0 at
/// the crest, theta' = kappa0 = 0 at the end, for a given strain, along the branch that starts at
/// rest. With tan x = (1 + a^2)^(-1/4) tan y, x the wave's phase from its crest, the slope is
///     theta = theta0(y) + sum over k = 1..terms of turn_k sin((2k - 1) y)/(2k - 1),
/// whose terms meet the conditions at both ends; energy and chord are summed at 2 terms midpoints.
class WaveSolver {
 public:
  /// Precondition: slope > 0, compliance > 0, terms >= 1.
  WaveSolver(const Wave& wave, int terms);

  /// The wave as cut: strain and force 0.
  const WaveEquilibrium& rest() const { return rest_; }

  /// Follows the branch from an equilibrium on it to `strain`. Empty when the branch cannot be
  /// followed that far.
  std::optional<WaveEquilibrium> advance(const WaveEquilibrium& from, double strain) const;

  /// Newton's method from a guess, which may have fewer terms.
  std::optional<WaveEquilibrium> step(const WaveEquilibrium& here, double strain) const;
  std::optional<WaveEquilibrium> corrected(WaveEquilibrium guess) const;

  /// Largest change of curvature times `half_width`, plus the axial strain there: of the most
  /// stretched fibre.
  double fibre_strain(const WaveEquilibrium& at, double half_width) const;

  const Wave& wave() const { return wave_; }

 private:
  struct Station {
    double stretch;  // ds/dy
    double weight;   // of the sum, in y
    double slope;    // theta0
  };
  struct Terms;
  struct Sums;

  /// `change`: theta - theta0 at the stations.
  Terms terms_at(double force, std::span<const double> change) const;
  Sums sums_at(const WaveEquilibrium& at) const;

  Wave wave_;
  int terms_;
  std::vector<Station> stations_;
  std::vector<double> sines_;    // sin((2k - 1) y)/(2k - 1), a row for each station
  std::vector<double> cosines_;  // its derivative by y
  WaveEquilibrium rest_;
};

/// Terms for a relative error of the force of about 1e-13 along the branch.
int enough_terms(const Wave& wave);

}  // namespace latticast
