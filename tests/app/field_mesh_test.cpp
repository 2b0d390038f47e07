// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// `leastcost field` on meshes: against distances by hand, `leastcost distances`, and Dijkstra's search over points on
// the edges.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <queue>
#include <random>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "tests/app/called.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/data.hpp"
#include "tests/support/trials.hpp"

namespace leastcost::test {
namespace {

namespace fs = std::filesystem;
using Catch::Contains;
using Json = nlohmann::json;

/// A square of two triangles folded along its diagonal, and a triangle apart.
const char* const kFold = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 9 0 0\nv 9 1 0\nv 9 0 1\nf 1 2 3\nf 2 4 3\nf 5 6 7\n";

std::string config_of(const std::string& mesh, int source, int target, const std::string& cost = "euclidean") {
  std::ostringstream out;
  out << "manifold: {type: mesh, file: " << mesh << "}\ncost: " << cost << "\nends:\n  source: {vertex: " << source
      << "}\n  target: {vertex: " << target << "}\n";
  return out.str();
}

/// A bumpy sheet of n x n vertices.
struct Sheet {
  Sheet(std::uint32_t seed, int n) : size(n) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> height(0, 0.8), shift(-0.25, 0.25);
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) positions.emplace_back(i + shift(random), j + shift(random), height(random));
    for (int j = 0; j + 1 < n; ++j)
      for (int i = 0; i + 1 < n; ++i) {
        const int a = j * n + i;
        if (random() % 4 == 0 && i > 0 && j > 0 && i + 2 < n && j + 2 < n && (i + j) % 2 == 0)
          continue;  // a hole; no vertex loses all faces
        faces.push_back({a, a + 1, a + n + 1});
        faces.push_back({a, a + n + 1, a + n});
      }
  }
  std::string obj() const {
    std::ostringstream out;
    out.precision(17);
    for (const Eigen::Vector3d& p : positions) out << "v " << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
    for (const auto& f : faces) out << "f " << f[0] + 1 << ' ' << f[1] + 1 << ' ' << f[2] + 1 << '\n';
    return out.str();
  }
  int size;
  std::vector<Eigen::Vector3d> positions;
  std::vector<std::array<int, 3>> faces;
};

/// Distances from vertices by Dijkstra's search over the vertices and `more` points in each edge, joined within faces:
/// never too short, and too long by about 1 / more^2 / 8.
std::vector<double> over_points_on_edges(const Sheet& sheet, const std::vector<int>& sources, int more) {
  std::vector<Eigen::Vector3d> nodes = sheet.positions;
  std::map<std::pair<int, int>, int> first_of_edge;
  std::vector<std::vector<int>> around(sheet.positions.size());
  std::vector<std::vector<int>> on_face;
  for (const auto& face : sheet.faces) {
    std::vector<int> here(face.begin(), face.end());
    for (std::size_t k = 0; k < 3; ++k) {
      const std::pair<int, int> edge = std::minmax(face[k], face[(k + 1) % 3]);
      if (first_of_edge.emplace(edge, static_cast<int>(nodes.size())).second)
        for (int i = 1; i <= more; ++i) {
          const double t = double(i) / (more + 1);
          nodes.emplace_back((1 - t) * sheet.positions[static_cast<std::size_t>(edge.first)] +
                             t * sheet.positions[static_cast<std::size_t>(edge.second)]);
        }
      for (int i = 0; i < more; ++i) here.push_back(first_of_edge[edge] + i);
    }
    on_face.push_back(std::move(here));
  }
  std::vector<std::vector<int>> faces_of(nodes.size());
  for (std::size_t f = 0; f < on_face.size(); ++f)
    for (const int node : on_face[f]) faces_of[static_cast<std::size_t>(node)].push_back(static_cast<int>(f));
  std::vector<double> distance(nodes.size(), std::numeric_limits<double>::infinity());
  std::priority_queue<std::pair<double, int>, std::vector<std::pair<double, int>>, std::greater<>> queue;
  for (const int source : sources) queue.emplace(distance[static_cast<std::size_t>(source)] = 0, source);
  while (!queue.empty()) {
    const auto [d, node] = queue.top();
    queue.pop();
    if (d > distance[static_cast<std::size_t>(node)]) continue;
    for (const int f : faces_of[static_cast<std::size_t>(node)])
      for (const int to : on_face[static_cast<std::size_t>(f)]) {
        const auto at = static_cast<std::size_t>(to);
        const double there = d + (nodes[at] - nodes[static_cast<std::size_t>(node)]).norm();
        if (there < distance[at]) queue.emplace(distance[at] = there, to);
      }
  }
  distance.resize(sheet.positions.size());
  return distance;
}

}  // namespace

TEST_CASE("field on a mesh: exact lengths as CSV, NPY, VTP and PLY, and the summary") {
  const ScratchDir dir;
  text_file(dir / "fold.obj", kFold);
  const std::string config = text_file(dir / "fold.yaml", config_of("fold.obj", 0, 3));
  const auto field = [&](const std::string& file, std::vector<std::string> more = {}) {
    std::vector<std::string> all = {"field", config, "-o", (dir / file).string()};
    all.insert(all.end(), more.begin(), more.end());
    return call(all);
  };
  const Called csv = field("f.csv");
  CHECK(csv.exit == 0);
  CHECK_THAT(csv.out, Contains("7 vertices, 4 reached, the largest value 1.41421 length") && Contains("proved"));
  CHECK_THAT(content(dir / "f.csv"), Contains("vertex,x,y,z,cost\n0,0,0,0,0\n") && Contains("\n3,1,1,0,1.41421356") &&
                                         Contains("\n5,9,1,0,nan\n"));
  CHECK(field("f.NPY").exit == 0);
  const std::vector<double> numbers = npy_numbers(dir / "f.NPY");
  REQUIRE(numbers.size() == 7);
  CHECK(numbers[3] == Approx(std::sqrt(2.0)).epsilon(1e-14));
  CHECK(std::isnan(numbers[6]));
  CHECK(field("f.vtp").exit == 0);
  CHECK_THAT(content(dir / "f.vtp"), Contains("Scalars=\"cost\"") && Contains("1.41421356"));
  CHECK(field("f.ply").exit == 0);
  CHECK_THAT(content(dir / "f.ply"), Contains("property double cost\n") && Contains("9 0 1 -1 0\n3 0 1 2\n"));

  const Called way = field("f.csv", {"--from", "0", "--from", "1,0,0", "--to", "3", "--to", "0.25,1,0", "--way",
                                     (dir / "way.csv").string(), "--format", "json"});
  CHECK(way.exit == 0);
  const Json summary = Json::parse(way.out);
  CHECK(summary["method"] == "exact windows");
  CHECK(summary["vertices"] == 7);
  CHECK(summary["from"] == Json::parse("[[0.0, 0.0, 0.0], [1.0, 0.0, 0.0]]"));
  CHECK(summary["error"]["largest"] < 1e-12);
  CHECK(summary["ways"][0]["cost"].get<double>() == Approx(1));
  CHECK(summary["ways"][1]["cost"].get<double>() == Approx(std::hypot(0.25, 1)));
  CHECK_THAT(content(dir / "way.csv"), Contains("way,x,y,z\n0,1,0,0\n") && Contains("\n1,0.25,1,0\n"));
  const std::string list = text_file(dir / "places.txt", "# two\n0\n1,0,0\n");
  CHECK(field("g.csv", {"--from", list}).exit == 0);
  CHECK(content(dir / "g.csv") == content(dir / "f.csv"));

  CHECK(field("c.csv", {"--corridor"}).exit == 0);
  CHECK_THAT(content(dir / "c.csv"), Contains("\n0,0,0,0,0\n") && Contains("\n1,1,0,0,0.58578643"));
}

TEST_CASE("field on a mesh: a corridor is more than the shortest path, which may lead through no vertex") {
  const ScratchDir dir;
  text_file(dir / "big.obj", "v 0 0 0\nv 100 0 0\nv 0 100 0\nv 100 100 0\nf 1 2 3\nf 2 4 3\n");
  const std::string config = text_file(dir / "big.yaml", "manifold: {type: mesh, file: big.obj}\ncost: euclidean\n");
  const Called called =
      call({"field", config, "-o", (dir / "c.npy").string(), "--from", "30,30,0", "--to", "31,30,0", "--corridor"});
  CHECK(called.exit == 0);
  const std::vector<double> detour = npy_numbers(dir / "c.npy");
  REQUIRE(detour.size() == 4);
  const double near = std::hypot(30, 30) + std::hypot(31, 30) - 1, right = std::hypot(70, 30) + std::hypot(69, 30) - 1;
  CHECK(detour[0] == Approx(near).epsilon(1e-12));
  CHECK(detour[1] == Approx(right).epsilon(1e-12));
  text_file(dir / "two.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 5 0 0\nv 6 0 0\nv 5 1 0\nf 1 2 3\nf 4 5 6\n");
  const std::string two = text_file(dir / "two.yaml", "manifold: {type: mesh, file: two.obj}\ncost: euclidean\n");
  const Called nothing =
      call({"field", two, "-o", (dir / "n.csv").string(), "--from", "3", "--from", "4", "--from", "5"});
  CHECK(nothing.exit == 5);
  CHECK_THAT(nothing.out, Contains("note: no path leads farther than the place itself"));
}

TEST_CASE("field on a mesh: what it refuses, in one sentence") {
  const ScratchDir dir;
  text_file(dir / "fold.obj", kFold);
  const std::string config = text_file(dir / "fold.yaml", config_of("fold.obj", 0, 3)), out = (dir / "f.csv").string();
  const auto refused = [&](std::vector<std::string> more, int exit, const std::string& words) {
    std::vector<std::string> all = {"field", config, "-o", out};
    all.insert(all.end(), more.begin(), more.end());
    const Called called = call(all);
    CHECK(called.exit == exit);
    CHECK_THAT(called.err, Contains(words));
    CHECK_FALSE(fs::exists(out));
  };
  refused({"--from", "1,2"}, 4,
          "--from: expected the number of a vertex, from 0, or a point like 3.5,-2,1, found '1,2'");
  refused({"--from", "x"}, 4, "--from x: there is no such file, and it is not a place like 12 (a vertex) or 3.5,-2,1");
  refused({"--from", "70"}, 4, "--from 70: ");
  refused({"--to", "5"}, 6, "--to 5: no path on the mesh leads there");
  refused({"--resolution", "1"}, 3, "on a mesh the nodes are its vertices");
  CHECK_THAT(call({"field", config, "-o", (dir / "f.asc").string()}).err,
             Contains("a field on a mesh can be written as .csv, .npy, .vtp or .ply"));
  const std::string fall = text_file(
      dir / "fall.yaml", config_of("fold.obj", 0, 3, "{type: refractive_index, index: {type: formula, n: \"2\"}}"));
  CHECK_THAT(call({"field", fall, "-o", out}).err, Contains("on a mesh the values are lengths"));
  const std::string apart = text_file(dir / "apart.yaml", config_of("fold.obj", 0, 5));
  CHECK_THAT(call({"field", apart, "-o", out, "--corridor"}).err, Contains("no path joins the two"));
}

TEST_CASE("field on a map: exact lengths to the vertices of its free cells, and a way in the plane") {
  const ScratchDir dir;
  const std::string map = (project_dir() / "configs/map_rooms.yaml").string();
  const Called called = call({"field", map, "-o", (dir / "f.csv").string(), "--to", "23.5,11.5", "--way",
                              (dir / "way.csv").string(), "--format", "json"});
  CHECK(called.exit == 0);
  // The path of the configuration alone, which is of another class, has the length 23.328.
  // Round corners of the walls at (12, 6), (14, 7), (17, 8) and (22, 10).
  const double around =
      std::hypot(9.5, 3.5) + std::hypot(2, 1) + std::hypot(3, 1) + std::hypot(5, 2) + std::hypot(1.5, 1.5);
  CHECK(Json::parse(called.out)["ways"][0]["cost"].get<double>() == Approx(around).epsilon(1e-12));
  CHECK_THAT(content(dir / "way.csv"), Contains("way,x,y\n0,2.5,2.5\n") && Contains("\n0,23.5,11.5\n"));
}

TEST_CASE("field on a mesh: 100 random sheets against a search over points on their edges") {
  const ScratchDir dir;
  const int sheets = kSanitized ? 10 : 100;
  for (int seed = 1; seed <= sheets; ++seed) {
    const Sheet sheet(static_cast<std::uint32_t>(seed), 6);
    text_file(dir / "sheet.obj", sheet.obj());
    const int source = seed % 36, other = (7 * seed + 11) % 36, target = source == 35 ? 34 : 35;
    const std::string config = text_file(dir / "sheet.yaml", config_of("sheet.obj", source, target));
    const Called called = call({"field", config, "-o", (dir / "f.npy").string(), "--from", std::to_string(source),
                                "--from", std::to_string(other), "--to", std::to_string(target), "--format", "json"});
    CAPTURE(seed, called.err);
    REQUIRE(called.exit == 0);
    const std::vector<double> found = npy_numbers(dir / "f.npy");
    const std::vector<double> reference = over_points_on_edges(sheet, {source, other}, 15);
    REQUIRE(found.size() == reference.size());
    for (std::size_t v = 0; v < found.size(); ++v) {
      CAPTURE(v, found[v], reference[v]);
      if (!std::isfinite(reference[v])) {
        CHECK(std::isnan(found[v]));
        continue;
      }
      CHECK(found[v] <= reference[v] + 1e-12);
      CHECK(reference[v] <= 1.01 * found[v]);
    }
    const Json summary = Json::parse(called.out);
    CHECK(summary["ways"][0]["cost"].get<double>() ==
          Approx(found[static_cast<std::size_t>(target)]).epsilon(1e-12).margin(1e-12));
  }
}

}  // namespace leastcost::test
