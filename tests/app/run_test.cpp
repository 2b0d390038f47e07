// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// Whole runs inside the process, and their files read back.
#include "app/run/run.hpp"

#include <fstream>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>

#include "app/cli/summary.hpp"
#include "catalogue/output/manifest.hpp"
#include "catalogue/registry/registry.hpp"
#include "catalogue/yaml/yaml_reader.hpp"
#include "problems/readers/waypoint_reader.hpp"
#include "tests/app/config_text.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/data.hpp"

namespace leastcost::test {

namespace fs = std::filesystem;
using Catch::Contains;
using Json = nlohmann::json;

namespace {

const char* const kChute = R"(manifold: {type: euclidean, dimension: 2}
cost: {type: travel_time, gravity: 1, start_speed: 1}
ends: {source: {point: [0, 0]}, target: {point: [3, -1]}}
path: {points: 15}
)";

/// A square pyramid without base: five vertices, four faces.
const char* const kPyramid = "v 0 0 1\nv 1 1 0\nv -1 1 0\nv -1 -1 0\nv 1 -1 0\nf 1 2 3\nf 1 3 4\nf 1 4 5\nf 1 5 2\n";

const char* const kOnPyramid = R"(manifold: {type: mesh, file: pyramid.obj, subdivide: 2}
cost: euclidean
ends:
  source: {face: 0, barycentric: [0.2, 0.3, 0.5]}
  target: {face: 2, barycentric: [0.1, 0.4, 0.5]}
path: {points: 9}
)";

fs::path write(const fs::path& file, const std::string& text) {
  std::ofstream(file) << text;
  return file;
}

app::WrittenRun run_file(const fs::path& config, const fs::path& output, const Monitor& monitor = {}) {
  return app::run({config, {}, output, false, {"leastcost", "run"}}, monitor);
}

Json result_of(const fs::path& output) { return Json::parse(content(output / "result.json")); }

std::vector<std::vector<std::string>> csv(const fs::path& file) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream in(content(file));
  for (std::string line; std::getline(in, line);) {
    std::istringstream cells(line);
    rows.emplace_back();
    for (std::string cell; std::getline(cells, cell, ',');) rows.back().push_back(cell);
  }
  return rows;
}

}  // namespace

TEST_CASE("run: every promised file, and result.json with every promised key") {
  const ScratchDir dir;
  const app::WrittenRun outcome = run_file(write(dir / "chute.yaml", kChute), dir / "out");
  CHECK(outcome.output_error == "");
  for (const char* name : {"config.resolved.yaml", "manifest.json", "result.json", "path.csv", "curve.csv", "path.vtp",
                           "path.obj", "history.csv"})
    CHECK(fs::exists(dir / "out" / name));

  const Json r = result_of(dir / "out");
  for (const char* key : {"schema_version", "status", "certified", "failures", "scope", "cost", "spacing",
                          "certificate", "solver", "seconds", "points"}) {
    CAPTURE(key);
    CHECK(r.contains(key));
  }
  for (const char* key : {"value", "unit", "error_estimate", "initial"}) CHECK(r["cost"].contains(key));
  for (const char* key : {"name", "iterations", "counters", "termination", "message"}) CHECK(r["solver"].contains(key));
  for (const char* key : {"read", "initialize", "solve", "post_process", "certify"}) CHECK(r["seconds"].contains(key));
  CHECK(r["status"] == "certified");
  CHECK(r["points"] == 15);
  CHECK(r["cost"]["value"] == outcome.result.certificate.estimate.value);
  CHECK(r["cost"]["unit"] == "s");
}

TEST_CASE("run: on a mesh under the Euclidean cost the shortest path is proved, unless told otherwise") {
  const ScratchDir dir;
  write(dir / "pyramid.obj", kPyramid);
  const auto result_with = [&dir](const std::string& more, const char* name) {
    run_file(write(dir / (std::string(name) + ".yaml"), kOnPyramid + more), dir / name);
    return result_of(dir / name);
  };
  const Json proved = result_with("", "proved");
  CHECK(proved["status"] == "certified");
  CHECK(proved["scope"] == "global_on_polyhedron");
  CHECK(proved["solver"]["name"] == "none");
  CHECK(proved["global"]["outcome"] == "proved");
  CHECK(proved["global"]["bound"] == "euclid");
  CHECK(proved["global"]["windows"] > 0);
  const double length = proved["cost"]["curve"], lower = proved["global"]["lower_bound"];
  CHECK(lower <= length);
  CHECK(lower >= length * (1 - 1e-9));

  const Json off = result_with("certificate: {global: off}\n", "off");
  CHECK(off["scope"] == "local_on_polyhedron");
  CHECK(off["global"].is_null());
  CHECK(off["solver"]["name"] == "lbfgs");
  const Json little = result_with("certificate: {global: {max_windows: 1}}\n", "little");
  CHECK(little["global"]["outcome"] == "bounded");
  CHECK(little["scope"] == "local_on_polyhedron");
  CHECK(little["status"] == "certified");
  CHECK(little["global"]["lower_bound"] <= length);
}

TEST_CASE("run: path.csv holds the path to the last bit and starts another run") {
  const ScratchDir dir;
  const app::WrittenRun outcome = run_file(write(dir / "chute.yaml", kChute), dir / "out");
  const auto rows = csv(dir / "out/path.csv");
  REQUIRE(rows.size() == 18);
  CHECK(rows[0] == std::vector<std::string>{"index", "x", "y", "segment_cost", "cumulative_cost"});
  for (std::size_t i = 0; i < 17; ++i) {
    const auto column = static_cast<Index>(i);
    CHECK(std::stod(rows[i + 1][1]) == outcome.result.path.u(0, column));
    CHECK(std::stod(rows[i + 1][2]) == outcome.result.path.u(1, column));
    if (i < 16) CHECK(std::stod(rows[i + 1][3]) == outcome.result.costs[column]);
  }
  CHECK(std::stod(rows.back()[3]) == 0);
  CHECK(std::stod(rows.back()[4]) == Approx(outcome.result.curve.cost).epsilon(1e-14));
  const Eigen::MatrixXd read = read_waypoints(dir / "out/path.csv", {"x", "y"});
  CHECK(read == outcome.result.path.u);

  const std::string again = std::string(kChute) + "initializer: {type: file, file: out/path.csv}\n";
  CHECK(run_file(write(dir / "again.yaml", again), dir / "out2").result.status == Status::certified);
}

TEST_CASE("run: the resolved configuration repeats the run exactly, wherever it lies") {
  const ScratchDir dir;
  fs::create_directories(dir / "in");
  write(dir / "in/pyramid.obj", kPyramid);
  run_file(write(dir / "in/chute.yaml", kChute), dir / "a/chute");
  run_file(write(dir / "in/mesh.yaml", kOnPyramid), dir / "a/b/mesh");
  for (const char* folder : {"a/chute", "a/b/mesh"}) {
    const fs::path repeated = (dir / folder).string() + ".repeated";
    run_file(dir / folder / "config.resolved.yaml", repeated);
    CHECK(content(repeated / "path.csv") == content(dir / folder / "path.csv"));
    CHECK(content(repeated / "curve.csv") == content(dir / folder / "curve.csv"));
    Json first = result_of(dir / folder), second = result_of(repeated);
    for (Json* r : {&first, &second}) {
      r->erase("seconds");
      if ((*r)["global"].is_object()) (*r)["global"].erase("seconds");
    }
    CHECK(first == second);
  }
}

TEST_CASE("run: on a mesh, path.csv speaks of the file's faces and vertices") {
  const ScratchDir dir;
  write(dir / "pyramid.obj", kPyramid);
  const app::WrittenRun outcome = run_file(write(dir / "mesh.yaml", kOnPyramid), dir / "out");
  const std::vector<Eigen::Vector3d> vertices = {{0, 0, 1}, {1, 1, 0}, {-1, 1, 0}, {-1, -1, 0}, {1, -1, 0}};
  for (const char* name : {"path.csv", "curve.csv"}) {
    const auto rows = csv(dir / "out" / name);
    REQUIRE(rows[0] == std::vector<std::string>{"index", "x", "y", "z", "segment_cost", "cumulative_cost", "face",
                                                "fan", "v0", "v1", "v2", "b0", "b1", "b2"});
    for (std::size_t i = 1; i < rows.size(); ++i) {
      Eigen::Vector3d p = Eigen::Vector3d::Zero();
      for (std::size_t k = 0; k < 3; ++k)
        p += std::stod(rows[i][11 + k]) * vertices.at(static_cast<std::size_t>(std::stoi(rows[i][8 + k])));
      CHECK((p - Eigen::Vector3d(std::stod(rows[i][1]), std::stod(rows[i][2]), std::stod(rows[i][3]))).norm() < 1e-14);
      CHECK(std::stoi(rows[i][6]) < 4);
    }
  }
  const auto points = csv(dir / "out/path.csv"), curve = csv(dir / "out/curve.csv");
  CHECK(points[1][6] == "0");
  CHECK(std::stod(points.back()[5]) == Approx(outcome.result.curve.cost).epsilon(1e-12));
  CHECK(std::stod(curve.back()[5]) == Approx(outcome.result.curve.cost).epsilon(1e-12));
  CHECK(result_of(dir / "out")["ends"]["source"]["moved"] == 0.0);
  CHECK(outcome.result.status == Status::certified);
}

TEST_CASE("run: path.vtp and path.obj are consistent files") {
  const ScratchDir dir;
  write(dir / "pyramid.obj", kPyramid);
  run_file(write(dir / "mesh.yaml", kOnPyramid), dir / "out");
  const std::string vtp = content(dir / "out/path.vtp");
  const auto rows = csv(dir / "out/path.csv").size() - 1, curve = csv(dir / "out/curve.csv").size() - 1;
  CHECK_THAT(vtp,
             Contains("NumberOfPoints=\"" + std::to_string(rows + curve) + "\"") && Contains("NumberOfLines=\"2\""));
  const auto values = [&](const std::string& name) {
    const std::regex pattern("<DataArray[^>]*Name=\"" + name + "\"[^>]*>([^<]*)</DataArray>");
    std::smatch match;
    REQUIRE(std::regex_search(vtp, match, pattern));
    std::istringstream in(match[1].str());
    return std::vector<double>(std::istream_iterator<double>(in), {});
  };
  CHECK(values("Points").size() == 3 * (rows + curve));
  CHECK(values("cumulative_cost").size() == rows + curve);
  CHECK(values("connectivity").size() == rows + curve);
  CHECK(values("offsets") == std::vector<double>{double(rows), double(rows + curve)});
  CHECK(values("line") == std::vector<double>{0, 1});
  CHECK(values("part") == std::vector<double>{0, 1});  // chords, curve
  for (const char* tag : {"Piece", "PointData", "CellData", "Points", "Lines", "PolyData", "VTKFile"}) {
    CHECK_THAT(vtp, Contains(std::string("<") + tag) && Contains(std::string("</") + tag + ">"));
  }
  const std::string obj = content(dir / "out/path.obj");
  CHECK(static_cast<std::size_t>(std::count(obj.begin(), obj.end(), 'v')) == curve);
  CHECK_THAT(obj, Contains(std::to_string(curve) + "\n"));
}

TEST_CASE("run: the manifest names the inputs by content") {
  const ScratchDir dir;
  write(dir / "pyramid.obj", kPyramid);
  run_file(write(dir / "mesh.yaml", kOnPyramid), dir / "out");
  const Json m = Json::parse(content(dir / "out/manifest.json"));
  CHECK(m["program"] == "leastcost");
  REQUIRE(m["inputs"].size() == 2);
  // The commit of a checkout, and the back ends of this build with their versions.
  CHECK((m["commit"].is_null() || m["commit"].get<std::string>().size() >= 40));
  if (fs::exists(project_dir() / ".git")) CHECK(m["commit"].is_string());
  for (const PluginEntry* solver : kind("solver").entries) {
    CAPTURE(solver->type);
    CHECK(m["build"]["libraries"].contains(solver->type) == !solver->library.empty());
    if (solver->type == "nlopt" && solver->missing.empty())
      CHECK_THAT(m["build"]["libraries"]["nlopt"].get<std::string>(), Catch::StartsWith("NLopt 2."));
    if (solver->type == "ceres" && solver->missing.empty())
      CHECK_THAT(m["build"]["libraries"]["ceres"].get<std::string>(), Catch::StartsWith("Ceres 2."));
  }
  CHECK(m["inputs"][0]["sha256"] == sha256_of_text(kOnPyramid));
  CHECK(m["inputs"][1]["sha256"] == sha256_of_text(kPyramid));
  CHECK(m["arguments"] == Json({"leastcost", "run"}));
  for (const char* key : {"version", "build", "machine", "threads", "seed", "started", "finished"})
    CHECK(m.contains(key));
}

TEST_CASE("run: a stop request keeps the best path, a time budget too") {
  const ScratchDir dir;
  int iterations = 0;
  Monitor monitor;
  monitor.observe = [&](const Progress& progress) { iterations += progress.iteration != nullptr ? 1 : 0; };
  monitor.stop_requested = [&] { return iterations > 2; };
  const app::WrittenRun stopped = run_file(write(dir / "chute.yaml", kChute), dir / "out", monitor);
  CHECK(stopped.result.status == Status::interrupted);
  CHECK(app::exit_of(stopped.result.status) == app::Exit::interrupted);
  CHECK(result_of(dir / "out")["status"] == "interrupted");
  CHECK(result_of(dir / "out")["cost"]["error_estimate"].is_null());
  CHECK(result_of(dir / "out")["cost"]["value"].is_number());
  const std::string summary = app::summary_text(stopped, false);
  CHECK_THAT(summary, Catch::Contains("interrupted: error not measured") && !Catch::Contains("+-"));
  CHECK(csv(dir / "out/path.csv").size() == 18);

  const std::string short_of_time = std::string(kChute) + "max_seconds: 1e-9\n";
  CHECK_THROWS_AS(run_file(write(dir / "short.yaml", short_of_time), dir / "out2"), StoppedEarly);
  CHECK_FALSE(std::filesystem::exists(dir / "out2"));
}

TEST_CASE("run: statuses") {
  const ScratchDir dir;
  const std::string uncertified = std::string(kChute) + "certificate: {enabled: false}\n";
  CHECK(run_file(write(dir / "u.yaml", uncertified), dir / "u").result.status == Status::uncertified);
  const Json r = result_of(dir / "u");
  CHECK(r["certified"] == false);
  CHECK(r["cost"]["error_estimate"].is_null());
  CHECK(r["certificate"]["measured"] == false);
  CHECK(app::exit_of(Status::certified) == app::Exit::certified);
  CHECK(app::exit_of(Status::uncertified) == app::Exit::uncertified);
  CHECK(app::exit_of(Status::collapsed) == app::Exit::uncertified);
}

namespace {

/// Makes a curve that leaves the domain of its cost.
class LeadsAstray final : public PostProcessor {
 public:
  std::string_view name() const override { return "leads_astray"; }
  PostProcessed apply(const Problem&, const FirstPath&, PostProcessed path, const Monitor&) const override {
    path.curve_costs[1] = path.curve.cost = std::numeric_limits<double>::infinity();
    return path;
  }
};

}  // namespace

TEST_CASE("run: instead of a path that costs infinitely much the first path is delivered, without an error bar") {
  const ScratchDir dir;
  Run loaded = parse_run(kPlane, "a");
  loaded.parts.options.post_processors = {std::make_shared<const LeadsAstray>()};
  const app::WrittenRun outcome =
      app::run(std::move(loaded), {"a.yaml", {}, dir / "out", false, {"leastcost", "run"}}, {});
  CHECK(outcome.output_error == "");
  CHECK(outcome.result.status == Status::uncertified);
  const std::string summary = app::summary_text(outcome, true);
  CHECK_THAT(summary, Contains("cost        5 length") && Contains("the first path is delivered; its cost is 5") &&
                          Contains("infinite_cost") && !Contains("+-") && !Contains("nan"));
  const Json result = result_of(dir / "out");
  CHECK(result["cost"]["value"] == 5);
  CHECK(result["cost"]["error_estimate"].is_null());
  CHECK_FALSE(std::regex_search(content(dir / "out/report.html"), std::regex("[^a-z]nan[^a-z]")));
}

TEST_CASE("run: a ring is closed in every file") {
  const ScratchDir dir;
  run_file(write(dir / "ring.yaml", content(project_dir() / "configs/ring_collapses.yaml")), dir / "out");
  CHECK(result_of(dir / "out")["status"] == "collapsed");
  CHECK(result_of(dir / "out")["ends"].is_null());
  CHECK(csv(dir / "out/path.csv").size() == 33);
  CHECK_THAT(content(dir / "out/path.vtp"), Contains(" 31 0\n"));
}

TEST_CASE("run: a loop with a fixed point begins and ends there") {
  const ScratchDir dir;
  run_file(write(dir / "loop.yaml", content(project_dir() / "configs/based_loop.yaml")), dir / "out");
  const Json r = result_of(dir / "out");
  CHECK(r["status"] == "certified");
  CHECK(r["ring"] == true);
  CHECK(r["points"] == 64);
  CHECK(r["ends"]["source"]["placed"] == Json({0.0, 2.2}));
  CHECK_FALSE(r["ends"].contains("target"));
  const auto rows = csv(dir / "out/path.csv");
  CHECK(rows.size() == 1 + 64 + 2);
}

TEST_CASE("run: ends are placed or refused with their position") {
  const ScratchDir dir;
  write(dir / "pyramid.obj", kPyramid);
  const auto source = [&](const std::string& end) {
    const fs::path file =
        write(dir / "m.yaml", "manifold: {type: mesh, file: pyramid.obj}\ncost: euclidean\nends:\n  source: " + end +
                                  "\n  target: {vertex: 3}\npath: {points: 4}\n");
    try {
      const Run prepared = load_run(file);
      return "moved " + std::to_string(prepared.parts.source.moved);
    } catch (const ConfigError& e) {
      return std::string(e.what());
    }
  };
  CHECK(source("{vertex: 1}") == "moved 0.000000");
  CHECK(source("{point: [0, 0, 1.01]}") == "moved 0.010000");
  CHECK_THAT(source("{point: [0, 0, 2]}"), Contains("m.yaml:4:19: error: 'point' in ends.source: the nearest point of "
                                                    "the manifold is 1 away, but the tolerance is 0.03"));
  CHECK(source("{point: [0, 0, 2], tolerance: 1}") == "moved 1.000000");
  CHECK_THAT(source("{vertex: 5}"),
             Contains("m.yaml:4:20: error: 'vertex' in ends.source: the mesh has vertices 0 to 4, not 5"));
  CHECK_THAT(source("{face: 4, barycentric: [1, 0, 0]}"), Contains("the mesh has faces 0 to 3, not 4"));
  CHECK_THAT(source("{face: 0, barycentric: [1, 1, 0]}"), Contains("must have sum 1, not 2"));
  CHECK_THAT(source("{vertex: 3}"), Contains("is the same point as the source"));
}

TEST_CASE("run: ends that only rounding tells apart are one place") {
  const ScratchDir dir;
  std::ostringstream cloud;
  cloud.precision(17);
  for (int i = 0; i < 40; ++i)
    for (int j = 0; j < 40; ++j) cloud << 0.1 * i << ' ' << 0.1 * j << ' ' << 0.1 * std::sin(0.3 * i) << '\n';
  write(dir / "c.xyz", cloud.str());
  write(dir / "pyramid.obj", kPyramid);
  const std::vector<std::pair<std::string, std::vector<double>>> domains = {
      {"euclidean", {1, 1}},
      {"{type: euclidean, dimension: 5}", {1, 2, 3, 4, 5}},
      {"{type: euclidean, lower: [0, 0, 0], upper: [4, 4, 4]}\nobstacles: [{type: ball, center: [3, 3, 3], radius: "
       "0.5}]",
       {1, 1, 1}},
      {"{type: implicit, surface: sphere}", {0.6, 0.8, 0}},
      {"{type: parametric, surface: torus}", {0.5, 1}},
      {"{type: earth}", {50, 10}},
      {"{type: point_cloud, file: c.xyz}", {0.1, 0.1, 0.1 * std::sin(0.3)}},
      {"{type: mesh, file: pyramid.obj}", {0.5, 0, 0.5}}};
  for (const auto& [domain, place] : domains) {
    std::vector<double> other = place;
    other[0] = std::nextafter(other[0], 100.0);
    const auto text = [](const std::vector<double>& x) {
      std::ostringstream out;
      out.precision(17);
      for (std::size_t i = 0; i < x.size(); ++i) out << (i > 0 ? ", " : "[") << x[i];
      return out.str() + "]";
    };
    const fs::path file =
        write(dir / "one.yaml", "manifold: " + domain + "\ncost: euclidean\nends: {source: {point: " + text(place) +
                                    "}, target: {point: " + text(other) + "}}\n");
    INFO(domain);
    CHECK_THROWS_WITH(solve(load_run(file), {}), Contains("same point"));
  }
  // Where vertices are known to 1e-12 of an edge, the shortest path has one point.
  for (const double apart : {1e-13, 3e-14, 1e-15}) {
    std::ostringstream ends;
    ends.precision(17);
    ends << "ends: {source: {point: [0, 0, 1]}, target: {point: [" << apart << ", 0, 1]}}\n";
    const fs::path file =
        write(dir / "m.yaml", "manifold: {type: mesh, file: pyramid.obj}\ncost: euclidean\n" + ends.str());
    INFO(apart);
    CHECK_THROWS_WITH(solve(load_run(file), {}),
                      Contains("one point only: source and target are") && Contains("path.ring: true"));
  }
}

TEST_CASE("run: missing and broken data are input errors") {
  const ScratchDir dir;
  const fs::path file = write(dir / "m.yaml", kOnPyramid);
  CHECK_THROWS_AS(load_run(file), InputError);
  write(dir / "pyramid.obj", "v 0 0 zero\n");
  CHECK_THROWS_AS(load_run(file), InputError);
  CHECK_FALSE(fs::exists(dir / "results"));
}

namespace {

/// A sheet of 4 x 2 squares that is folded by 180 degrees over x = 0.
std::string folded_sheet(double away = 0) {
  std::ostringstream text;
  text.precision(17);
  for (int i = 0; i <= 4; ++i)
    for (int j = 0; j <= 2; ++j) text << "v " << away + std::abs(i - 2) * 0.5 << ' ' << away + j * 0.5 << " 0\n";
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 2; ++j) {
      const int a = 3 * i + j + 1, b = a + 3;
      text << "f " << a << ' ' << b << ' ' << b + 1 << "\nf " << a << ' ' << b + 1 << ' ' << a + 1 << '\n';
    }
  return text.str();
}

/// Three sheets that meet in the x axis, each of two squares.
std::string three_sheets() {
  std::string text = "v 0 0 0\nv 1 0 0\nv 2 0 0\n";
  for (const char* side : {"1 0", "-0.5 0.8", "-0.6 -0.7"})
    for (const char* x : {"0.1", "1.1", "2.1"}) text += std::string("v ") + x + " " + side + "\n";
  for (int k = 0; k < 3; ++k)
    for (int i = 1; i <= 2; ++i) {
      const int c = 3 + 3 * k + i;
      const auto face = [&](int p, int q, int r) {
        text += "f " + std::to_string(p) + " " + std::to_string(q) + " " + std::to_string(r) + "\n";
      };
      face(i, i + 1, c + 1);
      face(i, c + 1, c);
    }
  return text;
}

app::WrittenRun between(const fs::path& folder, const std::string& mesh, const std::string& source,
                        const std::string& target, int points) {
  write(folder / "mesh.obj", mesh);
  return run_file(
      write(folder / "run.yaml", "manifold: {type: mesh, file: mesh.obj}\ncost: euclidean\nends: {source: {" + source +
                                     "}, target: {" + target + "}}\npath: {points: " + std::to_string(points) + "}\n"),
      folder / "out");
}

}  // namespace

/// What is proved is not refused for what rounding makes of a tiny segment, or of a place that is passed twice.
TEST_CASE("run: proved paths between ends almost at a vertex and between near ends are certified") {
  const struct {
    const char *source, *target;
    int points;
  } cases[] = {
      {"face: 4, barycentric: [6.6e-14, 0.99999999999986, 7.4e-14]",
       "face: 11, barycentric: [2.7e-14, 0, 0.999999999999973]", 10},
      {"face: 4, barycentric: [0.9999999946809134, 5.319086640141959e-09, 0]", "face: 4, barycentric: [1, 0, 0]", 700},
      {"face: 5, barycentric: [0, 1, 0]", "face: 5, barycentric: [0, 0.999999979709255, 2.029074502654787e-08]", 300},
      {"face: 0, barycentric: [0.3, 0.3, 0.4]", "face: 13, barycentric: [0.2, 0.3, 0.5]", 300},
      {"face: 3, barycentric: [0.1, 0.3, 0.6]", "face: 12, barycentric: [0.1, 0.3, 0.6]", 37},
  };
  for (const double away : {0.0, 1e6})
    for (const auto& one : cases) {
      if (away > 0 && one.points != 37 && one.source[6] != '0') continue;  // nearer than positions are known there
      INFO(one.source << " to " << one.target << ", " << away << " from the origin");
      ScratchDir folder;
      const app::WrittenRun run = between(folder.path(), folded_sheet(away), one.source, one.target, one.points);
      const Json result = result_of(folder / "out");
      INFO(result["failures"].dump());
      CHECK(result["certified"] == true);
    }
}

/// As `field --to` does.
TEST_CASE("run: a path over an edge of three faces is proved by default") {
  ScratchDir folder;
  between(folder.path(), three_sheets(), "face: 0, barycentric: [0.2, 0.2, 0.6]",
          "face: 6, barycentric: [0.1, 0.4, 0.5]", 20);
  const Json result = result_of(folder / "out");
  INFO(result["failures"].dump());
  CHECK(result["certified"] == true);
  CHECK(result["scope"] == "global_on_polyhedron");
}

/// A floor of 2 km and a ball a kilometre away are no reason to doubt the plan of an arm of one metre.
TEST_CASE("run: the plan of an arm is certified beside what is huge or far off") {
  for (const char* far :
       {"{type: box, lower: [-1000, -1000, -1], upper: [1000, 1000, -0.5]}",
        "{type: ball, center: [1000, 0, 0], radius: 1}", "{type: ball, center: [1000, 0, 0], radius: 998}",
        "{type: ball, center: [1000000, 0, 0], radius: 1}", "{type: half_space, normal: [0, 0, 1], offset: -300}"}) {
    INFO(far);
    ScratchDir folder;
    run_file(write(folder / "arm.yaml",
                   "manifold: robot\nrobot: {type: dh_arm, model: panda}\nobstacles:\n"
                   "  - {type: ball, center: [0.55, 0, 0.45], radius: 0.12}\n"
                   "  - {type: ball, center: [0.45, 0.35, 0.95], radius: 0.1}\n  - " +
                       std::string(far) +
                       "\nclearance: 0.02\ncost: euclidean\nends:\n"
                       "  source: {point: [-1.2, 0.4, 0, -1.8, 0, 2.2, 0.7]}\n"
                       "  target: {point: [1.2, 0.5, 0.1, -1.6, 0.2, 2.1, -0.5]}\npath: {points: 50}\n"),
             folder / "out");
    const Json result = result_of(folder / "out");
    INFO(result["failures"].dump());
    CHECK(result["certified"] == true);
  }
}

}  // namespace leastcost::test
