// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "tests/adversarial/planning/scenes.hpp"

namespace leastcost::test {

/// What became of one scene.
struct SceneOutcome {
  std::string word = {};    ///< certified, uncertified: <failures>, collapsed, or the name of an error; crash, timeout
  bool confirmed = false;   ///< the judge knows a way
  bool end_inside = false;  ///< the judge says that an end breaks the clearance by more than a rounding
  bool wrong = false;       ///< certified, and the judge says that the curve touches, or that no way exists
  double excess = 0;        ///< of the certified curve over the shortest, relative; NaN: not known
  double seconds = 0;

  bool certified() const { return word == "certified"; }
};

/// In a process of its own, so that a crash is an outcome. `budget`: of find_path, seconds; a minute more is a timeout.
SceneOutcome measure_scene(const PlannedScene& planned, double budget);

struct SceneTally {
  int scenes = 0, confirmed = 0, certified = 0, certified_of_confirmed = 0, wrong = 0, crashes = 0, untyped = 0;
  std::map<std::string, int> others = {};  ///< words of those that are not certified
  std::vector<double> excess = {};         ///< of certified ones, where the shortest is known
  std::vector<std::uint64_t> wrong_seeds = {}, crash_seeds = {};
  double seconds = 0;

  void add(std::uint64_t seed, const SceneOutcome& outcome);
  std::string row(const std::string& family) const;
};

/// Seeds first, first + 2, ...; with LEASTCOST_SCENES_CSV every scene is a line of that file.
SceneTally measure_scenes(const SceneFamily& family, std::uint64_t first, int count, double budget);

}  // namespace leastcost::test
