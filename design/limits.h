// SPDX-License-Identifier: GPL-3.0-or-later
// How large and how small the numbers of a design or material may be. Everything outside these
// limits is a slip of the pen, and is refused before anything of that size is made.
#pragma once

#include <cstddef>

#include "design/material/range.h"

namespace latticast {

namespace limits {

inline constexpr std::size_t file_bytes = 4'000'000;
inline constexpr std::size_t name_bytes = 100;
inline constexpr int nesting = 32;  ///< of tables and lists, and parts of a dotted key

inline constexpr Range length{1e-3, 1e5, "mm"};
inline constexpr Range grid_angle{0, 180, "degrees", RangeEnds::neither};
inline constexpr Range ring_phase{0, 1, "", RangeEnds::low};  ///< of the pitch
inline constexpr Range cell_error{0.05, 50, "%"};
inline constexpr Range horseshoe_arc{20, 300, "degrees"};
inline constexpr Range waves{0.5, 5000};  ///< on one strand, two links each
inline constexpr Range pressure{-1e5, 1e5, "kPa"};
inline constexpr Range tolerance{1e-5, 1, "mm"};

inline constexpr Range strain{1e-3, 100};
inline constexpr Range density{0.01, 30, "g/cm3"};
inline constexpr Range shrinkage{0, 0.2};
inline constexpr Range modulus_low{1e-3, 1};
inline constexpr Range modulus_high{1, 1e3};

inline constexpr int segments = 100;
inline constexpr int strands_or_rings = 10'000;
inline constexpr int families = 100;
inline constexpr int mold_pieces = 100;
inline constexpr int load_cases = 100'000;
inline constexpr int preview_cases = 1'000;
inline constexpr double strand_turns = 1'000;  ///< of one strand around the tube
inline constexpr double links = 10'000;        ///< of one curved strand
inline constexpr double crossings = 1e6;       ///< of strands and rings on one segment

}  // namespace limits
}  // namespace latticast
