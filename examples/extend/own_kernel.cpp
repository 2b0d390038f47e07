// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// A kernel of one's own: H(s) = cosh s - 1. It changes how stiffly the points hold their equal spacing, not the path.
#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>

#include <leastcost/framework/search/find_path.hpp>
#include <leastcost/problems/costs/travel_time.hpp>
#include <leastcost/problems/initializers/straight.hpp>
#include <leastcost/problems/manifolds/euclidean.hpp>
#include <leastcost/solvers/newton.hpp>

namespace {

using namespace leastcost;

struct Cosh {
  static constexpr KernelKind kind = KernelKind::quadratic_at_zero;  // H(0) = 0, H ~ s^2 / 2

  /// phi(q) = H(sqrt q) with two derivatives in q. Near 0 by its series: the quotients there are 0 / 0.
  Jet2 operator()(double q) const {
    if (q < 1e-4) return {q / 2 + q * q / 24, 0.5 + q / 12 + q * q / 240, 1.0 / 12 + q / 120};
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    if (q > 5e5) return {kInfinity, kInfinity, kInfinity};  // cosh s overflows at s = 710
    const double s = std::sqrt(q), c = std::cosh(s), by_s = std::sinh(s) / s;
    return {c - 1, by_s / 2, (c - by_s) / (4 * q)};
  }
};

}  // namespace

int main() {
  Problem problem;
  problem.manifold = std::make_shared<EuclideanManifold>(EuclideanManifoldOptions{.dimension = 2});
  problem.source.u = Eigen::Vector2d(0, 0);
  problem.target.u = Eigen::Vector2d(std::numbers::pi, -2);
  problem.cost = make_travel_time_cost({.gravity = 1}, 2, problem.source.u);
  problem.kernel = make_kernel<Cosh>();
  const Newton newton;
  const Result result = find_path(problem, StraightInitializer(), newton, {.points = 60});

  const double spread = result.costs.maxCoeff() / result.costs.minCoeff() - 1;
  std::printf("%.8f s, exact pi; spacing %.1e\n", result.certificate.estimate.value, spread);
  const bool right = std::abs(result.certificate.estimate.value - std::numbers::pi) < 1e-5 && spread < 1e-9;
  return result.certificate.certified() && right ? 0 : 1;
}
