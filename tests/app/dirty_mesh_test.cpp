// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// Runs on meshes with faults: what is solved is delivered, whatever becomes of its curve.
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/app/called.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/data.hpp"

namespace leastcost::test {

namespace fs = std::filesystem;
using Catch::Contains;
using Json = nlohmann::json;

namespace {

/// Three sheets that meet in the edge from vertex 0 to vertex 1; paths from one to another cross it.
const char* const kThreeSheets = "v 0 0 0\nv 0 1 0\nv -1 0.5 0\nv 1 0.5 0\nv 0 0.5 1\nf 1 2 3\nf 2 1 4\nf 1 2 5\n";

fs::path write(const fs::path& file, const std::string& text) {
  std::ofstream(file) << text;
  return file;
}

}  // namespace

TEST_CASE("run: without a proof a path over an edge with three faces is delivered, uncertified, with the reason") {
  const ScratchDir dir;
  write(dir / "sheets.obj", kThreeSheets);
  const int subdivide = GENERATE(0, 1);
  const std::string config =
      "manifold: {type: mesh, file: sheets.obj, subdivide: " + std::to_string(subdivide) +
      "}\ncost: euclidean\nends:\n  source: {point: [-0.5, 0.4, 0]}\n  target: {point: [0.5, 0.7, 0]}\n"
      "path: {points: 9}\ncertificate: {global: off}\n";
  const std::string out = (dir / "out").string();
  const Called run = call({"run", write(dir / "a.yaml", config).string(), "-o", out, "--format", "json"});
  CHECK(run.exit == 5);
  const Json result = Json::parse(run.out);
  CHECK(result["status"] == "uncertified");
  REQUIRE(result["failures"].size() == 1);
  CHECK(result["failures"][0]["name"] == "post_process");
  const std::string message = result["failures"][0]["message"];
  CHECK_THAT(message, Contains("three or more faces"));
  if (subdivide == 0) CHECK_THAT(message, Contains("vertex 0") && Contains("vertex 1"));
  if (subdivide > 0) CHECK_THAT(message, Contains("the vertex that subdivision made at (0, 0.5, 0)"));
  for (const char* file : {"path.csv", "curve.csv", "report.html"}) CHECK(fs::exists(dir / "out" / file));
  CHECK_THAT(content(dir / "out/report.html"), Contains("three or more faces"));
}

TEST_CASE("run: a soup whose corners are off by rounding is joined by the weld that messages name") {
  const ScratchDir dir;
  // A square of two triangles that share no corners.
  write(dir / "soup.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 1e-7\nv 1e-7 1 0\nv 1 -1e-7 0\nf 1 2 3\nf 4 5 6\n");
  const auto run = [&](const std::string& weld) {
    const std::string config = "manifold: {type: mesh, file: soup.obj, weld: " + weld +
                               "}\ncost: euclidean\nends: {source: {vertex: 0}, target: {vertex: 3}}\n";
    return call(
        {"run", write(dir / "a.yaml", config).string(), "-o", (dir / "out").string(), "--force", "--format", "json"});
  };
  const Called loose = run("true");
  CHECK(loose.exit == 6);
  CHECK_THAT(loose.out + loose.err, Contains("`weld: 1e-6` those no farther apart"));
  const Called joined = run("1e-6");
  CHECK(joined.exit == 0);
  CHECK(Json::parse(joined.out)["global"]["seconds"].get<double>() > 0);
  CHECK(Json::parse(joined.out)["cost"]["value"].get<double>() == Approx(std::sqrt(2.0)).epsilon(1e-6));

  const std::string mesh = (dir / "soup.obj").string();
  const Called doctor = call({"doctor", mesh});
  CHECK(doctor.exit == 4);
  CHECK_THAT(doctor.out, Contains("border vertices close to an earlier one: 2 (4, 5)") &&
                             Contains("try weld: 1e-06 (length units)"));
  CHECK_THAT(call({"doctor", mesh, "--weld=1e-6"}).out,
             Contains("2 vertices merged into others up to 1e-07 away") && Contains("1 component,"));
  CHECK(call({"distances", mesh, "--from", "0", "--weld=1e-6", "-q"}).exit == 0);
  CHECK_THAT(call({"doctor", mesh, "--weld=-1"}).err, Contains("a distance above 0"));
}

TEST_CASE("run: paths on dirty models are delivered") {
  const ScratchDir dir;
  for (const std::string name : {"fan3.obj", "horse_dirty.obj", "motor_soup.stl", "teapot_dirty.obj"}) {
    const auto file = data_file("meshes/" + name);
    if (!file) continue;
    CAPTURE(name);
    const std::string config = "manifold: {type: mesh, file: '" + file->string() +
                               "'}\ncost: euclidean\nends: {source: {vertex: 0}, target: {vertex: 1}}\n"
                               "path: {points: 20}\nmax_seconds: 20\n";
    const Called run = call({"run", write(dir / "a.yaml", config).string(), "-o", (dir / name).string(), "-q"});
    CAPTURE(run.err);
    CHECK((run.exit == 0 || run.exit == 5 || run.exit == 6));
    CHECK(fs::exists(dir / name / "path.csv") == (run.exit != 6));
  }
}

}  // namespace leastcost::test
