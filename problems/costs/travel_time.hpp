// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>

#include <leastcost/framework/options.hpp>
#include <leastcost/framework/segment_cost.hpp>

namespace leastcost {

enum class TravelTimeRule { chute, midpoint };
Words<TravelTimeRule> words(TravelTimeRule);

struct TravelTimeOptions {
  TravelTimeRule rule = TravelTimeRule::chute;
  double gravity = 9.80665;
  double start_speed = 0;
  std::optional<double> level = {};  ///< length units; else source height + start_speed^2 / (2 gravity)
  void fields(FieldVisitor& visit);
};

/// Time of a bead that slides without friction, seconds when lengths are metres. The last coordinate is height, up is
/// positive; +infinity above the energy level. Rule chute: 2 L / (v_a + v_b), exact for a straight chute; midpoint:
/// L / v at mid-height, VFCS Eqs. (21), (22). `source` gives the level unless the options state it (a ring must).
/// Throws OptionError.
std::shared_ptr<const SegmentCost> make_travel_time_cost(const TravelTimeOptions& options, int dim,
                                                         const std::optional<Eigen::VectorXd>& source);

/// Throws the OptionError that the above would throw, before the source is known.
void check_travel_time(const TravelTimeOptions& options, bool has_source);

}  // namespace leastcost
