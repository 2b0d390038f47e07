// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// A cost of one's own: travel time of a ray through a medium whose speed grows with depth. The fastest ray is a circle
// arc; its time is known (docs/extend.md).
#include <cmath>
#include <cstdio>
#include <random>

#include <leastcost/framework/check/check_cost.hpp>
#include <leastcost/framework/cost/segment_cost_function.hpp>
#include <leastcost/framework/search/find_path.hpp>
#include <leastcost/problems/initializers/straight.hpp>
#include <leastcost/problems/kernels/kernels.hpp>
#include <leastcost/problems/manifolds/euclidean.hpp>
#include <leastcost/solvers/newton.hpp>

namespace {

using namespace leastcost;

struct RayTime {
  static constexpr int dim = 2;
  static constexpr bool encloses = true;  // compile it with intervals, too: certificates can be proved
  double gain;                            // speed 1 + gain * depth
  CostTraits traits() const { return {.unit = "s", .symmetric = true}; }

  template <class S>
  S value(const Point<S, 2>& a, const Point<S, 2>& b) const {
    const S speed = 1.0 + 0.5 * gain * (a[1] + b[1]);
    if (!(speed > S(0.0))) return S(std::numeric_limits<double>::infinity());
    return (b - a).squaredNorm() / (speed * speed);
  }
};

}  // namespace

int main() {
  const auto cost = make_segment_cost(RayTime{.gain = 0.5});
  std::mt19937_64 engine(1);
  const auto faults = check_cost(*cost, sample_box(Eigen::Vector2d(0, 0), Eigen::Vector2d(4, 2)), engine);
  std::printf("%s", text(faults).c_str());

  Problem problem;
  problem.manifold = std::make_shared<EuclideanManifold>(EuclideanManifoldOptions{.dimension = 2});
  problem.cost = cost;
  problem.kernel = make_kernel<Expm1Square>();
  problem.source.u = Eigen::Vector2d(0, 0);
  problem.target.u = Eigen::Vector2d(4, 0);
  const Newton newton;
  const Result result = find_path(problem, StraightInitializer(), newton, {.points = 60});

  const double exact = 2 * std::acosh(3.0);  // acosh(1 + gain^2 |b - a|^2 / 2) / gain
  std::printf("%.8f s, exact %.8f s\n", result.certificate.estimate.value, exact);
  const bool right = std::abs(result.certificate.estimate.value - exact) < 1e-6;
  return faults.empty() && result.certificate.certified() && right ? 0 : 1;
}
