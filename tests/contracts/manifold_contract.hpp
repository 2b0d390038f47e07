// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include <leastcost/framework/check/check_manifold.hpp>
#include <leastcost/problems/mesh/has_mesh.hpp>
#include "tests/support/catch.hpp"
#include "tests/support/random.hpp"

namespace leastcost::test {

/// What the contract needs to know about a domain besides the domain.
struct ManifoldCase {
  std::shared_ptr<const ConstraintManifold> manifold;
  std::function<Eigen::VectorXd(Random&)> near;  ///< a point near the domain, in coordinates
  std::vector<Eigen::VectorXd> special = {};     ///< nearly degenerate ones: 1e-8 off an edge, a corner, a bound
  double size = 1;                               ///< rounding is measured against it
  double step = 1;                               ///< longest step, see CheckManifoldOptions
};

/// A ring through points (every column free), projected.
inline CoordinatePath projected(const ConstraintManifold& manifold, const Points& points) {
  CoordinatePath path{points, {}, true};
  CHECK(manifold.project(path).failed.empty());
  return path;
}

/// Where a point is does not depend on where the search for it began.
inline void check_hints(const ManifoldCase& c, const Points& points, Random& random) {
  const auto* domain = dynamic_cast<const HasMesh*>(c.manifold.get());
  if (!domain) return;
  const CoordinatePath unaided = projected(*c.manifold, points);
  for (int repeat = 0; repeat < 5; ++repeat) {
    CoordinatePath hinted{points, {}, true};
    for (Index i = 0; i < points.cols(); ++i)
      hinted.sites.push_back(random.integer(0, domain->mesh().face_count() - 1));
    CHECK(c.manifold->project(hinted).failed.empty());
    CHECK((hinted.u - unaided.u).cwiseAbs().maxCoeff() <= 1e-14 * c.size);
  }
}

/// Whether a point is a vertex of a mesh: a step off a corner of its border may slide along the other edge.
inline bool is_vertex(const ManifoldCase& c, const Eigen::VectorXd& x) {
  const auto* domain = dynamic_cast<const HasMesh*>(c.manifold.get());
  if (!domain) return false;
  for (const Eigen::Vector3d& p : domain->mesh().positions())
    if ((x - p.head(x.size())).norm() < 1e-6 * c.size) return true;
  return false;
}

/// On the border of a mesh, away from its corners: a step outwards does not move the point, a step inwards does.
inline void check_border(const ManifoldCase& c, const CoordinatePath& path) {
  const auto* bounds = dynamic_cast<const HasBounds*>(c.manifold.get());
  if (!bounds || c.manifold->shape() != Shape::polyhedral) return;
  Points normals(path.u.rows(), path.u.rows());
  for (Index i = 0; i < path.u.cols(); ++i) {
    if (bounds->active_bounds(path, i, normals) != 1 || is_vertex(c, path.u.col(i))) continue;
    CoordinatePath one{path.u.col(i), {path.site(i)}, true}, to;
    c.manifold->retract(one, 1e-4 * normals.col(0), to);
    CHECK((to.u - one.u).norm() <= 1e-8 * c.size);
    c.manifold->retract(one, -1e-4 * normals.col(0), to);
    CHECK((to.u - one.u).norm() == Approx(1e-4).epsilon(1e-3));
  }
}

/// The contract of ConstraintManifold (framework/domain/manifold.hpp), by the check that authors have as well; and of
/// meshes.
inline void check_manifold_contract(const ManifoldCase& c) {
  Random random;
  CheckManifoldOptions options;
  options.size = c.size;
  options.step = c.step;
  options.special = c.special;
  CHECK(text(check_manifold(
            *c.manifold, [&](std::mt19937_64&) { return c.near(random); }, random.engine(), options)) == "");
  Points points(c.manifold->dimensions().coordinate, 12 + static_cast<Index>(c.special.size()));
  for (Index i = 0; i < 12; ++i) points.col(i) = c.near(random);
  for (std::size_t i = 0; i < c.special.size(); ++i) points.col(12 + static_cast<Index>(i)) = c.special[i];
  check_hints(c, points, random);
  check_border(c, projected(*c.manifold, points));
}

}  // namespace leastcost::test
