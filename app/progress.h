// SPDX-License-Identifier: GPL-3.0-or-later
// How far long work is, in steps of about equal weight.
#pragma once

#include <string>

#include "app/console.h"

namespace latticast {

/// Draws itself on a terminal: "[ 42 %] what". The number never falls, is below 100 while a step is
/// still being worked on, and ends at 100.
class Progress {
 public:
  explicit Progress(const Console& console) : console_(console) {}

  /// More steps than known before. Call before the first step: a number that falls misleads.
  void expect(int steps) { steps_ += steps; }

  /// The step before is done, this one begins. Throws Interrupted when a signal has come.
  void begin(const std::string& what);

  /// Every step is done.
  void finish();

  int percent() const;

 private:
  const Console& console_;
  int steps_ = 0;
  int begun_ = 0;
  bool finished_ = false;
};

}  // namespace latticast
