// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <leastcost/framework/problem/initializer.hpp>
#include <leastcost/problems/initializers/rrt_options.hpp>

namespace leastcost {

/// Rapidly exploring random trees in the shell around a smooth domain, VFCS Sec. 4.2.1: from the tree's point nearest
/// to a random sample one step towards it, then into the shell; one tree from each end, which grow towards each other
/// (Kuffner and LaValle 2000). Here the shell is what lies within a distance of the domain, on both sides, so that it
/// needs nothing but a projection. Every edge has a continuous projection and is clear of obstacles; the path is
/// projected and shortened by random shortcuts. Of several `paths`, each of trees of its own, the shortest is taken:
/// among obstacles in space what is pulled tight later stays in the class that it began in. The same seed gives the
/// same path.
class RrtInitializer final : public Initializer {
 public:
  /// Throws OptionError for a step or shell that is no distance.
  explicit RrtInitializer(const RrtOptions& options = {}, int run_seed = 0);
  std::string_view name() const override { return "rrt"; }
  /// Throws InitializationError that says how many nodes there were and how near the trees came to each other.
  FirstPath first_path(const Problem& problem, const Monitor& monitor) const override;

 private:
  RrtOptions options_;
};

}  // namespace leastcost
