// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <leastcost/framework/base/options.hpp>
#include <leastcost/framework/problem/initializer.hpp>

namespace leastcost {

struct CoordinateCircleOptions {
  int coordinate = 0;  ///< the one that runs around
  Eigen::VectorXd through = {};
  int turns = 1;
  void fields(FieldVisitor& visit);
};

/// A ring around a chart with seams: one coordinate runs through its period, the others stay. VFCS 6.1.
class CoordinateCircleInitializer final : public Initializer, public MakesRings {
 public:
  explicit CoordinateCircleInitializer(CoordinateCircleOptions options);
  std::string_view name() const override { return "coordinate_circle"; }
  /// Throws InitializationError for an open path and where the circle does not close.
  FirstPath first_path(const Problem& problem, const Monitor& monitor) const override;

 private:
  CoordinateCircleOptions options_;
};

}  // namespace leastcost
