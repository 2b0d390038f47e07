// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/framework/energy/path_energy.hpp>

#include <leastcost/framework/cost/segment_cost_function.hpp>
#include <leastcost/framework/energy/chain_model.hpp>
#include <leastcost/problems/manifolds/data/mesh.hpp>
#include "framework/check/observed_order.hpp"
#include "tests/problems/sample_meshes.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/compose.hpp"
#include "tests/support/random.hpp"
#include "tests/support/sample_domains.hpp"

namespace leastcost::test {
namespace {

/// A weight that varies in every direction, so that no derivative vanishes by luck.
struct Wavy {
  static constexpr int dim = Eigen::Dynamic;
  CostTraits traits() const { return {.unit = "weighted length"}; }
  template <class S>
  S value(const Point<S, dim>& a, const Point<S, dim>& b) const {
    using std::sin;
    S weight(1.5);
    for (Index i = 0; i < a.size(); ++i) weight += 0.2 * sin(S((a[i] + b[i]) * (0.5 + 0.3 * static_cast<double>(i))));
    return (b - a).squaredNorm() * weight * weight;
  }
};

struct Setting {
  std::string name;
  Problem problem;
  CoordinatePath path;
};

Setting setting(const std::string& name, std::shared_ptr<const ConstraintManifold> manifold, const Points& points,
                bool ring) {
  CoordinatePath path{points, {}, ring};
  manifold->project(path);
  const int d = manifold->dimensions().ambient;
  return {name, {std::move(manifold), make_segment_cost(Wavy{}, d), make_kernel<Expm1Square>(), {}, {}, ring}, path};
}

std::vector<Setting> settings(bool ring, Random& random) {
  Points around(3, 8);
  for (int i = 0; i < 8; ++i) around.col(i) << std::cos(0.75 * i), std::sin(0.75 * i), 0.5;
  const Points noise = 0.1 * random.matrix(3, 8);
  return {
      setting("plane", space(2), (around + noise).topRows(2), ring),
      setting("R^7", space(7), random.matrix(7, 8), ring),
      setting("sphere", std::make_shared<Sphere>(), around + noise, ring),
      setting("torus", std::make_shared<Torus>(), 2.5 * around + noise, ring),
      setting("box", box(Eigen::Vector2d(-0.6, -5), Eigen::Vector2d(0.8, 0.7)), (around + noise).topRows(2), ring),
  };
}

}  // namespace

TEST_CASE("path energy: gradient by slope 2, chain Hessian by slope 3 along the retraction", "[framework]") {
  const bool ring = GENERATE(false, true);
  Random random;
  for (const Setting& s : settings(ring, random)) {
    CAPTURE(s.name, ring);
    PathEnergy energy(s.problem, PathEnergy(s.problem, 1).cost(s.path) / static_cast<double>(s.path.segment_count()));
    Points gradient, step;
    Frames frames;
    const double value = energy.value_and_gradient(s.path, gradient);
    CHECK(value == Approx(energy.value(s.path)).epsilon(1e-14));
    energy.frames(s.path, gradient, frames);
    Eigen::VectorXd tangent, product;
    energy.to_tangent(frames, gradient, tangent);
    // A random move in the frames; blocked directions do not move, and inactive bounds are not crossed by small steps.
    Eigen::VectorXd t = random.vector(tangent.size());
    energy.from_tangent(frames, t, step);
    energy.to_tangent(frames, step, t);
    energy.from_tangent(frames, t, step);
    const auto* bounds = dynamic_cast<const HasBounds*>(s.problem.manifold.get());
    Points normals(s.path.u.rows(), s.path.u.rows());
    bool at_bound = false;
    for (Index i = 0; bounds && i < step.cols(); ++i)
      for (int k = bounds->active_bounds(s.path, s.path.free_begin() + i, normals); k-- > 0; at_bound = true)
        step.col(i) -=
            std::max(0.0, normals.col(k).dot(step.col(i))) * normals.col(k);  // the retraction would clamp it
    CHECK(at_bound == (s.name == "box"));
    if (ring) step.col(0).setZero();  // pinned along the ring: what is taken off above might point there
    energy.to_tangent(frames, step, t);
    ChainSystem hessian;
    energy.chain_hessian(s.path, gradient, frames, HessianKind::exact, hessian);
    hessian.multiply(t, product);
    const double slope = tangent.dot(t), curvature = t.dot(product);
    CoordinatePath moved;
    const auto difference = [&](double h) {
      energy.retract(s.path, h * step, moved);
      return energy.value(moved) - value;
    };
    // Second differences of R carry h^2 of their own: the Hessian is good to about 1e-7 of itself on a curved domain.
    const double exact = 1e-13 * (std::abs(value) + std::abs(slope) + std::abs(curvature));
    CHECK(observed_order([&](double h) { return difference(h) - h * slope; }, 0.02, exact) > 2 - kOrderSlack);
    const auto third = [&](double h) { return difference(h) - h * slope - h * h / 2 * curvature; };
    const bool flat = s.problem.manifold->shape() == Shape::flat;
    CHECK(observed_order(third, 0.02, exact, flat ? 20 : 6) > 3 - kOrderSlack);
  }
}

TEST_CASE("path energy: on a mesh the slope of the chain model is that along the retraction", "[framework]") {
  // Tangent bases come from smooth normals, the retraction stays in the faces.
  const auto mesh = std::make_shared<MeshManifold>(TriangleMesh(sphere(2)));
  Random random;
  const Points inside = 0.7 * random.matrix(3, 9).colwise().normalized();  // from outside, many would land on edges
  const Setting s = setting("mesh", mesh, inside, GENERATE(false, true));
  PathEnergy energy(s.problem, 1);
  ChainModel model;
  REQUIRE(model.evaluate(energy, s.path));
  Points step;
  energy.from_tangent(model.frames, random.vector(model.tangent.size()), step);
  Eigen::VectorXd t;
  energy.to_tangent(model.frames, step, t);  // without blocked directions
  energy.from_tangent(model.frames, t, step);
  CoordinatePath moved;
  const auto error = [&](double h) {
    energy.retract(s.path, h * step, moved);
    return energy.value(moved) - model.value - h * model.tangent.dot(t);
  };
  CHECK(observed_order(error, 1e-4, 1e-12 * model.value) > 2 - kOrderSlack);
}

TEST_CASE("path energy: the Gauss-Newton Hessian is semidefinite in every setting", "[framework]") {
  const bool ring = GENERATE(false, true);
  Random random;
  for (const Setting& s : settings(ring, random)) {
    CAPTURE(s.name, ring);
    PathEnergy energy(s.problem, 1);
    Points gradient;
    Frames frames;
    energy.value_and_gradient(s.path, gradient);
    energy.frames(s.path, gradient, frames);
    ChainSystem hessian;
    energy.chain_hessian(s.path, gradient, frames, HessianKind::gauss_newton, hessian);
    for (Index i = 0; i < hessian.count(); ++i)
      hessian.diagonal(i).diagonal().array() += 1e-9 * hessian.diagonal(i).norm();
    CHECK(hessian.factor());
  }
}

TEST_CASE("path energy: counters count, scale and costs agree", "[framework]") {
  Random random;
  const Setting s = settings(false, random)[0];
  PathEnergy energy(s.problem, 0.7);
  Points gradient;
  Frames frames;
  ChainSystem hessian;
  CoordinatePath moved;
  energy.value(s.path);
  energy.value_and_gradient(s.path, gradient);
  energy.frames(s.path, gradient, frames);
  energy.chain_hessian(s.path, gradient, frames, HessianKind::gauss_newton, hessian);
  Eigen::VectorXd x = random.vector(hessian.size());
  if (energy.factor(hessian)) energy.solve(hessian, x);
  energy.retract(s.path, gradient, moved);
  const Counters& n = energy.counters();
  CHECK((n.energies == 1 && n.gradients == 1 && n.hessians == 1 && n.linear_solves == 2 && n.projections == 1));
  const Eigen::VectorXd costs = energy.costs(s.path);
  CHECK(energy.cost(s.path) == Approx(costs.sum()).epsilon(1e-14));
  double value = 0, scale = 0;
  for (const double c : costs) {
    value += kernel_value(*s.problem.kernel, c / 0.7);
    scale += kernel_slope_times_s(*s.problem.kernel, c / 0.7);
  }
  CHECK(energy.value(s.path) == Approx(value).epsilon(1e-13));
  CHECK(energy.scale(s.path) == Approx(scale).epsilon(1e-13));
}

TEST_CASE("path energy: no exact Hessian for H = s", "[framework]") {
  Random random;
  Setting s = settings(false, random)[0];
  CHECK(PathEnergy(s.problem, 1).has_exact_hessian());
  s.problem.kernel = make_kernel<Linear>();
  CHECK_FALSE(PathEnergy(s.problem, 1).has_exact_hessian());
}

}  // namespace leastcost::test
