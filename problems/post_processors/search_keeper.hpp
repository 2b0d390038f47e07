// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include <leastcost/framework/problem/global_bound.hpp>
#include <leastcost/framework/problem/problem.hpp>
#include <leastcost/problems/exact/exact_search.hpp>
#include "problems/exact/metric_mesh.hpp"

namespace leastcost {

/// The exact search of a domain, kept between queries with the workspaces that are idle. Shared by threads.
class KeptSearch {
 public:
  KeptSearch(const Problem& problem, const TriangleMesh& mesh, const MetricRoot& metric, const GlobalBudget& budget,
             const std::function<bool()>& stop);

  bool is_of(const Problem& problem, const MetricRoot& metric) const;
  const ExactSearch& search() const { return *search_; }
  /// Nothing for the Euclidean metric: then the search runs on the mesh itself.
  const MetricMesh* turned() const { return turned_ ? &*turned_ : nullptr; }

  ExactSearch::Workspace borrow();
  void give_back(ExactSearch::Workspace workspace);

 private:
  void add_landmarks(const GlobalBudget& budget, const std::function<bool()>& stop);

  std::shared_ptr<const ConstraintManifold> domain_;  // kept alive, hence its address is its own
  MetricRoot metric_;
  std::optional<MetricMesh> turned_;
  std::unique_ptr<ExactSearch> search_;
  std::mutex lock_;
  std::vector<ExactSearch::Workspace> idle_;
};

/// The search of the domain that was asked for last.
class SearchKeeper {
 public:
  /// Makes it where there is none for this domain and metric; other threads wait. Throws InputError for an index that
  /// does not fit.
  std::shared_ptr<KeptSearch> search_for(const Problem& problem, const TriangleMesh& mesh, const MetricRoot& metric,
                                         const GlobalBudget& budget, const std::function<bool()>& stop);

  /// Whether it is there already.
  bool holds(const Problem& problem, const MetricRoot& metric);

 private:
  std::mutex lock_;
  std::shared_ptr<KeptSearch> last_;
};

}  // namespace leastcost
