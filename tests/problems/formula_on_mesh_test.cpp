// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// A cost by formula on a mesh against a search that shares no code with ours: Dijkstra over many places on each edge,
// with straight moves across faces whose costs are integrals of the same formula, written again by hand.
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <queue>
#include <utility>
#include <vector>

#include <leastcost/problems/costs/formula_cost.hpp>
#include <leastcost/problems/initializers/dijkstra.hpp>
#include <leastcost/problems/manifolds/data/mesh.hpp>
#include <leastcost/problems/post_processors/trace.hpp>
#include <leastcost/solvers/lbfgs.hpp>
#include "tests/problems/sample_meshes.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/compose.hpp"

namespace leastcost::test {
namespace {

using Eigen::Vector3d;

/// The integral of (1 + 4 z^2) |v| along a straight move: Simpson's rule is exact for a parabola.
double cost_of_move(const Vector3d& a, const Vector3d& b) {
  const auto unit = [](double z) { return 1 + 4 * z * z; };
  return (b - a).norm() * (unit(a.z()) + 4 * unit((a.z() + b.z()) / 2) + unit(b.z())) / 6;
}

/// The least cost between two vertices over `between` places on each edge: an upper bound of the least cost there is.
double dijkstra_over_places(const TriangleMesh& mesh, int source, int target, int between) {
  std::vector<Vector3d> places(mesh.positions().begin(), mesh.positions().end());
  std::vector<std::vector<std::pair<int, double>>> moves;
  std::map<std::pair<int, int>, int> first_on;
  std::vector<std::vector<int>> on_faces;
  for (const auto& face : mesh.faces()) {
    std::vector<int> on = {face[0], face[1], face[2]};
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [a, b] = std::minmax(face[k], face[(k + 1) % 3]);
      const auto [edge, is_new] = first_on.try_emplace({a, b}, static_cast<int>(places.size()));
      for (int i = 1; is_new && i <= between; ++i) {
        const double t = static_cast<double>(i) / (between + 1);
        places.emplace_back((1 - t) * mesh.position(a) + t * mesh.position(b));
      }
      for (int i = 0; i < between; ++i) on.push_back(edge->second + i);
    }
    on_faces.push_back(std::move(on));
  }
  moves.resize(places.size());
  for (const std::vector<int>& on : on_faces)
    for (const int a : on)
      for (const int b : on)
        if (a != b) {
          const double cost = cost_of_move(places[static_cast<std::size_t>(a)], places[static_cast<std::size_t>(b)]);
          moves[static_cast<std::size_t>(a)].emplace_back(b, cost);
        }
  std::vector<double> cost(places.size(), std::numeric_limits<double>::infinity());
  std::priority_queue<std::pair<double, int>, std::vector<std::pair<double, int>>, std::greater<>> open;
  cost[static_cast<std::size_t>(source)] = 0;
  open.emplace(0, source);
  while (!open.empty()) {
    const auto [here, at] = open.top();
    open.pop();
    if (at == target) return here;
    if (here > cost[static_cast<std::size_t>(at)]) continue;
    for (const auto& [to, step] : moves[static_cast<std::size_t>(at)])
      if (here + step < cost[static_cast<std::size_t>(to)])
        open.emplace(cost[static_cast<std::size_t>(to)] = here + step, to);
  }
  return std::numeric_limits<double>::infinity();
}

}  // namespace

TEST_CASE("formula on a mesh: its path costs what a search over places on all edges finds") {
  const auto hill = [](double u, double v) {
    return Vector3d(u, v, 0.35 * std::sin(5 * u + 1) * std::cos(4 * v) + 0.1 * std::sin(9 * u * v));
  };
  const auto mesh = std::make_shared<const MeshManifold>(TriangleMesh(sheet(12, 12, hill)));
  const auto cost = make_formula_cost({.lagrangian = "(1+4*z^2)*sqrt(vx^2+vy^2+vz^2)"}, 3, {});
  FindOptions options{.points = 40};
  options.post_processors = {std::make_shared<const TracePostProcessor>()};
  for (const auto& [source, target] : {std::pair(0, 168), std::pair(26, 160)}) {
    Problem problem{mesh, cost, make_kernel<Expm1Square>(), mesh->vertex(source), mesh->vertex(target)};
    const Result result = find_path(problem, DijkstraInitializer(), Lbfgs(), options);
    const double bound = dijkstra_over_places(mesh->mesh(), source, target, 7);
    const CostEstimate& estimate = result.certificate.estimate;
    CAPTURE(result.curve.cost, bound, estimate.value, estimate.error, result.status);
    CHECK(result.curve.cost == Approx(bound).epsilon(2e-3));
    CHECK(estimate.value - estimate.error < bound);
  }
}

}  // namespace leastcost::test
