// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/robots/segment_distance.hpp"

#include <algorithm>
#include <cmath>

namespace leastcost {
namespace {

/// The place on a segment that is nearest to a point.
double place_nearest_to(const Segment3& segment, const Eigen::Vector3d& x) {
  const Eigen::Vector3d way = segment.to - segment.from;
  const double square = way.squaredNorm();
  return square > 0 ? std::clamp((x - segment.from).dot(way) / square, 0.0, 1.0) : 0;
}

}  // namespace

/// Either it is between the insides of both, where the line between them is at right angles to both, or at an end.
double distance_of_segments(const Segment3& first, const Segment3& second, double& s, double& t) {
  double least = (first.from - second.from).squaredNorm();
  s = t = 0;
  const auto take = [&](double at, double other) {
    const double square = (first.at(at) - second.at(other)).squaredNorm();
    if (square >= least) return;
    least = square;
    s = at;
    t = other;
  };
  const Eigen::Vector3d u = first.to - first.from, v = second.to - second.from, w = first.from - second.from;
  const double uu = u.squaredNorm(), uv = u.dot(v), vv = v.squaredNorm(), det = uu * vv - uv * uv;
  if (det > 0) {
    const double at = std::clamp((uv * v.dot(w) - vv * u.dot(w)) / det, 0.0, 1.0);
    const double other = place_nearest_to(second, first.at(at));
    take(place_nearest_to(first, second.at(other)), other);
  }
  for (const double end : {0.0, 1.0}) {
    take(end, place_nearest_to(second, first.at(end)));
    take(place_nearest_to(first, second.at(end)), end);
  }
  return std::sqrt(least);
}

}  // namespace leastcost
