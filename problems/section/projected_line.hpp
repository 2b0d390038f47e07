// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <leastcost/framework/domain/manifold.hpp>

namespace leastcost {

/// Straight lines, projected onto a domain without sites. A line that passes a place where the nearest point jumps (the
/// centre of a sphere, from one sheet to another) has no continuous projection, and that is found: a jump does not
/// shrink when the line is bisected.
class LineProjector {
 public:
  explicit LineProjector(const ConstraintManifold& manifold);

  /// The nearest point of the domain, if there is one.
  std::optional<Eigen::VectorXd> nearest(const Eigen::VectorXd& x);

  /// Appends the projections of a -> b to `out`, without that of a: `pieces` of equal length, bisected until neighbours
  /// are at most `gap` apart. False where that fails; why() says at which point.
  bool append(const Eigen::VectorXd& a, const Eigen::VectorXd& b, int pieces, double gap,
              std::vector<Eigen::VectorXd>& out);
  const std::string& why() const { return why_; }

 private:
  struct Foot {
    Eigen::VectorXd x, on;  ///< on the line and on the domain
  };
  bool bisect(const Foot& a, const Foot& b, double gap, int depth, std::vector<Eigen::VectorXd>& out);
  bool foot(const Eigen::VectorXd& x, Foot& out);

  const ConstraintManifold& manifold_;
  CoordinatePath one_;
  std::string why_;
};

/// Length of a polyline.
double polyline_length(const std::vector<Eigen::VectorXd>& points);
/// The points as a path with ends.
CoordinatePath as_open_path(const std::vector<Eigen::VectorXd>& points);

}  // namespace leastcost
