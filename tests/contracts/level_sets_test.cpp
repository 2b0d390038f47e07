// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// The domains that are given by equations: contract, and the errors of what is no domain.
#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/domain/has_curvature.hpp>
#include <leastcost/framework/domain/has_images.hpp>
#include <leastcost/framework/problem/problem.hpp>
#include <leastcost/problems/manifolds/constraint.hpp>
#include <leastcost/problems/manifolds/implicit.hpp>
#include "tests/contracts/manifold_contract.hpp"
#include "tests/support/words.hpp"

namespace leastcost::test {
namespace {

/// A random point of the domain in a box around the origin, within 3 % of its size.
ManifoldCase level_set_case(std::shared_ptr<const ConstraintManifold> manifold, double half_box, double size) {
  const auto on = [manifold, half_box](Random& random) -> Eigen::VectorXd {
    for (;;) {
      const int d = manifold->dimensions().coordinate;
      CoordinatePath path{
          Eigen::VectorXd::NullaryExpr(d, [&] { return random.uniform(-half_box, half_box); }), {}, true};
      if (manifold->project(path).failed.empty() && path.u.cwiseAbs().maxCoeff() <= 2 * half_box) return path.u.col(0);
    }
  };
  const auto near = [on, size](Random& random) -> Eigen::VectorXd {
    const Eigen::VectorXd x = on(random);
    return x + 0.01 * size * random.vector(x.size());
  };
  Random random;
  ManifoldCase c{.manifold = manifold, .near = near, .size = size};
  for (const double off : {0.0, 1e-8, -1e-8}) {
    const Eigen::VectorXd x = on(random);
    c.special.emplace_back(x + off * Eigen::VectorXd::Ones(x.size()));
  }
  return c;
}

std::shared_ptr<const LevelSet> implicit_surface(const char* surface) {
  ImplicitManifoldOptions options{.surface = form<implicit::Surface>(surface)};
  if (auto* ellipsoid = std::get_if<implicit::Ellipsoid>(&options.surface)) ellipsoid->axes = Eigen::Vector3d(3, 2, 1);
  return make_implicit_manifold(options);
}

std::shared_ptr<const LevelSet> implicit_formula(const char* f, int dimension = 3,
                                                 const std::map<std::string, double>& parameters = {}) {
  return make_implicit_manifold(
      {.surface = implicit::Formula{.f = f, .dimension = dimension, .parameters = parameters}});
}

std::shared_ptr<const LevelSet> equations(std::optional<int> dimension, const std::vector<std::string>& texts) {
  ConstraintManifoldOptions options;
  options.dimension = dimension;
  options.equations = texts;
  return make_constraint_manifold(options);
}

std::shared_ptr<const LevelSet> named_set(const constraint::Set& set, std::optional<int> dimension) {
  ConstraintManifoldOptions options;
  options.dimension = dimension;
  options.set = set;
  return make_constraint_manifold(options);
}

/// What project_end() says about a point.
std::string refusal(const ConstraintManifold& manifold, const Eigen::VectorXd& x) {
  try {
    project_end(manifold, x);
    return "accepted";
  } catch (const InputError& error) {
    return error.what();
  }
}

/// The second derivative of gradient'R(step) by the step, which the domain says, against differences of R.
void check_bend(const LevelSet& domain, double half_box) {
  constexpr double kStep = 1e-3;
  const auto* bends = find_ability<HasCurvature>(domain);
  REQUIRE(bends != nullptr);
  const int d = domain.dimensions().coordinate;
  Random random;
  for (int trial = 0; trial < 20; ++trial) {
    CoordinatePath path{Eigen::VectorXd::NullaryExpr(d, [&] { return random.uniform(-half_box, half_box); }), {}, true};
    if (!domain.project(path).failed.empty()) continue;
    const Eigen::VectorXd gradient = random.vector(d);
    Points bases, bend;
    domain.tangent_bases(path, bases);
    REQUIRE(bends->bend(path, 0, gradient, bend));
    REQUIRE(bend.rows() == d);
    const Eigen::VectorXd along = bases * random.vector(bases.cols()).normalized();
    CoordinatePath plus, minus;
    domain.retract(path, kStep * along, plus);
    domain.retract(path, -kStep * along, minus);
    const double differences = gradient.dot(plus.u.col(0) + minus.u.col(0) - 2 * path.u.col(0)) / (kStep * kStep);
    CHECK(along.dot(bend * along) == Approx(differences).epsilon(1e-3).margin(1e-4 * gradient.norm() * bend.norm()));
  }
}

template <class Make>
std::string wrong_key(Make make) {
  try {
    make();
    return "accepted";
  } catch (const OptionError& error) {
    return error.key();
  }
}

}  // namespace

TEST_CASE("manifold contract: implicit, sphere", "[contract]") {
  check_manifold_contract(level_set_case(implicit_surface("sphere"), 1, 1));
}
TEST_CASE("manifold contract: implicit, ellipsoid", "[contract]") {
  check_manifold_contract(level_set_case(implicit_surface("ellipsoid"), 2, 3));
}
TEST_CASE("manifold contract: implicit, torus", "[contract]") {
  check_manifold_contract(level_set_case(implicit_surface("torus"), 2, 3));
}
TEST_CASE("manifold contract: implicit, genus2", "[contract]") {
  check_manifold_contract(level_set_case(implicit_surface("genus2"), 1.5, 2));
}
TEST_CASE("manifold contract: implicit, gyroid", "[contract]") {
  check_manifold_contract(level_set_case(implicit_surface("gyroid"), 3, 6));
}
TEST_CASE("manifold contract: implicit, paper_curve", "[contract]") {
  check_manifold_contract(level_set_case(implicit_surface("paper_curve"), 2, 3));
}
TEST_CASE("manifold contract: implicit, formula", "[contract]") {
  check_manifold_contract(level_set_case(implicit_formula("z - a*sin(x)*cos(y)", 3, {{"a", 0.5}}), 2, 3));
  check_manifold_contract(level_set_case(implicit_formula("x^2/4 + y^2 - 1", 2), 2, 2));
}
TEST_CASE("manifold contract: constraint, equations", "[contract]") {
  check_manifold_contract(
      level_set_case(equations(4, {"x0^2 + x1^2 - 1", "x2^2 + x3^2 - 1"}), 1, 2));          // Clifford torus
  check_manifold_contract(level_set_case(equations(4, {"x0^2 + x1^2 + x2^2 - 1"}), 1, 2));  // sphere x line
  // Two joints of a planar arm whose tip stays on a line, and a third that is free.
  check_manifold_contract(level_set_case(equations(3, {"cos(x0) + cos(x0 + x1) - 0.5"}), 2, 4));
}
TEST_CASE("manifold contract: constraint, sphere", "[contract]") {
  check_manifold_contract(level_set_case(named_set(constraint::Sphere{2}, 7), 2, 2));
}
TEST_CASE("manifold contract: constraint, so3", "[contract]") {
  const auto rotations = named_set(constraint::Rotations{}, 4);
  check_manifold_contract(level_set_case(rotations, 1, 1));
  const auto* images = dynamic_cast<const HasImages*>(rotations.get());
  REQUIRE(images != nullptr);
  const Eigen::Vector4d q(0.5, 0.5, 0.5, 0.5), r(1, 0, 0, 0);
  REQUIRE(images->images(q, r, 5).size() == 1);
  CHECK(images->images(q, r, 5)[0].u == -q);
  CHECK(images->images(q, r, 0).empty());
}

TEST_CASE("level sets bend as their retraction does", "[contract]") {
  for (const char* name : {"sphere", "ellipsoid", "torus", "genus2", "gyroid", "paper_curve"})
    check_bend(*implicit_surface(name), 1.5);
  check_bend(*implicit_formula("z - a*sin(x)*cos(y)", 3, {{"a", 0.5}}), 2);
  check_bend(*implicit_formula("x^2/4 + y^2 - 1", 2), 2);
  check_bend(*equations(4, {"x0^2 + x1^2 - 1", "x2^2 + x3^2 - 1 + 0.2 * x0 * x3"}), 1);
  check_bend(*equations(3, {"cos(x0) + cos(x0 + x1) - 0.5"}), 2);
  check_bend(*named_set(constraint::Sphere{2}, 7), 2);
  check_bend(*named_set(constraint::Rotations{}, 4), 1);
}

TEST_CASE("level sets: where a box holds points or formulas are of many coordinates differences tell how they bend",
          "[contract]") {
  ImplicitManifoldOptions boxed{.surface = implicit::Torus{}};
  boxed.box.upper = Eigen::Vector3d(2, 2, 2);
  boxed.box.lower = Eigen::Vector3d(-2, -2, -2);
  CHECK(find_ability<HasCurvature>(*make_implicit_manifold(boxed)) == nullptr);
  CHECK(find_ability<HasCurvature>(*equations(6, {"x0^2 + x1 * x5 - 1"})) == nullptr);
}

TEST_CASE("level sets: where there is no projection, the reason is given", "[contract]") {
  CHECK_THAT(refusal(*implicit_surface("sphere"), Eigen::Vector3d::Zero()),
             Catch::Contains("gradients of the equations are zero"));
  CHECK_THAT(refusal(*implicit_surface("torus"), Eigen::Vector3d(0, 0, 0.3)),
             Catch::Contains("no solution of the equations was found"));  // on the axis
  CHECK_THAT(refusal(*implicit_formula("x^2 + y^2 + z^2 + 1"), Eigen::Vector3d(1, 2, 3)),
             Catch::Contains("the set may be empty"));
  CHECK_THAT(refusal(*implicit_formula("log(x) + y + z"), Eigen::Vector3d(-1, 0, 0)),
             Catch::Contains("not finite there"));
  CHECK_THAT(refusal(*implicit_formula("x^2 + y^2 - z^2"), Eigen::Vector3d::Zero()),  // the apex lies on it
             Catch::Contains("gradients of the equations are zero"));
  CHECK_THAT(refusal(*equations(3, {"x0 + x1", "2*x0 + 2*x1 - 1"}), Eigen::Vector3d(1, 1, 1)),
             Catch::Contains("linearly dependent"));
}

TEST_CASE("level sets: projection does not run away", "[contract]") {
  // Almost at the centre of a sphere the undamped step is 5e5 long; on a gyroid the next sheet is half a period away.
  const PathEnd end = project_end(*implicit_surface("sphere"), Eigen::Vector3d(1e-6, 0, 0));
  CHECK((end.u - Eigen::Vector3d::UnitX()).norm() <= 1e-15);
  Random random;
  for (int i = 0; i < 200; ++i) {
    double moved = 0;
    const Eigen::VectorXd x = 3 * random.vector(3);
    Eigen::VectorXd value(1);
    Points gradient(3, 1);
    implicit_surface("gyroid")->function().evaluate(x, value, gradient);
    if (std::abs(value[0]) > 1.2) continue;  // 1.5 is the most, where there is no direction to go
    project_end(*implicit_surface("gyroid"), x, &moved);
    CHECK(moved < 3.2);  // half a period is pi
  }
}

TEST_CASE("level sets: options that describe none are refused by name", "[contract]") {
  CHECK(wrong_key([] { implicit_formula("x +"); }) == "surface.f");
  CHECK(wrong_key([] { implicit_formula("a*x", 3, {{"x", 1}}); }) == "surface.parameters.x");
  CHECK(wrong_key([] { implicit_formula("x*z", 2); }) == "surface.f");
  CHECK(wrong_key([] { make_implicit_manifold({.surface = implicit::Torus{.minor_radius = 3}}); }) ==
        "surface.minor_radius");
  CHECK(wrong_key([] { equations(-1, {"x0"}); }) == "dimension");
  CHECK(wrong_key([] { equations({}, {"x0"}); }) == "dimension");
  CHECK(wrong_key([] { equations(2, {"x0", "x1"}); }) == "equations");
  CHECK(wrong_key([] { equations(3, {"x0", "x3"}); }) == "equations.1");
  CHECK(wrong_key([] { named_set(constraint::Rotations{}, 3); }) == "dimension");
  CHECK(wrong_key([] { named_set(constraint::Sphere{}, -1); }) == "dimension");
  CHECK(wrong_key([] { named_set(constraint::Sphere{-1}, 3); }) == "set.radius");
  CHECK(wrong_key([] { make_constraint_manifold({}); }) == "equations");
}

}  // namespace leastcost::test
