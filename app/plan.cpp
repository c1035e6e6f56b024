// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/plan.h"

#include <algorithm>
#include <stdexcept>

#include <fmt/core.h>

#include "app/products.h"
#include "design/design.h"

namespace latticast {
namespace {

std::vector<const Product*> products_named(const std::string& word) {
  std::vector<const Product*> named;
  for (const Product& product : products()) {
    if (name(product.stage) == word || product.key == word || product.group == word) {
      named.push_back(&product);
    }
  }
  if (named.empty() || word.empty()) {
    throw std::invalid_argument(
        fmt::format("--only {}: no such part; parts are {}", word, product_words(false)));
  }
  return named;
}

std::vector<Stage> chosen_parts(const Make& make, const std::vector<std::string>& only) {
  std::vector<Stage> chosen;
  for (const std::string& word : only) {
    const std::size_t before = chosen.size();
    for (const Product* product : products_named(word)) {
      if (product->asked(make)) chosen.push_back(product->stage);
    }
    if (chosen.size() == before) {
      throw std::invalid_argument(fmt::format(
          "--only {}: the design's [make] does not ask for it; add it there first", word));
    }
  }
  return chosen;
}

bool has_lattice(const Design& design) {
  return std::any_of(design.segments.begin(), design.segments.end(),
                     [](const Segment& segment) { return segment.lattice.has_value(); });
}

bool has_curved_strand(const Design& design) {
  return std::any_of(design.segments.begin(), design.segments.end(), [](const Segment& segment) {
    return segment.lattice && has_curved_strands(*segment.lattice);
  });
}

// A single strand is uneven around the tube as well.
bool has_uneven_widths(const Design& design) {
  for (const Segment& segment : design.segments) {
    if (!segment.lattice) continue;
    for (const Grid& grid : segment.lattice->grids) {
      const auto [low, high] = std::minmax_element(grid.widths_mm.begin(), grid.widths_mm.end());
      if (grid.count() == 1 || (grid.count() > 1 && *low != *high)) return true;
    }
  }
  return false;
}

PlannedStage plan_product(const Design& design, const Product& product,
                          const std::vector<Stage>& chosen, bool narrowed) {
  const Stage stage = product.stage;
  if (!product.asked(design.make)) {
    return {stage, false, fmt::format("[make] does not name {}", product.key)};
  }
  if (narrowed && std::find(chosen.begin(), chosen.end(), stage) == chosen.end()) {
    return {stage, false, "left out by --only"};
  }
  if (product.only_of_lattice && !has_lattice(design)) {
    return {stage, false, "no segment has a lattice"};
  }
  return {stage, true, fmt::format("[make] names {}", product.key)};
}

// The stages of the prediction follow from what shows the design under pressure.
void plan_prediction(const Design& design, Plan& plan) {
  const bool shown = plan.runs(Stage::preview);
  const bool reported = plan.runs(Stage::report) && !design.load.empty();
  const bool needed = shown || reported;
  const auto add = [&](Stage stage, bool wanted, std::string_view why, std::string_view why_not) {
    const bool runs = needed && wanted;
    plan.stages.push_back({stage, runs,
                           std::string(runs     ? why
                                       : needed ? why_not
                                                : "nothing that is made needs a deformed shape")});
  };
  add(Stage::prediction, true,
      shown ? "the preview shows the shape under pressure"
            : "the report shows the response to pressure",
      "");
  add(Stage::horseshoe_law, has_curved_strand(design), "a strand is a horseshoe",
      "no strand is a horseshoe");
  add(Stage::bending, has_uneven_widths(design), "a family of strands is uneven around the tube",
      "every section is symmetric about its axis");
}

}  // namespace

std::string_view name(Stage stage) {
  switch (stage) {
    case Stage::prediction:
      return "prediction";
    case Stage::horseshoe_law:
      return "horseshoe-law";
    case Stage::bending:
      return "bending";
    case Stage::lattice:
      return "lattice";
    case Stage::liner:
      return "liner";
    case Stage::flat_pattern:
      return "flat-pattern";
    case Stage::preview:
      return "preview";
    case Stage::lattice_mold:
      return "lattice-mold";
    case Stage::liner_mold:
      return "liner-mold";
    case Stage::deck:
      return "deck";
    case Stage::report:
      return "report";
  }
  return "";
}

bool Plan::runs(Stage stage) const {
  return std::any_of(stages.begin(), stages.end(), [&](const PlannedStage& planned) {
    return planned.stage == stage && planned.runs;
  });
}

Plan plan_build(const Design& design, const std::vector<std::string>& only) {
  const std::vector<Stage> chosen = chosen_parts(design.make, only);
  Plan plan;
  for (const Product& product : products()) {
    plan.stages.push_back(plan_product(design, product, chosen, !only.empty()));
  }
  plan_prediction(design, plan);
  std::sort(plan.stages.begin(), plan.stages.end(),
            [](const PlannedStage& a, const PlannedStage& b) { return a.stage < b.stage; });
  return plan;
}

std::vector<std::string> unavailable([[maybe_unused]] const Plan& plan) {
  std::vector<std::string> missing;
#if !LATTICAST_HAS_MOLDS
  if (runs_any(plan, &Product::is_mold)) {
    missing.emplace_back(
        "this program was built without molds: build it with -DLATTICAST_MOLDS=ON, or leave them "
        "out with --only");
  }
#endif
#if !LATTICAST_HAS_PREDICT
  if (runs_any(plan, &Product::needs_cell)) {
    missing.emplace_back(
        "this program was built without the unit cell that a deck's mesh comes from: build it with "
        "-DLATTICAST_PREDICT=ON, or leave it out with --only");
  }
  if (runs_any(plan, &Product::shows_inflated)) {
    missing.emplace_back(
        "this program was built without the prediction that a preview or report needs: build it "
        "with -DLATTICAST_PREDICT=ON, or leave them out with --only");
  }
#endif
  return missing;
}

std::string describe(const Plan& plan) {
  std::string text;
  for (const PlannedStage& planned : plan.stages) {
    text += fmt::format("{:<5} {:<14} {}\n", planned.runs ? "run" : "skip", name(planned.stage),
                        planned.reason);
  }
  return text;
}

}  // namespace latticast
