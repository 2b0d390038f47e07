// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string_view>
#include <vector>

#include <leastcost/framework/path/path.hpp>

namespace leastcost {

/// A chart's coordinate that comes back after a period, possibly with another coordinate turned over (Klein bottle,
/// Moebius strip): u_c + period and -u_flipped name the same point.
struct Seam {
  int coordinate = 0;               ///< the coordinate that comes back
  double period = 0;                ///< > 0
  std::optional<int> flipped = {};  ///< the coordinate that changes its sign across it
};

/// Ability: the chart has seams. Paths live on the universal cover, where they cross seams freely and keep their
/// winding.
class HasSeams {
 public:
  static constexpr std::string_view kAbility = "chart with seams";
  virtual ~HasSeams() = default;
  virtual const std::vector<Seam>& seams() const = 0;  ///< all of them
  /// Least and greatest coordinates, 2 x 2, one coordinate a row; infinite where the chart has no edge.
  virtual Eigen::Matrix2d edges() const = 0;
};

/// The image of a point after `windings` turns across each seam (one entry per seam).
SeamMap seam_map(const std::vector<Seam>& seams, int dimension, const Eigen::VectorXi& windings);

/// Turns across each seam that bring the image of `u` nearest to `near`, in coordinates.
Eigen::VectorXi nearest_image(const std::vector<Seam>& seams, const Eigen::VectorXd& u, const Eigen::VectorXd& near);

}  // namespace leastcost
