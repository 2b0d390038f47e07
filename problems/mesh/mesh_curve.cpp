// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/mesh/mesh_curve.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <limits>
#include <optional>
#include <string>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/cost/has_constant_metric.hpp>

namespace leastcost {
namespace {

/// A place on a piece of a curve, the share t of it from its beginning.
struct PlaceOnCurve {
  Index piece = 0;
  double t = 0;
};

/// Finds points on a curve by their positions, in the order in which the curve passes them. Where the curve comes back
/// to a place, on another sheet of a fold, the face of a point tells which of its pieces is meant.
class CurveFollower {
 public:
  explicit CurveFollower(const Curve& curve)
      : curve_(curve), near_(std::max(kNear * extent_of(curve.x), kRoundings * curve.x.cwiseAbs().maxCoeff())) {}

  std::optional<PlaceOnCurve> at_start(const Eigen::VectorXd& x) {
    return (x - curve_.x.col(0)).norm() <= near_ ? std::optional(PlaceOnCurve{}) : next(x, kNoSite);
  }

  std::optional<PlaceOnCurve> at_end(const Eigen::VectorXd& x) {
    const Index last = curve_.x.cols() - 1;
    if ((x - curve_.x.col(last)).norm() <= near_) return PlaceOnCurve{last - 1, 1};
    return next(x, kNoSite);
  }

  /// The first place from the last one on, on a piece with that face where there is one.
  std::optional<PlaceOnCurve> next(const Eigen::VectorXd& x, Site face) {
    std::optional<PlaceOnCurve> found = face == kNoSite ? std::nullopt : first_near(x, face);
    if (!found) found = first_near(x, kNoSite);
    if (found) last_ = *found;
    return found;
  }

 private:
  static constexpr double kNear = 1e-9;                                              ///< of the extent of the curve
  static constexpr double kRoundings = 16 * std::numeric_limits<double>::epsilon();  ///< of the largest coordinate

  std::optional<PlaceOnCurve> first_near(const Eigen::VectorXd& x, Site face) const {
    for (Index piece = last_.piece; piece + 1 < curve_.x.cols(); ++piece) {
      if (face != kNoSite && !curve_.segment_sites.empty() &&
          curve_.segment_sites[static_cast<std::size_t>(piece)] != face)
        continue;
      const Eigen::VectorXd d = curve_.x.col(piece + 1) - curve_.x.col(piece), to = x - curve_.x.col(piece);
      const double from = piece == last_.piece ? last_.t : 0;
      const double t = d.squaredNorm() > 0 ? std::clamp(to.dot(d) / d.squaredNorm(), from, 1.0) : from;
      if ((to - t * d).norm() <= near_) return PlaceOnCurve{piece, t};
    }
    return std::nullopt;
  }

  const Curve& curve_;
  double near_;
  PlaceOnCurve last_;
};

}  // namespace

const HasMesh& mesh_of(const Problem& problem, std::string_view name) {
  const auto* domain = find_ability<HasMesh>(*problem.manifold);
  if (!domain) throw InputError(std::string(name) + " needs a domain that is a mesh");
  return *domain;
}

std::optional<MetricRoot> constant_metric(const Problem& problem) {
  const auto* cost = find_ability<HasConstantMetric>(*problem.cost);
  if (!cost) return std::nullopt;
  const Eigen::MatrixXd metric = cost->metric();
  if (metric.isIdentity(0)) return MetricRoot{};
  Eigen::Matrix3d m = Eigen::Matrix3d::Identity();
  m.topLeftCorner(metric.rows(), metric.cols()) = metric;
  return MetricRoot{Eigen::Matrix3d(m.llt().matrixU())};
}

Eigen::Vector3d in_space(const Eigen::VectorXd& x) {
  Eigen::Vector3d p = Eigen::Vector3d::Zero();
  p.head(x.size()) = x;
  return p;
}

std::vector<SurfacePoint> surface_points(const TriangleMesh& mesh, const CoordinatePath& path) {
  std::vector<SurfacePoint> points;
  points.reserve(static_cast<std::size_t>(path.u.cols()));
  for (Index i = 0; i < path.u.cols(); ++i)
    points.push_back(point_on_face(mesh, path.site(i), in_space(path.u.col(i))));
  return points;
}

CoordinatePath coordinate_path(const Problem& problem, const TriangleMesh& mesh,
                               const std::vector<SurfacePoint>& points) {
  const int rows = problem.manifold->dimensions().coordinate;
  CoordinatePath path{Points(rows, static_cast<Index>(points.size())), {}, false};
  path.sites.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    path.u.col(static_cast<Index>(i)) = mesh.point(points[i]).head(rows);
    path.sites.push_back(points[i].face);
  }
  return path;
}

CoordinatePath as_coordinates(const Problem& problem, const SurfacePath& path) {
  const int rows = problem.manifold->dimensions().coordinate;
  CoordinatePath out{Points(rows, static_cast<Index>(path.points.size())), path.faces, false};
  for (std::size_t i = 0; i < path.points.size(); ++i) out.u.col(static_cast<Index>(i)) = path.points[i].head(rows);
  if (!path.faces.empty()) out.sites.push_back(path.faces.back());
  return out;
}

Curve as_curve(const Problem& problem, const SurfacePath& path) {
  const int rows = problem.manifold->dimensions().ambient;
  Curve curve;
  curve.x.resize(rows, static_cast<Index>(path.points.size()));
  for (std::size_t i = 0; i < path.points.size(); ++i) curve.x.col(static_cast<Index>(i)) = path.points[i].head(rows);
  if (!problem.ring && curve.x.cols() > 1) {  // barycentric rounding may lift an end above the level of a bead at rest
    curve.x.col(0) = problem.source.u;
    curve.x.rightCols(1) = problem.target.u;
  }
  curve.segment_sites = path.faces;
  curve.cost = total_cost(*problem.cost, {{curve.x.data(), rows, curve.x.cols()}, {}, false});
  return curve;
}

Eigen::VectorXd costs_along(const Problem& problem, const Curve& curve, const CoordinatePath& chain) {
  const Index pieces = curve.x.cols() - 1, segments = chain.segment_count();
  const Eigen::VectorXd costs =
      segment_costs(*problem.cost, {{curve.x.data(), curve.x.rows(), curve.x.cols()}, {}, false});
  Eigen::VectorXd between = Eigen::VectorXd::Constant(segments, std::numeric_limits<double>::infinity());
  CurveFollower follower(curve);
  Index piece = 0;
  double passed = 0, before = 0;  // cost up to `piece`; cost up to the last point of the chain
  for (Index i = 0; i <= segments; ++i) {
    const Index column = i % chain.u.cols();
    const bool is_last = i == segments && !chain.ring;
    const std::optional<PlaceOnCurve> place = i == 0    ? follower.at_start(chain.u.col(column))
                                              : is_last ? follower.at_end(chain.u.col(column))
                                                        : follower.next(chain.u.col(column), chain.site(column));
    if (!place) break;
    for (; piece < std::min(place->piece, pieces); ++piece) passed += costs[piece];
    double here = passed;
    if (place->t > 0) {
      const Eigen::VectorXd a = curve.x.col(place->piece), d = curve.x.col(place->piece + 1) - a;
      here += place->t < 1 ? move_cost(*problem.cost, a, a + place->t * d) : costs[place->piece];
    }
    if (i > 0) between[i - 1] = here - before;
    before = here;
  }
  return between;
}

SurfacePath as_surface_path(const Curve& curve) {
  SurfacePath path;
  for (Index i = 0; i < curve.x.cols(); ++i) path.points.push_back(in_space(curve.x.col(i)));
  path.faces = curve.segment_sites;
  return path;
}

}  // namespace leastcost
