// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "tests/app/config_text.hpp"
#include "tests/support/catch.hpp"

namespace leastcost::test {

using Catch::Contains;

TEST_CASE("override: replaces, adds, and makes blocks on the way") {
  CHECK(parse(kPlane, {"path.points=7"}).config.points == 7);
  CHECK(parse(kPlane, {"seed=3", "name=x"}).config.seed == 3);
  CHECK(parse(kPlane, {"kernel=square"}).config.kernel.plugin->type == "square");
  CHECK(parse(kPlane, {"solver={type: lbfgs, memory: 3}"}).config.solver.plugin->type == "lbfgs");
  CHECK(parse(kPlane, {"ends.target.point=[1, 2]"}).config.target->point == Eigen::Vector2d(1, 2));
  CHECK(parse(kPlane, {"post_process=[]"}).config.post_process->empty());
}

TEST_CASE("override: a type given as a word becomes a block") {
  LoadedConfig loaded = parse(kPlane, {"cost=travel_time", "cost.gravity=1"});
  CHECK(loaded.errors.empty());
  CHECK_THAT(resolved_yaml(loaded.config), Contains("type: travel_time") && Contains("gravity: 1\n"));
}

TEST_CASE("override: the last one wins") { CHECK(parse(kPlane, {"seed=1", "seed=2"}).config.seed == 2); }

TEST_CASE("override: positions in a list") {
  LoadedConfig loaded =
      parse(kPlane + "initializer: {type: waypoints, points: [[1, 1], [2, 2]]}\n", {"initializer.points.1.0=5"});
  CHECK(loaded.errors.empty());
  CHECK_THAT(resolved_yaml(loaded.config), Contains("points: [[1, 1], [5, 2]]"));
  CHECK_THAT(
      errors_of(kPlane + "post_process: []\n", {"post_process.0=trace"}),
      Contains("--set post_process.0=trace: error: the list has 0 entries, numbered from 0; '0' is not one of them\n"));
}

TEST_CASE("override: positions in a list may be written in brackets and are numbered from 0") {
  const std::string discs = kPlane +
                            "obstacles: [{type: ball, center: [9, 9], radius: 1}, {type: ball, center: [5, 5], radius: "
                            "1}]\n";
  LoadedConfig loaded = parse(discs, {"obstacles[1].radius=0.25", "obstacles[0].center[1]=7"});
  CHECK(loaded.errors.empty());
  const std::string resolved = resolved_yaml(loaded.config);
  CHECK_THAT(resolved, Contains("radius: 0.25") && Contains("[9, 7]"));
  CHECK(resolved.find("radius: 0.25") > resolved.find("[5, 5]") - 60);
  CHECK_THAT(errors_of(discs, {"obstacles[2].radius=1"}),
             Contains("the list has 2 entries, numbered from 0; '2' is not one of them"));
  for (const char* bad : {"obstacles[=1", "obstacles[].radius=1", "obstacles[x].radius=1", "obstacles[1]radius=1",
                          "[1].radius=1", "obstacles.[1].radius=1"}) {
    CAPTURE(bad);
    CHECK_THAT(errors_of(discs, {bad}), Contains("obstacles[1].radius=2"));
  }
}

TEST_CASE("override: an entry of a list that is not there is told with what would be right") {
  for (const char* path : {"obstacles[0].type=ball", "obstacles[2].radius=2", "obstacles.0.radius=2"}) {
    CAPTURE(path);
    CHECK_THAT(errors_of(kPlane, {path}),
               Contains(std::string("--set ") + path + ": error: 'obstacles' has no entry") &&
                   Contains("the configuration does not give this list; give all of it at "
                            "once, obstacles=[..]"));
    CHECK_THAT(errors_of(kPlane, {path}), !Contains("has no value"));
  }
  CHECK_THAT(errors_of(kPlane, {"ends[0].point=[1, 2]"}),
             Contains("'ends' has no entry 0: it is a block of keys, not a list; name one of its keys, ends.KEY"));
  CHECK_THAT(errors_of(kPlane, {"path.points=7", "path.points[1]=3"}),
             Contains("'path.points' has no entry 1: it is one value, not a list; leave out the number"));
}

TEST_CASE("override: errors show the argument in the place of the position") {
  CHECK(errors_of(kPlane, {"path.points=many"}) ==
        "--set path.points=many: error: 'points' in path must be a whole number or auto (found 'many')\n");
  CHECK(errors_of(kPlane, {"solver.type=newton", "solver.max_itr=5"}) ==
        "--set solver.max_itr=5: error: unknown key 'max_itr' in solver (did you mean 'max_iterations'?)\n");
  CHECK(errors_of(kPlane, {"seed="}) == "--set seed=: error: 'seed' has no value: remove the key to use the default\n");
  for (const char* bad : {"seed", "=3", "a..b=1", ".a=1", "a b=1"}) {
    CAPTURE(bad);
    CHECK_THAT(errors_of(kPlane, {bad}), Contains("must have the form key=value or block.key=value"));
  }
  CHECK_THAT(errors_of(kPlane, {"seed=[1"}), Contains("--set seed=[1: error: YAML: "));
  CHECK_THAT(errors_of(kPlane, {"ends.target.point=[0, 0]"}),
             Contains("--set ends.target.point=[0, 0]: error: 'target' in ends") ||
                 Contains("is the same point as the source"));
}

}  // namespace leastcost::test
