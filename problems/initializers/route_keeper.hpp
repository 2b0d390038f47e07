// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include <leastcost/framework/problem/problem.hpp>
#include <leastcost/problems/straighten/geodesic.hpp>
#include "problems/mesh/edge_landmarks.hpp"

namespace leastcost {

/// What quick first paths on one mesh under one metric need, kept between queries: landmarks, and the searches that are
/// idle. Shared by threads.
class KeptRoutes {
 public:
  KeptRoutes(const Problem& problem, const TriangleMesh& mesh, const MetricRoot& metric, int landmarks,
             const StopPredicate& stop);

  bool is_of(const Problem& problem, const MetricRoot& metric) const;
  /// Null where none were asked for.
  const EdgeLandmarks* landmarks() const { return landmarks_ ? &*landmarks_ : nullptr; }
  GeodesicSearch borrow();
  void give_back(GeodesicSearch search);

 private:
  std::shared_ptr<const ConstraintManifold> domain_;  // kept alive, hence its address is its own
  const TriangleMesh* mesh_;
  MetricRoot metric_;
  std::optional<EdgeLandmarks> landmarks_;
  std::mutex lock_;
  std::vector<GeodesicSearch> idle_;
};

/// The routes of the domain that was asked for last.
class RouteKeeper {
 public:
  /// Makes them where there are none for this domain and metric; other threads wait. Throws Interrupted when stopped
  /// before the landmarks were made.
  std::shared_ptr<KeptRoutes> routes_for(const Problem& problem, const TriangleMesh& mesh, const MetricRoot& metric,
                                         int landmarks, const StopPredicate& stop);

 private:
  std::mutex lock_;
  std::shared_ptr<KeptRoutes> last_;
};

}  // namespace leastcost
