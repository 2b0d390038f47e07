// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <optional>

#include <leastcost/framework/base/options.hpp>
#include <leastcost/framework/problem/clearance.hpp>
#include <leastcost/framework/result/result.hpp>

namespace leastcost {

/// Limits of the motion along a path; both or none of them. Units of the coordinates (radians for joints that turn) per
/// s and s^2.
struct TrajectoryOptions {
  std::optional<Eigen::VectorXd> velocity = {};      ///< of each coordinate, or one number for all; > 0
  std::optional<Eigen::VectorXd> acceleration = {};  ///< the same
  double interval = 0.01;                            ///< s, between two samples; > 0
  void fields(FieldVisitor& visit);
  bool wanted() const { return velocity || acceleration; }  ///< whether limits were given
};

/// A path with times, from rest to rest, sampled. The curve is the delivered path with its corners rounded by
/// parabolas. The acceleration jumps; the jerk has no limit.
struct Trajectory {
  Eigen::VectorXd time;  ///< s, from 0 to the duration; equally spaced but for the last one
  Points x;              ///< d x count
  Points velocity;       ///< per s
  Points acceleration;   ///< per s^2
  double duration = 0;   ///< s
  double deviation = 0;  ///< no place of the curve is farther from the delivered path; coordinates
  /// No motion between these ends is quicker under these limits, whatever its path: each coordinate alone, rest to
  /// rest; s.
  double least_duration = 0;
  std::optional<Clearance>
      clearance;              ///< of eight chords of each rounding; curve and chords are checked_within apart, at most
  double checked_within = 0;  ///< coordinates
  bool touches = false;       ///< whether these come too near, by more than contact_tolerance()
};

/// Throws OptionError for limits that are not positive or not one for each coordinate, InputError for rings and for
/// domains that are not flat.
void check_trajectory(const Problem& problem, const TrajectoryOptions& options);

/// The quickest motion along the delivered path, see time_optimal(). Corners are rounded as far as that stays clear of
/// obstacles; the narrower the rounding, the slower. Throws what check_trajectory() does, InputError for paths without
/// a length and OptionError("interval") for more than a million samples.
Trajectory make_trajectory(const Problem& problem, const Result& result, const TrajectoryOptions& options);

}  // namespace leastcost
