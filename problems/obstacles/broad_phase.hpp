// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <vector>

namespace leastcost {

/// Which of many boxes meet a given one: an R-tree (Boost.Geometry) in two and three dimensions, one after the other in
/// more. Immutable, may be shared by threads.
class BroadPhase {
 public:
  using Box = Eigen::AlignedBox<double, Eigen::Dynamic>;

  /// Boxes of one dimension; one that is infinite meets all.
  explicit BroadPhase(std::vector<Box> boxes);
  ~BroadPhase();
  BroadPhase(const BroadPhase&) = delete;
  BroadPhase& operator=(const BroadPhase&) = delete;

  /// The numbers of the boxes that meet `box`, ascending, in place of what `found` held.
  void meeting(const Box& box, std::vector<int>& found) const;

 private:
  struct Tree;
  std::vector<Box> boxes_;
  std::vector<int> everywhere_;  ///< the infinite ones
  std::unique_ptr<const Tree> tree_;
};

}  // namespace leastcost
