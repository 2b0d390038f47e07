// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// What a report needs to answer clicks, and when it does. What it answers: tests/report.
#include <fstream>

#include <nlohmann/json.hpp>

#include <leastcost/app/report/report.hpp>
#include "app/report/page/clicks_module.hpp"
#include "app/report/page/json_file.hpp"
#include "app/report/run/clicks_part.hpp"
#include "app/run/run.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/data.hpp"

namespace leastcost::test {

namespace fs = std::filesystem;
using Catch::Contains;

namespace {

/// Two triangles; a vertex that no face uses comes first.
const char* const kRoof = "v 9 9 9\nv 0 0 0\nv 1 0 0.25\nv 0 1 0.1234567890123\nv 1 1 0\nf 2 3 4\nf 3 5 4\n";

fs::path folder_of_run(const ScratchDir& dir, const std::string& config) {
  std::ofstream(dir / "roof.obj") << kRoof;
  std::ofstream(dir / "run.yaml") << config;
  const app::WrittenRun outcome = app::run({dir / "run.yaml", {}, dir / "run", true, {"leastcost", "run"}}, {});
  REQUIRE(outcome.output_error == "");
  return dir / "run";
}

std::string page_of(const fs::path& folder) { return make_report(folder).front().content; }

const char* const kOnRoof = R"(manifold: {type: mesh, file: roof.obj}
cost: euclidean
ends: {source: {vertex: 1}, target: {vertex: 4}}
path: {points: 5}
)";

}  // namespace

TEST_CASE("clicks: a mesh goes into a page to the last digit, with the numbers of its file") {
  const ScratchDir dir;
  const fs::path folder = folder_of_run(dir, kOnRoof);
  const auto data = nlohmann::json::parse(app::text_of_file(folder / "clicks.json"));
  CHECK(data.at("mesh").at("vertices").at(8) == 0.1234567890123);
  CHECK(data.at("mesh").at("numbers") == nlohmann::json({1, 2, 3, 4}));
  CHECK(data.at("mesh").at("triangles") == nlohmann::json({0, 1, 2, 1, 3, 2}));
  const std::string page = page_of(folder);
  CHECK_THAT(page, Contains("roof.obj, 4 vertices, from vertex 1 to vertex 4"));
  if (app::clicks_module().empty()) return record_skip("answers to clicks", "built with LEASTCOST_CLICKS=OFF");
  CHECK_THAT(page, Contains("id=\"ask-form\"") && Contains("id=\"solver\"") && Contains("\"file\":\"roof.obj\""));
  CHECK_THAT(page, Contains("\"decimals\":null"));  // no multiple of 1e-12
}

TEST_CASE("clicks: left out where files say so, and where the cost is not the length") {
  const ScratchDir dir;
  const std::string without =
      std::string(kOnRoof) + "output: {files: [result, path, history, scene, config, report]}\n";
  CHECK_FALSE(fs::exists(folder_of_run(dir, without) / "clicks.json"));
  CHECK_THAT(page_of(dir / "run"), !Contains("id=\"ask-form\"") && !Contains("id=\"solver\""));
  std::string metric = kOnRoof;
  metric.replace(metric.find("euclidean"), 9, "{type: metric_tensor, matrix: [[2, 0, 0], [0, 1, 0], [0, 0, 1]]}");
  CHECK_FALSE(fs::exists(folder_of_run(dir, metric) / "clicks.json"));
}

TEST_CASE("clicks: obstacles in the plane by their cores and what is required") {
  const ScratchDir dir;
  const fs::path folder = folder_of_run(dir, R"(manifold: {type: euclidean, lower: [-1, -1]}
obstacles: [{type: ball, center: [2, 0.1], radius: 0.5}, {type: box, lower: [3, 1], upper: [4, 2]}]
clearance: 0.25
cost: euclidean
ends: {source: {point: [0, 0]}, target: {point: [5, 0]}}
path: {points: 9}
)");
  const auto plan = nlohmann::json::parse(app::text_of_file(folder / "clicks.json")).at("plan");
  CHECK(plan.at("counts") == nlohmann::json({1, 4}));
  CHECK(plan.at("required") == nlohmann::json({0.75, 0.25}));
  CHECK(plan.at("corners") == nlohmann::json({2.0, 0.1, 3.0, 1.0, 4.0, 1.0, 4.0, 2.0, 3.0, 2.0}));
  CHECK(plan.at("box").at("upper").at(0).is_null());
  if (!app::clicks_module().empty()) CHECK_THAT(page_of(folder), Contains("id=\"ask-form\"") && Contains("\"frame\":"));
}

TEST_CASE("clicks: a sentence in the place of a mesh that is too large") {
  if (app::clicks_module().empty()) return record_skip("answers to clicks", "built with LEASTCOST_CLICKS=OFF");
  const ScratchDir dir;
  const fs::path folder = folder_of_run(dir, kOnRoof);
  std::ofstream(folder / "clicks.json") << R"({"schema_version":1,"mesh":{"too_large":871306}})";
  CHECK_THAT(page_of(folder),
             Contains("it has 871306 triangles, and the limit of the page is 200000") && !Contains("id=\"solver\""));
}

TEST_CASE("clicks: numbers are packed as differences, and decimals are found where there are any") {
  CHECK(app::packed(std::vector<std::int64_t>{1, 0, 64}, 1) == "AgGAAQ==");  // 2, 1, 128 = 0x80 0x01
  CHECK(app::packed(std::vector<std::int64_t>{5, 7, 5, 7}, 2) == "Cg4AAA==");
  CHECK(app::common_decimals({1, -3, 20}) == 0);
  CHECK(app::common_decimals({0.1, -1.92679e-05}) == 10);
  CHECK(app::common_decimals({0.1, 1.0 / 3}) == -1);
  CHECK(app::common_decimals({1e200}) == -1);
}

}  // namespace leastcost::test
