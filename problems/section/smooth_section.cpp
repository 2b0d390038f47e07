// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/section/smooth_section.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/problems/chart/seams.hpp>
#include <leastcost/problems/cloud/has_point_cloud.hpp>
#include "framework/base/point_text.hpp"
#include "problems/chart/chart_search.hpp"
#include "problems/section/plane_station.hpp"

namespace leastcost {
namespace {

constexpr double kMostTurn = 0.2;       ///< radians per step
constexpr double kLittleTurn = 0.08;    ///< radians below which the step grows
constexpr double kShortestStep = 1e-7;  ///< relative to the size of the coordinates
constexpr double kFarthest = 1e4;       ///< from the first point, relative to the size of the coordinates
constexpr int kMostSteps = 20000;

class Follower {
 public:
  Follower(const ConstraintManifold& surface, const Eigen::Vector3d& point, const Eigen::Vector3d& normal,
           const Deadline& deadline)
      : surface_(surface),
        chart_(find_ability<HasChart>(surface)),
        point_(point),
        normal_(normal),
        stations_(surface, point, normal),
        deadline_(deadline) {}

  CoordinatePath follow() {
    const Station start = first_station();
    size_ = std::max(point_.norm(), start.x.norm());
    if (size_ == 0) size_ = 1;  // the origin says nothing about the size; steps adapt anyway
    std::vector<Eigen::VectorXd> ring = {start.u};
    Station now = start;
    double step = 0.02 * size_, length = 0;
    for (int i = 0; i < kMostSteps; ++i) {
      Station next = advance(now, step);
      length += (next.x - now.x).norm();
      if (length > 4 * (next.x - now.x).norm() && passes(start, now, next)) return closed(std::move(ring), start, next);
      if ((next.x - start.x).norm() > kFarthest * size_) break;
      ring.push_back(next.u);
      now = std::move(next);
    }
    throw InitializationError("the plane's curve does not close: after length " + short_number(length, 6) +
                              " it is at " + point_text(now.x));
  }

 private:
  /// Of the places in the plane around the given point, on circles that grow, the first that leads to the curve; the
  /// nearest of its circle.
  Station first_station() {
    std::optional<Station> best;
    const auto take = [&](std::optional<Station> s) {
      look_at_clock(deadline_);
      if (s && (!best || (s->x - point_).norm() < (best->x - point_).norm())) best = std::move(s);
    };
    if (chart_ != nullptr) {
      for (const Eigen::VectorXd& u : nearest_in_chart(surface_, point_)) take(stations_.reach(u));
    } else if (const auto* cloud = find_ability<HasPointCloud>(surface_)) {
      for (std::int32_t i = 0; i < cloud->cloud().size(); ++i) {
        const Eigen::Vector3d p = cloud->cloud().sample(i).position + cloud->cloud().centre();
        if (std::abs(normal_.dot(p - point_)) > cloud->cloud().radius(i)) continue;
        if (!best || (p - point_).norm() < (best->x - point_).norm()) take(stations_.reach(p));
      }
    } else {
      const Eigen::Vector3d a = normal_.unitOrthogonal(), b = normal_.cross(a);
      take(stations_.reach(point_));
      for (double r = 1e-3 * (1 + point_.norm()); !best && r < 1e3 * (1 + point_.norm()); r *= 1.5)
        for (int k = 0; k < 16; ++k) {
          const double angle = 2 * std::numbers::pi * k / 16;
          take(stations_.reach(point_ + r * (std::cos(angle) * a + std::sin(angle) * b)));
        }
    }
    if (!best)
      throw InitializationError("no point of the surface was found on the plane near " + point_text(point_) +
                                ": the plane misses the surface or touches it, or the point is too far away");
    return *best;
  }

  /// The next station; `step` is adapted to how fast the curve turns.
  Station advance(const Station& now, double& step) {
    for (; step > kShortestStep * size_; step /= 2) {
      look_at_clock(deadline_);
      std::optional<Station> found = stations_.reach(now.u + now.pulled_back(step * now.along));
      if (!found) continue;
      Station next = std::move(*found);
      if (now.along.dot(next.along) < 0) next.along = -next.along;
      const double turn = std::acos(std::clamp(now.along.dot(next.along), -1.0, 1.0));
      const double moved = (next.x - now.x).norm();
      if (turn > kMostTurn || moved < 0.5 * step || moved > 1.5 * step) continue;
      refuse_bounds(next);
      if (turn < kLittleTurn) step *= 1.5;
      return next;
    }
    throw InitializationError("the plane's curve ends at " + point_text(now.x) +
                              ": the surface ends there, the plane touches it, or its chart has a pole");
  }

  void refuse_bounds(const Station& s) const {
    const auto* bounds = find_ability<HasBounds>(surface_);
    if (bounds == nullptr) return;
    Points normals(s.u.size(), s.u.size());
    if (bounds->active_bounds({s.u, {}, true}, 0, normals) > 0)
      throw InitializationError("the plane's curve leaves the domain at " + point_text(s.x) + ": it is not closed");
  }

  /// Whether the curve comes back to its start between two stations, in the direction in which it left.
  static bool passes(const Station& start, const Station& a, const Station& b) {
    const Eigen::Vector3d d = b.x - a.x;
    const double t = (start.x - a.x).dot(d) / d.squaredNorm();
    return t > 0 && t <= 1 && (a.x + t * d - start.x).norm() < 0.2 * d.norm() && start.along.dot(b.along) > 0.5;
  }

  CoordinatePath closed(std::vector<Eigen::VectorXd> ring, const Station& start, const Station& last) const {
    CoordinatePath path{Points(start.u.size(), static_cast<Index>(ring.size())), {}, true};
    for (std::size_t i = 0; i < ring.size(); ++i) path.u.col(static_cast<Index>(i)) = ring[i];
    if (const auto* domain = find_ability<HasSeams>(surface_)) {
      const Eigen::VectorXi turns = nearest_image(domain->seams(), start.u, last.u);
      if (!turns.isZero()) path.closing = seam_map(domain->seams(), static_cast<int>(start.u.size()), turns);
    }
    // The next station goes a little beyond the start: coordinates that jump belong to another image of it.
    const double beyond = (last.u - path.closing.apply(start.u)).norm();
    const double before = (last.u - ring.back()).norm();
    if (chart_ != nullptr && beyond > 2 * before)
      throw InitializationError("the plane's curve goes around a pole of the chart: its coordinates do not close");
    return path;
  }

  const ConstraintManifold& surface_;
  const HasChart* chart_;
  Eigen::Vector3d point_, normal_;
  StationFinder stations_;
  const Deadline& deadline_;
  double size_ = 1;
};

}  // namespace

CoordinatePath smooth_section(const ConstraintManifold& surface, const Eigen::Vector3d& point,
                              const Eigen::Vector3d& normal, const Deadline& deadline) {
  return Follower(surface, point, normal, deadline).follow();
}

}  // namespace leastcost
