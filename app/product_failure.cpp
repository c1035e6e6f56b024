// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/product_failure.h"

#include "app/builder.h"
#include "design/unsupported_design.h"
#include "geometry/pattern/cannot_draw.h"
#include "geometry/solid/geometry_error.h"
#if LATTICAST_HAS_MOLDS
#include "molds/cannot_mold.h"
#endif
#if LATTICAST_HAS_PREDICT
#include "report/no_equilibrium.h"
#endif

namespace latticast {

Failure product_failure() {
  try {
    throw;
  } catch (const AuditFailed& fault) {
    return {ExitStatus::check_failed, fault.what()};
  } catch (const GeometryError& fault) {
    return {ExitStatus::check_failed, fault.what()};
  } catch (const CannotDraw& fault) {
    return {ExitStatus::invalid, fault.what()};
  } catch (const UnsupportedDesign& fault) {
    return {ExitStatus::invalid, fault.what()};
#if LATTICAST_HAS_MOLDS
  } catch (const CannotMold& fault) {
    return {ExitStatus::invalid, fault.what()};
#endif
#if LATTICAST_HAS_PREDICT
  } catch (const NoEquilibrium& fault) {
    return {ExitStatus::no_equilibrium, fault.what()};
#endif
  }
}

}  // namespace latticast
