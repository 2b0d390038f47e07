// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "tests/adversarial/planning/judge/scene.hpp"

namespace leastcost::test {

/// A scene, with how many points a path through it is to have.
struct PlannedScene {
  judge::Scene scene;
  int points = 60;
};

struct SceneFamily {
  std::string name;
  std::function<PlannedScene(std::uint64_t seed)> make;  ///< the same seed always makes the same scene
};
const std::vector<SceneFamily>& scene_families();

}  // namespace leastcost::test
