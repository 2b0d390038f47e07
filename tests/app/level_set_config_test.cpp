// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// Surfaces and equations in a configuration: what is wrong is shown where it stands.
#include "tests/app/config_text.hpp"
#include "tests/support/catch.hpp"

namespace leastcost::test {

using Catch::Contains;

namespace {

std::string on(const std::string& manifold, const std::string& source = "[1, 0, 0]",
               const std::string& target = "[0, 1, 0]") {
  return "manifold:\n" + manifold + "cost: euclidean\nends:\n  source: {point: " + source +
         "}\n  target: {point: " + target + "}\n";
}

}  // namespace

TEST_CASE("level sets in a configuration: right ones") {
  CHECK(errors_of(on("  type: implicit\n  surface: sphere\n")) == "");
  CHECK(errors_of(on("  type: implicit\n  surface: {type: formula, f: x^2 + y^2 + z^2 - r, parameters: {r: 1}}\n")) ==
        "");
  CHECK(errors_of(on("  type: constraint\n  dimension: 3\n  equations: x0^2 + x1^2 + x2^2 - 1\n")) == "");
}

TEST_CASE("level sets in a configuration: errors at their places") {
  CHECK_THAT(errors_of(on("  type: implicit\n")), Contains("missing key 'surface' in manifold"));
  CHECK_THAT(errors_of(on("  type: implicit\n  surface: {type: torus, radius: 1}\n")),
             Contains("a.yaml:3:26: error: unknown key 'radius' in manifold.surface (did you mean "
                      "'major_radius'?)"));
  CHECK_THAT(errors_of(on("  type: implicit\n  surface: {type: torus, major_radius: 1, minor_radius: 2}\n")),
             Contains("a.yaml:3:57: error: 'minor_radius' in manifold.surface must be smaller than major_radius"));
  CHECK_THAT(errors_of(on("  type: implicit\n  surface: {type: formula, f: x + yy}\n")),
             Contains("a.yaml:3:31: error: 'f' in manifold.surface: character 5 of the formula: unknown name 'yy'"));
  CHECK_THAT(errors_of(on("  type: constraint\n  dimension: 3\n  equations: [x0 - 1, x1 +]\n")),
             Contains("a.yaml:4:23: error:") && Contains("character 5 of the formula: found the end"));
  CHECK_THAT(errors_of(on("  type: constraint\n")), Contains("missing: give equations") && Contains("or a set"));
  CHECK_THAT(errors_of(on("  type: implicit\n  surface: sphere\n", "[0, 0, 0]")),
             Contains("a.yaml:6:19: error:") && Contains("gradients of the equations are zero"));
}

TEST_CASE("level sets in a configuration: described with every type of surface") {
  const LoadedConfig loaded =
      parse(on("  type: implicit\n  surface: {type: ellipsoid, axes: [1, 2, 3]}\n", "[1, 0, 0]", "[0, 2, 0]"));
  CHECK_THAT(resolved_yaml(loaded.config), Contains("  surface:\n    type: ellipsoid\n    axes: [1, 2, 3]\n"));
}

TEST_CASE("distance grids in a configuration: checked without reading or sampling anything") {
  CHECK(errors_of(on("  type: signed_distance\n  source: {type: mesh, file: missing.obj}\n  cell: 1\n")) == "");
  CHECK(errors_of(on("  type: signed_distance\n  source: {type: implicit, surface: sphere}\n  cell: 1e-9\n")) == "");
  CHECK_THAT(errors_of(on("  type: signed_distance\n")), Contains("missing key 'source' in manifold"));
  CHECK_THAT(
      errors_of(on("  type: signed_distance\n  source: {type: implicit, surface: sphere}\n  cell: 1\n  accuracy: 1\n")),
      Contains("a.yaml:5:13: error: 'accuracy' in manifold: give either cell or accuracy"));
  CHECK_THAT(errors_of(on("  type: signed_distance\n  source: {type: mesh, file: a.obj, sign: unsigned}\n")),
             Contains("'offset' in manifold.source must be greater than 0 with sign: unsigned"));
  CHECK_THAT(
      errors_of(on("  type: signed_distance\n  source: {type: implicit, surface: {type: formula, f: x + yy}}\n")),
      Contains("a.yaml:3:56: error: 'f' in manifold.source.surface: character 5"));
}

}  // namespace leastcost::test
