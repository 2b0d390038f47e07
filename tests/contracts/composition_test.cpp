// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// Every cost on every domain it fits, through one find_path(); and a kernel, a cost and a manifold of ten lines each
// that solve with no other file touched.
#include <Eigen/Geometry>

#include <leastcost/framework/cost/segment_cost_function.hpp>
#include <leastcost/problems/costs/metric_tensor.hpp>
#include <leastcost/problems/initializers/dijkstra.hpp>
#include <leastcost/problems/manifolds/data/mesh.hpp>
#include <leastcost/problems/post_processors/straighten.hpp>
#include <leastcost/problems/post_processors/trace.hpp>
#include "tests/problems/sample_meshes.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/chute_chain.hpp"
#include "tests/support/compose.hpp"
#include "tests/support/random.hpp"

namespace leastcost::test {
namespace {

/// cosh s - 1: convex, of the third kind.
struct Cosh {
  static constexpr KernelKind kind = KernelKind::quadratic_at_zero;
  Jet2 operator()(double q) const {
    const double s = std::sqrt(q);
    if (s < 1e-2) return {q / 2 + q * q / 24, 0.5 + q / 12 + q * q / 240, 1.0 / 12 + q / 120};
    return {std::cosh(s) - 1, std::sinh(s) / (2 * s), (std::cosh(s) - std::sinh(s) / s) / (4 * q)};
  }
};

/// Length in a medium that is twice as slow at height 1 as at height 0.
struct SlowAbove {
  static constexpr int dim = 3;
  CostTraits traits() const { return {.unit = "s"}; }
  template <class S>
  S value(const Point<S, 3>& a, const Point<S, 3>& b) const {
    const S slowness = S(1.5) + (a[2] + b[2]) * 0.25;
    return (b - a).squaredNorm() * slowness * slowness;
  }
};

/// The cylinder of radius 1 around the z axis.
class Cylinder final : public EmbeddedManifold {
 public:
  Cylinder() : EmbeddedManifold({3, 3, 2}) {}
  bool project_point(Eigen::Ref<Eigen::VectorXd> x) const override {
    if (!(x.head(2).norm() > 0)) return false;
    x.head(2).normalize();
    return true;
  }
  void tangent_basis(const Eigen::VectorXd& x, Eigen::Ref<Points> basis) const override {
    basis << -x[1], 0, x[0], 0, 0, 1;
  }
};

std::shared_ptr<const ConstantMetricCost> metric_cost(int d) {
  MetricTensorOptions options;
  options.matrix = Eigen::VectorXd::LinSpaced(d, 1, 3).asDiagonal();
  return make_metric_tensor_cost(options, d);
}

std::shared_ptr<const SegmentCost> bead_cost(const Eigen::VectorXd& source, TravelTimeRule rule, double start_speed) {
  TravelTimeOptions options;
  options.rule = rule;
  options.gravity = 1;
  options.start_speed = start_speed;
  return make_travel_time_cost(options, static_cast<int>(source.size()), source);
}

/// A square of 2 x 2 in the plane through 0 with unit axes e (level) and f (falling), m x m quads.
std::shared_ptr<const MeshManifold> tilted_plane(const Eigen::Vector3d& e, const Eigen::Vector3d& f, int m) {
  PolygonSoup soup;
  for (int i = 0; i <= m; ++i)
    for (int j = 0; j <= m; ++j) soup.positions.emplace_back((2.0 * i / m - 0.2) * e + (2.0 * j / m - 0.2) * f);
  for (int i = 0; i < m; ++i)
    for (int j = 0; j < m; ++j)
      add_polygon(soup, {i * (m + 1) + j, (i + 1) * (m + 1) + j, (i + 1) * (m + 1) + j + 1, i * (m + 1) + j + 1});
  return std::make_shared<MeshManifold>(TriangleMesh(soup));
}

Result find_on_mesh(const Problem& problem, int points,
                    std::vector<std::shared_ptr<const PostProcessor>> post_processors) {
  const Newton newton;
  FindOptions options;
  options.points = points;
  options.post_processors = std::move(post_processors);
  return find_path(problem, DijkstraInitializer(), newton, options);
}

}  // namespace

TEST_CASE("composition: every cost in R^2, R^3 and R^7", "[contract]") {
  const int d = GENERATE(2, 3, 7);
  Random random;
  const Eigen::VectorXd down = -Eigen::VectorXd::Unit(d, d - 1), source = random.vector(d);
  const Eigen::VectorXd target = source + random.vector(d) + 4 * down;
  using Cost = std::shared_ptr<const SegmentCost>;
  for (const Cost& cost :
       {Cost(make_euclidean_cost(d)), Cost(metric_cost(d)), bead_cost(source, TravelTimeRule::chute, 0),
        bead_cost(source, TravelTimeRule::chute, 1), bead_cost(source, TravelTimeRule::midpoint, 1)}) {
    const Result result = find(between(space(d), cost, source, target), 24);
    CAPTURE(d, cost->traits().unit, failures(result.certificate));
    CHECK(result.status == Status::certified);
    CHECK(result.certificate.estimate.value == Approx(result.costs.sum()).epsilon(0.01));
  }
}

TEST_CASE("composition: a bead in R^d falls in the vertical plane of its ends", "[contract]") {
  const int d = GENERATE(2, 3, 7);
  Eigen::VectorXd target = Eigen::VectorXd::Constant(d, 2 / std::sqrt(d - 1.0));  // 2 across
  target[d - 1] = -1;
  const Result result = find(bead(Eigen::VectorXd::Zero(d), target), 20);
  CHECK(result.status == Status::certified);
  CHECK(result.costs.sum() == Approx(chute_chain_time(2, 1, 1, 21)).epsilon(1e-9));
}

TEST_CASE("composition: every cost on a mesh", "[contract]") {
  const auto mesh = std::make_shared<MeshManifold>(TriangleMesh(sphere(4)));
  const Eigen::Vector3d source(0.1, 0.2, 0.97), target(0.9, -0.3, -0.3);
  const auto trace = std::make_shared<const TracePostProcessor>();
  const auto straighten = std::make_shared<const StraightenPostProcessor>();
  for (const auto& cost : {make_euclidean_cost(3), metric_cost(3)}) {
    const Result result = find_on_mesh(between(mesh, cost, source, target), 32, {trace, straighten});
    CAPTURE(cost->traits().unit, failures(result.certificate));
    CHECK(result.status == Status::certified);
    CHECK(result.certificate.scope == Scope::local_on_polyhedron);
  }
  const Eigen::VectorXd from = project_end(*mesh, source).u;
  for (const auto& cost : {bead_cost(from, TravelTimeRule::chute, 0), bead_cost(from, TravelTimeRule::chute, 1),
                           bead_cost(from, TravelTimeRule::midpoint, 1), make_segment_cost(SlowAbove{})}) {
    const Result result = find_on_mesh(between(mesh, cost, source, target), 32, {trace});
    CAPTURE(cost->traits().unit, failures(result.certificate));
    CHECK(result.status == Status::certified);
    CHECK(result.certificate.scope == Scope::chain_on_polyhedron);
    CHECK(result.costs.sum() < result.initial_cost);
  }
}

TEST_CASE("composition: a bead on a tilted mesh plane is a bead in R^2 with less gravity", "[contract]") {
  const double slope = GENERATE(0.4, 1.2);  // angle of the plane, radians
  const Eigen::Vector3d e = Eigen::Vector3d(0.6, 0.8, 0),
                        f(0.8 * std::cos(slope), -0.6 * std::cos(slope), -std::sin(slope));
  const auto mesh = tilted_plane(e, f, 9);
  const Eigen::Vector3d zero = Eigen::Vector3d::Zero(), target = 1.5 * e + 1 * f;
  const auto trace = std::make_shared<const TracePostProcessor>();
  const Result result =
      find_on_mesh(between(mesh, bead_cost(zero, TravelTimeRule::chute, 0), zero, target), 30, {trace});
  const double time = chute_chain_time(1.5, 1, std::sin(slope), 31);
  CAPTURE(slope, result.costs.sum(), time, word_of(result.solve.termination), failures(result.certificate));
  CHECK(result.costs.sum() == Approx(time).epsilon(1e-7));
  CHECK(result.curve.cost == Approx(time).epsilon(1e-7));  // a chute is additive: tracing changes nothing
  CHECK(result.status == Status::certified);
}

TEST_CASE("composition: a kernel, a cost and a manifold from this file alone", "[contract]") {
  const Eigen::Vector3d source(1, 0, 0), target(std::cos(2.0), std::sin(2.0), 3);
  const auto cylinder = std::make_shared<Cylinder>();
  SECTION("kernel and manifold: the cylinder's helix, docs/oracles.md D1") {
    const int n = GENERATE(8, 64);
    const Result result = find(between(cylinder, make_euclidean_cost(3), source, target, make_kernel<Cosh>()), n - 1);
    CHECK(result.status == Status::certified);
    CHECK(result.costs.sum() == Approx(n == 8 ? 3.60266707052392889 : 3.60550613503331362).epsilon(1e-12));
    CHECK(std::abs(result.certificate.estimate.value - std::sqrt(13.0)) <= result.certificate.estimate.error);
  }
  SECTION("all three: in a medium that varies along the cylinder the helix is no longer best") {
    const Problem problem = between(cylinder, make_segment_cost(SlowAbove{}), source, target, make_kernel<Cosh>());
    const Result result = find(problem, 40);
    CAPTURE(failures(result.certificate));
    CHECK(result.status == Status::certified);
    const Result helix = find(between(cylinder, make_euclidean_cost(3), source, target, make_kernel<Cosh>()), 40);
    CHECK(result.costs.sum() < PathEnergy(problem, 1).cost(helix.path));
    CHECK(result.path.u(2, 20) > helix.path.u(2, 20));  // equal in time: more of them where it is slow
  }
  SECTION("cost and kernel in R^3 and on a mesh") {
    const auto cost = make_segment_cost(SlowAbove{});
    CHECK(find(between(space(3), cost, source, target, make_kernel<Cosh>()), 20).status == Status::certified);
  }
}

}  // namespace leastcost::test
