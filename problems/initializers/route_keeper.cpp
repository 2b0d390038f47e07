// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/initializers/route_keeper.hpp"

#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include "problems/mesh/choose_landmarks.hpp"

namespace leastcost {

KeptRoutes::KeptRoutes(const Problem& problem, const TriangleMesh& mesh, const MetricRoot& metric, int landmarks,
                       const StopPredicate& stop)
    : domain_(problem.manifold), mesh_(&mesh), metric_(metric) {
  if (landmarks == 0) return;
  landmarks_ = choose_landmarks(mesh, landmarks, metric, stop);
  if (stop && stop()) throw Interrupted("the landmarks of the mesh were not ready");
}

bool KeptRoutes::is_of(const Problem& problem, const MetricRoot& metric) const {
  return problem.manifold == domain_ && metric.has_value() == metric_.has_value() && (!metric || *metric == *metric_);
}

GeodesicSearch KeptRoutes::borrow() {
  {
    const std::lock_guard<std::mutex> guard(lock_);
    if (!idle_.empty()) {
      GeodesicSearch search = std::move(idle_.back());
      idle_.pop_back();
      return search;
    }
  }
  return GeodesicSearch(*mesh_);
}

void KeptRoutes::give_back(GeodesicSearch search) {
  const std::lock_guard<std::mutex> guard(lock_);
  idle_.push_back(std::move(search));
}

std::shared_ptr<KeptRoutes> RouteKeeper::routes_for(const Problem& problem, const TriangleMesh& mesh,
                                                    const MetricRoot& metric, int landmarks,
                                                    const StopPredicate& stop) {
  const std::lock_guard<std::mutex> guard(lock_);
  if (!last_ || !last_->is_of(problem, metric))
    last_ = std::make_shared<KeptRoutes>(problem, mesh, metric, landmarks, stop);
  return last_;
}

}  // namespace leastcost
