// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// Coordinates of a configuration that name a point which has others: which of them a straight start goes to.
#include <leastcost/catalogue/run/load_run.hpp>
#include <leastcost/catalogue/run/solve.hpp>
#include "tests/app/config_text.hpp"
#include "tests/support/catch.hpp"

namespace leastcost::test {
namespace {

using Catch::Contains;

std::string with_ends(const std::string& surface, const std::string& source, const std::string& target,
                      const std::string& more = "") {
  return "manifold: {type: parametric, surface: " + surface + "}\ncost: euclidean\nends:\n  source: {point: " + source +
         "}\n  target: {point: " + target + "}\n" + more;
}

RunOutcome solved_image(const std::string& text) { return solve(parse_run(text, "a.yaml")); }

bool has_note(const RunOutcome& run, const std::string& part) {
  for (const std::vector<std::string>* notes : {&run.parts.notes, &run.result.notes})
    for (const std::string& note : *notes)
      if (note.find(part) != std::string::npos) return true;
  return false;
}

}  // namespace

TEST_CASE("a straight start goes to the cheapest image of the target, and says so") {
  const RunOutcome run = solved_image(with_ends("cylinder", "[0.1, 0]", "[6, 0.5]"));
  CHECK(has_note(run, "the target was replaced by (-0.283185, 0.5), winding (-1)"));
  CHECK(run.result.curve.cost == Approx(std::hypot(0.3831853, 0.5)).epsilon(1e-3));
  // A straight line through the pole is cheaper than along the parallel, and would end in a kink there.
  const RunOutcome beside_pole = solved_image(with_ends("sphere", "[0, 1.2]", "[2.5, 1.2]"));
  CHECK(beside_pole.result.status == Status::certified);
  const double sine = std::sin(1.2), cosine = std::cos(1.2);
  CHECK(beside_pole.result.curve.cost ==
        Approx(std::acos(sine * sine + cosine * cosine * std::cos(2.5))).epsilon(1e-3));
}

TEST_CASE("a target that states a winding keeps it, and so does a given one, the cheaper image is named") {
  const RunOutcome wound = solved_image(with_ends("cylinder", "[0.1, 0]", "[7.1, 0.5]"));
  CHECK(wound.result.curve.cost == Approx(std::hypot(7, 0.5)).epsilon(1e-3));
  CHECK(has_note(wound, "the target is also (0.816815, 0.5), winding (-1)"));
  const RunOutcome given = solved_image(with_ends("cylinder", "[0.1, 0]", "[6, 0.5]", "path: {target_image: given}\n"));
  CHECK(given.result.curve.cost == Approx(std::hypot(5.9, 0.5)).epsilon(1e-3));
  CHECK(has_note(given, "the target is also (-0.283185, 0.5), winding (-1)"));
  const RunOutcome near = solved_image(with_ends("cylinder", "[0.1, 0]", "[1, 0.5]"));
  CHECK_FALSE(has_note(near, "the target"));
}

TEST_CASE("a target that names the source by other coordinates is an error, unless it states a winding") {
  const char* same = "is the same point as the source, in other coordinates";
  CHECK_THAT(errors_of(with_ends("sphere", "[0.3, 1.5707963267948966]", "[1.2, 1.5707963267948966]")),
             Contains("a.yaml:5:3: error: 'target' in ends ") && Contains(same));
  CHECK_THAT(errors_of(with_ends("sphere", "[0.3, 0.4]", "[3.4415926535897932, 2.7415926535897932]")), Contains(same));
  CHECK_THAT(errors_of("manifold: {type: constraint, set: so3}\ncost: euclidean\nends:\n  source: {point: [1, 0, 0, 0]}"
                       "\n  target: {point: [-1, 0, 0, 0]}\n"),
             Contains(same));
  const std::string loop = with_ends("cylinder", "[0, 0]", "[6.283185307179586, 0]");
  CHECK(errors_of(loop) == "");
  CHECK(has_note(solved_image(loop), "both ends are the same point of the domain"));
}

}  // namespace leastcost::test
