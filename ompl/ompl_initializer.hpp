// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include <leastcost/framework/base/options.hpp>
#include <leastcost/framework/problem/initializer.hpp>

namespace leastcost {

/// Geometric planners of OMPL, by its names. Those from prm_star on look for better paths until their time is up.
enum class OmplPlanner {
  rrt_connect,
  rrt,
  lazy_rrt,
  trrt,
  est,
  bi_est,
  kpiece,
  bkpiece,
  lbkpiece,
  sbl,
  stride,
  pdst,
  prm,
  lazy_prm,
  fmt,
  bfmt,
  prm_star,
  rrt_star,
  informed_rrt_star,
  bit_star
};
Words<OmplPlanner> words(OmplPlanner);

struct OmplOptions {
  static constexpr double kMostSeconds = 1e6;  ///< of max_seconds
  OmplPlanner planner = OmplPlanner::rrt_connect;
  double max_seconds = 10;
  std::optional<double> range = {};  ///< length units; else an eighth of the distance for a robot, or OMPL's choice
  std::optional<double> step = {};   ///< length units; else a sixteenth of the distance of the ends
  double reach = 1;
  int shortcuts = 200;
  std::optional<int> seed = {};  ///< else the seed of the run
  void fields(FieldVisitor& visit);
};

/// A path of a planner of OMPL 1.5 in the coordinates of a smooth domain: samples are points of the domain (in R^n, of
/// poses, configurations, products, level sets), moves are straight lines projected onto it, and both are free where
/// the domain says so (ChecksMoves: by bounds, not by samples) and the cost is finite. Then shortened by random
/// shortcuts.
///
/// Samples lie in the box of the domain; along a side without end, in a box around the ends that reaches `reach` of
/// their distance beyond them.
///
/// OMPL has one generator of seeds for a process: calls wait for each other, and it is set to a seed anew by each. The
/// same seed gives the same path where a planner neither looks at a clock (those that improve) nor has threads (prm),
/// and the program uses OMPL nowhere else meanwhile. What OMPL has to say is not printed.
class OmplInitializer final : public Initializer {
 public:
  /// Throws OptionError for a range, step or time that is no positive number, and a range for a planner without one.
  explicit OmplInitializer(const OmplOptions& options = {}, int run_seed = 0);
  std::string_view name() const override { return "ompl"; }
  /// Throws InitializationError that says what the planner came to.
  FirstPath first_path(const Problem& problem, const Monitor& monitor) const override;

 private:
  OmplOptions options_;
};

/// Version of the library in use, "1.5.2".
std::string ompl_version();

}  // namespace leastcost
