// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// VFCS Fig. 7: two paths between the same ends of a closed model, under the normal metric and under an anisotropic one.
// Each is the cheaper one under its own metric.
#include <cstdio>

#include "app/run/run.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/compose.hpp"
#include "tests/support/data.hpp"

namespace leastcost::test {
namespace {

struct Found {
  Problem problem;
  Result result;
};

Found run_config(const char* name) {
  const Run prepared = load_run(project_dir() / "configs" / name);
  const RunParts& parts = prepared.parts;
  return {parts.problem, find_path(parts.problem, *parts.initializer, *parts.solver, parts.options)};
}

/// Cost of a curve under a metric, its pieces so short that the metric does not change on them.
double cost_under(const SegmentCost& cost, const Points& curve) {
  constexpr Index kParts = 4;
  Points fine(curve.rows(), kParts * (curve.cols() - 1) + 1);
  for (Index i = 0; i + 1 < curve.cols(); ++i)
    for (Index k = 0; k <= kParts; ++k) {
      const double t = static_cast<double>(k) / kParts;
      fine.col(kParts * i + k) = (1 - t) * curve.col(i) + t * curve.col(i + 1);
    }
  return total_cost(cost, {{fine.data(), fine.rows(), fine.cols()}, {}, false});
}

}  // namespace

TEST_CASE("Fig. 7: each path is the cheaper one under its own metric", "[paper][slow]") {
  if (!installed_model("glmark2/models/bunny.obj")) return;
  const Found normal = run_config("fig7_normal_metric.yaml"), anisotropic = run_config("fig7_anisotropic_metric.yaml");
  const auto cost = [](const Found& metric, const Found& path) {
    return cost_under(*metric.problem.cost, path.result.curve.x);
  };
  double apart = 0;  // farthest point of one path from the other
  for (Index i = 0; i < anisotropic.result.path.u.cols(); ++i)
    apart = std::max(apart, (normal.result.curve.x.colwise() - Eigen::VectorXd(anisotropic.result.path.u.col(i)))
                                .colwise()
                                .norm()
                                .minCoeff());
  const double length = cost(normal, normal), own = cost(anisotropic, anisotropic);
  std::printf("Fig. 7: length %.6f against %.6f, anisotropic cost %.6f against %.6f, %.3f apart (%s; %s)\n", length,
              cost(normal, anisotropic), cost(anisotropic, normal), own, apart,
              failures(normal.result.certificate).c_str(), failures(anisotropic.result.certificate).c_str());
  CHECK(normal.result.status == Status::certified);
  CHECK(anisotropic.result.status == Status::certified);
  CHECK(length < 0.97 * cost(normal, anisotropic));
  CHECK(own < 0.93 * cost(anisotropic, normal));
  CHECK(apart > 0.04 * length);
}

}  // namespace leastcost::test
