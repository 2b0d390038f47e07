// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// Rasters as they come, in configurations that say nothing about them: cells without data, and places on the Earth.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include <leastcost/catalogue/output/write_run.hpp>
#include <leastcost/catalogue/run/load_run.hpp>
#include <leastcost/catalogue/run/solve.hpp>
#include <leastcost/framework/base/errors.hpp>
#include <leastcost/problems/drawing/draws_itself.hpp>
#include "tests/support/catch.hpp"
#include "tests/support/data.hpp"

namespace leastcost::test {
namespace {

using Catch::Contains;

constexpr int kBaySide = 16;

/// Cells of 10 from (0, 0), all 1, without data in rows 4 to 11 from the top of columns 0 to 9.
void write_bay(const std::filesystem::path& file, const std::string& nodata, const std::string& corner = "0",
               const std::string& cell = "10") {
  std::ofstream out(file);
  out << "ncols 16\nnrows 16\nxllcorner " << corner << "\nyllcorner " << corner << "\ncellsize " << cell
      << "\nNODATA_value " << nodata << "\n";
  for (int row = 0; row < kBaySide; ++row)
    for (int column = 0; column < kBaySide; ++column)
      out << (row >= 4 && row < 12 && column < 10 ? nodata : "1") << (column + 1 < kBaySide ? " " : "\n");
}

RunOutcome solved_bay(const std::string& config, const std::filesystem::path& folder) {
  return solve(parse_run(config, "a.yaml", folder));
}

std::string refusal_of_run(const std::string& config, const std::filesystem::path& folder) {
  try {
    solved_bay(config, folder);
    return "accepted";
  } catch (const std::exception& error) {
    return error.what();
  }
}

const std::string kBayEnds = "ends: {source: {point: [25, 145]}, target: {point: [25, 15]}}\npath: {points: 64}\n";

bool has_raster_note(const RunOutcome& run, const std::string& text) {
  return std::any_of(run.parts.notes.begin(), run.parts.notes.end(),
                     [&](const std::string& note) { return note.find(text) != std::string::npos; });
}

}  // namespace

TEST_CASE("cells without data are obstacles of terrains and cost maps, without a word about them") {
  const ScratchDir dir;
  for (const char* nodata : {"nan", "-9999"}) {
    write_bay(dir / "bay.asc", nodata);
    for (const char* parts : {"manifold: {type: terrain, file: bay.asc}\ncost: euclidean\n",
                              "manifold: {type: euclidean, dimension: 2}\n"
                              "cost: {type: cost_map, file: bay.asc, interpolation: smooth}\n"}) {
      const RunOutcome run = solved_bay(std::string(parts) + kBayEnds, dir.path());
      INFO(parts);
      CHECK(run.result.status == Status::certified);
      // Round the corners (115, 25) and (115, 135): nearer places need one of the missing values.
      const double length = 2 * std::hypot(90, 10) + 110;
      CHECK(run.result.certificate.estimate.value == Approx(length).epsilon(0.03));
      CHECK(has_raster_note(run, "places without data are obstacles"));
      Drawing drawn;  // a map shows them as what they are, not as outlines of obstacles
      find_ability<DrawsItself>(*run.parts.problem.manifold)->draw({run.result.curve.x, run.result.path.u}, drawn);
      CHECK(drawn.obstacles.empty());
    }
    // Cells as they are: round their corners (100, 40) and (100, 120).
    const RunOutcome cells = solved_bay(
        "manifold: {type: euclidean, dimension: 2}\ncost: {type: cost_map, file: bay.asc}\n" + kBayEnds, dir.path());
    CHECK(cells.result.status == Status::certified);
    CHECK(cells.result.curve.cost == Approx(2 * std::hypot(75, 25) + 80).epsilon(1e-12));
  }
}

TEST_CASE("a .prj in degrees beside a grid makes it one in degrees, with ends in longitude and latitude") {
  const ScratchDir dir;
  write_bay(dir / "bay.asc", "nan", "45", "0.0001");
  std::ofstream(dir / "bay.prj") << R"(GEOGCS["GCS_WGS_1984",DATUM["D_WGS_1984",SPHEROID["WGS_1984",6378137.0,)"
                                    R"(298.257223563]],PRIMEM["Greenwich",0.0],UNIT["Degree",0.0174532925199433]])";
  const std::string ends =
      "ends: {source: {lonlat: [45.0013, 45.0002]}, target: {lonlat: [-314.9987, 45.0014]}}\npath: {points: 20}\n";
  for (const char* parts : {"manifold: {type: terrain, file: bay.asc}\ncost: euclidean\n",
                            "manifold: {type: euclidean, dimension: 2}\ncost: {type: cost_map, file: bay.asc}\n"}) {
    const RunOutcome run = solved_bay(parts + ends, dir.path());
    INFO(parts);
    CHECK(run.result.certificate.estimate.value == Approx(0.0012 * 111131.745).epsilon(1e-3));
    CHECK(has_raster_note(run, "bay.asc is in degrees"));
    CHECK(run.parts.initializer->name() ==
          (run.parts.problem.cost->traits().unit == "cost" ? "cell_graph" : "dijkstra"));
    write_run(run, dir / "out", {.replace = true});
    std::ifstream in(dir / "out/path.geojson");
    const auto line = nlohmann::json::parse(in)["features"][0]["geometry"];
    CHECK(line["type"] == "LineString");
    CHECK(line["coordinates"].back()[0].get<double>() == Approx(45.0013).epsilon(1e-9));
    CHECK(line["coordinates"].back()[1].get<double>() == Approx(45.0014).epsilon(1e-9));
    CHECK(std::filesystem::exists(dir / "out/path_points.geojson"));
  }
}

TEST_CASE("longitude and latitude where nothing is known of the Earth are refused with the options that help") {
  const ScratchDir dir;
  write_bay(dir / "bay.asc", "nan");
  const std::string ends = "ends: {source: {lonlat: [8, 47]}, target: {lonlat: [8, 47.1]}}\n";
  CHECK_THAT(refusal_of_run("manifold: {type: terrain, file: bay.asc}\ncost: euclidean\n" + ends, dir.path()),
             Contains("'lonlat' in ends.source") && Contains("degrees: true") && Contains("GDAL"));
  CHECK(solved_bay("manifold: earth\ncost: euclidean\npath: {points: 10}\n" + ends, dir.path()).result.status ==
        Status::certified);
  CHECK_THAT(refusal_of_run(
                 "manifold: earth\ncost: euclidean\nends: {source: {lonlat: [47, 147]}, target: {lonlat: [8, 47]}}\n",
                 dir.path()),
             Contains("give longitude first"));
}

}  // namespace leastcost::test
