// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <leastcost/framework/base/monitor.hpp>
#include "ompl/plans/plan_space.hpp"

namespace leastcost {

/// Places of several plans, and others, between which the cheapest way is sought: what is best of each plan is put
/// together (Raveh, Enosh and Halperin 2011, path hybridization). Moves are asked for as late as possible (LazySP:
/// Dellin and Srinivasa 2016), and never twice.
class PlanRoadmap {
 public:
  /// Moves between places of different plans, or that are not neighbours on one, are at most `longest`, of the columns.
  PlanRoadmap(const PlanSpace& space, Eigen::VectorXd from, Eigen::VectorXd to, double longest);

  /// From the first end to the second; its moves are valid. Of turns by the longer way nothing is known.
  void add_path(const Points& x);
  void add(const Eigen::VectorXd& place);
  /// The cheapest way that is known to be valid when the monitor says stop, else of all; empty where there is none.
  Points cheapest(const Monitor& monitor);
  Index size() const { return static_cast<Index>(nodes_.size()); }
  long asked() const { return asked_; }

 private:
  enum class Known { nothing, clear_of_walls, valid };  ///< each says more than the one before
  struct Edge {
    int to;
    double cost;
    Known known;
  };
  int node(const Eigen::VectorXd& place);
  void link(int i, int j, Known known);
  std::vector<int> way(bool valid_only) const;
  bool ask(const std::vector<int>& way);
  Edge* edge(int i, int j);
  Points points(const std::vector<int>& way) const;

  const PlanSpace& space_;
  double longest_;
  std::vector<Eigen::VectorXd> nodes_;
  std::vector<std::vector<Edge>> edges_;
  long asked_ = 0;
};

}  // namespace leastcost
