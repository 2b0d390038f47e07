// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// A manifold of one's own: a cylinder. Its geodesics are helices.
#include <cmath>
#include <cstdio>
#include <random>

#include <leastcost/framework/check/check_manifold.hpp>
#include <leastcost/framework/search/find_path.hpp>
#include <leastcost/problems/costs/euclidean.hpp>
#include <leastcost/problems/initializers/straight.hpp>
#include <leastcost/problems/kernels/kernels.hpp>
#include <leastcost/solvers/newton.hpp>

namespace {

using namespace leastcost;

/// Radius 1, around the z axis.
class Cylinder final : public EmbeddedManifold {
 public:
  Cylinder() : EmbeddedManifold({.coordinate = 3, .ambient = 3, .tangent = 2}) {}

 private:
  bool project_point(Eigen::Ref<Eigen::VectorXd> x) const override {
    const double radius = std::hypot(x[0], x[1]);
    if (!(radius > 0)) return false;  // on the axis every point is as near
    x.head(2) /= radius;
    return true;
  }
  void tangent_basis(const Eigen::VectorXd& x, Eigen::Ref<Points> basis) const override {
    basis.col(0) << -x[1], x[0], 0;
    basis.col(1) << 0, 0, 1;
  }
};

}  // namespace

int main() {
  const auto cylinder = std::make_shared<Cylinder>();
  std::mt19937_64 engine(1);
  const auto near = [](std::mt19937_64& random) -> Eigen::VectorXd {
    const double angle = std::uniform_real_distribution<double>(-3, 3)(random);
    const double radius = std::uniform_real_distribution<double>(0.8, 1.2)(random);
    return Eigen::Vector3d(radius * std::cos(angle), radius * std::sin(angle), angle);
  };
  const auto faults = check_manifold(*cylinder, near, engine);
  std::printf("%s", text(faults).c_str());

  Problem problem;
  problem.manifold = cylinder;
  problem.cost = make_euclidean_cost(3);
  problem.kernel = make_kernel<Expm1Square>();
  problem.source = project_end(*cylinder, Eigen::Vector3d(1, 0, 0));
  problem.target = project_end(*cylinder, Eigen::Vector3d(std::cos(2.0), std::sin(2.0), 3));
  const Newton newton;
  const Result result = find_path(problem, StraightInitializer(), newton, {.points = 60});

  const double exact = std::sqrt(2.0 * 2.0 + 3.0 * 3.0);  // unrolled: 2 around, 3 up
  std::printf("%.8f, exact %.8f\n", result.certificate.estimate.value, exact);
  const bool right = std::abs(result.certificate.estimate.value - exact) < 1e-6;
  return faults.empty() && result.certificate.certified() && right ? 0 : 1;
}
