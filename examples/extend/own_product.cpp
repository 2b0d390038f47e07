// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// A camera that runs on a round rail and pans: the product of a domain of one's own and an angle.
#include <cmath>
#include <cstdio>
#include <random>

#include <leastcost/framework/check/check_manifold.hpp>
#include <leastcost/framework/result/other_images.hpp>
#include <leastcost/framework/search/find_path.hpp>
#include <leastcost/problems/costs/weighted_length.hpp>
#include <leastcost/problems/initializers/straight.hpp>
#include <leastcost/problems/kernels/kernels.hpp>
#include <leastcost/problems/manifolds/angle.hpp>
#include <leastcost/problems/manifolds/product.hpp>
#include <leastcost/solvers/newton.hpp>

using namespace leastcost;

constexpr double kRail = 2;  ///< its radius, m

class Rail final : public EmbeddedManifold {
 public:
  Rail() : EmbeddedManifold({.coordinate = 2, .ambient = 2, .tangent = 1}) {}

 private:
  bool project_point(Eigen::Ref<Eigen::VectorXd> x) const override {
    if (!(x.norm() > 0)) return false;
    x *= kRail / x.norm();
    return true;
  }
  void tangent_basis(const Eigen::VectorXd& x, Eigen::Ref<Points> basis) const override {
    basis.col(0) << -x[1] / kRail, x[0] / kRail;
  }
};

int main() {
  const auto camera = std::make_shared<ProductManifold>(
      ProductManifold::Factors{std::make_shared<Rail>(), std::make_shared<AngleManifold>()},
      std::vector<std::string>{"x", "y", "pan"});
  Problem problem;
  problem.manifold = camera;
  problem.cost = make_weighted_length({Eigen::Vector2d(1, 0.5)}, *camera);  // a radian of pan counts as 0.5 m
  problem.kernel = make_kernel<Expm1Square>();
  problem.source = project_end(*camera, Eigen::Vector3d(kRail, 0, 3));
  problem.target = project_end(*camera, Eigen::Vector3d(0, kRail, -3));
  // -3 is 2 pi - 3 as well, which is nearer to 3.
  if (const auto cheaper = find_cheaper_image(problem)) problem.target.u = cheaper->image.u;
  const Result result = find_path(problem, StraightInitializer(), Newton(), {.points = 60});

  std::mt19937_64 engine(1);
  const auto near = [](std::mt19937_64& random) -> Eigen::VectorXd {
    std::uniform_real_distribution<double> turn(-3, 3), off(0.9, 1.1);
    const double angle = turn(random), radius = kRail * off(random);
    return Eigen::Vector3d(radius * std::cos(angle), radius * std::sin(angle), turn(random));
  };
  const auto faults = check_manifold(*camera, near, engine);
  std::printf("%s", text(faults).c_str());

  const double quarter = std::acos(-1.0) / 2 * kRail, pan = 2 * std::acos(-1.0) - 6;
  const double exact = std::hypot(quarter, 0.5 * pan), value = result.certificate.estimate.value;
  std::printf("%s: %.6f m, exactly %.6f\n", result.certificate.certified() ? "certified" : "uncertified", value, exact);
  return faults.empty() && result.certificate.certified() && std::abs(value - exact) < 1e-6 ? 0 : 1;
}
