// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <random>
#include <vector>

#include <leastcost/framework/base/monitor.hpp>
#include <leastcost/framework/domain/has_sample_box.hpp>
#include <leastcost/framework/problem/problem.hpp>
#include <leastcost/problems/initializers/rrt_options.hpp>
#include "problems/initializers/clear_lines.hpp"
#include "problems/initializers/growing_points.hpp"

namespace leastcost {

/// A random tree in the shell around a domain: every node has a foot, the nearest point of the domain.
class RandomTree {
 public:
  explicit RandomTree(const Eigen::VectorXd& root);
  int size() const { return points_.size(); }
  int nearest(const Eigen::VectorXd& x) const { return points_.nearest(x); }
  Eigen::VectorXd node(int i) const { return points_[i]; }  ///< in the shell
  const Eigen::VectorXd& foot(int i) const { return feet_[static_cast<std::size_t>(i)]; }
  int add(const Eigen::VectorXd& x, const Eigen::VectorXd& foot, int parent);
  /// Feet from the root to a node.
  std::vector<Eigen::VectorXd> branch(int node) const;

 private:
  GrowingPoints points_;
  std::vector<Eigen::VectorXd> feet_;
  std::vector<int> parents_;
};

/// One tree from each end of a problem, each growing towards random samples and then, as far as it gets, towards what
/// the other has just gained (Kuffner and LaValle 2000, RRT-Connect), in the shell of VFCS Sec. 4.2.1.
class RandomTrees {
 public:
  /// `seed`: of the samples, whatever the options say. Problem and options outlive it.
  RandomTrees(const Problem& problem, const RrtOptions& options, std::uint64_t seed);

  /// Samples only where paths of at most this length come, longer than the ends are apart.
  void look_for(double length);

  /// Grows until the trees meet: the nodes from the source to the target, on the domain. Nothing when there are
  /// `most_nodes` or the monitor says stop.
  std::optional<std::vector<Eigen::VectorXd>> joined(int most_nodes, const Monitor& monitor);

  /// The whole path on the domain, without what lies between two of its points whose straight line projects to
  /// something shorter; as ClearLines::shortened() and roughly_shortened().
  std::vector<Eigen::VectorXd> shortened(const std::vector<Eigen::VectorXd>& nodes, const Monitor& monitor,
                                         double longest = std::numeric_limits<double>::infinity());
  std::vector<Eigen::VectorXd> roughly_shortened(const std::vector<Eigen::VectorXd>& nodes, const Monitor& monitor,
                                                 double longest = std::numeric_limits<double>::infinity());
  bool quick() const { return lines_.quick(); }  ///< whether there is anything to gain by the second of these

  int size() const { return trees_[0].size() + trees_[1].size(); }
  long samples() const { return samples_; }
  bool stopped() const { return stopped_; }            ///< by the monitor
  double least_distance() const { return distance_; }  ///< between the trees, of what was tried

 private:
  bool is_over(const Monitor& monitor);
  double shortest_quick_step() const;  ///< of a step
  Eigen::VectorXd sample(const Eigen::VectorXd& other_end);
  int extend(int tree, int from, const Eigen::VectorXd& x);
  int connect(int tree, const Eigen::VectorXd& foot, const Monitor& monitor);
  bool joins(int tree, int from, const Eigen::VectorXd& foot);

  const RrtOptions& options_;
  double step_, shell_;
  std::mt19937_64 engine_;
  ClearLines lines_;
  std::array<RandomTree, 2> trees_;  ///< from the source, from the target
  Eigen::VectorXd margin_;
  SampleBox around_ends_, around_trees_, of_use_;
  int most_nodes_ = 0;
  long samples_ = 0;
  bool stopped_ = false;
  double distance_ = std::numeric_limits<double>::infinity();
};

}  // namespace leastcost
