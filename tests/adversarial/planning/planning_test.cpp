// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// How often a plan is certified and wrong, and how often none is found where there is one, on random scenes that an
// independent judge decides. LEASTCOST_SCENES: how many of each family; LEASTCOST_SCENES_SEED: the first seed (in steps
// of two: what was tuned on even seeds is measured on odd ones); LEASTCOST_SCENES_FAMILY: only those whose names hold
// this text; LEASTCOST_SCENES_BUDGET: seconds for each; LEASTCOST_SCENES_CSV: a file to which each scene adds a line;
// LEASTCOST_SCENES_SAVE: a folder for the scene files of all that are asked, for the program `judge`.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>

#include "tests/adversarial/planning/measure_scenes.hpp"
#include "tests/support/catch.hpp"

namespace leastcost::test {
namespace {

int count_from(const char* variable, int otherwise) {
  const char* text = std::getenv(variable);  // NOLINT(concurrency-mt-unsafe)
  return text == nullptr ? otherwise : std::atoi(text);
}

void save(const SceneFamily& family, std::uint64_t first, int count) {
  const char* folder = std::getenv("LEASTCOST_SCENES_SAVE");  // NOLINT(concurrency-mt-unsafe)
  if (folder == nullptr) return;
  for (int i = 0; i < count; ++i) {
    const std::uint64_t seed = first + 2 * static_cast<std::uint64_t>(i);
    std::ofstream out(std::string(folder) + "/" + family.name + "_" + std::to_string(seed) + ".scene");
    judge::write(family.make(seed).scene, out);
  }
}

}  // namespace

TEST_CASE("planning: random scenes by family, nothing certified touches", "[adversarial][planning]") {
  const int count = count_from("LEASTCOST_SCENES", 1);
  const auto first = static_cast<std::uint64_t>(count_from("LEASTCOST_SCENES_SEED", 2));
  const int budget = count_from("LEASTCOST_SCENES_BUDGET", 1);
  const char* only = std::getenv("LEASTCOST_SCENES_FAMILY");  // NOLINT(concurrency-mt-unsafe)
  std::printf("  %-14s %6s %9s %9s %9s %6s %7s %9s %9s %6s  others\n", "family", "scenes", "confirmed", "certified",
              "of those", "wrong", "crashes", "excess 50", "worst", "s");
  for (const SceneFamily& family : scene_families()) {
    if (only != nullptr && family.name.find(only) == std::string::npos) continue;
    save(family, first, count);
    const SceneTally tally = measure_scenes(family, first, count, budget);
    std::printf("%s\n", tally.row(family.name).c_str());
    CAPTURE(family.name, count, first);
    CHECK(tally.wrong == 0);
    CHECK(tally.crashes == 0);
    CHECK(tally.untyped == 0);
  }
}

}  // namespace leastcost::test
