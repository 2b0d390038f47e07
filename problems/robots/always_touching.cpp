// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/robots/always_touching.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "problems/robots/segment_distance.hpp"

namespace leastcost {
namespace {

/// A value of a joint; one without limits turns.
double random_value(double lower, double upper, std::mt19937& engine) {
  constexpr double kTurn = std::numbers::pi;
  if (!std::isfinite(lower)) lower = -kTurn;
  if (!std::isfinite(upper)) upper = kTurn;
  constexpr double kSteps = 1 << 20;  // not std::uniform_real_distribution, which is another one in other libraries
  return lower + (upper - lower) * static_cast<double>(engine() >> 12) / kSteps;
}

}  // namespace

void leave_out_what_always_touches(Robot& robot, std::size_t first) {
  constexpr int kTrials = 200;
  const Kinematics& kinematics = *robot.kinematics;
  const Eigen::VectorXd lower = kinematics.lower(), upper = kinematics.upper();
  std::mt19937 engine(1);
  const auto begin = robot.self.begin() + static_cast<std::ptrdiff_t>(first);
  std::vector<std::pair<int, int>> always(begin, robot.self.end());
  std::vector<Frame> links;
  Eigen::VectorXd x(lower.size());
  for (int trial = 0; trial < kTrials && !always.empty(); ++trial) {
    for (Eigen::Index i = 0; i < x.size(); ++i) x[i] = random_value(lower[i], upper[i], engine);
    kinematics.place(x, links);
    std::erase_if(always, [&](const std::pair<int, int>& pair) {
      const Capsule &here = robot.capsules[static_cast<std::size_t>(pair.first)],
                    &there = robot.capsules[static_cast<std::size_t>(pair.second)];
      const Frame &one = links[static_cast<std::size_t>(here.link)], &two = links[static_cast<std::size_t>(there.link)];
      double s = 0, t = 0;
      return distance_of_segments({one.at(here.from), one.at(here.to)}, {two.at(there.from), two.at(there.to)}, s, t) >
             here.radius + there.radius;
    });
  }
  if (always.empty()) return;
  const std::set<std::pair<int, int>> out(always.begin(), always.end());
  robot.self.erase(std::remove_if(begin, robot.self.end(), [&](const auto& pair) { return out.count(pair) > 0; }),
                   robot.self.end());
  std::set<std::pair<std::string, std::string>> names;
  for (const auto& [i, j] : always)
    names.emplace(robot.part_name(static_cast<std::size_t>(i)), robot.part_name(static_cast<std::size_t>(j)));
  robot.whose += "; pairs of parts that touch in every configuration tried are ignored:";
  const char* separator = " ";
  for (const auto& [one, other] : names) {
    robot.whose.append(separator).append(one).append(" and ").append(other);
    separator = ", ";
  }
}

}  // namespace leastcost
