// SPDX-License-Identifier: GPL-3.0-or-later
#include "checks/check_design.h"

#include <iterator>
#include <utility>

#include "design/design.h"
#include "prepared/prepared_design.h"
#if LATTICAST_HAS_GEOMETRY
#include "checks/print_checks.h"
#endif
#if LATTICAST_HAS_MOLDS
#include "checks/casting_checks.h"
#endif
#if LATTICAST_HAS_PREDICT
#include "checks/load_checks.h"
#endif

namespace latticast {

CheckFindings check_design(const Design& design) {
  PreparedDesign prepared(design);
  return check_design(design, prepared);
}

CheckFindings check_design([[maybe_unused]] const Design& design,
                           [[maybe_unused]] PreparedDesign& prepared,
                           [[maybe_unused]] const CheckScope& scope) {
  CheckFindings findings;
  const auto add = [&](CheckFindings more) {
    std::move(more.begin(), more.end(), std::back_inserter(findings));
  };
#if LATTICAST_HAS_GEOMETRY
  if (scope.printing) add(print_checks(design, prepared.lattices));
#endif
#if LATTICAST_HAS_MOLDS
  if (scope.casting) add(casting_checks(design, prepared.lattices, prepared.molds));
#endif
#if LATTICAST_HAS_PREDICT
  if (scope.inflating) add(load_checks(prepared.responses));
#endif
  return findings;
}

}  // namespace latticast
