// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// `leastcost field` in space, and where it says that there is no field.
#include <nlohmann/json.hpp>
#include <string>

#include "tests/app/called.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/data.hpp"

namespace leastcost::test {
namespace {

using Catch::Contains;
using Json = nlohmann::json;

const char* const kHall = R"(manifold: {type: euclidean, dimension: 3, lower: [0, 0, 0], upper: [4, 2, 1]}
obstacles: [{type: ball, center: [2, 1, 0.5], radius: 0.3}]
cost: euclidean
ends:
  source: {point: [1, 1, 0.5]}
  target: {point: [3, 1, 0.5]}
)";

}  // namespace

TEST_CASE("field in space: its files and a way and a corridor") {
  const ScratchDir dir;
  const std::string config = text_file(dir / "room.yaml", kHall);
  const auto field = [&](const std::string& file, std::vector<std::string> more = {}) {
    std::vector<std::string> all = {"field", config, "--resolution", "0.25", "-o", (dir / file).string()};
    all.insert(all.end(), more.begin(), more.end());
    return call(all);
  };
  const Called csv = field("f.csv", {"--to", "3,1,0.5", "--way", (dir / "way.csv").string(), "--format", "json"});
  CHECK(csv.err == "");
  CHECK(csv.exit == 0);
  const Json summary = Json::parse(csv.out);
  CHECK(summary["nodes"] == Json::parse("[17, 9, 5]"));
  CHECK(summary["error"]["largest"] > 0);
  CHECK(summary["ways"][0]["cost"].get<double>() == Approx(2.09).margin(0.03));
  CHECK_THAT(content(dir / "f.csv"),
             Contains("x,y,z,cost\n") && Contains("\n1,1,0.5,0\n") && Contains("\n2,1,0.5,nan\n"));
  CHECK_THAT(content(dir / "way.csv"), Contains("way,x,y,z\n0,1,1,0.5\n") && Contains("\n0,3,1,0.5\n"));
  CHECK(field("f.npy").exit == 0);
  const std::string npy = content(dir / "f.npy");
  CHECK(npy.size() == 128 + 8 * 17 * 9 * 5);
  CHECK_THAT(npy.substr(0, 128), Contains("'shape': (17, 9, 5), }"));
  CHECK(field("f.vti", {"--corridor"}).exit == 0);
  CHECK_THAT(content(dir / "f.vti"),
             Contains("WholeExtent=\"0 16 0 8 0 4\" Origin=\"0 0 0\" Spacing=\"0.25 0.25 0.25\"") &&
                 Contains("Name=\"detour\"") && Contains("\n-1\n"));
  CHECK_THAT(field("f.asc").err, Contains("a field in space can be written as .csv, .npy or .vti"));
  CHECK_THAT(field("f.csv", {"--figure", (dir / "f.svg").string()}).err, Contains("write one in space as .vti"));
  CHECK_THAT(field("f.csv", {"--from", "1,1"}).err, Contains("expected three numbers with commas between them"));
  CHECK_THAT(call({"field", config, "-o", (dir / "g.csv").string()}).out, Contains("81 x 41 x 21 nodes"));
}

TEST_CASE("field: domains without one name what there is instead") {
  const ScratchDir dir;
  const auto refused = [&](const std::string& name) {
    return call({"field", (project_dir() / "configs" / name).string(), "-o", (dir / "f.csv").string()}).err;
  };
  CHECK(refused("earth.yaml").empty());  // charts that close on themselves have fields
  CHECK(refused("torus_parametric.yaml").empty());
  CHECK_THAT(refused("implicit_torus.yaml"), Contains("leastcost run gives the least cost between two places"));
  CHECK_THAT(refused("se2_pose.yaml"), Contains("leastcost run gives the least cost between two places"));
}

}  // namespace leastcost::test
