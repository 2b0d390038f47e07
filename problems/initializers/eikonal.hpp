// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <optional>

#include <leastcost/framework/base/options.hpp>
#include <leastcost/framework/problem/initializer.hpp>

namespace leastcost {

struct EikonalOptions {
  /// Along the longest side of the box. None: as many as a raster of costs has, or a whole multiple, and at most so
  /// many that the field takes a fraction of a second; 100 without one.
  std::optional<int> cells = {};
  std::optional<Eigen::VectorXd> lower = {};  ///< of the box that is searched; else that of the domain
  std::optional<Eigen::VectorXd> upper = {};
  /// Where nothing arrives, the straight line, or among obstacles what else finds a way (a grid in the plane, edges);
  /// the line too where there are no obstacles and it costs no more. A default needs it.
  bool fallback = false;
  void fields(FieldVisitor& visit);
};

/// The way back down the field of least arrival costs over a lattice in the two coordinates of a domain: the plane, a
/// chart, terrain, with obstacles or without, under any cost, also one that depends on direction or is asymmetric
/// (Riemann, Randers, Finsler). Its class is that of the least-cost path as far as the lattice resolves it: a path
/// along edges prefers their directions, this one does not.
class EikonalInitializer final : public Initializer {
 public:
  /// Throws OptionError for cells or a box that cannot be.
  explicit EikonalInitializer(const EikonalOptions& options = {});
  std::string_view name() const override { return "eikonal"; }
  /// Throws InitializationError for a ring or a domain without two coordinates, or where nothing arrives.
  FirstPath first_path(const Problem& problem, const Monitor& monitor) const override;

 private:
  FirstPath down_the_field(const Problem& problem, const Monitor& monitor) const;

  EikonalOptions options_;
};

}  // namespace leastcost
