// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>

#include <leastcost/framework/base/options.hpp>
#include <leastcost/framework/cost/segment_cost.hpp>

namespace leastcost {

/// How a segment is timed: as a straight chute, or by the speed at its middle.
enum class TravelTimeRule { chute, midpoint };
Words<TravelTimeRule> words(TravelTimeRule);

struct TravelTimeOptions {
  TravelTimeRule rule = TravelTimeRule::chute;
  double gravity = 9.80665;
  double start_speed = 0;
  /// Of rest, a height; else source height + start_speed^2 / (2 gravity). In a potential an energy per mass.
  std::optional<double> level = {};
  std::optional<std::string> potential = {};  ///< energy per mass in place of gravity, in the coordinates
  std::map<std::string, double> parameters = {};
  void fields(FieldVisitor& visit);
};

/// Time of a bead that slides without friction, seconds when lengths are metres. The last coordinate is height, up is
/// positive; +infinity above the energy level. Rule chute: 2 L / (v_a + v_b), exact for a straight chute; midpoint:
/// L / v at mid-height, VFCS Eqs. (21), (22). `source` gives the level unless the options state it (a ring must).
///
/// In a potential U(x) the speed is sqrt(2 (level - U)), the level U(source) + start_speed^2 / 2 or as stated, in any
/// unit of time; +infinity where U is above it. The chute is exact where U is linear along it and second order
/// elsewhere. The bead may be at rest at either end.
/// Throws OptionError.
std::shared_ptr<const SegmentCost> make_travel_time_cost(const TravelTimeOptions& options, int dim,
                                                         const std::optional<Eigen::VectorXd>& source);

/// Throws the OptionError that the above would throw, before the source is known.
void check_travel_time(const TravelTimeOptions& options, bool has_source);

}  // namespace leastcost
