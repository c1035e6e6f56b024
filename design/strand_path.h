// SPDX-License-Identifier: GPL-3.0-or-later
// Strand paths: the line that a strand follows along its chord line. What a path is called and how
// large it is; how it is drawn is in geometry/pattern/strand_path.h, its force law in
// model/strand/link_shape.h. Lengths mm, angles degrees.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace latticast {

/// The chord line itself.
struct StraightPath {};

/// A chain of circular arcs ([Wang] Fig. 2(g)): radius of the centre line and full angle of one
/// arc. A link is one arc.
struct Horseshoe {
  double radius_mm = 0;
  double arc_deg = 180;
  bool alternate = true;  ///< successive arcs curve to opposite sides
};

/// A sine wave: amplitude of the centre line, and full waves on the whole strand, in halves. It
/// starts on the chord line, with a half wave to the right. A link is a half wave.
struct Sinusoid {
  double amplitude_mm = 0;
  double waves = 1;
};

using StrandPath = std::variant<StraightPath, Horseshoe, Sinusoid>;

/// Whether the centre line leaves the chord line, so that the strand bends when it is pulled.
bool is_curved(const StrandPath& path);

/// A path as files and messages write it.
struct PathDescription {
  std::string_view name;      ///< its key in the design file; "straight" for the chord line
  std::string_view noun;      ///< one strand of it: "a horseshoe"
  std::string text;           ///< "arcs of 180 degrees, radius 2.6 mm"; empty for the chord line
  std::string_view more;      ///< what gives it a longer way to full extension
  std::string_view narrower;  ///< what brings it nearer to its chord line
  using Value = std::variant<double, bool>;
  std::vector<std::pair<std::string_view, Value>> parameters;  ///< name with unit, value
};
PathDescription describe(const StrandPath& path);

/// The path of a strand that is `factor` times as large.
StrandPath scaled(const StrandPath& path, double factor);

}  // namespace latticast
