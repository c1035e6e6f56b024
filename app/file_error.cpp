// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/file_error.h"

#include <cmath>

#include <fmt/core.h>

#include "design/text/written_number.h"
#include "geometry/solid/tube_solids.h"

namespace latticast {
namespace {

constexpr double summing = 1e-12;  // what rounding leaves of a volume that is summed up

}  // namespace

SolidError error_of_file(const Solid& solid, const Audit& written) {
  const double rounding = rounding_mm(solid.mesh);
  SolidError error = solid.error;
  error.surface_mm += rounding;
  error.volume_mm3 += summing * written.volume_mm3;
  error.volume_mm3 += solid.volume_mm3 > 0 ? std::abs(written.volume_mm3 - solid.volume_mm3)
                                           : rounding * written.area_mm2;
  return error;
}

std::string describe(const SolidError& error) {
  return fmt::format("within {} mm of the drawn surface, volume to {} mm3",
                     written(error.surface_mm, 2), written(error.volume_mm3, 2));
}

}  // namespace latticast
