// SPDX-License-Identifier: GPL-3.0-or-later
// What `latticast build` can make, one row a product: plan, checks before the build, help and
// messages read this table.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "app/plan.h"

namespace latticast {

struct Make;

struct Product {
  Stage stage;
  std::string_view key;             ///< under [make]
  std::string_view group = {};      ///< a word for several products, on the command line
  bool (*asked)(const Make& make);  ///< whether [make] asks for it
  void (*leave_out)(Make& make);    ///< takes it out of [make]
  bool only_of_lattice = false;     ///< there is none where no segment has a lattice
  bool draws_lattice = false;       ///< so every lattice must be drawable
  bool is_printed = false;          ///< checks of printing concern it
  bool is_mold = false;             ///< checks of casting concern it, and it needs LATTICAST_MOLDS
  bool shows_inflated = false;      ///< needs LATTICAST_PREDICT
  bool needs_cell = false;          ///< needs LATTICAST_PREDICT: the mesh is a unit cell's
};

/// In the order of work.
std::span<const Product> products();

/// Whether one of the plan's products is as asked: runs(plan, &Product::is_mold).
bool runs_any(const Plan& plan, bool Product::*property);

/// The products' names as --only takes them, separated by commas: every one and the groups, or
/// groups in place of their members.
std::string product_words(bool groups_for_members);

}  // namespace latticast
