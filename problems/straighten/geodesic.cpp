// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/straighten/geodesic.hpp>

#include <algorithm>
#include <exception>
#include <utility>

#include <leastcost/framework/base/errors.hpp>

namespace leastcost {

Geodesic GeodesicSearch::shortest(const SurfacePoint& source, const SurfacePoint& target,
                                  const GeodesicOptions& options) {
  LengthSearchOptions graph_options;
  graph_options.metric = options.metric;
  graph_options.stop = options.stop;
  graph_options.landmarks = options.landmarks;
  StraightenOptions straighten_options;
  straighten_options.metric = options.metric;
  straighten_options.stop = options.stop;
  straighten_options.flips = options.flips;

  Geodesic best;
  std::exception_ptr error;
  for (int route = 0; route < std::min(options.routes, 2); ++route) {
    graph_options.diagonals = route == 0;
    Geodesic next;
    next.first = graph_.shortest(source, target, graph_options);
    if (!next.found()) return route == 0 ? next : best;
    try {
      next.result = straighten(*mesh_, next.first.path, straighten_options);
    } catch (const InputError&) {  // another route may keep clear of the edge with three faces
      error = std::current_exception();
      continue;
    }
    if (!best.found() || next.result.final_length < best.result.final_length) best = std::move(next);
    if (options.stop && options.stop()) break;
  }
  if (!best.found() && error) std::rethrow_exception(error);
  return best;
}

}  // namespace leastcost
