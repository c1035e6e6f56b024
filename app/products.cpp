// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/products.h"

#include <algorithm>
#include <array>

#include "design/design.h"

namespace latticast {
namespace {

constexpr std::array<Product, 8> table{{
    {.stage = Stage::lattice,
     .key = "lattice",
     .asked = [](const Make& make) { return make.lattice; },
     .leave_out = [](Make& make) { make.lattice = false; },
     .only_of_lattice = true,
     .draws_lattice = true,
     .is_printed = true},
    {.stage = Stage::liner,
     .key = "liner",
     .asked = [](const Make& make) { return make.liner; },
     .leave_out = [](Make& make) { make.liner = false; },
     .is_printed = true},
    {.stage = Stage::flat_pattern,
     .key = "flat_pattern",
     .asked = [](const Make& make) { return make.flat_pattern; },
     .leave_out = [](Make& make) { make.flat_pattern = false; },
     .only_of_lattice = true,
     .draws_lattice = true},
    {.stage = Stage::preview,
     .key = "preview",
     .asked = [](const Make& make) { return make.preview.has_value(); },
     .leave_out = [](Make& make) { make.preview.reset(); },
     .draws_lattice = true,
     .shows_inflated = true},
    {.stage = Stage::lattice_mold,
     .key = "lattice_mold",
     .group = "molds",
     .asked = [](const Make& make) { return make.lattice_mold.has_value(); },
     .leave_out = [](Make& make) { make.lattice_mold.reset(); },
     .only_of_lattice = true,
     .draws_lattice = true,
     .is_printed = true,
     .is_mold = true},
    {.stage = Stage::liner_mold,
     .key = "liner_mold",
     .group = "molds",
     .asked = [](const Make& make) { return make.liner_mold.has_value(); },
     .leave_out = [](Make& make) { make.liner_mold.reset(); },
     .is_printed = true,
     .is_mold = true},
    {.stage = Stage::deck,
     .key = "deck",
     .asked = [](const Make& make) { return make.deck.has_value(); },
     .leave_out = [](Make& make) { make.deck.reset(); },
     .only_of_lattice = true,
     .needs_cell = true},
    {.stage = Stage::report,
     .key = "report",
     .asked = [](const Make& make) { return make.report; },
     .leave_out = [](Make& make) { make.report = false; },
     .draws_lattice = true,
     .shows_inflated = true},
}};

// The group's word stands once, after its last member.
bool ends_group(const Product& product) {
  const auto later = std::find_if(&product + 1, table.data() + table.size(),
                                  [&](const Product& p) { return p.group == product.group; });
  return !product.group.empty() && later == table.data() + table.size();
}

}  // namespace

std::span<const Product> products() {
  return table;
}

bool runs_any(const Plan& plan, bool Product::*property) {
  return std::any_of(table.begin(), table.end(), [&](const Product& product) {
    return product.*property && plan.runs(product.stage);
  });
}

std::string product_words(bool groups_for_members) {
  std::string words;
  const auto add = [&](std::string_view word) {
    if (!words.empty()) words += ", ";
    words += word;
  };
  for (const Product& product : table) {
    if (product.group.empty() || !groups_for_members) add(name(product.stage));
    if (ends_group(product)) add(product.group);
  }
  return words;
}

}  // namespace latticast
