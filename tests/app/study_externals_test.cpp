// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// Objects of a program in the problems of its studies.
#include <memory>
#include <string>

#include <leastcost/app/study.hpp>
#include <leastcost/problems/costs/euclidean.hpp>
#include <leastcost/problems/manifolds/euclidean.hpp>
#include "app/study/rows/run_table.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/data.hpp"

namespace leastcost::test {
namespace {

using Catch::Contains;

const std::string kOfObjects = R"(problems:
  - name: line
    config:
      manifold: {type: external, name: room}
      cost: {type: external, name: price}
      ends: {source: {point: [0, 0]}, target: {point: [3, 4]}}
points: [8, 12]
)";

Externals objects() {
  return {{"room", std::make_shared<const EuclideanManifold>(EuclideanManifoldOptions{.dimension = 2})},
          {"price", make_euclidean_cost(2)}};
}

}  // namespace

TEST_CASE("study: objects that the program hands over are in its cells") {
  const ScratchDir dir;
  const StudyOptions options{.output = dir / "out", .parallel = 2};
  const StudyResult result = run_study_text(kOfObjects, "study", {}, {}, options, objects());
  CHECK(result.complete_and_ok());
  const app::RunTable table = app::read_runs_csv(content(dir / "out/runs.csv"), "runs.csv");
  REQUIRE(table.rows.size() == 2);
  CHECK(table.rows[0].status == "certified");
  CHECK(table.rows[0].cost.value() == Approx(5).epsilon(1e-12));
}

TEST_CASE("study: an object that is not handed over is named at its place") {
  const ScratchDir dir;
  Externals without = objects();
  without.erase("price");
  const StudyOptions options{.output = dir / "out"};
  CHECK_THROWS_WITH(run_study_text(kOfObjects, "study", {}, {}, options, without),
                    Contains("study:5:") && Contains("price"));
}

}  // namespace leastcost::test
