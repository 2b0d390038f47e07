// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// Replanning on a budget: the target moves, each plan starts from the one before, and what is not finished in time is
// used as far as it got.
#include <chrono>
#include <cstdio>
#include <numbers>

#include <leastcost/leastcost.hpp>

int main() {
  using namespace leastcost;
  Problem problem;
  problem.manifold = std::make_shared<EuclideanManifold>(EuclideanManifoldOptions{.dimension = 2});
  problem.source.u = Eigen::Vector2d(0, 0);
  problem.target.u = Eigen::Vector2d(std::numbers::pi - 1, -2);
  problem.cost = make_travel_time_cost({.gravity = 1}, 2, problem.source.u);
  problem.kernel = make_kernel<Expm1Square>();
  const Newton newton;
  const FindOptions options{.points = 60, .certificate = {.enabled = false}};
  Result plan = find_path(problem, StraightInitializer(), newton, options);

  for (int cycle = 1; cycle <= 10; ++cycle) {
    problem.target.u[0] = std::numbers::pi - 1 + 0.1 * cycle;
    Monitor monitor;
    monitor.deadline = Monitor::Clock::now() + std::chrono::milliseconds(5);
    Result next = improve_path(problem, plan.path, newton, options, monitor);
    if (next.path.u.cols() > 0) plan = std::move(next);  // else it was interrupted before it had a path
  }

  plan = improve_path(problem, plan.path, newton);  // no deadline, and a certificate
  if (plan.status != Status::certified)
    for (const CertificateFailure& failure : plan.certificate.failures) std::printf("%s\n", failure.message.c_str());
  const double seconds = plan.certificate.estimate.value;
  std::printf("%s: %.6f s, exact pi, after %d iterations\n", name(plan.status).data(), seconds, plan.solve.iterations);
  return plan.status == Status::certified && std::abs(seconds - std::numbers::pi) < 1e-5 ? 0 : 1;
}
