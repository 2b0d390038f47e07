// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cstddef>
#include <string>

#include <leastcost/eigen_alignment.hpp>

namespace leastcost {

/// The nodes of a regular grid: node (i, j, k) lies at origin + cell (i, j, k), x runs fastest in memory.
struct GridShape {
  static constexpr int kFewest = 4;  ///< nodes along an axis that a cubic needs

  Eigen::Vector3d origin = Eigen::Vector3d::Zero();  ///< place of node (0, 0, 0)
  double cell = 0;                                   ///< length units
  std::array<int, 3> count = {0, 0, 0};              ///< nodes along x, y, z

  /// Number of nodes.
  std::size_t nodes() const {
    return static_cast<std::size_t>(count[0]) * static_cast<std::size_t>(count[1]) * static_cast<std::size_t>(count[2]);
  }
  /// Of a node in memory.
  std::size_t index(int i, int j, int k) const {
    return (static_cast<std::size_t>(k) * static_cast<std::size_t>(count[1]) + static_cast<std::size_t>(j)) *
               static_cast<std::size_t>(count[0]) +
           static_cast<std::size_t>(i);
  }
  /// Place of a node.
  Eigen::Vector3d node(int i, int j, int k) const { return origin + cell * Eigen::Vector3d(i, j, k); }
  Eigen::Vector3d upper() const { return node(count[0] - 1, count[1] - 1, count[2] - 1); }  ///< place of the last node
};

/// Every second node of a grid. Throws InputError when too few are left.
GridShape every_second(const GridShape& shape);

/// "128 x 128 x 96 nodes of cell 0.02".
std::string text(const GridShape& shape);

/// "12.3 MiB".
std::string bytes_in_words(double bytes);

/// Memory that building a distance grid takes per node, at its peak: the values, and feet or coefficients beside them.
/// The finished grid keeps a third of it.
inline constexpr double kBytesPerNode = 24;

/// A grid over `box` and `margin` cells around it, whose counts are 4 m + 1, so that its second and fourth nodes end
/// with it. Throws OptionError("cell") when the cell is not positive and finite, InputError when the box is empty, or
/// when kBytesPerNode for every node exceeds `memory` (bytes): the message says how many nodes, how much memory and
/// which cell would fit.
GridShape grid_around(const Eigen::AlignedBox3d& box, double cell, int margin, double memory);

}  // namespace leastcost
