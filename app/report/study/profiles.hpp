// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

namespace leastcost::app {

/// The work that each solver (column) needs for each problem (row), in any unit; infinity: not solved. All rows equally
/// long.
using WorkTable = std::vector<std::vector<double>>;

/// A step function: share[i] of the problems from at[i] on; zero before at[0].
struct Profile {
  std::vector<double> at, share;
};

/// Performance profiles of Dolan and More (2002), one per solver: the share of all problems that it solves with at most
/// `at` times the work of the best solver of each. Problems that it does not solve, also those that nobody solves,
/// count as not solved. Work must be positive.
std::vector<Profile> performance_profiles(const WorkTable& work);

/// Data profiles of More and Wild (2009), one per solver: the share of all problems that it solves with at most `at`
/// units of work, where the unit of problem p is units[p] (n + 1 evaluations, a simplex gradient, in their paper; 1:
/// evaluations as they are).
std::vector<Profile> data_profiles(const WorkTable& work, const std::vector<double>& units);

/// The least-squares slope of log y against log x over the pairs in which both are positive, finite, and y is above
/// `floor`; nothing for fewer than two x.
std::optional<double> log_log_slope(const std::vector<double>& x, const std::vector<double>& y, double floor = 0);

/// The first of work whose excess is at most tau, infinity when none is: when a solver has solved a problem to tau.
/// Equally long.
double work_to_reach(const std::vector<double>& work, const std::vector<double>& excess, double tau);

}  // namespace leastcost::app
