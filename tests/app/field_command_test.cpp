// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// `leastcost field`: its files, its summary, and what it refuses.
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/app/called.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/data.hpp"

namespace leastcost::test {
namespace {

namespace fs = std::filesystem;
using Catch::Contains;
using Json = nlohmann::json;

const char* const kBox = R"(manifold: {type: euclidean, lower: [0, 0], upper: [4, 2]}
cost: euclidean
ends:
  source: {point: [1, 1]}
  target: {point: [3, 1]}
)";

/// A plane with four walls around (1, 1).
std::string closed_room() {
  std::string walls =
      "manifold: {type: euclidean, lower: [0, 0], upper: [4, 2]}\ncost: euclidean\nclearance: 0.01\nobstacles:\n";
  for (const char* corners :
       {"[0.7, 0.7], [1.3, 0.7], [1.3, 0.8], [0.7, 0.8]", "[0.7, 1.2], [1.3, 1.2], [1.3, 1.3], [0.7, 1.3]",
        "[0.7, 0.7], [0.8, 0.7], [0.8, 1.3], [0.7, 1.3]", "[1.2, 0.7], [1.3, 0.7], [1.3, 1.3], [1.2, 1.3]"})
    walls += std::string("  - {type: polygon, corners: [") + corners + "]}\n";
  return walls;
}

}  // namespace

TEST_CASE("field command: the same values as CSV, NPY and ASC") {
  const ScratchDir dir;
  const std::string config = text_file(dir / "box.yaml", kBox);
  const auto field = [&](const std::string& file) {
    return call({"field", config, "--resolution", "0.5", "-o", (dir / file).string()});
  };
  const Called csv = field("f.csv");
  CHECK(csv.exit == 0);
  CHECK_THAT(csv.out, Contains("9 x 5 nodes, 45 reached, the largest value 3.16") && Contains("error  about"));
  CHECK_THAT(content(dir / "f.csv"), Contains("x,y,cost\n0,0,1.41421356") && Contains("\n1,1,0\n"));
  CHECK(field("f.npy").exit == 0);
  const std::string npy = content(dir / "f.npy");
  REQUIRE(npy.size() == 128 + 8 * 45);
  CHECK(npy.substr(0, 6) == "\x93NUMPY");
  CHECK_THAT(npy.substr(0, 128), Contains("'<f8', 'fortran_order': False, 'shape': (5, 9), }") && Contains("\n"));
  if constexpr (std::endian::native == std::endian::little) {
    double first = 0, third = 0;
    std::memcpy(&first, npy.data() + 128, 8);
    std::memcpy(&third, npy.data() + 128 + 8 * (2 * 9 + 2), 8);
    CHECK(first == Approx(std::sqrt(2.0)).epsilon(1e-6));
    CHECK(third == 0);
  }
  CHECK(field("f.asc").exit == 0);
  CHECK_THAT(content(dir / "f.asc"), Contains("ncols 9\nnrows 5\nxllcorner -0.25\nyllcorner -0.25\ncellsize 0.5\n"));
  CHECK_THAT(field("f.txt").err, Contains(".csv, .npy, .asc or .tif"));
  CHECK(field("none/f.csv").exit == 8);
}

TEST_CASE("field command: several places, ways, corridors and the summary") {
  const ScratchDir dir;
  const std::string config = text_file(dir / "box.yaml", kBox), out = (dir / "f.csv").string();
  const Called two = call({"field", config, "--resolution", "0.5", "-o", out, "--from", "0,0", "--from", "4,2"});
  CHECK(two.exit == 0);
  CHECK_THAT(content(out), Contains("\n0,0,0\n") && Contains("\n4,2,0\n"));
  const std::string list = text_file(dir / "places.txt", "0,0\r\n4,2\n\n");
  const std::string before = content(out);
  CHECK(call({"field", config, "--resolution", "0.5", "-o", out, "--from", list}).exit == 0);
  CHECK(content(out) == before);
  const std::string sheet = text_file(dir / "sheet.txt",
                                      "\xEF\xBB\xBF"
                                      "0,0\r\n4,2\r\n");
  CHECK(call({"field", config, "--resolution", "0.5", "-o", out, "--from", sheet}).exit == 0);
  CHECK(content(out) == before);

  const std::string way = (dir / "way.csv").string();
  const Called back =
      call({"field", config, "--resolution", "0.1", "-o", out, "--to", "4,2", "--way", way, "--format", "json"});
  CHECK(back.exit == 0);
  const Json summary = Json::parse(back.out);
  CHECK(summary["method"] == "isotropic march");
  CHECK(summary["directed"] == false);
  CHECK(summary["from"] == Json::parse("[[1.0, 1.0]]"));
  CHECK(summary["columns"] == 41);
  CHECK(summary["error"]["kind"] == "estimate");
  CHECK(summary["error"]["largest"] < 1e-3);
  CHECK(summary["ways"][0]["cost"].get<double>() == Approx(std::sqrt(10.0)).epsilon(1e-4));
  CHECK_THAT(content(way), Contains("way,x,y\n0,1,1\n") && Contains("\n0,4,2\n"));

  const Called corridor = call({"field", config, "--resolution", "0.5", "-o", out, "--corridor"});
  CHECK(corridor.exit == 0);
  CHECK_THAT(content(out), Contains("\n0,1,2\n"));  // one to go there, three to come back, less the two between
  CHECK(call({"field", config, "--resolution", "0.5", "-o", out, "--corridor", "--to", "1,2"}).exit == 0);
  CHECK_THAT(content(out), Contains("\n1,2,0\n") && Contains("\n1,0,2\n"));  // not to the configuration's own target
}

TEST_CASE("field command: a wind in space") {
  const ScratchDir dir;
  const std::string config =
      text_file(dir / "wind.yaml", R"(manifold: {type: euclidean, lower: [0, 0, 0], upper: [4, 2, 2]}
cost: {type: zermelo, speed: 1, flow: {type: uniform, velocity: [0.5, 0, 0]}}
)");
  const auto field = [&](const std::vector<std::string>& more) {
    std::vector<std::string> words = {"field", config, "--from", "1,1,1", "--to", "3,1,1", "--resolution", "0.25"};
    words.insert(words.end(), more.begin(), more.end());
    return call(words);
  };
  const Called there = field({"-o", (dir / "f.vti").string(), "--format", "json"});
  REQUIRE(there.exit == 0);
  const Json out = Json::parse(there.out);
  CHECK(out["method"] == "arrival field");
  CHECK(out["directed"] == true);
  CHECK(out["ways"][0]["cost"] == Approx(2 / 1.5));
  const Called back = field({"-o", (dir / "f.npy").string(), "--to-here"});
  CHECK(back.exit == 0);
  CHECK_THAT(back.out, Contains("17 x 9 x 9 nodes") && Contains("these are costs of reaching the place"));
}

TEST_CASE("field command: ways over a pole, to places by any of their names, in metres") {
  const ScratchDir dir;
  const std::string earth = text_file(dir / "earth.yaml", "manifold: {type: earth}\ncost: euclidean\n");
  const auto field = [&](const std::vector<std::string>& more) {
    std::vector<std::string> all = {"field", earth, "-o", (dir / "f.csv").string(), "--format", "json"};
    all.insert(all.end(), more.begin(), more.end());
    return call(all);
  };
  // Half a meridian is 20003931 m.
  const Called over = field({"--from", "60,0", "--to", "60,180"});
  REQUIRE(over.exit == 0);
  const Json summary = Json::parse(over.out);
  CHECK(summary["ways"][0]["cost"].get<double>() == Approx(6.695e6).epsilon(0.006));
  CHECK(field({"--from", "0,0", "--to", "0,180", "--to-here"}).exit == 0);
  const Called one = field({"--from", "51.5,-0.1"});
  REQUIRE(one.exit == 0);
  CHECK(Json::parse(one.out)["unit"] == "m");
}

TEST_CASE("field command: the error of a narrow box is estimated too") {
  const ScratchDir dir;
  const std::string config =
      text_file(dir / "narrow.yaml", "manifold: {type: euclidean, lower: [0, 0], upper: [400, 1]}\ncost: euclidean\n");
  const Called called = call({"field", config, "-o", (dir / "f.csv").string(), "--from", "1,0.5"});
  CHECK(called.exit == 0);
  CHECK_THAT(called.out, Contains("201 x 5 nodes") || Contains("1601 x 5 nodes"));
  CHECK_THAT(called.out, Contains("error  about"));
}

TEST_CASE("field and run: a terrain with heights in millimetres is refused in one sentence") {
  const ScratchDir dir;
  std::string grid = "ncols 12\nnrows 12\nxllcorner 0\nyllcorner 0\ncellsize 30\n";
  for (int i = 0; i < 144; ++i) grid += std::to_string(400000 + 400 * ((i * i) % 37)) + (i % 12 == 11 ? "\n" : " ");
  text_file(dir / "dem.asc", grid);
  const std::string config = text_file(dir / "dem.yaml",
                                       "manifold: {type: terrain, file: dem.asc}\ncost: walking\n"
                                       "ends: {source: {point: [100, 100]}, target: {point: [250, 250]}}\n");
  for (const std::string command : {"field", "run"}) {
    const Called called = call({command, config, "-o", (dir / "out.csv").string()});
    CHECK(called.exit == 3);
    CHECK_THAT(called.err, Contains("are heights in metres, as cells are? Set value_scale"));
  }
}

TEST_CASE("field command: fields are refused by their dimension before their places are read") {
  const ScratchDir dir;
  const std::string line = text_file(dir / "line.yaml", "manifold: {type: euclidean, lower: [0], upper: [4]}\n"),
                    four = text_file(dir / "four.yaml", "manifold: {type: euclidean, dimension: 4}\n");
  for (const char* place : {"1", "1,2", "1,2,3", "1,2,3,4"}) {
    const Called one = call({"field", line, "-o", (dir / "f.csv").string(), "--from", place});
    CHECK(one.exit == 4);
    CHECK_THAT(one.err,
               Contains("field: there are none in one coordinate: only in two and in three coordinates, and on "
                        "a mesh"));
    CHECK_THAT(call({"field", four, "-o", (dir / "f.csv").string(), "--from", place}).err,
               Contains("field: there are none in 4 coordinates"));
  }
}

TEST_CASE("field command: costs that are not positive are named, and errors above every value") {
  const ScratchDir dir;
  const std::string out = (dir / "f.csv").string();
  const auto field = [&](const std::string& n, const std::string& resolution) {
    const std::string config = text_file(dir / "n.yaml",
                                         "manifold: {type: euclidean, lower: [0, 0], upper: [4, 2]}\ncost: {type: "
                                         "refractive_index, index: {type: formula, n: \"" +
                                             n + "\"}}\n");
    return call({"field", config, "-o", out, "--from", "1,1", "--resolution", resolution});
  };
  const Called negative = field("x - 5", "0.1");
  CHECK(negative.exit == 4);
  CHECK_THAT(negative.err, Contains("at (1, 1) the formula of n is not positive: n = -4") && !Contains("obstacles"));
  CHECK_THAT(field("3 - x", "0.1").out,
             Contains("note: nodes without a cost are left out: at (") && Contains("is not positive: n = -"));
}

TEST_CASE("field command: costs of 0 and negative ones in every direction and places without a way out are told") {
  const ScratchDir dir;
  const std::string out = (dir / "f.csv").string();
  const auto field = [&](const std::string& cost, std::vector<std::string> more = {}) {
    const std::string config =
        text_file(dir / "n.yaml", "manifold: {type: euclidean, lower: [0, 0], upper: [4, 2]}\ncost: {" + cost + "}\n");
    std::vector<std::string> all = {"field", config, "-o", out, "--from", "1,1", "--resolution", "0.1"};
    all.insert(all.end(), more.begin(), more.end());
    return call(all);
  };
  const Called free = field("type: refractive_index, index: {type: formula, n: \"max(0, x - 2)\"}");
  CHECK(free.exit == 0);
  CHECK_THAT(free.out,
             Contains("note: a unit of length costs 0 at ") && Contains(" of 861 nodes, the first is (0, 0)"));
  const Called negative = field("type: formula, lagrangian: \"-sqrt(vx^2 + vy^2)\"", {"--to", "3,1"});
  CHECK(negative.exit == 4);
  CHECK_THAT(negative.err, Contains("no path leaves the place (1, 1)") && Contains("F = -1"));
  const std::string room = text_file(dir / "room.yaml", closed_room());
  const Called enclosed = call({"field", room, "-o", out, "--from", "1,1", "--resolution", "0.05"});
  CHECK_THAT(enclosed.out, Contains("note: no path leads farther than 5 steps from the place: obstacles"));
  const Called strip = call({"field", room, "-o", (dir / "f.asc").string(), "--from", "3,1", "--resolution", "0.3"});
  CHECK_THAT(strip.out, Contains("a strip at its upper edges has no nodes, 0.1 wide along x and 0.2 along y"));
}

TEST_CASE("field command: a field that cannot be relied on is written with a note and the exit code 5") {
  const ScratchDir dir;
  const std::string out = (dir / "f.csv").string();
  // Half as many nodes see nothing of the cheap rows between them.
  const std::string medium = text_file(
      dir / "n.yaml",
      "manifold: {type: euclidean, lower: [0, 0], upper: [4, 0.4]}\ncost: {type: refractive_index, index: {type: "
      "formula, n: \"1 + 1e4 * cos(3.14159265358979 * y / 0.2)^2\"}}\n");
  const std::vector<std::string> words = {"field", medium,         "-o",  out,        "--from",
                                          "0,0.1", "--resolution", "0.1", "--format", "json"};
  const Called coarse = call(words);
  REQUIRE(fs::exists(out));
  const Json summary = Json::parse(coarse.out);
  REQUIRE(summary["error"]["largest"].get<double>() > summary["largest"].get<double>());
  CHECK(coarse.exit == 5);
  CHECK_THAT(summary["notes"].dump(), Contains("the error may be larger than every value: use a smaller --resolution"));

  const std::string room = text_file(dir / "room.yaml", closed_room());
  const Called enclosed = call({"field", room, "-o", out, "--from", "1,1", "--resolution", "0.05"});
  CHECK(enclosed.exit == 5);
  CHECK_THAT(enclosed.out, Contains("note: no path leads farther than 5 steps from the place"));
  // No node is farther than five steps from the place, and those beside it are outside of the room.
  const Called small =
      call({"field", room, "-o", out, "--from", "1,1", "--resolution", "0.5", "--set", "manifold.upper=[2, 2]"});
  CHECK(small.exit == 5);
  CHECK_THAT(small.out, Contains("1 reached") && Contains("note: no path leads farther"));
  const std::string none = (dir / "none.csv").string();
  const Called beyond = call({"field", room, "-o", none, "--from", "1,1", "--to", "3,1", "--resolution", "0.05"});
  CHECK(beyond.exit == 6);
  CHECK_THAT(beyond.err, Contains("error: --to 3,1: field: no path leads to the place (3, 1)"));
  CHECK_FALSE(fs::exists(none));
  const Called corridor = call({"field", room, "-o", none, "--from", "1,1", "--to", "3,1", "--corridor", "--resolution",
                                "0.05", "--format", "json"});
  CHECK(corridor.exit == 6);
  CHECK(Json::parse(corridor.out)["status"] == "no_path");
}

TEST_CASE("field command: a result never replaces a file that is read") {
  const ScratchDir dir;
  std::string grid = "ncols 8\nnrows 8\nxllcorner 0\nyllcorner 0\ncellsize 1\n";
  for (int i = 0; i < 64; ++i) grid += i % 8 == 7 ? "1\n" : "1 ";
  const std::string map = text_file(dir / "map.asc", grid), places = text_file(dir / "places.csv", "2,2\n");
  const std::string config = text_file(dir / "c.yaml", "manifold: euclidean\ncost: {type: cost_map, file: map.asc}\n");
  const Called called = call({"field", config, "--from", "1,1", "-o", map});
  CHECK(called.exit == 4);
  CHECK_THAT(called.err, Contains("--output " + map + " would replace a file that is read: name another file"));
  CHECK_THAT(
      call({"field", config, "--from", "1,1", "--to", places, "-o", (dir / "f.asc").string(), "--way", places}).err,
      Contains("--way " + places + " would replace a file that is read"));
  CHECK(content(dir / "map.asc") == grid);
  CHECK(content(dir / "places.csv") == "2,2\n");
}

TEST_CASE("field command: a place in the outer half of a border cell has a value and no note") {
  const ScratchDir dir;
  std::string grid = "ncols 40\nnrows 40\nxllcorner 0\nyllcorner 0\ncellsize 1\n";
  for (int i = 0; i < 1600; ++i) grid += i % 40 == 39 ? "1\n" : "1 ";
  text_file(dir / "one.asc", grid);
  const std::string config = text_file(dir / "one.yaml",
                                       "manifold: {type: euclidean, lower: [0, 0], upper: [40, 40]}\ncost: {type: "
                                       "cost_map, file: one.asc, interpolation: cells}\n");
  for (const bool back : {false, true}) {
    std::vector<std::string> words = {"field",    config,      "-o",   (dir / "f.npy").string(),
                                      "--from",   "10,10",     "--to", "0.02,2",
                                      "--to",     "39.9,39.9", "--to", "20,39.6",
                                      "--format", "json"};
    if (back) words.push_back("--to-here");
    const Called called = call(words);
    REQUIRE(called.exit == 0);
    const Json summary = Json::parse(called.out);
    CHECK(summary["notes"].empty());
    for (const Json& way : summary["ways"])
      CHECK(way["value"].get<double>() == Approx(way["cost"].get<double>()).epsilon(0.01));
  }
  const std::string bilinear = text_file(dir / "bilinear.yaml",
                                         "manifold: {type: euclidean, lower: [0, 0], upper: [40, 40]}\ncost: {type: "
                                         "cost_map, file: one.asc, interpolation: bilinear}\n");
  CHECK_THAT(call({"field", bilinear, "-o", (dir / "f.npy").string(), "--from", "10,10", "--to", "0.02,2"}).err,
             Contains("(0.02, 2) is outside the values of ") && Contains("which extend from (0.5, 0.5)"));
}

TEST_CASE("field and run: a value that was taken as no data is told where there is no path") {
  const ScratchDir dir;
  std::string grid = "ncols 12\nnrows 12\nxllcorner 0\nyllcorner 0\ncellsize 1\n";
  for (int i = 0; i < 144; ++i) grid += std::string(i % 12 == 6 ? "-99" : "2") + (i % 12 == 11 ? "\n" : " ");
  text_file(dir / "wall.asc", grid);
  const std::string config = text_file(dir / "wall.yaml",
                                       "manifold: {type: euclidean, lower: [0, 0], upper: [12, 12]}\nends: {source: "
                                       "{point: [2, 2]}, target: {point: [10, 10]}}\ncost: {type: cost_map, file: "
                                       "wall.asc}\n");
  const std::string terrain = text_file(dir / "terrain.yaml",
                                        "manifold: {type: terrain, file: wall.asc}\nends: {source: {point: [2, 2]}, "
                                        "target: {point: [10, 10]}}\ncost: euclidean\n");
  const std::string out = (dir / "out").string(), file = (dir / "f.csv").string();
  const std::vector<std::pair<int, std::vector<std::string>>> failing = {
      {6, {"run", config, "-o", out}},
      {6, {"run", config, "-o", out, "--format", "json"}},
      {4, {"run", config, "-o", out, "--set", "ends.source.point=[6.5, 3]"}},
      {3, {"run", config, "-o", out, "--set", "ends.source.point=[6.5, 3]", "--set", "cost.interpolation=smooth"}},
      {3, {"run", terrain, "-o", out, "--set", "ends.source.point=[6.5, 3]"}},
      {6, {"field", config, "-o", file, "--to", "10,10"}},
      {6, {"field", config, "-o", file, "--corridor"}},
      {4, {"field", config, "-o", file, "--from", "6.5,3"}}};
  for (const auto& [exit, words] : failing) {
    const Called called = call(words);
    INFO(called.err);
    CHECK(called.exit == exit);
    CHECK_THAT(called.err + called.out, Contains("note: the value -99 was taken as \"no data\": 12 of 144 cells") ||
                                            Contains("note: the value -99 was taken as \\\"no data\\\""));
    CHECK_FALSE(fs::exists(file));
  }
  const std::string pairs = text_file(dir / "pairs.csv", "source_x,source_y,target_x,target_y\n2,2,10,10\n");
  const Called many = call({"run", config, "-o", (dir / "many").string(), "--pairs", pairs});
  CHECK(many.exit == 7);
  CHECK_THAT(many.out, Contains("note        the value -99 was taken as \"no data\""));
}

TEST_CASE("field command: a fault is said of the place that has it, and columns have the names of coordinates") {
  const ScratchDir dir;
  const std::string config = text_file(dir / "box.yaml", kBox), out = (dir / "f.csv").string();
  const Called far = call({"field", config, "-o", out, "--from", "1,1", "--from", "2,9"});
  CHECK_THAT(far.err, Contains("--from 2,9 must have y between 0 and 2 (found 9): move the point\n"));
  const std::string open = text_file(dir / "open.yaml", "manifold: {type: euclidean, lower: [0, 0], upper: [4, 2]}\n");
  CHECK_THAT(call({"field", open, "-o", out, "--from", "1,1", "--to", "9,1"}).err, Contains("--to 9,1 must have x"));
  const std::string body =
      text_file(dir / "body.yaml", R"(manifold: {type: euclidean, lower: [0, 0, 0], upper: [4, 4, 2]}
robot: {type: rigid_body, shape: [[-0.5, 0, 0.5, 0, 0.1]]}
obstacles: [{type: ball, center: [2, 2], radius: 0.5}]
)");
  const std::string way = (dir / "w.csv").string();
  const Called called =
      call({"field", body, "-o", out, "--from", "1,1,1", "--to", "3,1,1", "--way", way, "--resolution", "0.5"});
  CHECK(called.err == "");
  CHECK_THAT(content(out), Catch::StartsWith("x,y,angle,cost\n"));
  CHECK_THAT(content(way), Catch::StartsWith("way,x,y,angle\n"));
}

TEST_CASE("field command: options of the picture need a picture") {
  const ScratchDir dir;
  const std::string config = text_file(dir / "box.yaml", kBox), out = (dir / "f.csv").string();
  for (const auto& [option, value] :
       {std::pair("--what", "path"), std::pair("--width", "80mm"), std::pair("--font-size", "9"),
        std::pair("--unit", "m"), std::pair("--dpi", "300")}) {
    const Called called = call({"field", config, "-o", out, option, value});
    CHECK(called.exit == 2);
    CHECK_THAT(called.err, Contains(option) && Contains("add --figure FILE"));
  }
}

TEST_CASE("field and run: usual fill values and unlikely slopes of a terrain are told") {
  const ScratchDir dir;
  const auto terrain = [&](double scale, const std::string& fill) {
    std::string grid = "ncols 40\nnrows 40\nxllcorner 0\nyllcorner 0\ncellsize 3000\n";
    for (int i = 0; i < 1600; ++i) {
      const double z = scale * (500 + 300 * std::sin(0.7 * (i % 40)) * std::cos(0.5 * double(i / 40)));
      grid += (i < 40 ? fill : std::to_string(z)) + (i % 40 == 39 ? "\n" : " ");
    }
    text_file(dir / "dem.asc", grid);
    const std::string config = text_file(dir / "dem.yaml", "manifold: {type: terrain, file: dem.asc}\n");
    return call({"field", config, "-o", (dir / "out.csv").string(), "--from", "50000,50000", "--resolution", "3000"});
  };
  const Called filled = terrain(1, "-9999");
  CHECK(filled.err == "");
  CHECK_THAT(filled.out, Contains("note: the value -9999 was taken as \"no data\": 40 of 1600 cells have it"));
  CHECK_THAT(terrain(100, "500").out, Contains("note: ") && Contains("steeper than 60 degrees"));
  // Not far below heights from 200 to 800, but the only value below 0.
  CHECK_THAT(terrain(1, "-99").out, Contains("note: the value -99 was taken as \"no data\": 40 of 1600 cells"));
}

TEST_CASE("field command: what it refuses, in one sentence") {
  const ScratchDir dir;
  const std::string config = text_file(dir / "box.yaml", kBox), out = (dir / "f.csv").string();
  const auto refused = [&](std::vector<std::string> more, int exit, const std::string& words) {
    std::vector<std::string> all = {"field", config, "-o", out};
    all.insert(all.end(), more.begin(), more.end());
    const Called called = call(all);
    CHECK(called.exit == exit);
    CHECK_THAT(called.err, Contains(words));
    CHECK_FALSE(fs::exists(out));
  };
  refused({"--from", "1"}, 4, "--from 1: there is no such file, and it is not a place");
  refused({"--from", "1,nan"}, 4, "expected two numbers");
  refused({"--from", "9,9"}, 4, "--from 9,9 must have x between 0 and 4 (found 9)");
  refused({"--to", "9,9"}, 4, "--to 9,9 must have x between 0 and 4 (found 9): move the point\n");
  refused({"--way", "w.csv"}, 4, "--way needs --to X,Y");
  refused({"--corridor", "--to-here"}, 4, "both directions");
  refused({"--resolution", "0"}, 3, "resolution");
  refused({"--resolution", "100"}, 3,
          "is 100, but the shortest side of the box is 2 long: choose at most a quarter of it, 0.5");
  refused({"--resolution", "0.51"}, 3, "choose at most a quarter of it, 0.5");
  refused({"--corridor", "--to", "1,1", "--to", "2,1"}, 4, "--corridor leads to one place");
  refused({"--resolution", "0.5", "--to", "4,2", "--way", out}, 4, "name the same file");
  refused({"--resolution", "1e-9"}, 3, "more than 50 million nodes");
  CHECK(call({"field", config}).exit == 2);
}

}  // namespace leastcost::test
