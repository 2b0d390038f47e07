// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// The Earth in configurations: degrees, latitude first; path.geojson, longitude first; degrees on a chart in radians.
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>

#include <leastcost/catalogue/output/write_run.hpp>
#include <leastcost/catalogue/run/load_run.hpp>
#include <leastcost/catalogue/run/solve.hpp>
#include <leastcost/framework/problem/clearance.hpp>
#include "catalogue/output/geojson.hpp"
#include "catalogue/output/unit_of_cost.hpp"
#include "tests/app/config_text.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/data.hpp"
#include "tests/support/shell.hpp"

namespace leastcost::test {
namespace {

using Catch::Contains;
using Json = nlohmann::json;
using LonLat = Eigen::Vector2d;

std::string on_earth(const std::string& source, const std::string& target) {
  return "manifold: earth\ncost: euclidean\nends:\n  source: {point: " + source + "}\n  target: {point: " + target +
         "}\npath: {points: 20}\n";
}

std::string on_sphere(const std::string& source, const std::string& target) {
  return "manifold: {type: parametric, surface: sphere}\ncost: euclidean\nends:\n  source: {point: " + source +
         "}\n  target: {point: " + target + "}\npath: {points: 10}\n";
}

Json written_geojson(const std::string& config, const std::filesystem::path& folder) {
  const RunOutcome run = solve(parse_run(config, "a.yaml"));
  write_run(run, folder);
  return Json::parse(content(folder / "path.geojson"));
}

}  // namespace

TEST_CASE("GeoJSON: the path across the antimeridian is cut there, longitude first, points in order") {
  const ScratchDir dir;
  const Json json = written_geojson(on_earth("[60, 170]", "[50, -150]"), dir / "out");
  CHECK(json["type"] == "FeatureCollection");
  const Json& path = json["features"][0];
  CHECK(path["properties"]["status"] == "certified");
  CHECK(path["geometry"]["type"] == "MultiLineString");
  const Json& lines = path["geometry"]["coordinates"];
  REQUIRE(lines.size() == 2);
  CHECK(lines[0][0] == Json({170.0, 60.0}));
  CHECK(lines[0].back()[0] == 180.0);
  CHECK(lines[1][0][0] == -180.0);
  CHECK(lines[0].back()[1] == lines[1][0][1]);
  CHECK(lines[1].back() == Json({-150.0, 50.0}));
  CHECK(json["features"].size() == 1);
  const Json points = Json::parse(content(dir / "out/path_points.geojson"))["features"];
  REQUIRE(points.size() == 22);
  CHECK(points[21]["geometry"]["coordinates"] == Json({-150.0, 50.0}));
  CHECK(points[21]["properties"]["cumulative_cost"].get<double>() ==
        Approx(path["properties"]["cost"].get<double>()).epsilon(1e-4));
}

TEST_CASE("GeoJSON: a line is cut at seams and poles, and only there") {
  const auto lines = [](const std::vector<LonLat>& cover) { return geographic_lines(cover); };
  CHECK(lines({{10, 20}, {30, 40}, {50, 60}}).size() == 1);
  // Twice around the axis and on.
  const auto turns = lines({{100, 0}, {900, 10}});
  REQUIRE(turns.size() == 3);
  CHECK(turns[1].front() == LonLat(-180, 1));
  CHECK(turns[1].back() == LonLat(180, 5.5));
  CHECK(turns[2].back() == LonLat(180, 10));
  // Over the north pole: down the meridian opposite.
  const auto over = lines({{20, 80}, {20, 100}});
  REQUIRE(over.size() == 2);
  CHECK(over[0].back() == LonLat(20, 90));
  CHECK(over[1].front() == LonLat(-160, 90));
  CHECK(over[1].back() == LonLat(-160, 80));
  // A point that lies on the seam cuts nothing twice.
  const auto at = lines({{170, 0}, {180, 1}, {190, 2}});
  REQUIRE(at.size() == 2);
  CHECK(at[0].back() == LonLat(180, 1));
  CHECK(at[1].front() == LonLat(-180, 1));
  CHECK(at[1].back() == LonLat(-170, 2));
  for (const auto& all : {turns, over, at})
    for (const GeographicLine& line : all)
      for (const LonLat& place : line) CHECK((std::abs(place[0]) <= 180 && std::abs(place[1]) <= 90));
}

TEST_CASE("GeoJSON opens in ogrinfo") {
  if (!has_program("ogrinfo", "gdal-bin")) return;
  const ScratchDir dir;
  written_geojson(on_earth("[60, 170]", "[50, -150]"), dir / "out");
  const std::string out = output_of("ogrinfo -al -q '" + (dir / "out/path.geojson").string() + "' 2>&1");
  CHECK_THAT(out, Contains("MULTILINESTRING ((170 60,"));
  CHECK_THAT(out, Contains("status (String) = certified"));
  const std::string points = output_of("ogrinfo -al '" + (dir / "out/path_points.geojson").string() + "' 2>&1");
  CHECK_THAT(points, Contains("index (Integer) = 21") && Contains("Geometry: Point"));
}

TEST_CASE("GeoJSON is written on the Earth alone, and can be left out") {
  const ScratchDir dir;
  write_run(solve(parse_run(kPlane, "a.yaml")), dir / "plane");
  CHECK_FALSE(std::filesystem::exists(dir / "plane/path.geojson"));
  write_run(solve(parse_run(on_earth("[60, 170]", "[50, -150]") + "output: {files: [path]}\n", "a.yaml")),
            dir / "some");
  CHECK_FALSE(std::filesystem::exists(dir / "some/path.geojson"));
}

TEST_CASE("degrees: a latitude beyond a pole is an error on the Earth, and met with a word on charts in radians") {
  CHECK_THAT(errors_of(on_earth("[-0.1, 51.5]", "[139.7, 35.7]")),
             Contains("'point' in ends.target") && Contains("the latitude 139.7 is beyond 90 degrees") &&
                 Contains("(latitude, longitude)"));
  CHECK_THAT(errors_of(on_sphere("[-0.1, 51.5]", "[139.7, 35.7]")),
             Contains("for degrees, use manifold: {type: earth}"));
  CHECK(errors_of(on_sphere("[-0.1, 0.5]", "[1, 3]")) == "");
  const Run run = parse_run(on_sphere("[-0.1, 0.5]", "[1, 3]"), "a.yaml");
  bool said = false;
  for (const std::string& note : run.parts.notes)
    said = said || note.find("the latitude 3 of the target is beyond pi/2") != std::string::npos;
  CHECK(said);
  CHECK(parse_run(on_sphere("[-0.1, 0.5]", "[1, 1.5]"), "a.yaml").parts.notes.empty());
}

TEST_CASE("the Earth: longitudes of both conventions, across the date line, round the axis by waypoints") {
  const auto end_of = [](const std::string& config) { return solve(parse_run(config, "a.yaml")); };
  for (const char* target : {"[37.6, -122.4]", "[37.6, 237.6]", "[37.6, 597.6]"}) {
    const RunOutcome run = end_of(on_earth("[35.7, 139.7]", target));
    CAPTURE(target);
    CHECK(run.result.status == Status::certified);
    CHECK(run.result.certificate.estimate.value == Approx(8300363.7509).epsilon(1e-8));
    CHECK(run.parts.notes.empty());
  }
  const RunOutcome round = end_of(on_earth("[10, 0]", "[10, 20]") +
                                  "initializer: {type: waypoints, points: [[0, 120], [0, -120]]}\n"
                                  "certificate: {enabled: false}\n");
  CHECK(round.parts.problem.target.u[1] == 380);
  CHECK_THAT(errors_of(on_earth("[10, 0]", "[10, 360]")), Contains("is the same point as the source"));
}

TEST_CASE("the Earth: a current to the east and north, by the flow that the refusal names") {
  const std::string ends =
      "ends: {source: {point: [-17.8, 177.4]}, target: {point: [-13.8, -171.8]}}\npath: {points: 20}\n";
  const auto current = [&](const std::string& flow) {
    return "manifold: earth\ncost: {type: zermelo, speed: 5, " + flow + "}\n" + ends;
  };
  const std::string refused = errors_of(current("flow: {type: uniform, velocity: [0.5, 0.1]}"));
  const std::size_t begin = refused.find("flow: {type: east_north"), end = refused.find('}', begin);
  REQUIRE(end != std::string::npos);
  const RunOutcome run = solve(parse_run(current(refused.substr(begin, end + 1 - begin)), "a.yaml"));
  CHECK(run.result.status == Status::certified);
  // Against formulas of the unit vectors on a sphere, north off by 0.2 degrees at most.
  CHECK(run.result.certificate.estimate.value == Approx(225101.6).epsilon(1e-4));
  // With the current alone, due east along the equator, time is length / (5 + 1).
  const RunOutcome east =
      solve(parse_run("manifold: earth\ncost: {type: zermelo, speed: 5, flow: {type: east_north, velocity: [1, 0]}}\n"
                      "ends: {source: {point: [0, 0]}, target: {point: [0, 10]}}\npath: {points: 20}\n",
                      "a.yaml"));
  CHECK(east.result.certificate.estimate.value == Approx(6378137 * 10 * std::numbers::pi / 180 / 6).epsilon(1e-8));
  const RunOutcome north =
      solve(parse_run("manifold: earth\ncost: {type: zermelo, speed: 5, flow: {type: east_north, velocity: [0, 1]}}\n"
                      "ends: {source: {point: [40, 10]}, target: {point: [41, 10]}}\npath: {points: 20}\n",
                      "a.yaml"));
  const RunOutcome calm = solve(parse_run(on_earth("[40, 10]", "[41, 10]"), "a.yaml"));
  CHECK(north.result.certificate.estimate.value == Approx(calm.result.certificate.estimate.value / 6).epsilon(1e-8));
}

TEST_CASE("the Earth: land in degrees is refused with the ball in space that holds it, which is one to go round") {
  const auto around = [](const std::string& obstacle) {
    return "manifold: earth\ncost: euclidean\nobstacles: [" + obstacle +
           "]\nclearance: 1000\nends: {source: {point: [-17.8, 177.4]}, target: {point: [-13.8, -171.8]}}\n";
  };
  const std::string refused =
      errors_of(around("{type: polygon, corners: [[-17, 178], [-17, -179], [-15, -179], [-15, 178]]}"));
  const std::size_t begin = refused.find("{type: ball"), end = refused.find('}', begin);
  REQUIRE(end != std::string::npos);
  const Run run = parse_run(around(refused.substr(begin, end + 1 - begin)), "a.yaml");
  const Eigen::Vector2d corner(-17, 178);
  CHECK_FALSE(why_in_clearance(run.parts.problem, PathEnd{corner}).empty());
}

TEST_CASE("the Earth: lengths are metres, on another planet they are lengths") {
  const RunOutcome earth = solve(parse_run(on_earth("[10, 20]", "[11, 21]"), "a.yaml"));
  CHECK(unit_of_cost(earth.parts.problem) == "m");
  std::string planet = on_earth("[10, 20]", "[11, 21]");
  planet.replace(0, planet.find('\n'), "manifold: {type: earth, semi_major_axis: 3396190}");
  CHECK(unit_of_cost(parse_run(planet, "a.yaml").parts.problem) == "length");
}

TEST_CASE("the Earth: a way over a pole is said in words, not by a latitude of 100") {
  for (const char* target : {"[80, 180]", "[90, 180]"}) {
    const RunOutcome run = solve(parse_run(on_earth("[80, 0]", target), "a.yaml"));
    CAPTURE(target);
    CHECK(run.result.status == Status::certified);
    for (const std::string& note : run.parts.notes) CHECK_THAT(note, Contains("the path goes over the north pole"));
    for (const std::string& note : run.result.notes) CHECK_THAT(note, !Contains("the target is also"));
  }
}

TEST_CASE("the Earth: an ellipsoid that is none is refused by name") {
  const std::string ends = "cost: euclidean\nends:\n  source: {point: [0, 0]}\n  target: {point: [1, 1]}\n";
  CHECK_THAT(errors_of("manifold: {type: earth, inverse_flattening: 0.5}\n" + ends), Contains("inverse_flattening"));
  CHECK_THAT(errors_of("manifold: {type: earth, semi_major_axis: 0}\n" + ends), Contains("semi_major_axis"));
  CHECK(errors_of("manifold: {type: earth, inverse_flattening: 0}\n" + ends) == "");
}

}  // namespace leastcost::test
