// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// What a user reads when a configuration is wrong, to the letter.
#include <fstream>
#include <string>

#include "catalogue/registry/registry.hpp"
#include "catalogue/yaml/suggest.hpp"
#include "tests/app/called.hpp"
#include "tests/app/config_text.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/data.hpp"

namespace leastcost::test {

using Catch::Contains;

TEST_CASE("config errors: a number with point or exponent is told from a whole number in digits") {
  for (const char* number : {"1e12", "64.0", "1e2"})
    CHECK_THAT(errors_of(kPlane + "seed: " + number + "\n"),
               Contains("'seed' must be a whole number in digits, without point and exponent (found '" +
                        std::string(number) + "')"));
}

TEST_CASE("config: a torus that crosses itself gets a note") {
  const auto notes = [](const std::string& minor) {
    const Run run =
        parse_run("manifold: {type: parametric, surface: {type: torus, major_radius: 1, minor_radius: " + minor +
                      "}}\ncost: euclidean\nends: {source: {point: [0, 0]}, target: {point: [1, 1]}}\n",
                  "a.yaml");
    std::string all;
    for (const std::string& note : run.parts.notes) all += note + "\n";
    return all;
  };
  CHECK_THAT(notes("2"),
             Contains("the torus crosses itself, because minor_radius (2) is larger than major_radius (1)"));
  CHECK_THAT(notes("0.5"), !Contains("crosses itself"));
}

TEST_CASE("config: a space has as many dimensions as its box") {
  const std::string ends = "\nends: {source: {point: [0, 0, 0]}, target: {point: [1, 1, 1]}}\n";
  for (const char* sides : {"lower: [0, 0, 0], upper: [1, 1, 1]", "lower: [0, 0, 0]", "upper: [1, 1, 1]"}) {
    const std::string text = "manifold: {type: euclidean, " + std::string(sides) + "}" + ends;
    CHECK(errors_of(text) == "");
    CHECK_THAT(resolved_yaml(parse(text).config), Contains("dimension: 3"));
  }
  CHECK_THAT(errors_of("manifold: {type: euclidean, lower: [0, 0, 0], upper: [1, 1]}" + ends),
             Contains("'upper' in manifold: 2 numbers, but the space has dimension 3"));
  CHECK_THAT(errors_of("manifold: {type: euclidean, dimension: 2, lower: [0, 0, 0]}" + ends),
             Contains("'lower' in manifold: 3 numbers, but the space has dimension 2"));
}

TEST_CASE("config errors: a good configuration has none") { CHECK(errors_of(kPlane) == ""); }

TEST_CASE("config errors: unknown key, with place, line, underline and the key that was meant") {
  CHECK(errors_of(kPlane + "solver:\n  type: newton\n  max_iter: 200\n") ==
        "a.yaml:8:3: error: unknown key 'max_iter' in solver (did you mean 'max_iterations'?)\n"
        "    8 |   max_iter: 200\n"
        "      |   ^~~~~~~~\n");
}

TEST_CASE("config errors: an unknown key that resembles none lists the valid ones") {
  CHECK(errors_of("manifold: {type: euclidean, colour: 3}\n" + kPlane.substr(kPlane.find('\n') + 1)) ==
        "a.yaml:1:29: error: unknown key 'colour' in manifold; valid keys: dimension, lower, upper, type\n"
        "    1 | manifold: {type: euclidean, colour: 3}\n"
        "      |                             ^~~~~~\n");
}

/// What an error lists: it grows with every plug-in.
static std::string all_manifolds() { return joined(types_of(kind("manifold"))); }

TEST_CASE("config errors: unknown type") {
  CHECK(errors_of("manifold: euclidan\ncost: euclidean\nends: {source: {point: [0, 0]}, target: {point: [1, 1]}}\n") ==
        "a.yaml:1:11: error: unknown manifold 'euclidan' (did you mean 'euclidean'?); valid types: " + all_manifolds() +
            "\n"
            "    1 | manifold: euclidan\n"
            "      |           ^~~~~~~~\n");
}

TEST_CASE("config errors: missing keys stand at their block") {
  CHECK(errors_of(
            "manifold: euclidean\ncost: metric_tensor\nends:\n  source: {point: [0, 0]}\n  target: {point: [1, 1]}\n")
            .rfind("a.yaml:2:1: error: missing key 'matrix' in cost: ", 0) == 0);
  CHECK_THAT(errors_of("manifold: {dimension: 2}\ncost: euclidean\n"),
             Contains("a.yaml:1:1: error: missing key 'type' in manifold: one of " + all_manifolds() + "\n"));
  CHECK_THAT(errors_of("cost: euclidean\n"), Contains("a.yaml:1:1: error: missing key 'manifold': "));
  CHECK_THAT(errors_of("manifold: euclidean\n"), Contains("missing key 'ends': the source and target of the path"));
  CHECK_THAT(errors_of("manifold: euclidean\ncost: euclidean\nends:\n  source: {point: [0, 0]}\n"),
             Contains("a.yaml:3:1: error: missing key 'target' in ends: End of the path.\n"));
}

TEST_CASE("config errors: all of them, in the order of the file") {
  const std::string errors = errors_of(R"(manifold: {type: euclidean, dimension: two}
cost: {type: travel_time, gravity: -1, rule: chut}
ends:
  source: {point: [0, x]}
  target: {point: [1, 1], vertex: 3}
path: {points: 0, rng: true}
nmae: x
)");
  std::vector<std::string> lines;
  for (std::size_t at = 0; (at = errors.find("a.yaml:", at)) != std::string::npos; ++at)
    lines.push_back(errors.substr(at, errors.find('\n', at) - at));
  CHECK(lines ==
        std::vector<std::string>{
            "a.yaml:1:40: error: 'dimension' in manifold must be a whole number (found 'two')",
            "a.yaml:2:36: error: 'gravity' in cost must be greater than 0 (found '-1')",
            "a.yaml:2:46: error: 'rule' in cost must be one of: chute, midpoint; found 'chut' (did you mean 'chute'?)",
            "a.yaml:4:23: error: 'point' in ends.source has an entry that must be a number, .inf or -.inf (found 'x')",
            "a.yaml:5:3: error: 'target' in ends must have exactly one of: vertex; face and barycentric; point; "
            "lonlat; state; points; tool",
            "a.yaml:5:35: error: 'euclidean' has no vertices: give the end as {point: [..]}",
            "a.yaml:6:16: error: 'points' in path must be at least 1 and at most 10000000 (found '0')",
            "a.yaml:6:19: error: unknown key 'rng' in path (did you mean 'ring'?)",
            "a.yaml:7:1: error: unknown key 'nmae' (did you mean 'name'?)"});
  CHECK(parse("manifold: euclidean\ncost: euclidean\npath: {ring: 1, points: x}\n").errors.count() ==
        "3 errors in a.yaml");
}

TEST_CASE("config errors: numbers that YAML would have bent") {
  const auto points = [](const std::string& value) { return errors_of(kPlane + "path: {points: " + value + "}\n"); };
  CHECK(points("64") == "");
  CHECK(points("+64") == "");
  CHECK_THAT(points("010"), Contains("must be a whole number or auto (found '010')"));
  CHECK_THAT(points("0x40"), Contains("must be a whole number or auto (found '0x40')"));
  CHECK_THAT(points("64.0"),
             Contains("must be a whole number in digits, without point and exponent, or auto (found '64.0')"));
  CHECK_THAT(points("\"64\""), Contains("must be a whole number or auto (found the text '64' in quotes)"));
  CHECK_THAT(points("99999999999999999999"), Contains("must be a whole number or auto"));
  const auto seed = [](const std::string& value) { return errors_of(kPlane + "seed: " + value + "\n"); };
  CHECK_THAT(seed("010"), Contains("must be a whole number without leading zeros (found '010')"));
  CHECK_THAT(seed("99999999999"), Contains("must be a whole number between -2147483648 and 2147483647"));
  CHECK_THAT(seed("1_000"), Contains("must be a whole number (found '1_000')"));
  CHECK_THAT(seed("-1"), Contains("must be at least 0 (found '-1')"));
  const auto seconds = [](const std::string& value) { return errors_of(kPlane + "max_seconds: " + value + "\n"); };
  CHECK(seconds("1.5e2") == "");
  CHECK(seconds(".5") == "");
  CHECK_THAT(seconds(".nan"), Contains("must be a finite number (found '.nan')"));
  CHECK_THAT(seconds("nan"), Contains("must be a finite number (found 'nan')"));
  CHECK_THAT(seconds(".inf"), Contains("must be a finite number (found '.inf')"));
  CHECK_THAT(seconds("1e999"), Contains("must be a number that fits double precision (found '1e999')"));
  CHECK_THAT(seconds("1,5"), Contains("must be a finite number (found '1,5')"));
  CHECK_THAT(seconds("[1]"), Contains("must be a finite number (found a list)"));
  const auto ring = [](const std::string& value) { return errors_of(kPlane + "path: {ring: " + value + "}\n"); };
  CHECK(ring("false") == "");
  CHECK_THAT(ring("no"), Contains("must be true or false (found 'no')"));
  CHECK_THAT(ring("False"), Contains("must be true or false (found 'False')"));
  CHECK_THAT(ring("0"), Contains("must be true or false (found '0')"));
}

TEST_CASE("config errors: lists and matrices") {
  const auto matrix = [](const std::string& value) {
    return errors_of("manifold: euclidean\ncost: {type: metric_tensor, matrix: " + value +
                     "}\nends: {source: {point: [0, 0]}, target: {point: [1, 1]}}\n");
  };
  CHECK(matrix("[[1, 0], [0, 1]]") == "");
  CHECK_THAT(matrix("[1, 0]"), Contains("must be a list of rows, like [[1, 0], [0, 1]] (found a list without rows)"));
  CHECK_THAT(matrix("3"), Contains("must be a list of rows, like [[1, 0], [0, 1]] (found '3')"));
  CHECK_THAT(matrix("[[1, 0], [0]]"),
             Contains("a.yaml:2:46: error: 'matrix' in cost has rows of different length (1 here, 2 in the first)"));
  CHECK_THAT(matrix("[[1, 0], [0, .inf]]"), Contains("has an entry that must be a finite number (found '.inf')"));
  CHECK_THAT(matrix("[]"), Contains("found a list without rows"));
  CHECK_THAT(errors_of("manifold: {type: euclidean, lower: three}\n" + kPlane.substr(kPlane.find('\n') + 1)),
             Contains("'lower' in manifold must be a list of numbers, like [0, 1] (found 'three')"));
}

TEST_CASE("config errors: what constructors refuse stands at its option") {
  const std::string ends = "\nends: {source: {point: [0, 0]}, target: {point: [1, 1]}}\n";
  const std::string box =
      errors_of("manifold: {type: euclidean, dimension: 2, lower: [0, 0, 0]}\ncost: euclidean" + ends);
  CHECK_THAT(box, Contains("a.yaml:1:50: error: 'lower' in manifold: 3 numbers, but the space has dimension 2; write "
                           "`dimension: 3` for it\n"));
  const std::string indefinite =
      errors_of("manifold: euclidean\ncost: {type: metric_tensor, matrix: [[1, 0], [0, -1]]}" + ends);
  CHECK_THAT(indefinite, Contains("a.yaml:2:37: error: 'matrix' in cost: "));
  CHECK_THAT(
      errors_of("manifold: euclidean\ncost: euclidean\nends: {source: {point: [0, 0, 0]}, target: {point: [1, 1]}}\n"),
      Contains("a.yaml:3:24: error: 'point' in ends.source must have 2 coordinates (x, y; found 3)\n"));
  CHECK_THAT(
      errors_of("manifold: euclidean\ncost: euclidean\nends: {source: {point: [1, 1]}, target: {point: [1, 1]}}\n"),
      Contains("'target' in ends is the same point as the source"));
}

TEST_CASE("config errors: parts that do not fit each other") {
  const std::string mesh = "manifold: {type: mesh, file: m.obj}\n";
  const std::string vertices = "ends: {source: {vertex: 0}, target: {vertex: 1}}\n";
  CHECK(errors_of(mesh + "cost: euclidean\n" + vertices) == "");
  CHECK_THAT(
      errors_of(mesh + "cost: travel_time\npost_process: [trace, straighten]\n" + vertices),
      Contains("a.yaml:3:23: error: 'straighten' needs a cost with a constant metric, but 'travel_time' has none\n"));
  CHECK_THAT(errors_of(kPlane + "post_process: [trace]\n"),
             Contains("'trace' needs a manifold with a mesh, but 'euclidean' has none"));
  CHECK_THAT(errors_of(kPlane + "initializer: dijkstra\n"),
             Contains("a.yaml:6:14: error: 'dijkstra' needs a manifold with a graph, but 'euclidean' has none\n"));
  CHECK_THAT(errors_of("manifold: euclidean\ncost: euclidean\n" + vertices),
             Contains("a.yaml:3:25: error: 'euclidean' has no vertices: give the end as {point: [..]}\n"));
  CHECK_THAT(errors_of(kPlane + "path: {points: auto}\n"),
             Contains("'auto' takes the number of points from the first path"));
  CHECK_THAT(errors_of(kPlane + "path: {ring: true}\n"),
             Contains("a ring (path.ring: true) has no target: remove one of the two"));
  const std::string ring = "manifold: euclidean\ncost: euclidean\npath: {ring: true}\n";
  const std::string based =
      "manifold: {type: parametric, surface: torus}\ncost: euclidean\npath: {ring: true}\n"
      "initializer: {type: coordinate_circle, through: [0, 3]}\n";
  CHECK(errors_of(based + "ends: {source: {point: [0, 3]}}\n") == "");
  CHECK_THAT(errors_of(based + "ends: {source: {point: [0, 3]}, target: {point: [1, 3]}}\n"),
             Contains("a source alone is a fixed point of the ring"));
  CHECK_THAT(errors_of(based + "ends: {source: {point: [0, 3, 1]}}\n"),
             Contains("must have 2 coordinates (u, v; found 3)"));
  CHECK_THAT(errors_of(based + "family: {windings: 1, bows: 2}\n"),
             Contains("'windings' tries images of the target, but a ring has none") &&
                 Contains("'bows' bows the line between two ends, but a ring has none"));
  CHECK_THAT(errors_of(based + "family: {initializers: [straight]}\n"), Contains("'straight' joins two ends"));
  CHECK_THAT(errors_of("manifold: {type: parametric, surface: torus}\ncost: euclidean\npath: {ring: true}\n"),
             Contains("give an initializer: plane_cut, waypoints, coordinate_circle or file"));
  CHECK_THAT(errors_of(kPlane + "family: {routes: 3}\n"), Contains("'routes' needs a manifold with a graph"));
  CHECK_THAT(errors_of(based + "family: {routes: 3, mirrored: true}\n"),
             Contains("'routes' tries routes between two ends") && Contains("'mirrored' mirrors a path at its ends"));
  CHECK_THAT(errors_of(kPlane + "family: {windings: 1}\n"), Contains("'windings' needs a manifold with a chart"));
  CHECK_THAT(errors_of(ring), Contains("give an initializer: waypoints or file"));
  CHECK_THAT(errors_of(ring + "initializer: straight\n"), Contains("'straight' joins two ends, but a ring has none"));
  CHECK(errors_of(ring + "initializer: {type: waypoints, points: [[1, 0], [0, 1], [-1, -1]]}\n") == "");
  CHECK(errors_of(mesh + "cost: euclidean\npath: {ring: true}\npost_process: [straighten]\n"
                         "initializer: {type: plane_cut, point: [0, 0, 0], normal: [0, 0, 1]}\n") == "");
  CHECK_THAT(errors_of(ring + "initializer: {type: plane_cut, point: [0, 0, 0], normal: [0, 0, 1]}\n"),
             Contains("'plane_cut' needs a manifold with a surface"));
  // What the type may have, the manifold itself is asked for.
  const std::string cut =
      "cost: euclidean\npath: {ring: true}\n"
      "initializer: {type: plane_cut, point: [0, 0, 0], normal: [0, 0, 1]}\nmanifold: ";
  CHECK_THAT(errors_of(cut + "{type: implicit, surface: paper_curve}\n"),
             Contains("needs a manifold with a surface, but this 'implicit' has none"));
  CHECK_THAT(errors_of(cut + "{type: constraint, dimension: 4, set: sphere}\n"),
             Contains("needs a manifold with a surface, but this 'constraint' has none"));
  CHECK(errors_of(cut + "{type: constraint, dimension: 3, set: sphere}\n") == "");
  CHECK(errors_of(cut + "{type: implicit, surface: sphere}\n") == "");
}

TEST_CASE("config errors: taut is the default among obstacles, in space where no box holds the path as well") {
  const auto solver_of = [](const std::string& box) {
    return parse("manifold: {type: euclidean, dimension: 3" + box +
                 "}\ncost: euclidean\nends: {source: {point: [-2, 0, 0]}, target: {point: [2, 0, 0]}}\n"
                 "obstacles: [{type: ball, center: [0, 0, 0], radius: 1}]\n")
        .config.solver.plugin->type;
  };
  CHECK(solver_of("") == "none");
  CHECK(solver_of(", lower: [-3, -3, -1.1], upper: [3, 3, 1.1]") == "newton");
}

TEST_CASE("config errors: layers, and refraction where it cannot be") {
  const std::string plane = "manifold: {type: euclidean, dimension: 2}\n";
  const std::string ends = "ends: {source: {point: [0, 1]}, target: {point: [2, -1]}}\n";
  const std::string layers = "cost: {type: layers, interfaces: [0], speeds: [2, 1]}\n",
                    refract = "post_process: [refract]\n";
  CHECK(errors_of(plane + ends + layers) == "");
  CHECK(errors_of(plane + ends + layers + refract) == "");
  CHECK_THAT(
      errors_of(plane + ends + "cost: {type: layers, interfaces: [0], speeds: [2, 1, 1]}\n"),
      Contains("'speeds' in cost has 3 numbers, but must have one for each of the 2 layers: one more than interfaces"));
  CHECK_THAT(errors_of(plane + ends + "cost: {type: layers, interfaces: [0]}\n"),
             Contains("give either 'speeds' or 'indices'"));
  CHECK_THAT(errors_of(plane + ends + "cost: {type: layers, interfaces: [1, 0], speeds: [1, 2, 3]}\n"),
             Contains("must increase: number 2 is not above the previous one"));
  CHECK_THAT(errors_of(plane + ends + "cost: euclidean\n" + refract),
             Contains("'refract' needs a cost with a stack of layers, but 'euclidean' has none"));
  CHECK_THAT(
      errors_of(plane + ends + layers + refract + "obstacles: [{type: ball, center: [9, 9], radius: 1}]\n"),
      Contains("'refract' works for paths between two ends in R^d or a box (euclidean), without obstacles or robots"));
}

TEST_CASE("config errors: cells of a cost map where they cannot be") {
  const std::string plane = "manifold: {type: euclidean, dimension: 2}\n",
                    ends = "ends: {source: {point: [0, 1]}, target: {point: [2, -1]}}\n",
                    ball = "obstacles: [{type: ball, center: [9, 9], radius: 1}]\n";
  const auto map = [](const char* read) {
    return std::string("cost: {type: cost_map, file: a.csv, interpolation: ") + read + "}\n";
  };
  CHECK(errors_of(plane + ends + map("cells")) == "");
  CHECK(errors_of(plane + ends + map("cells") + "post_process: [refract_cells]\n") == "");
  CHECK_THAT(errors_of(plane + ends + map("cells") + ball),
             Contains("'cells' works for paths between two ends in the plane or a box (euclidean), without obstacles"));
  CHECK(errors_of(plane + ends + map("smooth") + ball) == "");  // as it says
  CHECK_THAT(errors_of(plane + ends + map("smooth") + "post_process: [refract_cells]\n"),
             Contains("'refract_cells' needs a cost map that is constant in each cell"));
  const std::string graph = "initializer: cell_graph\n", other = "family: {initializers: [cell_graph]}\n";
  CHECK(errors_of(plane + ends + map("cells") + graph) == "");
  for (const std::string& first : {graph, other})
    CHECK_THAT(errors_of(plane + ends + map("smooth") + first),
               Contains("'cell_graph' needs a cost map that is constant in each cell") &&
                   Contains("interpolation: cells") && Contains("a.yaml:"));
  CHECK_THAT(errors_of(plane + ends + "cost: euclidean\n" + graph), Contains("'cell_graph' needs a cost map"));
}

TEST_CASE("config errors: a cost map where points fill space would be the same at every height") {
  const std::string space = "manifold: {type: euclidean, dimension: 3}\n",
                    ends = "ends: {source: {point: [0, 1, 0]}, target: {point: [2, -1, 1]}}\n",
                    map = "{type: cost_map, file: a.csv}";
  for (const std::string& cost : {map, "{type: scaled, by: \"2\", cost: " + map + "}"})
    CHECK_THAT(errors_of(space + ends + "cost: " + cost + "\n"),
               Contains("the points of this manifold fill space") && Contains("use the plane or a surface"));
}

TEST_CASE("config errors: taut where paths cannot be pulled tight") {
  const auto plan = [](const std::string& manifold, const std::string& cost, const std::string& obstacles) {
    const std::string ends = manifold.find("3") == std::string::npos
                                 ? "{source: {point: [-2, 0]}, target: {point: [2, 0]}}"
                                 : "{source: {point: [-2, 0, 0]}, target: {point: [2, 0, 0]}}";
    return "manifold: " + manifold + "\ncost: " + cost + "\nends: " + ends + "\nobstacles: " + obstacles +
           "\npost_process: [taut]\n";
  };
  const std::string plane = "{type: euclidean, dimension: 2}", disc = "[{type: ball, center: [0, 0], radius: 1}]";
  CHECK(errors_of(plan(plane, "euclidean", disc)) == "");
  CHECK(errors_of(plan("{type: euclidean, dimension: 3}", "euclidean",
                       "[{type: ball, center: [0, 0, 0], radius: 1}]")) == "");
  CHECK_THAT(errors_of(plan(plane, "euclidean", "[]")),
             Contains("'taut' needs obstacles around which to pull the path"));
  CHECK_THAT(errors_of(plan(plane, "{type: clearance, weight: 1, reach: 1}", disc)),
             Contains("'taut' needs a cost with a constant metric, but 'clearance' has none"));
  CHECK_THAT(
      errors_of(plan("{type: se2, lower: [-3, -3], upper: [3, 3]}", "{type: weighted_length, weights: [1, 1]}", disc)),
      Contains("'taut' works in the plane and in space"));
  CHECK_THAT(errors_of("manifold: " + plane +
                       "\ncost: euclidean\npath: {ring: true, points: 20}\npost_process: [taut]\n"
                       "initializer: {type: waypoints, points: [[0, 2], [2, 0], [0, -2]]}\nobstacles: " +
                       disc + "\n"),
             Contains("'taut' joins two ends, but a ring has none"));
}

TEST_CASE("config errors: ends") {
  const auto source = [](const std::string& end) {
    return errors_of("manifold: {type: mesh, file: m.obj}\ncost: euclidean\nends: {source: " + end +
                     ", target: {vertex: 1}}\n");
  };
  CHECK(source("{vertex: 0}") == "");
  CHECK(source("{face: 0, barycentric: [0.2, 0.3, 0.5]}") == "");
  CHECK(source("{point: [0, 0, 0], tolerance: 1}") == "");
  CHECK_THAT(source("{vertex: -3}"), Contains("'vertex' in ends.source must be at least 0 (found '-3')"));
  CHECK_THAT(source("{face: 0}"), Contains("must have both face and barycentric"));
  CHECK_THAT(source("{barycentric: [1, 0, 0]}"), Contains("must have both face and barycentric"));
  CHECK_THAT(source("{face: 0, barycentric: [1, 0]}"), Contains("must have three numbers"));
  CHECK_THAT(source("{vertex: 0, point: [0, 0, 0]}"), Contains("must have exactly one of"));
  CHECK_THAT(source("{}"), Contains("must have exactly one of"));
  CHECK_THAT(source("{vertex: 0, tolerance: 1}"), Contains("is only for an end given as a point"));
  CHECK_THAT(source("3"), Contains("'ends.source' must be a block of keys (found '3')"));
}

TEST_CASE("config errors: names that become folders") {
  const auto name = [](const std::string& value) { return errors_of(kPlane + "name: " + value + "\n"); };
  CHECK(name("a run of 2024") == "");
  CHECK(name("2024") == "");
  for (const char* bad : {"../up", "a/b", ".hidden", "\"\"", "\"a\\nb\""}) {
    CAPTURE(bad);
    CHECK_THAT(name(bad), Contains("a.yaml:6:7: error: 'name'"));
  }
}

TEST_CASE("config errors: notes mean nothing, but x-expect-exit is an exit code") {
  CHECK(errors_of(kPlane + "x-anything: [1, {a: b}]\nx-expect-exit: 5\n") == "");
  CHECK(errors_of("manifold: {type: euclidean, x-why: because}\n" + kPlane.substr(kPlane.find('\n') + 1)) == "");
  CHECK_THAT(errors_of(kPlane + "x-expect-exit: 9\n"), Contains("must be an exit code of a run"));
  CHECK(errors_of(kPlane + "x-expect-exit: 8\n") == "");
}

TEST_CASE("config errors: auto is the same word in quotes, a number is not") {
  const std::string plain = errors_of(kPlane + "path: {points: auto}\n");
  CHECK_THAT(plain, Contains("'auto' takes the number of points"));
  std::string quoted = errors_of(kPlane + "path: {points: 'auto'}\n");
  CHECK_THAT(quoted, Contains("'auto' takes the number of points"));
  CHECK_THAT(errors_of(kPlane + "path: {points: '64'}\n"), Contains("must be a whole number or auto"));
}

TEST_CASE("config errors: source lines are shown safely") {
  const std::string text = kPlane + "k\xc3\xb6rper: {a: \x1b[31m}\n";
  CHECK_THAT(errors_of(text), Contains("unknown key 'k\xc3\xb6rper'") || Contains("YAML"));
  CHECK(errors_of(text).find('\x1b') == std::string::npos);
  const std::string wide = errors_of(kPlane + "name: [" + std::string(5000, ' ') + "1]\nzzz: 1\n");
  for (std::size_t at = 0; at < wide.size(); at = std::min(wide.find('\n', at), wide.size() - 1) + 1)
    CHECK(wide.find('\n', at) - at < 250);
}

TEST_CASE("config errors: a fault of a raster is told once, with the value that may mean no data") {
  const ScratchDir dir;
  std::ofstream(dir / "a.csv") << "1,1,1,1\n1,-9999,1,1\n1,1,1,1\n1,1,1,1\n";
  std::ofstream(dir / "a.yaml") << "manifold: euclidean\ncost: {type: cost_map, file: a.csv}\n"
                                   "ends: {source: {point: [0.5, 0.5]}, target: {point: [3, 3]}}\n";
  const Called called = call({"run", (dir / "a.yaml").string(), "-o", (dir / "out").string()});
  CHECK(called.exit == 3);
  CHECK_THAT(called.err, Contains("nodata: -9999"));
  CHECK_THAT(called.err, Contains("1 error in "));
  CHECK(call({"run", (dir / "a.yaml").string(), "--set", "cost.nodata=-9999", "-o", (dir / "out").string()}).exit == 0);
}

TEST_CASE("config errors: what an option of the command line put into a block is named for the block's faults") {
  ScratchDir folder;
  const std::string plan = text_file(folder / "plan.yaml",
                                     "manifold: {type: euclidean, dimension: 2}\nobstacles:\n"
                                     "  - {type: ball, center: [0.3, 0.05], radius: 0.1}\nclearance: 0.02\n"
                                     "cost: euclidean\nends: {source: {point: [0, 0]}, target: {point: [1, 0]}}\n");
  const auto said = [&](const std::string& option) { return call({"validate", plan, "--set", option}).err; };
  CHECK_THAT(said("obstacles.0.center=[1]"),
             Contains("--set obstacles.0.center=[1]: error: 'obstacles[0]': the ball at (1) has 1 dimension, but the "
                      "domain has 2"));
  CHECK_THAT(said("manifold=mesh"), Contains("--set manifold=mesh: error: missing key 'file' in manifold"));
  CHECK_THAT(said("ends.source.point=[0.3, 0.05]"),
             Contains("--set ends.source.point=[0.3, 0.05]: error: 'source' in"));
  CHECK_THAT(said("obstacles[0].radius=-1"), Contains("'radius' in obstacles[0] must be greater than 0"));
  CHECK_THAT(said("path.pints=3"), Contains("--set path.pints=3: error: unknown key 'pints' in path"));
  CHECK_THAT(
      call({"validate", text_file(folder / "none.yaml", "manifold: {type: euclidean, dimension: 2}\n"), "--set",
            "path.points=3"})
          .err,
      Contains("none.yaml:1:1: error: missing key 'cost'") || Contains("none.yaml:1:1: error: missing key 'ends'"));
}

TEST_CASE("config errors: a formula without a value is said to have none") {
  const auto said = [](const std::string& cost) {
    ScratchDir folder;
    return call({"run",
                 text_file(folder / "a.yaml",
                           "manifold: {type: euclidean, dimension: 2, lower: [0, 0], upper: [10, 10]}\ncost: " + cost +
                               "\nends: {source: {point: [1, 1]}, target: {point: [9, 2]}}\npath: {points: 20}\n"),
                 "-o", (folder / "out").string()})
        .err;
  };
  for (const char* cost : {"{type: formula, lagrangian: \"sqrt(vx^2 + vy^2) * (1 + log(x - 5))\"}",
                           "{type: refractive_index, index: {type: formula, n: \"1 + log(x - 5)\"}}",
                           "{type: scaled, by: \"log(x - 5)\", cost: euclidean}"}) {
    const std::string message = said(cost);
    INFO(message);
    CHECK_THAT(message, Contains("has no value") && Contains("at "));
    CHECK_THAT(message, !Contains("nan") && !Contains("is not positive"));
  }
}

TEST_CASE("config errors: an arm of other joints than the default masses are of is told whose they are") {
  const std::string text =
      "manifold: {type: euclidean, dimension: 4}\ncost: kinetic_energy\n"
      "ends: {source: {point: [0, 0, 0, 0]}, target: {point: [1, 1, 1, 1]}}\n";
  ScratchDir folder;
  CHECK_THAT(call({"run", text_file(folder / "a.yaml", text), "-o", (folder / "out").string()}).err,
             Contains("has 7 joints, but points of the domain have 4 coordinates: it is 'panda'"));
}

}  // namespace leastcost::test
