// SPDX-License-Identifier: GPL-3.0-or-later
// Little-endian numbers: binary files hold the least significant byte first.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>

namespace latticast {

/// Writes the low `size` bytes of `value`, the lowest first; returns the place after them.
inline char* put_little_endian(char* out, std::uint64_t value, std::size_t size) {
  for (std::size_t i = 0; i < size; ++i) {
    *out++ = static_cast<char>(value >> (8 * i));
  }
  return out;
}

inline char* put_float32(char* out, float value) {
  return put_little_endian(out, std::bit_cast<std::uint32_t>(value), 4);
}

/// The number whose `size` bytes (at most 8) begin at `in`, the lowest first.
inline std::uint64_t get_little_endian(const char* in, std::size_t size) {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < size; ++i) {
    value |= std::uint64_t{static_cast<unsigned char>(in[i])} << (8 * i);
  }
  return value;
}

inline float get_float32(const char* in) {
  return std::bit_cast<float>(static_cast<std::uint32_t>(get_little_endian(in, 4)));
}

}  // namespace latticast
