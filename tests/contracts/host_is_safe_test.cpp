// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// What data can do to a call: a typed outcome or an exception, never an abort.
#include <cmath>
#include <limits>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/cost/segment_cost_function.hpp>
#include <leastcost/problems/costs/metric_field.hpp>
#include <leastcost/problems/initializers/bow.hpp>
#include <leastcost/problems/initializers/dijkstra.hpp>
#include <leastcost/problems/manifolds/data/mesh.hpp>
#include <leastcost/problems/manifolds/parametric.hpp>
#include <leastcost/solvers/gradient_descent.hpp>
#include "tests/problems/sample_meshes.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/compose.hpp"

namespace leastcost::test {
namespace {

/// Free of charge along the line y = 0.
struct FreeLine {
  static constexpr int dim = 2;
  CostTraits traits() const { return {.unit = "cost"}; }
  template <class S>
  S value(const Point<S, 2>& a, const Point<S, 2>& b) const {
    const S y = (a[1] + b[1]) * 0.5;
    return (b - a).squaredNorm() * y * y;
  }
};

/// Length below y = 1, and nothing above it.
struct Fenced {
  static constexpr int dim = 2;
  bool speaks = true;
  CostTraits traits() const { return {.unit = "length"}; }
  template <class S>
  S value(const Point<S, 2>& a, const Point<S, 2>& b) const {
    if (innermost(a[1]) > 1 || innermost(b[1]) > 1) return S(std::numeric_limits<double>::infinity());
    return (b - a).squaredNorm();
  }
  std::string why_infinite(const Eigen::VectorXd& a, const Eigen::VectorXd& b) const {
    return speaks && std::max(a[1], b[1]) > 1 ? "it crosses the fence at y = 1" : "";
  }
};

class Start final : public Initializer {
 public:
  explicit Start(CoordinatePath path) : path_(std::move(path)) {}
  std::string_view name() const override { return "start"; }
  FirstPath first_path(const Problem&, const Monitor&) const override { return {path_, {}, {}}; }

 private:
  CoordinatePath path_;
};

std::string message_of(const Problem& problem) {
  try {
    find_path(problem, StraightInitializer(), Newton());
  } catch (const InitializationError& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("host: a path that comes to cost nothing", "[contract]") {
  const Problem problem =
      between(space(2), make_segment_cost(FreeLine{}), Eigen::Vector2d(-0.8, 1), Eigen::Vector2d(0.8, 1));
  const auto solver = GENERATE(as<std::shared_ptr<const Solver>>(), std::make_shared<Newton>(),
                               std::make_shared<Lbfgs>(), std::make_shared<GradientDescent>());
  for (const int points : {1, 7, 40}) {
    FindOptions options;
    options.points = points;
    options.cascade = points == 40;
    const Result result = find_path(problem, StraightInitializer(), *solver, options);
    CAPTURE(points, solver->name(), failures(result.certificate));
    CHECK(result.status != Status::interrupted);
    CHECK(result.path.u.allFinite());
  }
}

TEST_CASE("host: both ends are the apex of a cone", "[contract]") {
  Problem problem;
  problem.manifold = make_parametric_manifold({.surface = parametric::Cone{}});
  problem.cost = make_euclidean_cost(3);
  problem.kernel = make_kernel<Expm1Square>();
  problem.source.u = Eigen::Vector2d(0, 0);
  problem.target.u = Eigen::Vector2d(1, 0);
  const auto solver =
      GENERATE(as<std::shared_ptr<const Solver>>(), std::make_shared<Newton>(), std::make_shared<Lbfgs>());
  CHECK_THROWS_AS(find_path(problem, BowInitializer(BowOptions{}), *solver), InputError);
}

TEST_CASE("host: an end on a mesh without its face", "[contract]") {
  const auto mesh = std::make_shared<const MeshManifold>(TriangleMesh(sphere(2)));
  const MetricFieldOptions curvature{.field = CurvatureMetricOptions{.weight = 0.3}};
  Problem problem;
  problem.manifold = mesh;
  problem.cost = GENERATE_COPY(as<std::shared_ptr<const SegmentCost>>(), make_euclidean_cost(3),
                               make_metric_field_cost(curvature, 3, mesh.get()));
  problem.kernel = make_kernel<Expm1Square>();
  problem.source.u = Eigen::Vector3d(0, 0, 1);
  problem.target.u = Eigen::Vector3d(1, 0, 0);
  FindOptions options;
  options.points = 15;
  const Result result = find_path(problem, DijkstraInitializer(), Lbfgs(), options);
  CHECK(result.costs.sum() > 1);
  Problem sited = problem;
  sited.source = project_end(*mesh, problem.source.u);
  sited.target = project_end(*mesh, problem.target.u);
  CHECK(find_path(sited, DijkstraInitializer(), Lbfgs(), options).path.u == result.path.u);
  problem.target.u = Eigen::Vector3d(1.1, 0.2, 0);  // beside the mesh: moved, and said
  const Result moved = find_path(problem, DijkstraInitializer(), Lbfgs(), options);
  CHECK(mesh->residual(moved.path) < 1e-12);
  CHECK_FALSE(moved.notes.empty());
  sited.target.site = 1 << 30;
  CHECK_THROWS_AS(find_path(sited, DijkstraInitializer(), Lbfgs(), options), InputError);
}

TEST_CASE("host: options and first paths that cannot be", "[contract]") {
  const Problem line = between(space(2), make_euclidean_cost(2), Eigen::Vector2d(0, 0), Eigen::Vector2d(1, 2));
  const auto refuses = [&](const FindOptions& options) {
    CHECK_THROWS_AS(find_path(line, StraightInitializer(), Newton(), options), InputError);
  };
  CHECK(find_path(line, StraightInitializer(), Newton()).status == Status::certified);  // FindOptions{}
  refuses({.points = 0});
  refuses({.points = -3});
  for (const double s0 : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()})
    refuses({.reference_cost = s0});
  refuses({.post_processors = {nullptr}});
  refuses({.points = std::nullopt});
  for (const CoordinatePath& first :
       {CoordinatePath{}, CoordinatePath{Points::Zero(3, 4), {}, false}, CoordinatePath{Points::Zero(2, 4), {}, true},
        CoordinatePath{Points::Constant(2, 4, std::nan("")), {}, false},
        CoordinatePath{Points::Zero(2, 4), {1}, false}})
    CHECK_THROWS_AS(find_path(line, Start(first), Newton()), InputError);
  CHECK_THROWS_AS(PathEnergy(line, 0), InputError);
}

TEST_CASE("host: a cost says why a move is infinite, and nobody speaks of energy levels", "[contract]") {
  const auto ask = [](Fenced cost) {
    return message_of(between(space(2), make_segment_cost(cost), Eigen::Vector2d(0, 0), Eigen::Vector2d(1, 2)));
  };
  CHECK_THAT(ask({true}), Catch::Contains("it crosses the fence at y = 1"));
  const std::string mute = ask({false});
  CHECK_THAT(mute, Catch::Contains("infinite"));
  CHECK(mute.find("energy level") == std::string::npos);
  CHECK(mute.find("travel time") == std::string::npos);
  CHECK_THAT(message_of(bead(Eigen::Vector2d(0, 0), Eigen::Vector2d(2, 1))), Catch::Contains("above the energy level"));
}

TEST_CASE("host: a chain of infinite cost has no error bar", "[contract]") {
  const Problem problem = between(space(2), make_segment_cost(Fenced{}), Eigen::Vector2d(0, 0), Eigen::Vector2d(1, 0));
  CoordinatePath path{Points(2, 5), {}, false};
  path.u << 0, 0.25, 0.5, 0.75, 1, 0, 0, 2, 0, 0;
  const Certificate c = certify_chain(problem, path, 0.25);
  CAPTURE(failures(c));
  CHECK(failed(c, "infinite_cost"));
  CHECK(std::isnan(c.estimate.error));
  CHECK(failures(c).find("nan") == std::string::npos);
}

}  // namespace leastcost::test
