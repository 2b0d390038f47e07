// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/mesh/mesh_curve.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <limits>
#include <string>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/cost/has_constant_metric.hpp>

namespace leastcost {

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
  const double near = 1e-9 * extent_of(curve.x);
  const Eigen::VectorXd costs =
      segment_costs(*problem.cost, {{curve.x.data(), curve.x.rows(), curve.x.cols()}, {}, false});
  Eigen::VectorXd between = Eigen::VectorXd::Constant(segments, std::numeric_limits<double>::infinity());
  Index piece = 0;
  double passed = 0, before = 0;  // cost up to `piece`; cost up to the last point of the chain
  for (Index i = 0; i <= segments; ++i) {
    for (; piece < pieces; passed += costs[piece++]) {
      const Eigen::VectorXd a = curve.x.col(piece), d = curve.x.col(piece + 1) - curve.x.col(piece);
      const Eigen::VectorXd to = chain.u.col(i % chain.u.cols()) - curve.x.col(piece);
      const double t = d.squaredNorm() > 0 ? std::clamp(to.dot(d) / d.squaredNorm(), 0.0, 1.0) : 0;
      if ((to - t * d).norm() > near) continue;
      const double here = passed + move_cost(*problem.cost, a, a + t * d);
      if (i > 0) between[i - 1] = here - before;
      before = here;
      break;
    }
    if (piece == pieces) break;
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
