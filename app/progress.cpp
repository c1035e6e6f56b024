// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/progress.h"

#include <algorithm>

#include "app/interrupt.h"

namespace latticast {

void Progress::begin(const std::string& what) {
  stop_if_interrupted();
  ++begun_;
  console_.progress(percent(), what);
}

void Progress::finish() {
  stop_if_interrupted();
  finished_ = true;
  console_.progress(percent(), "");
  console_.end_progress();
}

int Progress::percent() const {
  if (finished_) return 100;
  const int done = std::max(begun_ - 1, 0);
  return std::min(99, 100 * done / std::max(steps_, 1));
}

}  // namespace latticast
