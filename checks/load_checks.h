// SPDX-License-Identifier: GPL-3.0-or-later
// What pressure will do to the part: where it balloons or buckles, tears, touches itself, or leaves
// what its prediction is good for. Each check's formula and source: docs/checks.md, "Under load".
#pragma once

#include "checks/check_finding.h"

namespace latticast {

class PreparedResponses;

/// All checks under the load of the responses' design; none without one. A segment that cannot be
/// predicted has one finding, not-predictable.
CheckFindings load_checks(PreparedResponses& responses);

}  // namespace latticast
