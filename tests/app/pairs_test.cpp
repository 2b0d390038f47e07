// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// Runs of many pairs of ends, inside the process and by the built program: `ends: {pairs: FILE}`, --pairs.
#include <algorithm>
#include <atomic>
#include <cmath>
#include <csignal>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <numbers>
#include <random>
#include <sstream>

#include <leastcost/catalogue/catalogue.hpp>
#include "app/pairs/pair_summary.hpp"
#include "catalogue/pairs/ordered_pairs.hpp"
#include "tests/app/called.hpp"
#include "tests/app/child_program.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/data.hpp"

namespace leastcost::test {
namespace {

namespace fs = std::filesystem;
using Catch::Contains;
using Json = nlohmann::json;

fs::path put(const fs::path& file, const std::string& text) {
  std::ofstream(file, std::ios::binary) << text;
  return file;
}

/// The lines of a run.
std::vector<Json> lines_of(const fs::path& folder) {
  std::vector<Json> lines;
  std::istringstream in(content(folder / "paths.jsonl"));
  for (std::string line; std::getline(in, line);) lines.push_back(Json::parse(line));
  return lines;
}

/// The whole lines that a killed run left. The system may tear one write of many lines at the end of any page.
std::size_t whole_lines_left(const fs::path& folder) {
  const std::string text = content(folder / "paths.jsonl");
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

/// What two runs must have in common.
std::vector<Json> lines_without_seconds(const fs::path& folder) {
  std::vector<Json> lines = lines_of(folder);
  for (Json& line : lines) line.erase("seconds");
  return lines;
}

/// A run of `config` with these pairs; exit code and output of the program.
Called run_pairs_of(const ScratchDir& dir, const std::string& config, const std::string& pairs,
                    const std::vector<std::string>& more = {}) {
  put(dir / "pairs.csv", pairs);
  std::vector<std::string> arguments = {"run", put(dir / "many.yaml", config).string(), "-o", (dir / "out").string(),
                                        "-q"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return call(arguments);
}

const std::string kSquareMesh =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 9 9 9\nv 8 9 9\nv 9 8 9\nf 1 2 3\nf 1 3 4\nf 5 6 7\n";
const std::string kOnSquare =
    "manifold: {type: mesh, file: square.obj}\ncost: euclidean\nends: {pairs: pairs.csv}\npath: {points: 5}\n";

const std::string kAroundDisc =
    "manifold: {type: euclidean, dimension: 2}\nobstacles: [{type: ball, center: [0, 0], radius: 1}]\n"
    "cost: euclidean\nends: {pairs: pairs.csv}\npath: {points: 20}\n";
const std::string kInPlane = "source_x,source_y,target_x,target_y\n";

/// The shortest path around the unit disc between places at opposite sides of it, as far away as that.
double around_disc(double distance) { return 2 * (std::sqrt(distance * distance - 1) + std::asin(1 / distance)); }

}  // namespace

TEST_CASE("pairs: two vertices at one position, on the lips of a slit, are two places") {
  const ScratchDir dir;
  put(dir / "slit.off", "OFF\n6 4 0\n0 0 0\n0 0 0\n1 0 0\n0 1 0\n0 -1 0\n2 0 0\n3 0 2 3\n3 2 5 3\n3 1 4 2\n3 4 5 2\n");
  const std::string config =
      "manifold: {type: mesh, file: " + (dir / "slit.off").string() + "}\ncost: euclidean\nends: {pairs: pairs.csv}\n";
  run_pairs_of(dir, config, "source,target\n0,1\n0,0\n");
  const std::vector<Json> lines = lines_of(dir / "out");
  REQUIRE(lines.size() == 2);
  CAPTURE(lines[0].dump());
  CHECK(lines[0]["cost"].get<double>() == Approx(2).epsilon(1e-9));
  CHECK(lines[1]["cost"].get<double>() == 0);
}

TEST_CASE("pairs of vertices: a line each, in order, the wrong ones by their number") {
  const ScratchDir dir;
  put(dir / "square.obj", kSquareMesh);
  // A byte order mark, quoted cells, \r\n, empty lines, another column, and everything that can be wrong with a number.
  const std::string hostile =
      "\xef\xbb\xbf\"target\",\"a \"\"label\"\", or so\" ,source\r\n"
      "2,x,0\r\n\r\n   \r\n\"3\",\"x, y\",\" "
      "1\"\r\n-1,x,0\n7,x,0\n99999999999999999999,x,0\n1.5,x,0\nnan,x,0\n1e400,x,0\n,x,0\n"
      "2,x\n2,x,0,0\n\"2,x,0\n2,x,2\n4,x,0\n+1,x,0\n" +
      std::string("\x00,x,0\n", 6) + "1,x,0";
  const Called called = run_pairs_of(dir, kOnSquare, hostile);
  CHECK(called.exit == 7);
  std::vector<Json> lines = lines_of(dir / "out");
  REQUIRE(lines.size() == 17);
  const auto is_path = [&](std::size_t i, int source, int target, double length) {
    CAPTURE(i);
    CHECK(lines[i]["pair"] == i);
    CHECK(lines[i]["source"] == source);
    CHECK(lines[i]["target"] == target);
    CHECK(lines[i]["outcome"] == "certified");
    CHECK(lines[i]["certified"] == true);
    CHECK(lines[i]["scope"] == "global_on_polyhedron");
    CHECK(lines[i]["proof"] == "proved");
    CHECK(lines[i]["cost"].get<double>() == Approx(length).epsilon(1e-14));
    CHECK(lines[i]["seconds"].get<double>() > 0);
  };
  is_path(0, 0, 2, std::sqrt(2.0));
  is_path(1, 1, 3, std::sqrt(2.0));
  is_path(14, 0, 1, 1);
  CHECK(lines[12]["outcome"] == "certified");  // a vertex with itself
  CHECK(lines[12]["cost"] == 0);
  CHECK(lines[12]["error_estimate"] == 0);
  CHECK(lines[12]["lower_bound"] == 0);
  is_path(16, 0, 1, 1);
  const auto is_wrong = [&](std::size_t i, int line, const char* outcome, const std::string& message) {
    CAPTURE(i);
    CHECK(lines[i]["pair"] == i);
    CHECK(lines[i]["line"] == line);
    CHECK(lines[i]["outcome"] == outcome);
    CHECK(lines[i]["certified"] == false);
    CHECK(lines[i]["cost"].is_null());
    CHECK_THAT(lines[i]["message"].get<std::string>(), Contains(message));
  };
  is_wrong(2, 6, "bad_pair", "target: '-1' is negative");
  is_wrong(3, 7, "bad_pair", "the mesh has vertices 0 to 6, not 7");
  is_wrong(4, 8, "bad_pair", "is too large for a vertex");
  is_wrong(5, 9, "bad_pair", "'1.5' is not a vertex number");
  is_wrong(6, 10, "bad_pair", "'nan' is not a vertex number");
  is_wrong(7, 11, "bad_pair", "'1e400' is not a vertex number");
  is_wrong(8, 12, "bad_pair", "target: is empty");
  is_wrong(9, 13, "bad_pair", "2 cells, but the header has 3");
  is_wrong(10, 14, "bad_pair", "4 cells, but the header has 3");
  is_wrong(11, 15, "bad_pair", "a quote is not closed");
  is_wrong(13, 17, "no_path", "");
  is_wrong(15, 19, "bad_pair", "is not a vertex number");

  const Json result = Json::parse(content(dir / "out/result.json"));
  CHECK(result["status"] == "failed");
  CHECK(result["pairs"] == 17);
  CHECK(result["outcomes"] == Json({{"bad_pair", 11}, {"certified", 5}, {"no_path", 1}}));
  CHECK(result["proofs"] == Json({{"proved", 5}}));
  CHECK_THAT(called.out, Contains("17: 11 bad_pair, 5 certified, 1 no_path"));
}

TEST_CASE("pairs of points: among obstacles as long as the tangents and the arc say") {
  const ScratchDir dir;
  const Called called =
      run_pairs_of(dir, kAroundDisc + "output: {pair_points: true}\n",
                   kInPlane + "-2,0,2,0\n0,-5,0,5\n-2,2,2,2\n0,0.5,3,3\n-3,-4,3,4\ninf,0,1,1\n-2,0,1e400,0\n");
  CHECK(called.exit == 7);
  std::vector<Json> lines = lines_of(dir / "out");
  REQUIRE(lines.size() == 7);
  for (const auto& [i, length] :
       {std::pair{0, around_disc(2)}, std::pair{1, around_disc(5)}, std::pair{2, 4.0}, std::pair{4, around_disc(5)}}) {
    CAPTURE(i);
    CHECK(lines[i]["outcome"] == "certified");
    CHECK(lines[i]["scope"] == "global");  // as a run of one path has it: pulled tight
    CHECK(lines[i]["cost"].get<double>() == Approx(length).epsilon(2e-6));
    REQUIRE(lines[i]["points"].size() == 22);
    for (const Json& point : lines[i]["points"])
      CHECK(std::hypot(point[0].get<double>(), point[1].get<double>()) >= 1 - 1e-9);
    CHECK(lines[i]["points"].front() == lines[i]["source"]);
    CHECK(lines[i]["points"].back() == lines[i]["target"]);
  }
  CHECK(lines[3]["outcome"] == "bad_pair");
  CHECK_THAT(lines[3]["message"].get<std::string>(), Contains("source: end_in_clearance"));
  CHECK_THAT(lines[5]["message"].get<std::string>(), Contains("source_x: 'inf' is not finite"));
  CHECK_THAT(lines[6]["message"].get<std::string>(), Contains("target_x: '1e400' is not a number, or overflows"));
}

TEST_CASE("pairs of points: a place with itself costs nothing, where it may be at all") {
  const ScratchDir dir;
  const Called called =
      run_pairs_of(dir, kAroundDisc + "output: {pair_points: true}\n", kInPlane + "-2,0,-2,0\n0,0.5,0,0.5\n");
  CHECK(called.exit == 7);
  const std::vector<Json> lines = lines_of(dir / "out");
  REQUIRE(lines.size() == 2);
  CHECK(lines[0]["certified"] == true);
  CHECK(lines[0]["cost"] == 0);
  CHECK(lines[0]["points"] == Json::array({Json::array({-2, 0})}));
  CHECK_THAT(lines[1]["message"].get<std::string>(), Contains("source: end_in_clearance"));
  // Another name of the same place is that place; on a torus it would state a way round.
  CHECK(run_pairs_of(dir, "manifold: earth\ncost: euclidean\nends: {pairs: pairs.csv}\n",
                     "source_lon,source_lat,target_lon,target_lat\n5,6,365,6\n", {"--force"})
            .exit == 0);
  CHECK(lines_of(dir / "out").front()["cost"] == 0);
}

TEST_CASE("pairs of places on the Earth: by longitude and latitude, or by the names of the coordinates") {
  const ScratchDir dir;
  const std::string config = "manifold: earth\ncost: euclidean\nends: {pairs: pairs.csv}\npath: {points: 20}\n";
  for (const char* pairs : {"source_lon,source_lat,target_lat,target_lon\n177.4,-17.8,-13.8,-171.8\n",
                            "source_latitude,source_longitude,target_latitude,target_longitude\n"
                            "-17.8,177.4,-13.8,-171.8\n"}) {
    CHECK(run_pairs_of(dir, config, pairs, {"--force"}).exit == 0);
    CHECK(lines_of(dir / "out").front()["cost"].get<double>() == Approx(1238493.306911).epsilon(1e-7));
  }
  CHECK_THAT(run_pairs_of(dir, config, "a,b\n1,2\n", {"--force"}).err,
             Contains("'source_lon,source_lat,target_lon,target_lat'"));
}

TEST_CASE("pairs of points: on a level set, and nearby as far as the tolerance of the pairs allows") {
  const ScratchDir dir;
  const std::string config =
      "manifold: {type: implicit, surface: sphere}\ncost: euclidean\nends: {pairs: pairs.csv, tolerance: 0.2}\n"
      "path: {points: 20}\n";
  CHECK(run_pairs_of(dir, config,
                     "source_x,source_y,source_z,target_x,target_y,target_z\n1,0,0,0,1,0\n"
                     "1.1,0,0,0,0.6,0.8\n1.3,0,0,0,1,0\n")
            .exit == 7);
  std::vector<Json> lines = lines_of(dir / "out");
  REQUIRE(lines.size() == 3);
  for (const int i : {0, 1}) {
    CHECK(lines[i]["certified"] == true);
    CHECK(lines[i]["cost"].get<double>() == Approx(std::numbers::pi / 2).epsilon(1e-8));
  }
  CHECK(lines[1]["moved"][0].get<double>() == Approx(0.1));
  CHECK_THAT(lines[2]["message"].get<std::string>(),
             Contains("source.point: the nearest point of the manifold is 0.3"));
}

TEST_CASE("pairs of points: in a chart by the names of its coordinates, each as a run of its own") {
  const ScratchDir dir;
  const std::string torus = "manifold: {type: parametric, surface: torus}\ncost: euclidean\npath: {points: 24}\n";
  // The second is cheaper the other way around, by another name of its target.
  CHECK(run_pairs_of(dir, torus + "ends: {pairs: pairs.csv}\n",
                     "target_v,target_u,source_u,source_v\n1,1,0,0\n0.5,6,0.5,0\n")
            .exit == 0);
  std::vector<Json> lines = lines_of(dir / "out");
  REQUIRE(lines.size() == 2);
  const auto alone = [&](const std::string& ends) {
    return solve(parse_run(torus + "ends: " + ends + "\n", "one.yaml")).result.certificate.estimate;
  };
  CHECK(lines[0]["cost"] == alone("{source: {point: [0, 0]}, target: {point: [1, 1]}}").value);
  const CostEstimate around = alone("{source: {point: [0.5, 0]}, target: {point: [6, 0.5]}}");
  CHECK(lines[1]["cost"] == around.value);
  CHECK(lines[1]["error_estimate"] == around.error);
  CHECK_THAT(lines[1]["notes"][0].get<std::string>(), Contains("the target was replaced by"));
}

TEST_CASE("pairs: a cost that starts at the source starts at that of each pair") {
  const ScratchDir dir;
  const std::string slide =
      "manifold: {type: euclidean, dimension: 2}\ncost: {type: travel_time, gravity: 1}\nends: {pairs: pairs.csv}\n";
  CHECK(run_pairs_of(dir, slide, kInPlane + "0,0,3.14159265358979,-2\n7,5,10.14159265358979,3\n0,0,1,1\n").exit == 7);
  std::vector<Json> lines = lines_of(dir / "out");
  REQUIRE(lines.size() == 3);
  for (const int i : {0, 1}) CHECK(lines[i]["cost"].get<double>() == Approx(std::numbers::pi).epsilon(1e-6));
  CHECK(lines[2]["outcome"] == "no_path");
}

TEST_CASE("pairs: threads, and what was cut off and is resumed, give the same lines") {
  const ScratchDir dir;
  std::string pairs = kInPlane;
  std::mt19937 random(7);  // NOLINT: the same at every run
  std::uniform_real_distribution<double> place(-3, 3);
  for (int i = 0; i < 60; ++i) {
    for (int k = 0; k < 4; ++k) pairs += (k > 0 ? "," : "") + std::to_string(place(random));
    pairs += '\n';
  }
  run_pairs_of(dir, kAroundDisc, pairs);
  const std::vector<Json> whole = lines_without_seconds(dir / "out");
  const std::string text = content(dir / "out/paths.jsonl");
  REQUIRE(whole.size() == 60);
  run_pairs_of(dir, kAroundDisc, pairs, {"--force", "-j", "3"});
  CHECK(lines_without_seconds(dir / "out") == whole);

  // As a kill leaves it: the last line is torn, and nothing stands at the end.
  const fs::path log = dir / "out/paths.jsonl";
  for (const std::size_t kept : {std::size_t{0}, std::size_t{5}, text.size() / 2, text.size() - 1, text.size()}) {
    CAPTURE(kept);
    put(log, text.substr(0, kept));
    fs::remove(dir / "out/result.json");
    const auto lines_kept = std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(kept), '\n');
    const Called called = run_pairs_of(dir, kAroundDisc, pairs, {"--resume", "-j", "2", "--format", "jsonl"});
    CHECK(lines_without_seconds(dir / "out") == whole);
    CHECK(content(log).substr(0, kept / 2) == text.substr(0, kept / 2));  // what was whole was not made again
    CHECK(std::count(called.out.begin(), called.out.end(), '\n') == 60 - lines_kept);
    CHECK(Json::parse(content(dir / "out/result.json"))["pairs"] == 60);
  }

  const auto refused = [&](const std::string& config, const std::string& other, const std::string& why) {
    const Called called = run_pairs_of(dir, config, other, {"--resume"});
    CHECK(called.exit == 2);
    CHECK_THAT(called.err, Contains(why));
    CHECK(content(log).size() >= text.size() / 2);
  };
  refused(kAroundDisc + "clearance: 0.1\n", pairs, "the options have changed");
  refused(kAroundDisc, pairs + "0,2,2,0\n", "one of its input files has changed");
  CHECK_THAT(run_pairs_of(dir, kAroundDisc, pairs).err,
             Contains("use --resume to continue the run of many pairs in it"));
  put(log, text.substr(0, text.size() / 2) + "\nno json\n");
  const Called broken = run_pairs_of(dir, kAroundDisc, pairs, {"--resume"});
  CHECK(broken.exit == 4);
  CHECK_THAT(broken.err, Contains("paths.jsonl:"));
}

TEST_CASE("pairs: on standard output as lines, as one object, or in words, exit codes") {
  const ScratchDir dir;
  const Called lines = run_pairs_of(dir, kAroundDisc, kInPlane + "-2,0,2,0\n0,2,2,0\n", {"--format", "jsonl"});
  CHECK(lines.exit == 0);
  CHECK(lines.out == content(dir / "out/paths.jsonl"));
  const Called object = run_pairs_of(dir, kAroundDisc, kInPlane + "-2,0,2,0\n", {"--format", "json", "--force"});
  const Json result = Json::parse(object.out);
  CHECK(result["status"] == "certified");
  CHECK(result["output"] == (dir / "out").string());
  CHECK(result["relative_error"]["worst_pair"] == 0);
  CHECK(result["seconds_per_pair"]["median"] <= result["seconds_per_pair"]["worst"]);
  CHECK(run_pairs_of(dir, kAroundDisc + "certificate: {enabled: false}\n", kInPlane + "-2,0,2,0\n", {"--force"}).exit ==
        5);
  CHECK_THAT(run_pairs_of(dir, kAroundDisc, kInPlane + "-2,0,2,0\nx,0,0,0\n", {"-n"}).out,
             Contains("2 of points, 1 of them invalid (line 3: source_x: 'x'"));
  const Called report = call({"report", (dir / "out").string()});
  CHECK(report.exit == 4);
  CHECK_THAT(report.err, Contains("a run of many pairs has no report"));

  // --pairs takes the place of the ends that the configuration has.
  const std::string file = put(dir / "other's.csv", kInPlane + "0,0,3,4\n").string();
  const std::string one = put(dir / "one.yaml", kPlane).string();
  const Called instead =
      call({"run", one, "--pairs", file, "-o", (dir / "instead").string(), "--format", "jsonl", "-q"});
  CHECK(instead.exit == 0);
  CHECK(Json::parse(instead.out)["cost"].get<double>() == Approx(5).epsilon(1e-14));
  for (const std::vector<std::string>& more :
       {std::vector<std::string>{"-j", "2"}, {"--resume"}, {"--format", "jsonl"}}) {
    std::vector<std::string> arguments = {"run", one, "-o", (dir / "none").string()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Called called = call(arguments);
    CHECK(called.exit == 2);
    CHECK_THAT(called.err, Contains("are for runs of many pairs of ends"));
  }
}

TEST_CASE("pairs: a file that is none is an error of the input, with what would be right") {
  const ScratchDir dir;
  put(dir / "square.obj", kSquareMesh);
  const auto refused = [&](const std::string& config, const std::string& pairs, const std::string& why) {
    CAPTURE(pairs);
    const Called called = run_pairs_of(dir, config, pairs);
    CHECK(called.exit == 4);
    CHECK_THAT(called.err, Contains(why));
    CHECK_FALSE(fs::exists(dir / "out"));
  };
  refused(kAroundDisc, "",
          "is empty; the first line must name the columns: 'source_x,source_y,target_x,target_y' for points");
  refused(kAroundDisc, "\n\r\n", "is empty");
  refused(kAroundDisc, kInPlane, "has a header but no pairs");
  refused(kAroundDisc, "source_x,source_y,target_x\n0,0,1\n", "pairs.csv:1: the column 'target_y' is missing");
  refused(kAroundDisc, "source,target\n0,1\n", "this domain has none; expected: 'source_x,");
  refused(kAroundDisc, "0,0,1,1\n", "the header has no ends");
  refused(kAroundDisc, "source_x,source_y,target_x,target_x,target_y\n0,0,1,1,1\n",
          "two columns have the name 'target_x'");
  refused(kAroundDisc, "\"source_x,source_y\n0,0\n", "a quote is not closed");
  refused(kOnSquare, "source\n1\n",
          "the column 'target' is missing; expected: 'source,target' for vertices, or "
          "'source_x,source_y,source_z,target_x");
  refused(kOnSquare, "source,target,source_x\n0,1,1\n", "both as vertices and as points");
  refused(kOnSquare, std::string(2 << 20, 'x') + "\n0,1\n", "more than a million bytes");
  fs::remove(dir / "pairs.csv");
  const Called missing = call({"run", (dir / "many.yaml").string(), "-o", (dir / "out").string()});
  CHECK(missing.exit == 4);
  CHECK_THAT(missing.err, Contains("many.yaml:3:15") && Contains("no such file"));
}

TEST_CASE("pairs: a line of any length costs no more memory than the longest one that is read") {
  const ScratchDir dir;
  const std::string pairs = kInPlane + "-2,0,2,0\n" + std::string(3 << 20, '7') + ",0,0,0\n0,2,2,0\n";
  CHECK(run_pairs_of(dir, kAroundDisc, pairs).exit == 7);
  std::vector<Json> lines = lines_of(dir / "out");
  REQUIRE(lines.size() == 3);
  CHECK_THAT(lines[1]["message"].get<std::string>(), Contains("more than a million bytes"));
  CHECK(lines[2]["outcome"] == "certified");
}

TEST_CASE("pairs in a configuration: instead of two ends, and not with what only one path has") {
  const std::string many = "manifold: euclidean\ncost: euclidean\nends: {pairs: p.csv}\n";
  CHECK(errors_of(many) == "");
  CHECK_THAT(errors_of(many, {"ends.source.point=[0, 0]"}), Contains("give either 'pairs' or 'source' and 'target'"));
  CHECK_THAT(errors_of(many + "path: {ring: true}\ninitializer: {type: waypoints, points: [[0, 1], [1, 0], [1, 1]]}\n"),
             Contains("a.yaml:3:15: error: a ring (path.ring: true) has no ends"));
  CHECK_THAT(errors_of(many + "output: {waypoints: {count: 5}}\n"), Contains("waypoints are for runs of one path"));
  CHECK_THAT(errors_of(many + "output: {files: [result]}\n"), Contains("'files' is for runs of one path"));
  CHECK_THAT(errors_of(kPlane + "output: {pair_points: true}\n"), Contains("needs many pairs of ends"));
  CHECK_THAT(errors_of(kPlane, {"ends.tolerance=1"}), Contains("is only for pairs"));
  CHECK_THAT(errors_of("manifold: euclidean\ncost: euclidean\nends: {target: {point: [1, 1]}}\n"),
             Contains("missing key 'source' in ends"));
  const ScratchDir dir;
  put(dir / "p.csv", kInPlane + "0,0,1,1\n");
  CHECK_THROWS_WITH(solve(parse_run(many, "many.yaml", dir.path())), Contains("solve() finds one path"));
  put(dir / "study.yaml",
      "problems:\n  - name: a\n    config: {manifold: euclidean, cost: euclidean, ends: {pairs: p.csv}}\n");
  const Called study = call({"study", (dir / "study.yaml").string(), "-n"});
  CHECK(study.exit == 3);
  CHECK_THAT(study.err, Contains("a problem of a study has one source and one target"));
}

TEST_CASE("output.files: a run writes what is named, and its manifest") {
  const ScratchDir dir;
  const auto written = [&](const std::string& files, const char* name) {
    const Called called = call({"run", put(dir / "one.yaml", kPlane + "output: {files: " + files + "}\n").string(),
                                "-o", (dir / name).string(), "-q"});
    CHECK(called.exit == 0);
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(dir / name)) names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
  };
  using Names = std::vector<std::string>;
  CHECK(written("[result, path]", "a") == Names{"manifest.json", "path.csv", "result.json"});
  CHECK(written("vtp", "b") == Names{"manifest.json", "path.vtp"});
  CHECK(written("[report, result, path, history, scene, config]", "c") ==
        Names{"config.resolved.yaml", "history.csv", "manifest.json", "path.csv", "report.html", "result.json",
              "scene.json"});
  CHECK(call({"run", put(dir / "one.yaml", kPlane).string(), "-o", (dir / "a").string(), "-q", "--force"}).exit == 0);
  CHECK(fs::exists(dir / "a/report.html"));  // all of them, in the place of a folder that lacks some
  CHECK_THAT(errors_of(kPlane + "output: {files: [result, pth]}\n"),
             Contains("a.yaml:6:17: error: 'files' has 'pth'") && Contains("did you mean 'path'"));
  CHECK_THAT(errors_of(kPlane + "output: {files: [result, report]}\n"), Contains("also needs 'path'"));
}

TEST_CASE("pairs on the bunny: killed and resumed with two threads, the same lines as at one go") {
  if (!built()) return;
  const auto bunny = installed_model("glmark2/models/bunny.obj");
  if (!bunny) return;
  const ScratchDir dir;
  put(dir / "many.yaml", "manifold: {type: mesh, file: " + bunny->string() +
                             "}\ncost: euclidean\nends: {pairs: pairs.csv}\npath: {points: 16}\n");
  std::string pairs = "source,target\n";
  constexpr int kPairs = 240;  // longer than a pause for all of them
  for (int i = 0; i < kPairs; ++i)
    pairs += std::to_string(140 * i + 100) + "," + std::to_string(34000 - 130 * i) + "\n";
  put(dir / "pairs.csv", pairs + "34834,34835\n");
  const auto begin = [&](const char* out, std::vector<std::string> more) {
    more.insert(more.begin(), {"run", (dir / "many.yaml").string(), "-q", "-o", (dir / out).string()});
    return start(dir, more);
  };
  CHECK(begin("whole", {}).wait() == 7);  // the last pair is none
  const std::vector<Json> whole = lines_without_seconds(dir / "whole");
  REQUIRE(whole.size() == kPairs + 1);
  CHECK_THAT(whole.back()["message"].get<std::string>(), Contains("0 to 34834, not 34835"));
  CHECK(std::count_if(whole.begin(), whole.end(), [](const Json& line) { return line["certified"] == true; }) ==
        kPairs);

  const Child killed = begin("out", {"-j", "2"});
  constexpr std::chrono::milliseconds kPause{1};
  constexpr int kMostPauses = 20000;
  std::error_code error;
  for (int i = 0; i < kMostPauses && !(fs::file_size(dir / "out/paths.jsonl", error) > 0 && !error); ++i)
    std::this_thread::sleep_for(kPause);
  ::kill(killed.pid, SIGKILL);
  const int ended = killed.wait();
  CHECK((ended == 1000 + SIGKILL || ended == 7));  // on a busy machine all pairs may be done before the signal
  const std::size_t left = whole_lines_left(dir / "out");
  CHECK(left > 0);
  CHECK(left <= kPairs + 1);
  CHECK(begin("out", {"--resume", "-j", "2"}).wait() == 7);
  CHECK(lines_without_seconds(dir / "out") == whole);
}

TEST_CASE("pairs: told to stop, the program says how to go on, and does") {
  if (!built()) return;
  const ScratchDir dir;
  put(dir / "many.yaml", kAroundDisc);
  std::string pairs = kInPlane;
  for (int i = 0; i < 100000; ++i) pairs += "-2,0,2,0." + std::to_string(i) + "\n";
  put(dir / "pairs.csv", pairs);
  const Child child = start(dir, {"run", (dir / "many.yaml").string(), "-q", "-j", "2", "-o", (dir / "out").string()});
  constexpr std::chrono::milliseconds kPause{5};
  std::error_code error;
  for (int i = 0; i < 4000 && !(fs::file_size(dir / "out/paths.jsonl", error) > 0 && !error); ++i)
    std::this_thread::sleep_for(kPause);
  ::kill(child.pid, SIGINT);
  CHECK(child.wait() == 130);
  CHECK_THAT(content(child.err), Contains("to continue, add --resume to the same command"));
  std::vector<Json> lines = lines_of(dir / "out");
  const Json result = Json::parse(content(dir / "out/result.json"));
  CHECK(result["status"] == "interrupted");
  CHECK(result["pairs"] == lines.size());
  REQUIRE(lines.size() < 100000);
  for (std::size_t i = 0; i < lines.size(); ++i) REQUIRE((lines[i]["pair"] == i && lines[i]["certified"] == true));
}

TEST_CASE("pairs in threads: in order, in a window, and whatever is thrown ends all of it") {
  const ScratchDir dir;
  std::string text = "source_x,target_x\n";
  constexpr long kMany = 20000;
  for (long i = 0; i < kMany; ++i) text += "0,1\n";
  put(dir / "pairs.csv", text);
  PairReader reader(dir / "pairs.csv", {"x"}, false);
  long delivered = 0;
  std::atomic<long> known{0}, farthest{0};
  OrderedPairs work{[&] { return reader.next(); }, {}, {}, {}, 3};
  const auto certified = [](long number) {
    PairResult result;
    result.number = number;
    result.outcome = "certified";
    return result;
  };
  work.solve = [&](const PairRow& row) {
    if (row.number % 5000 == 0) std::this_thread::sleep_for(std::chrono::milliseconds(30));
    long ahead = farthest.load();
    while (row.number - known > ahead && !farthest.compare_exchange_weak(ahead, row.number - known)) {
    }
    return certified(row.number);
  };
  work.done = [&](const PairResult& result) {
    REQUIRE(result.number == delivered);
    known = ++delivered;
  };
  CHECK(solve_in_order(work));
  CHECK(delivered == kMany);
  CHECK(farthest > 3);         // others went on while one took long
  CHECK(farthest <= 3 * 256);  // but not far

  const auto again = [&](auto change) {
    PairReader other(dir / "pairs.csv", {"x"}, false);
    delivered = 0;
    OrderedPairs broken{[&] { return other.next(); }, work.solve, work.done, work.stop_requested, 3};
    change(broken);
    return solve_in_order(broken);
  };
  CHECK_THROWS_WITH(again([&](OrderedPairs& broken) {
                      broken.solve = [&](const PairRow& row) {
                        if (row.number == 700) throw InputError("out of paper");
                        return certified(row.number);
                      };
                    }),
                    "out of paper");
  CHECK_THROWS_WITH(
      again([](OrderedPairs& broken) { broken.done = [](const PairResult&) { throw InputError("no disk"); }; }),
      "no disk");
  CHECK_FALSE(again([&](OrderedPairs& broken) { broken.stop_requested = [&] { return known > 1000; }; }));
  CHECK(delivered >= 1000);
  CHECK(delivered < kMany);
}

TEST_CASE("pairs: the median of many values in little memory is that of the sorted ones to 0.5 %") {
  std::mt19937 random(11);  // NOLINT: the same at every run
  std::lognormal_distribution<double> value(-7, 3);
  for (const int count : {1, 2, 3, 10, 1001, 20000}) {
    app::Spectrum spectrum;
    std::vector<double> all;
    for (int i = 0; i < count; ++i) {
      all.push_back(value(random));
      spectrum.add(all.back(), i);
    }
    const auto most = std::max_element(all.begin(), all.end());
    CHECK(spectrum.greatest() == *most);
    CHECK(spectrum.greatest_of() == most - all.begin());
    std::sort(all.begin(), all.end());
    CHECK(spectrum.median() == Approx(all[(all.size() - 1) / 2]).epsilon(0.005));
  }
  app::Spectrum none, odd;
  none.add(std::nan(""), 0);
  CHECK(none.empty());
  CHECK(std::isnan(none.median()));
  odd.add(0, 0), odd.add(0, 1), odd.add(std::numeric_limits<double>::infinity(), 2);
  CHECK(odd.median() == 0);
  CHECK(odd.greatest_of() == 2);
}

}  // namespace leastcost::test
