// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include <leastcost/framework/cost/segment_cost.hpp>

namespace leastcost {

/// A bead in a potential: the part of TravelTimeOptions that is about it.
struct BeadInPotential {
  std::string potential;
  std::map<std::string, double> parameters;
  double start_speed;
  std::optional<double> level;
};

/// See make_travel_time_cost(). Throws OptionError.
std::shared_ptr<const SegmentCost> make_potential_time_cost(const BeadInPotential& bead, int dim,
                                                            const std::optional<Eigen::VectorXd>& source);

}  // namespace leastcost
