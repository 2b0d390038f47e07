// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "catalogue/output/trajectory_files.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>

#include "catalogue/output/json_numbers.hpp"

namespace leastcost {

using Json = nlohmann::ordered_json;

std::string trajectory_csv(const Trajectory& motion, const std::vector<std::string>& names) {
  std::string text = fmt::format("time,{},velocity_{},acceleration_{}\n", fmt::join(names, ","),
                                 fmt::join(names, ",velocity_"), fmt::join(names, ",acceleration_"));
  for (Index k = 0; k < motion.time.size(); ++k) {
    fmt::format_to(std::back_inserter(text), "{:.17g}", motion.time[k]);
    for (const Points* rows : {&motion.x, &motion.velocity, &motion.acceleration})
      for (const double value : rows->col(k)) fmt::format_to(std::back_inserter(text), ",{:.17g}", value);
    text += '\n';
  }
  return text;
}

std::string trajectory_json(const Trajectory& motion, const std::vector<std::string>& names) {
  Json points = Json::array();
  for (Index k = 0; k < motion.time.size(); ++k) {
    const double whole = std::floor(motion.time[k]);
    points.push_back({{"positions", numbers(Eigen::VectorXd(motion.x.col(k)))},
                      {"velocities", numbers(Eigen::VectorXd(motion.velocity.col(k)))},
                      {"accelerations", numbers(Eigen::VectorXd(motion.acceleration.col(k)))},
                      {"time_from_start",
                       {{"sec", static_cast<long>(whole)},
                        {"nanosec", static_cast<long>(std::floor((motion.time[k] - whole) * 1e9))}}}});
  }
  return Json({{"joint_names", names}, {"points", points}}).dump(1) + '\n';
}

}  // namespace leastcost
