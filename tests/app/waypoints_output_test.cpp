// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// `output: {waypoints: ...}` of a configuration: waypoints.csv, result.json, and what is refused.
#include <algorithm>
#include <nlohmann/json.hpp>

#include <leastcost/catalogue/catalogue.hpp>
#include "tests/support/catch.hpp"
#include "tests/support/data.hpp"

namespace leastcost::test {
namespace {

namespace fs = std::filesystem;
using Catch::Contains;

const fs::path kTimed = "configs/waypoints.yaml", kAmongDiscs = "configs/plan_discs.yaml";

fs::path written(const ScratchDir& dir, const fs::path& config, const std::vector<Override>& overrides = {}) {
  return write_run(solve(load_run(project_dir() / config, overrides)), dir / "out");
}

nlohmann::json waypoints_of(const fs::path& folder) {
  return nlohmann::json::parse(content(folder / "result.json")).at("waypoints");
}

}  // namespace

TEST_CASE("waypoints of a time are a table with times") {
  const ScratchDir dir;
  const fs::path folder = written(dir, kTimed);
  const std::string table = content(folder / "waypoints.csv");
  CHECK_THAT(table, Catch::StartsWith("index,x,y,segment_cost,cumulative_cost,time\n0,0,0,"));
  CHECK(std::count(table.begin(), table.end(), '\n') == 1 + 33);  // 0, 0.1, ..., 3.1 and pi
  CHECK(waypoints_of(folder)["count"] == 33);
  CHECK(waypoints_of(folder)["clearance"].is_null());
}

TEST_CASE("waypoints among obstacles say whether the straight moves between them touch") {
  const ScratchDir dir;
  const fs::path few = written(dir, kAmongDiscs, {{"output.waypoints.count=4"}});
  CHECK(waypoints_of(few)["touches"] == true);
  CHECK_THAT(content(few / "result.json"),
             Contains("the straight moves between the waypoints are not collision-free: the move from waypoint"));
  CHECK_THAT(content(few / "waypoints.csv"), !Contains("time"));
}

TEST_CASE("waypoints take a count or a spacing") {
  const auto refused = [](const std::vector<Override>& overrides, const std::string& why) {
    CHECK_THROWS_WITH(load_run(project_dir() / kTimed, overrides), Contains(why));
  };
  refused({{"output.waypoints.count=5"}}, "either a 'count' or a 'spacing'");
  refused({{"output.waypoints.spacing=0"}}, "greater than 0");
  refused({{"output.waypoints.counts=5"}}, "did you mean 'count'");
}

}  // namespace leastcost::test
