// SPDX-License-Identifier: GPL-3.0-or-later
// Sinusoidal strand: a sine wave about its chord line. Lengths mm.
#pragma once

#include <string_view>

#include "design/path_description.h"

namespace latticast {

class Field;

/// Amplitude of the centre line, and full waves on the whole strand, in halves. It starts on the
/// chord line, with a half wave to the right. A link is a half wave.
struct Sinusoid {
  double amplitude_mm = 0;
  double waves = 1;

  static constexpr std::string_view key = "sinusoid";
  static Sinusoid read(const Field& field, double strand_mm);
  PathDescription description() const;
  Sinusoid scaled(double factor) const { return {factor * amplitude_mm, waves}; }

  friend bool operator==(const Sinusoid&, const Sinusoid&) = default;
};

}  // namespace latticast
