// SPDX-License-Identifier: GPL-3.0-or-later
// A design that uses the whole grammar, and what the tests do with it.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace latticast {

inline constexpr std::string_view whole_grammar = R"(# every key of the design file
name = "two-segments"

[[segment]]
length = 85

  [segment.liner]
  inner_radius = 12
  thickness = 4
  material = "ecoflex-00-50"

  [segment.lattice]
  thickness = 2
  material = "hei-cast-8400"
  fillet = 0.5

    [segment.lattice.rings]
    count = 8
    width = 2.5

    [[segment.lattice.grid]]
    angle = 36
    count = 8
    width = 2

    [[segment.lattice.grid]]
    angle = 120.5
    width = [1, 1.5, 2]

[[segment]]
length = 60.5

  [segment.liner]
  inner_radius = 10
  thickness = 3
  material = { law = "yeoh", c1 = 0.02, c2 = -0.001, c3 = 0.0001 }

  [segment.lattice]
  thickness = 1.5
  material = { law = "linear", E = 30, nu = 0.4 }

    [segment.lattice.rings]
    pitch = 10
    width = 1
    phase = 0.25

    [[segment.lattice.grid]]
    angle = 90
    count = 6
    width = { from = 1, to = 3, profile = "cosine" }
    horseshoe = { radius = 2.656, arc = 170, alternate = false }

    [[segment.lattice.grid]]
    angle = 80
    count = 5
    width = { from = 1, to = 2, profile = "halves" }
    horseshoe = { radius = 3 }

[[segment]]
length = 20

  [segment.liner]
  inner_radius = 10
  thickness = 3
  material = { law = "gent", mu = 0.05, jm = 40, shrinkage = 0.004 }

[load]
pressure = { from = 0, to = 60, step = 20 }
grid = [[5, 15], { from = 0, to = 50, step = 25 }, -3]
[[load.case]]
pressure = [10, -20, 30.5]
[[load.case]]
pressure = 7

[model]
kind = "mixture"
columns = "distributed"
joint = "paper"

[make]
lattice = true
liner = true
flat_pattern = true
lattice_mold = { pieces = 3, wall = 4, method = "replica" }
liner_mold = { wall = 6, ends = "closed", keyed = false, pieces = 4 }
preview = { pressures = [0, [20, 0, -5], 40] }
report = true

[export]
formats = ["stl", "obj", "3mf", "ply", "glb"]
tolerance = 0.02

[printer]
process = "sla"
min_wall = 0.8
min_gap = 0.4
clearance = 0.2
bed = [200, 210, 220]
)";

inline constexpr std::string_view smallest_design = R"(name = "tube"
[[segment]]
length = 50
[segment.liner]
inner_radius = 8
thickness = 2
material = "ecoflex-00-50"
)";

/// `text` with the one place where `old` stands replaced; a test that misses its place must not
/// pass.
inline std::string replaced(std::string_view text, std::string_view old, std::string_view by) {
  const std::size_t at = text.find(old);
  if (at == std::string_view::npos || text.find(old, at + 1) != std::string_view::npos) {
    throw std::logic_error("not exactly one place holds: " + std::string(old));
  }
  return std::string(text.substr(0, at)) + std::string(by) +
         std::string(text.substr(at + old.size()));
}

}  // namespace latticast
