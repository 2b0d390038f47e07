// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// The proof of a minimum as a second call, after a run that left it out.
#include <leastcost/framework/result/prove.hpp>

#include <string>
#include <vector>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/problems/costs/metric_field.hpp>
#include "tests/support/catch.hpp"
#include "tests/support/compose.hpp"

namespace leastcost::test {
namespace {

/// c = n |dx| in the plane, from the origin to (1, 0.1).
Problem medium(const std::string& n) {
  const std::string square = "(" + n + ")^2";
  MetricFieldOptions options;
  options.field = metric::Formula{{square, "0", square}, {}};
  return between(space(2), make_metric_field_cost(options, 2), Eigen::Vector2d(0, 0), Eigen::Vector2d(1, 0.1));
}

Result run(const Problem& problem, ProofRule rule, bool certify = true) {
  FindOptions options;
  options.certificate.proof = rule;
  options.certificate.enabled = certify;
  options.certificate.refine = 0;
  return find_path(problem, StraightInitializer(), Newton(), options);
}

}  // namespace

TEST_CASE("a proof that was left out is made by a second call", "[prove]") {
  const Problem problem = medium("1 + 0.3*exp(-6*((x-0.5)^2+(y-0.1)^2))");
  const Result at_once = run(problem, ProofRule::always), prompt = run(problem, ProofRule::never);
  REQUIRE(at_once.certificate.resolution->minimum_proved);
  REQUIRE(prompt.status == Status::certified);
  REQUIRE_FALSE(prompt.certificate.resolution->minimum_proved);
  const Result later = prove(problem, prompt);
  CHECK(later.status == Status::certified);
  REQUIRE(later.certificate.resolution->minimum_proved);
  CHECK(*later.certificate.resolution->lower == *at_once.certificate.resolution->lower);
  CHECK(*later.certificate.resolution->upper == *at_once.certificate.resolution->upper);
  CHECK(later.certificate.estimate.value == at_once.certificate.estimate.value);
  CHECK(later.path.u == prompt.path.u);
  CHECK(prove(problem, later).certificate.resolution->lower == later.certificate.resolution->lower);
}

TEST_CASE("a second call refuses what the points did not see", "[prove]") {
  const Problem problem = medium("1 - 5e-4*exp(-((y - 0.1*x - 0.003)/3e-4)^2)");
  const Result prompt = run(problem, ProofRule::never);
  REQUIRE(prompt.status == Status::certified);
  const Result later = prove(problem, prompt);
  CHECK(later.status == Status::uncertified);
  CHECK(failed(later.certificate, "unresolved"));
}

TEST_CASE("a second call without time changes nothing, and without a certificate it is refused", "[prove]") {
  const Problem problem = medium("1 + 0.3*exp(-6*((x-0.5)^2+(y-0.1)^2))");
  const Result prompt = run(problem, ProofRule::never);
  Monitor late;
  late.deadline = Monitor::Clock::now();
  const Result stopped = prove(problem, prompt, late);
  CHECK(stopped.status == prompt.status);
  CHECK(stopped.certificate.resolution->verdict == ResolutionVerdict::sampled);
  CHECK(stopped.certificate.estimate.error == prompt.certificate.estimate.error);
  REQUIRE(stopped.notes.size() == prompt.notes.size() + 1);
  CHECK(stopped.notes.back().find("prove()") != std::string::npos);
  CHECK_THROWS_AS(prove(problem, run(problem, ProofRule::never, false)), InputError);
  CHECK_THROWS_AS(prove(problem, Result()), InputError);
  const Problem in_space =
      between(space(3), make_euclidean_cost(3), Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1, 0, 0));
  CHECK_THROWS_WITH(prove(in_space, prompt), Catch::Contains("the path of the result is 2 x"));
  Problem without_kernel = problem;
  without_kernel.kernel = nullptr;
  CHECK_THROWS_WITH(prove(without_kernel, prompt), Catch::Contains("kernel"));
}

}  // namespace leastcost::test
