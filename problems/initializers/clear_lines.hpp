// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <random>
#include <vector>

#include <leastcost/framework/base/monitor.hpp>
#include <leastcost/framework/domain/checks_moves.hpp>
#include <leastcost/framework/domain/has_box.hpp>
#include <leastcost/framework/problem/problem.hpp>
#include <leastcost/problems/methods/decides_moves.hpp>
#include "problems/section/projected_line.hpp"

namespace leastcost {

/// Straight lines of the space around a domain without sites, projected onto it, as the edges of a search: those on
/// which the cost is finite and no obstacle is met. Has a workspace: one thread at a time.
class ClearLines {
 public:
  /// `step`: length units; projections are looked at in pieces of half of it. The problem outlives it.
  ClearLines(const Problem& problem, double step);

  /// The nearest point of the domain, if there is one.
  std::optional<Eigen::VectorXd> nearest(const Eigen::VectorXd& x);
  /// Whether the domain is flat and its obstacles tell quickly whether a whole line is clear.
  bool quick() const { return decides_ != nullptr; }
  /// The projection of a -> b into `out`, which is empty, without that of a; false where there is no continuous one,
  /// its cost is infinite or an obstacle is in the way.
  bool append(const Eigen::VectorXd& a, const Eigen::VectorXd& b, std::vector<Eigen::VectorXd>& out);
  bool is_clear(const Eigen::VectorXd& a, const Eigen::VectorXd& b);

  /// The path through `nodes` on the domain, from which `tries` random shortcuts leave out what lies between two of its
  /// points whose line is shorter; fewer where the monitor says stop. Throws Interrupted after its deadline. Where
  /// quick() is true the lines between the nodes are clear already; there are up to eight rounds of as many tries, but
  /// fewer where they gain little or the path is still longer than `longest`, of use to nobody.
  std::vector<Eigen::VectorXd> shortened(const std::vector<Eigen::VectorXd>& nodes, int tries, double longest,
                                         std::mt19937_64& engine, const Monitor& monitor);
  /// The same where quick() is false. Else with short rounds, until one gains little or, after two, the path is still
  /// longer than `longest`: what there is to choose among several paths before one is shortened().
  std::vector<Eigen::VectorXd> roughly_shortened(const std::vector<Eigen::VectorXd>& nodes, int tries, double longest,
                                                 std::mt19937_64& engine, const Monitor& monitor);

 private:
  using Places = std::vector<Eigen::VectorXd>;
  struct Rounds {
    int tries = 0;     ///< of each
    int most = 0;      ///< rounds
    int fewest = 0;    ///< before a path is given up because it is too long
    double worth = 0;  ///< of the length: what a round has to gain for another one
  };

  bool goes_straight(const Eigen::VectorXd& a, const Eigen::VectorXd& b);
  int pieces_of(const Eigen::VectorXd& a, const Eigen::VectorXd& b) const;
  Places in_pieces(const Places& nodes) const;
  Places straightened(Places path, const Rounds& rounds, double longest, std::mt19937_64& engine,
                      const Monitor& monitor);

  const Problem& problem_;
  const ChecksMoves* obstacles_;
  const DecidesMoves* decides_ = nullptr;
  const HasBox* box_;
  double step_;
  LineProjector lines_;
  std::vector<Eigen::VectorXd> line_;
};

/// Uniform in [0, 1) from the engine's own bits: the same on every platform.
inline double uniform_number(std::mt19937_64& engine) { return static_cast<double>(engine() >> 11U) * 0x1p-53; }

}  // namespace leastcost
