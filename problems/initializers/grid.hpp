// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <optional>

#include <leastcost/framework/base/options.hpp>
#include <leastcost/framework/problem/initializer.hpp>

namespace leastcost {

struct GridOptions {
  std::optional<double> resolution = {};      ///< length units; else a 64th of the longest side (in space a 32nd)
  std::optional<Eigen::VectorXd> lower = {};  ///< of the box that is searched; else that of the domain
  std::optional<Eigen::VectorXd> upper = {};
  int refinements = 4;
  bool shortcuts = true;
  bool trees = true;
  void fields(FieldVisitor& visit);
};

/// The least-cost route over the centres of the cells of a regular grid, A* over steps to all 8 (26) neighbours that
/// cost finitely much and are clear of obstacles (ChecksMoves); then straight shortcuts. In the plane and in space.
/// Where the grid has no passage its cells are halved, so many times, and at last random trees (RrtInitializer) look
/// for what no grid has seen.
class GridInitializer final : public Initializer {
 public:
  /// Throws OptionError for a resolution or a box that cannot be.
  explicit GridInitializer(const GridOptions& options = {});
  std::string_view name() const override { return "grid"; }
  /// Throws InitializationError that says which grids were searched, and how far trees came.
  FirstPath first_path(const Problem& problem, const Monitor& monitor) const override;

 private:
  GridOptions options_;
};

}  // namespace leastcost
