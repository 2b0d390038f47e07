// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// Tangent frames: which bounds hold a point, and the pinned point of a ring.
#include <leastcost/framework/energy/path_energy.hpp>

#include <Eigen/LU>

#include "tests/support/catch.hpp"
#include "tests/support/compose.hpp"
#include "tests/support/random.hpp"
#include "tests/support/sample_domains.hpp"

namespace leastcost::test {
namespace {

/// R^3 with two planes through every point, not at right angles to each other: all points lie in the edge of a wedge.
class Wedge final : public ConstraintManifold, public HasBounds {
 public:
  explicit Wedge(Points normals) : normals_(std::move(normals)) {}
  Dimensions dimensions() const override { return {3, 3, 3}; }
  Shape shape() const override { return Shape::flat; }
  Projection project(CoordinatePath&) const override { return {}; }
  void tangent_bases(const CoordinatePath& path, Points& bases) const override {
    bases = Points::Identity(3, 3).replicate(1, path.u.cols());
  }
  void retract(const CoordinatePath& from, const Points&, CoordinatePath& to) const override { to = from; }
  double residual(const CoordinatePath&) const override { return 0; }
  int active_bounds(const CoordinatePath&, Index, Eigen::Ref<Points> normals) const override {
    normals.leftCols(normals_.cols()) = normals_;
    return static_cast<int>(normals_.cols());
  }

 private:
  Points normals_;
};

Problem euclidean_on(std::shared_ptr<const ConstraintManifold> manifold, bool ring = false) {
  const int d = manifold->dimensions().ambient;
  return {std::move(manifold), make_euclidean_cost(d), make_kernel<Square>(), {}, {}, ring};
}

/// The frames of a path of three points whose middle one is x, for a gradient there.
Frames middle_frames(const Problem& problem, const Eigen::VectorXd& x, const Eigen::VectorXd& gradient) {
  CoordinatePath path{Points(x.size(), 3), {}, false};
  path.u << x - Eigen::VectorXd::Unit(x.size(), 0), x, x + Eigen::VectorXd::Unit(x.size(), 0);
  Frames frames;
  PathEnergy(problem, 1).frames(path, gradient, frames);
  return frames;
}

/// The descent that frames leave free.
Eigen::VectorXd free_descent(const Frames& frames, const Eigen::VectorXd& gradient) {
  if (frames.identity) return -gradient;
  const Points free = frames.bases.leftCols(frames.bases.cols() - frames.blocked[0]);
  return -free * (free.transpose() * gradient);
}

}  // namespace

TEST_CASE("frames: at a corner of a box only the bounds that are pushed hold", "[framework]") {
  const Problem problem = euclidean_on(box(Eigen::Vector3d::Zero(), Eigen::Vector3d::Ones()));
  const Eigen::Vector3d corner = Eigen::Vector3d::Ones();
  Random random;
  for (int repeat = 0; repeat < 20; ++repeat) {
    const Eigen::Vector3d gradient = random.vector(3);
    const Frames frames = middle_frames(problem, corner, gradient);
    const auto pushed = (gradient.array() < 0).count();  // -g points out of the box
    CHECK(frames.identity == (pushed == 0));
    CHECK(frames.blocked[0] == pushed);
    CHECK((free_descent(frames, gradient) - (-gradient).cwiseMin(0)).norm() <= 1e-14);
    if (!frames.identity) CHECK((frames.bases.transpose() * frames.bases - Points::Identity(3, 3)).norm() <= 1e-14);
  }
  CHECK(middle_frames(problem, Eigen::Vector3d(0.5, 0.5, 0.5), corner).identity);
}

TEST_CASE("frames: in a wedge the free descent is the nearest one that stays inside", "[framework]") {
  Random random;
  for (int repeat = 0; repeat < 200; ++repeat) {
    Points normals = random.matrix(3, 2);
    normals.colwise().normalize();
    const Problem problem = euclidean_on(std::make_shared<Wedge>(normals));
    const Eigen::Vector3d gradient = random.vector(3);
    const Eigen::Vector3d free = free_descent(middle_frames(problem, Eigen::Vector3d::Zero(), gradient), gradient);
    // Brute force: of the projections onto no, one or both planes, the nearest feasible one.
    Eigen::Vector3d best = Eigen::Vector3d::Constant(1e9);
    for (int set = 0; set < 4; ++set) {
      Points n(3, 0);
      for (int k = 0; k < 2; ++k)
        if (set & (1 << k)) n.conservativeResize(3, n.cols() + 1), n.rightCols(1) = normals.col(k);
      const Eigen::Vector3d d = -gradient;
      const Eigen::Vector3d v =
          n.cols() ? Eigen::Vector3d(d - n * (n.transpose() * n).inverse() * n.transpose() * d) : d;
      if ((normals.transpose() * v).maxCoeff() <= 1e-12 && (v - d).norm() < (best - d).norm()) best = v;
    }
    CAPTURE(repeat, gradient.transpose(), normals);
    CHECK((free - best).norm() <= 1e-10);
  }
}

TEST_CASE("frames: a ring is pinned along itself at its first point only", "[framework]") {
  Random random;
  Points points(3, 6);
  for (int i = 0; i < 6; ++i) points.col(i) << std::cos(1.0 * i), std::sin(1.0 * i), 0.4;
  for (const Problem& problem : {euclidean_on(space(3), true), euclidean_on(std::make_shared<Sphere>(), true)}) {
    CoordinatePath path{points + 0.05 * random.matrix(3, 6), {}, true};
    problem.manifold->project(path);
    PathEnergy energy(problem, 1);
    Points gradient;
    energy.value_and_gradient(path, gradient);
    Frames frames;
    energy.frames(path, gradient, frames);
    const int k = problem.manifold->dimensions().tangent;
    CHECK(frames.blocked == std::vector<int>{1, 0, 0, 0, 0, 0});
    const Points basis = frames.bases.leftCols(k);
    CHECK((basis.transpose() * basis - Points::Identity(k, k)).norm() <= 1e-14);
    const Eigen::VectorXd along = basis * (basis.transpose() * (path.u.col(1) - path.u.col(5)));
    CHECK(std::abs(basis.col(k - 1).dot(along.normalized())) == Approx(1).epsilon(1e-12));
    Eigen::VectorXd tangent;
    energy.to_tangent(frames, gradient, tangent);
    CHECK(tangent[k - 1] == 0);
  }
}

}  // namespace leastcost::test
