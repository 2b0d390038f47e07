// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "urdf/always_touching.hpp"

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

void leave_out_what_always_touches(Robot& robot) {
  constexpr int kTrials = 200;
  const Kinematics& kinematics = *robot.kinematics;
  const Eigen::VectorXd lower = kinematics.lower(), upper = kinematics.upper();
  std::mt19937 engine(1);
  std::vector<std::pair<int, int>> always = robot.self;
  std::vector<Frame> links;
  Eigen::VectorXd x(lower.size());
  for (int trial = 0; trial < kTrials && !always.empty(); ++trial) {
    for (Eigen::Index i = 0; i < x.size(); ++i) x[i] = random_value(lower[i], upper[i], engine);
    kinematics.place(x, links);
    std::erase_if(always, [&](const std::pair<int, int>& pair) {
      const Capsule &first = robot.capsules[static_cast<std::size_t>(pair.first)],
                    &second = robot.capsules[static_cast<std::size_t>(pair.second)];
      const Frame &one = links[static_cast<std::size_t>(first.link)],
                  &two = links[static_cast<std::size_t>(second.link)];
      double s = 0, t = 0;
      return distance_of_segments({one.at(first.from), one.at(first.to)}, {two.at(second.from), two.at(second.to)}, s,
                                  t) > first.radius + second.radius;
    });
  }
  if (always.empty()) return;
  const std::set<std::pair<int, int>> out(always.begin(), always.end());
  std::erase_if(robot.self, [&](const std::pair<int, int>& pair) { return out.count(pair) > 0; });
  std::set<std::pair<int, int>> of_links;
  for (const auto& [i, j] : always)
    of_links.emplace(robot.capsules[static_cast<std::size_t>(i)].link,
                     robot.capsules[static_cast<std::size_t>(j)].link);
  robot.whose += "; left out are parts that touch each other in every configuration tried:";
  const char* separator = " ";
  for (const auto& [link, other] : of_links) {
    robot.whose += separator + kinematics.link_name(link) + " and " + kinematics.link_name(other);
    separator = ", ";
  }
}

}  // namespace leastcost
