// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

namespace leastcost {

/// Points in R^d that become more, with the nearest of them: a k-d tree that grows by insertion. For points that come
/// in no particular order (samples of a random tree) its depth is O(log n).
class GrowingPoints {
 public:
  explicit GrowingPoints(int dimension) : dimension_(static_cast<std::size_t>(dimension)) {}
  int size() const { return static_cast<int>(nodes_.size()); }
  Eigen::Map<const Eigen::VectorXd> operator[](int i) const { return {at(i), static_cast<Eigen::Index>(dimension_)}; }

  int add(const Eigen::VectorXd& x);
  /// Number of the point nearest to x; there must be one.
  int nearest(const Eigen::VectorXd& x) const;

 private:
  struct Node {
    int axis = 0;
    int below = -1, above = -1;  ///< children: coordinate `axis` less than the node's, or not
  };
  const double* at(int i) const { return coordinates_.data() + static_cast<std::size_t>(i) * dimension_; }

  std::size_t dimension_;
  std::vector<double> coordinates_;
  std::vector<Node> nodes_;
};

}  // namespace leastcost
