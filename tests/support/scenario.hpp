// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace leastcost::test {

/// A line of a Moving AI .scen file: two cells, and the length of the least octile route between their centres.
struct ScenarioPair {
  int bucket = 0;
  Eigen::Vector2d source, target;  ///< centres of the cells, in cells
  double optimum = 0;
  double rounding = 0;  ///< half a unit of the last of the six digits that the file gives
};

inline std::vector<ScenarioPair> read_scenario(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::string line, map;
  std::getline(in, line);  // version 1
  std::vector<ScenarioPair> pairs;
  while (std::getline(in, line)) {
    std::istringstream fields(line);
    int width = 0, height = 0, from_x = 0, from_y = 0, to_x = 0, to_y = 0;
    ScenarioPair pair;
    if (!(fields >> pair.bucket >> map >> width >> height >> from_x >> from_y >> to_x >> to_y >> pair.optimum))
      continue;
    pair.source = {from_x + 0.5, from_y + 0.5};
    pair.target = {to_x + 0.5, to_y + 0.5};
    pair.rounding = 0.5 * std::pow(10, std::floor(std::log10(std::max(pair.optimum, 1.0))) - 5);
    if (pair.optimum > 0) pairs.push_back(pair);
  }
  return pairs;
}

/// At most `count` of them, spread evenly over the file, whose lines ascend by bucket.
inline std::vector<ScenarioPair> spread_over(const std::vector<ScenarioPair>& all, std::size_t count) {
  if (all.size() <= count) return all;
  if (count == 1) return {all[all.size() / 2]};
  std::vector<ScenarioPair> some;
  for (std::size_t k = 0; k < count; ++k) some.push_back(all[k * (all.size() - 1) / (count - 1)]);
  return some;
}

}  // namespace leastcost::test
