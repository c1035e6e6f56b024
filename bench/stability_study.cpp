// SPDX-License-Identifier: GPL-3.0-or-later
// The stability atlas of the prediction: four maps of two axes and a random sample of all axes,
// every answer judged (atlas_check.h). Writes
//   stability_summary   points by verdict, one row for each map and the sample
//   stability_map       every place of the maps (CSV only), for plots/stability.gp
//   stability_wrong     every wrong answer with the numbers of its design (CSV only)
//   stability           one sentence
// Batches of designs run in processes of their own, so that a crash or an endless loop is a
// finding.
#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <sstream>

#include <fmt/core.h>

#include "bench/atlas_check.h"
#include "bench/atlas_designs.h"
#include "bench/study.h"

namespace {

using namespace latticast;

constexpr int per_axis = 21;
constexpr int sample_designs = 1000;
constexpr unsigned seed = 20261124;
constexpr int batch = 50;
constexpr double batch_limit_s = 60;
constexpr double design_limit_s = 10;

using DesignAt = std::function<AtlasDesign(int)>;

std::string text_of(const std::vector<Judgement>& findings) {
  std::string text;
  for (const Judgement& finding : findings) {
    text += fmt::format("{}\t{}\t{}\n", static_cast<int>(finding.verdict), finding.kind,
                        finding.detail);
  }
  return text;
}

std::vector<Judgement> findings_of(const std::string& text) {
  std::vector<Judgement> findings;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t first = line.find('\t');
    const std::size_t second = line.find('\t', first + 1);
    findings.push_back({static_cast<Verdict>(std::stoi(line)),
                        line.substr(first + 1, second - first - 1), line.substr(second + 1)});
  }
  return findings;
}

/// Findings of designs begin .. end - 1, in that order.
std::vector<Judgement> examine_batch(const DesignAt& design_at, int begin, int end) {
  const Cost cost = in_own_process(
      [&] {
        std::string text;
        for (int i = begin; i < end; ++i) text += text_of(examine(design_at(i)));
        return text;
      },
      end - begin > 1 ? batch_limit_s : design_limit_s);
  if (cost.finished) return findings_of(cost.result);
  std::vector<Judgement> findings;
  if (end - begin == 1) {
    const AtlasDesign design = design_at(begin);
    const bool slow = cost.seconds > 0.9 * design_limit_s;
    findings.resize(design.pressures_kpa.size(), {Verdict::wrong, slow ? "no end" : "crash", ""});
    return findings;
  }
  for (int i = begin; i < end; ++i) {
    for (const Judgement& finding : examine_batch(design_at, i, i + 1)) findings.push_back(finding);
  }
  return findings;
}

/// What a point is coloured by: 0 stable, 1 unstable, 2 the branch has ended, 3 a law has ended,
/// 4 not supported, 5 wrong.
int colour(const Judgement& finding) {
  static const std::map<std::string, int> colours = {
      {"stable", 0},        {"unstable", 1},  {"limit point", 2}, {"asymptote", 2},
      {"growth", 2},        {"closure", 2},   {"instability", 2}, {"no length left", 2},
      {"stretch limit", 3}, {"law's end", 3}, {"unsupported", 4}};
  if (finding.verdict == Verdict::wrong) return 5;
  const auto found = colours.find(finding.kind);
  return found == colours.end() ? 5 : found->second;
}

struct Tables {
  StudyTable summary{"stability_summary",
                     {"part", "points", "stable states", "unstable states", "branch ended",
                      "law ended", "not supported", "wrong"}};
  StudyTable map{"stability_map", {"map", "x", "y", "column", "row", "colour", "kind"}};
  StudyTable wrong{"stability_wrong", {"part", "design", "kind", "detail"}};
  std::array<int, 6> total{};
};

/// Runs all designs of one part and enters them.
void run_part(const std::string& name, int designs, const DesignAt& design_at, Tables& tables,
              const std::function<void(int, const Judgement&)>& enter) {
  std::array<int, 6> counts{};
  for (int begin = 0; begin < designs; begin += batch) {
    const int end = std::min(begin + batch, designs);
    const std::vector<Judgement> findings = examine_batch(design_at, begin, end);
    std::size_t next = 0;
    for (int i = begin; i < end; ++i) {
      const AtlasDesign design = design_at(i);
      for (std::size_t j = 0; j < design.pressures_kpa.size(); ++j) {
        const Judgement& finding = findings.at(next++);
        ++counts[colour(finding)];
        ++tables.total[colour(finding)];
        if (enter) enter(i, finding);
        if (colour(finding) == 5) {
          tables.wrong.add({name, description(design), finding.kind, finding.detail});
        }
      }
    }
  }
  int points = 0;
  for (const int count : counts) points += count;
  std::vector<Cell> row{name, static_cast<double>(points)};
  for (const int count : counts) row.emplace_back(static_cast<double>(count));
  tables.summary.add(row);
}

}  // namespace

int main(int count, char** arguments) {
  const std::filesystem::path folder = study_folder(count, arguments);
  Tables tables;
  for (const AtlasMap& map : atlas_maps(per_axis)) {
    const auto rows = static_cast<int>(map.y.values.size());
    run_part(
        map.name, static_cast<int>(map.designs.size()), [&](int i) { return map.designs[i]; },
        tables,
        [&](int i, const Judgement& finding) {
          tables.map.add({map.name, map.x.values[i / rows], map.y.values[i % rows],
                          static_cast<double>(i / rows), static_cast<double>(i % rows),
                          static_cast<double>(colour(finding)), finding.kind});
        });
  }
  run_part("random", sample_designs, [](int i) { return random_atlas_design(seed, i); }, tables,
           {});
  const auto& n = tables.total;
  const int verified = n[0] + n[1];
  const int refused = n[2] + n[3] + n[4];
  std::vector<Cell> all{std::string("all"), static_cast<double>(verified + refused + n[5])};
  for (const int value : n) all.emplace_back(static_cast<double>(value));
  tables.summary.add(all);
  tables.summary.write(folder);
  tables.map.write(folder, false);
  tables.wrong.write(folder, false);
  write_sentence(
      folder, "stability",
      fmt::format("Prediction: {} points, {} verified states, {} refused by name, {} wrong.",
                  verified + refused + n[5], verified, refused, n[5]));
  return 0;
}
