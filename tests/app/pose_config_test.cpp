// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// Poses in configurations: which name of the target a path goes to, what is refused, and what the files call the
// coordinates.
#include <leastcost/catalogue/run/load_run.hpp>
#include <leastcost/catalogue/run/solve.hpp>
#include "catalogue/output/path_table.hpp"
#include "tests/app/config_text.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/pi.hpp"

namespace leastcost::test {
namespace {

std::string poses_between(const std::string& type, const std::string& source, const std::string& target,
                          const std::string& more = "") {
  return "manifold: {type: " + type +
         "}\ncost: {type: weighted_length, weights: [1, 0.5]}\nends:\n  source: {point: " + source +
         "}\n  target: {point: " + target + ", tolerance: 1e-6}\npath: {points: 40}\n" + more;
}

RunOutcome solved_poses(const std::string& text) { return solve(parse_run(text, "a.yaml")); }

double value_of(const RunOutcome& run) {
  CHECK(run.result.status == Status::certified);
  return run.result.certificate.estimate.value;
}

bool is_noted(const RunOutcome& run, const std::string& part) {
  for (const std::vector<std::string>* notes : {&run.parts.notes, &run.result.notes})
    for (const std::string& note : *notes)
      if (note.find(part) != std::string::npos) return true;
  return false;
}

}  // namespace

TEST_CASE("poses: a path goes to the name of the target to which it is cheapest, and says so") {
  const double turn = 2 * kPi - 6;
  const RunOutcome plane = solved_poses(poses_between("se2", "[0, 0, 3]", "[1, 1, -3]"));
  CHECK(value_of(plane) == Approx(std::hypot(std::sqrt(2.0), 0.5 * turn)).epsilon(1e-9));
  CHECK(is_noted(plane, "the target was replaced by (1, 1, 3.28319), winding (1)"));
  const RunOutcome room =
      solved_poses(poses_between("se3", "[0, 0, 0, 1, 0, 0, 0]", "[1, 2, -1, -0.5403023, 0, -0.8414710, 0]"));
  CHECK(value_of(room) == Approx(std::hypot(std::sqrt(6.0), 1)).epsilon(1e-6));
  CHECK(is_noted(room, "-q, the same point in other coordinates"));
  // Whichever first path it has.
  const RunOutcome tree =
      solved_poses(poses_between("se2", "[0, 0, 3]", "[1, 1, -3]", "initializer: rrt\nsolver: lbfgs\n"));
  CHECK(value_of(tree) == Approx(std::hypot(std::sqrt(2.0), 0.5 * turn)).epsilon(1e-9));
}

TEST_CASE("poses: a target a turn or more away states a winding, and so does a given one") {
  const RunOutcome wound = solved_poses(poses_between("se2", "[0, 0, 3]", "[1, 1, 10]"));
  CHECK(value_of(wound) == Approx(std::hypot(std::sqrt(2.0), 0.5 * 7)).epsilon(1e-9));
  CHECK(is_noted(wound, "the target is also (1, 1, 3.71681), winding (-1)"));
  std::string text = poses_between("se2", "[0, 0, 3]", "[1, 1, -3]");
  text.replace(text.find("path: {points: 40}"), 18, "path: {points: 40, target_image: given}");
  const RunOutcome kept = solved_poses(text);
  CHECK(value_of(kept) == Approx(std::hypot(std::sqrt(2.0), 3)).epsilon(1e-9));
  CHECK(is_noted(kept, "the target is also (1, 1, 3.28319), winding (1)"));
  // Waypoints lead to the coordinates that are given.
  const RunOutcome led = solved_poses(poses_between(
      "se2", "[0, 0, 3]", "[1, 1, -3]", "initializer: {type: waypoints, points: [[0.5, 0.5, 1], [0.8, 0.8, -2]]}\n"));
  CHECK(value_of(led) == Approx(std::hypot(std::sqrt(2.0), 3)).epsilon(1e-9));
}

TEST_CASE("poses: among obstacles the name of the target is chosen as without them") {
  const RunOutcome run = solved_poses(
      poses_between("se2", "[-2, 0.1, 3]", "[2, 0, -3]", "obstacles: [{type: ball, center: [0, 0], radius: 1}]\n"));
  CHECK(run.result.status == Status::certified);
  CHECK(is_noted(run, "winding (1)"));
  CHECK(is_noted(run, "without obstacles"));
  CHECK(run.result.certificate.estimate.value < 4.6);
}

TEST_CASE("poses: what is no pose, no box, no weight and no obstacle of theirs is refused where it stands") {
  using Catch::Contains;
  CHECK_THAT(errors_of(poses_between("se3", "[0, 0, 0, 0, 0, 0, 0]", "[1, 2, -1, 1, 0, 0, 0]")),
             Contains("'point' in ends.source") && Contains("factor 2 of the product has none"));
  CHECK_THAT(errors_of(poses_between("se2", "[0, 0]", "[1, 2, 3]")),
             Contains("'point' in ends.source") && Contains("must have 3 coordinates (x, y, angle; found 2)"));
  CHECK(errors_of(poses_between("se2", "[1, 1, 0.5]", "[1, 1, 6.783185307179586]")) == "");  // a loop, one turn
  CHECK_THAT(errors_of(poses_between("se3", "[0, 0, 0, 1, 0, 0, 0]", "[0, 0, 0, -1, 0, 0, 0]")),
             Contains("is the same point as the source, in other coordinates"));
  CHECK_THAT(errors_of(poses_between("se2, lower: [0, 0, 0]", "[1, 1, 0]", "[2, 2, 0]")),
             Contains("'lower' in manifold: 3 numbers, but the space has dimension 2"));
  CHECK_THAT(errors_of(poses_between("se2", "[0, 0, 0]", "[2, 2, 0]"), {"cost.weights=[1, 2, 3, 4]"}),
             Contains("'weights' in cost has 4 numbers; give 2, one per factor of the domain, or 3"));
  CHECK_THAT(errors_of(poses_between("se2", "[0, 0, 0]", "[2, 2, 0]"), {"cost.weights=[1, 0]"}),
             Contains("'weights' in cost"));
  CHECK_THAT(errors_of(poses_between("se2", "[-2, 0, 0]", "[2, 0, 0]",
                                     "obstacles: [{type: ball, center: [0, 0, 0], radius: 1}]\n")),
             Contains("'obstacles[0]': ") && Contains("has 3 dimensions, but the domain has 2"));
  CHECK_THAT(errors_of(poses_between("se2", "[0.5, 0, 3]", "[2, 0, 0]",
                                     "obstacles: [{type: ball, center: [0, 0], radius: 1}]\n")),
             Contains("end_in_clearance"));
}

TEST_CASE("poses: files call the coordinates by their names") {
  const RunOutcome run = solved_poses(poses_between("se2", "[0, 0, 1]", "[1, 1, 2]"));
  const Problem& problem = run.parts.problem;
  const std::string csv = csv_text(delivered_points(problem, run.result));
  CHECK(csv.substr(0, csv.find('\n')) == "index,x,y,angle,segment_cost,cumulative_cost");
  CHECK(csv_text(delivered_curve(problem, run.result)).substr(0, 15) == "index,x,y,angle");
  CHECK(first_path_csv(problem, run.result.first).substr(0, 15) == "index,x,y,angle");
}

}  // namespace leastcost::test
