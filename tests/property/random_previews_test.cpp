// SPDX-License-Identifier: GPL-3.0-or-later
// Whatever is drawn stays sound when it is moved. LATTICAST_RANDOM_PREVIEWS=1000 in the environment
// tries that many designs.
#include "tests/property/random_previews.h"

#include <cstdio>
#include <cstdlib>
#include <map>

#include <gtest/gtest.h>

namespace latticast {
namespace {

constexpr std::uint64_t first_seed = 20261128;
constexpr int usual_designs = 25;  // 100 take minutes

int wanted_designs() {
  const char* asked = std::getenv("LATTICAST_RANDOM_PREVIEWS");
  return asked != nullptr ? std::atoi(asked) : usual_designs;
}

TEST(RandomPreviews, PassTheirAudits) {
  const int wanted = wanted_designs();
  int drawn = 0;
  int meshes = 0;
  std::map<std::string, int> refusals;
  const char* from = std::getenv("LATTICAST_RANDOM_PREVIEWS_FROM");
  const std::uint64_t first = from != nullptr ? std::atoll(from) : first_seed;
  for (std::uint64_t seed = first; drawn < wanted; ++seed) {
    ASSERT_LT(seed - first, 3ULL * wanted) << "refusing everything proves nothing";
    const PreviewTrial trial = try_previews(seed);
    drawn += trial.drawn ? 1 : 0;
    meshes += trial.meshes;
    if (!trial.drawn) ++refusals[trial.refusal.substr(0, trial.refusal.find('\n')).substr(0, 60)];
    for (const std::string& fault : trial.faults) {
      ADD_FAILURE() << "seed " << seed << ", " << fault << '\n' << trial.design;
    }
  }
  std::printf("seeds from %llu: %d designs, %d moved meshes\n",
              static_cast<unsigned long long>(first_seed), drawn, meshes);
  for (const auto& [reason, count] : refusals)
    std::printf("  refused %d: %s\n", count, reason.c_str());
}

}  // namespace
}  // namespace latticast
