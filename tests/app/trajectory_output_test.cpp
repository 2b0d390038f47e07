// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// `output: {trajectory: ...}` of a configuration: trajectory.csv, trajectory.json, result.json, and what is refused.
#include <algorithm>
#include <nlohmann/json.hpp>

#include <leastcost/catalogue/catalogue.hpp>
#include "catalogue/output/output_folder.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/data.hpp"

namespace leastcost::test {
namespace {

namespace fs = std::filesystem;
using Catch::Contains;
using Json = nlohmann::json;

const fs::path kDiscs = "configs/plan_discs.yaml";

}  // namespace

TEST_CASE("trajectory: files among discs, with the corners rounded as far as that stays clear") {
  const ScratchDir dir;
  const fs::path folder = write_run(solve(load_run(project_dir() / kDiscs, {{"output.trajectory.velocity=[1]"},
                                                                            {"output.trajectory.acceleration=[2, 2]"},
                                                                            {"output.trajectory.interval=0.05"}})),
                                    dir / "out");
  for (const auto& file : fs::directory_iterator(folder)) CHECK(is_result_file(file.path()));  // may be replaced
  const Json result = Json::parse(content(folder / "result.json")).at("trajectory");
  CHECK(result["touches"] == false);
  CHECK(result["duration"] >= result["least_duration"]);
  const std::string table = content(folder / "trajectory.csv");
  CHECK_THAT(table, Catch::StartsWith("time,x,y,velocity_x,velocity_y,acceleration_x,acceleration_y\n0,"));
  CHECK(std::count(table.begin(), table.end(), '\n') == 1 + result["samples"].get<long>());
  const Json motion = Json::parse(content(folder / "trajectory.json"));
  CHECK(motion["joint_names"] == Json({"x", "y"}));
  CHECK(motion["points"].size() == result["samples"]);
  const Json& last = motion["points"].back();
  CHECK(last["time_from_start"]["sec"].get<double>() + 1e-9 * last["time_from_start"]["nanosec"].get<double>() ==
        Approx(result["duration"].get<double>()).margin(2e-9));
  CHECK(last["velocities"] == Json({0.0, 0.0}));
}

TEST_CASE("trajectory: limits that do not fit are refused before the path is sought") {
  const auto refused = [](const std::vector<Override>& overrides, const std::string& why) {
    CHECK_THROWS_WITH(load_run(project_dir() / kDiscs, overrides), Contains(why));
  };
  refused({{"output.trajectory.velocity=[0]"}, {"output.trajectory.acceleration=[1]"}}, "greater than 0");
  refused({{"output.trajectory.velocity=[1]"}}, "needs limits of both velocity and acceleration");
  refused({{"output.trajectory.velocity=[1, 2, 3]"}, {"output.trajectory.acceleration=[1]"}},
          "one for each of the 2 coordinates");
  CHECK_THROWS_WITH(load_run(project_dir() / "configs/constraint_sphere.yaml",
                             {{"output.trajectory.velocity=[1]"}, {"output.trajectory.acceleration=[1]"}}),
                    Contains("a trajectory needs a flat domain"));
}

}  // namespace leastcost::test
