// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include <leastcost/framework/energy/chain_system.hpp>
#include <leastcost/framework/path/path.hpp>

namespace leastcost {

/// Half-spaces for the unknowns z of a chain, blocks of k numbers: own . z[block] + next . z[block + 1] >= offset.
class ChainHalfSpaces {
 public:
  explicit ChainHalfSpaces(int block) : k_(block) {}

  void clear();
  void add(Index block, const Eigen::VectorXd& own, double offset);
  void add(Index block, const Eigen::VectorXd& own, const Eigen::VectorXd& next, double offset);

  int block() const { return k_; }
  Index count() const { return static_cast<Index>(blocks_.size()); }
  Index first_block(Index row) const { return blocks_[static_cast<std::size_t>(row)]; }
  bool couples(Index row) const { return couples_[static_cast<std::size_t>(row)] != 0; }
  /// k or, where it couples two blocks, 2 k numbers.
  const double* normal(Index row) const { return normals_.data() + 2 * k_ * row; }
  double offset(Index row) const { return offsets_[static_cast<std::size_t>(row)]; }

 private:
  void add_row(Index block, const Eigen::VectorXd& own, double offset);

  int k_;
  std::vector<Index> blocks_ = {};
  std::vector<char> couples_ = {};
  std::vector<double> normals_ = {}, offsets_ = {};
};

/// Minimises z' H z / 2 - force . z within half-spaces, H positive definite and block-tridiagonal, by an interior point
/// method (Nocedal and Wright 2006, Sec. 16.6) whose linear systems have the shape of H: linear in the number of
/// blocks. `z`: where it begins, within the half-spaces but for rounding; numbers of about one. Returns a z that is
/// within all of them but for rounding; nothing where that fails. Throws InputError for parts of different shapes, and
/// Interrupted after the deadline.
std::optional<Eigen::VectorXd> least_of_chain(const ChainSystem& h, const Eigen::VectorXd& force,
                                              const ChainHalfSpaces& half_spaces, const Eigen::VectorXd& z,
                                              const Deadline& deadline = {});

}  // namespace leastcost
