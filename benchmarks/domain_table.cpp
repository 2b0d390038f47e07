// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// Iterations of the chain solvers against the number of points, on every domain. One run, ratios.
#include <Eigen/Core>
#include <vector>

#include <leastcost/problems/costs/euclidean.hpp>
#include <leastcost/problems/costs/metric_field.hpp>
#include <leastcost/problems/initializers/coordinate_circle.hpp>
#include <leastcost/problems/initializers/dijkstra.hpp>
#include <leastcost/problems/kernels/kernels.hpp>
#include <leastcost/problems/manifolds/constraint.hpp>
#include <leastcost/problems/manifolds/data/point_cloud.hpp>
#include <leastcost/problems/manifolds/data/signed_distance.hpp>
#include <leastcost/problems/manifolds/euclidean.hpp>
#include <leastcost/problems/manifolds/implicit.hpp>
#include <leastcost/problems/manifolds/parametric.hpp>
#include <leastcost/solvers/lbfgs.hpp>
#include <leastcost/solvers/newton.hpp>
#include "benchmarks/measure.hpp"

namespace {

using namespace leastcost;
using namespace leastcost::bench;
using Eigen::Vector2d;
using Eigen::Vector3d;

Case between(const char* name, std::shared_ptr<const ConstraintManifold> manifold, const Eigen::VectorXd& source,
             const Eigen::VectorXd& target) {
  Case c{name, {}};
  c.problem.source = project_end(*manifold, source);
  c.problem.target = project_end(*manifold, target);
  c.problem.cost = make_euclidean_cost(manifold->dimensions().ambient);
  c.problem.manifold = std::move(manifold);
  return c;
}

Case in_chart(const char* name, const parametric::Surface& surface, const Vector2d& source, const Vector2d& target) {
  return between(name, make_parametric_manifold({.surface = surface}), source, target);
}

/// A ring at the waist of a hyperboloid, from a circle above it.
Case waist() {
  Case c = in_chart("hyperboloid, ring", parametric::Hyperboloid{}, {0, 0}, {1, 1});
  c.problem.ring = true;
  CoordinateCircleOptions circle;
  circle.through = Vector2d(0, 0.7);
  c.initializer = std::make_shared<CoordinateCircleInitializer>(circle);
  return c;
}

/// On the outside of the torus, from the far left to the right.
Case implicit_torus() {
  const ImplicitManifoldOptions options{.surface = implicit::Torus{}};
  return between("implicit torus", make_implicit_manifold(options), Vector3d(3, 0, 0), Vector3d(1.2, 2, 0.9));
}

Case distance_grid() {
  SignedDistanceOptions options;
  options.source = distance_source::Implicit{.surface = {.surface = implicit::Torus{}}};
  options.cell = 0.1;
  return between("grid, torus", make_signed_distance_manifold(options, ""), Vector3d(3, 0, 0), Vector3d(1.2, 2, 0.9));
}

Case rotations() {
  ConstraintManifoldOptions options;
  options.set = constraint::Rotations{};
  return between("SO(3)", make_constraint_manifold(options), Eigen::Vector4d(1, 0, 0, 0),
                 Eigen::Vector4d(0.3, 0.6, -0.5, 0.4));
}

Case field(const char* name, const metric::Field& tensor, const Vector2d& source, const Vector2d& target) {
  Case c = between(name, std::make_shared<EuclideanManifold>(EuclideanManifoldOptions{}), source, target);
  c.problem.cost = make_metric_field_cost({.field = tensor}, 2);
  return c;
}

Case cloud() {
  PointCloudManifoldOptions options;
  options.file = LEASTCOST_PROJECT_DIR "/configs/data/torus_cloud.xyz";
  Case c =
      between("cloud, torus", make_point_cloud_manifold(options, ""), Vector3d(3, 0, 0), Vector3d(0.85, 1.33, 0.91));
  c.initializer = std::make_shared<DijkstraInitializer>();
  return c;
}

}  // namespace

int main() {
  std::vector<Case> cases = {
      in_chart("torus", parametric::Torus{}, {0, 0}, {1, 2}),
      in_chart("triaxial ellipsoid", parametric::Ellipsoid{}, {0.17, 0.35}, {1.2, -0.5}),
      in_chart("Klein bottle", parametric::KleinBottle{}, {5, 0.4}, {7.2, 1.1}),
      waist(),
      implicit_torus(),
      rotations(),
      field("half-plane", metric::HalfPlane{}, {0, 1}, {2, 3}),
      field("Poincare disc", metric::PoincareDisc{}, {0.9, 0}, {-0.5, 0.7}),
      distance_grid(),
      cloud(),
  };
  const std::vector<int> sizes = {20, 200, 2000, 20000};
  print_heading(sizes);
  for (Case& c : cases)
    for (const auto& [name, solve] : std::vector<std::pair<const char*, Solve>>{
             {"newton", direct(std::make_shared<Newton>())}, {"lbfgs chain", direct(std::make_shared<Lbfgs>())}}) {
      c.problem.kernel = make_kernel<Expm1Square>();
      std::vector<Outcome> row;
      for (const int n : sizes) row.push_back(measure(c, n, solve, 1));
      print_row(c.name, "expm1_square", name, sizes, row);
    }
}
