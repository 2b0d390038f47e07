// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "catalogue/scene/scene.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/problems/manifolds/parametric.hpp>
#include <leastcost/problems/post_processors/bracket.hpp>
#include "problems/drawing/domain_shapes.hpp"
#include "problems/drawing/thinned.hpp"
#include "problems/level_set/named_surfaces.hpp"
#include "problems/manifolds/bounded_level_set.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/compose.hpp"
#include "tests/support/words.hpp"

namespace leastcost::test {

using Catch::Contains;

namespace {

/// How many edges have one triangle, and whether any has more than two. Vertices at one place are one.
struct Seams {
  std::size_t open = 0;
  bool manifold = true;
};
Seams seams_of(const TriangleSoup& soup) {
  std::map<std::array<long, 3>, int> number;
  const auto id = [&](int v) {
    std::array<long, 3> key{};
    for (int i = 0; i < 3; ++i)
      key[static_cast<std::size_t>(i)] = std::lround(1e6 * soup.vertices[static_cast<std::size_t>(v)][i]);
    return number.emplace(key, static_cast<int>(number.size())).first->second;
  };
  std::map<std::pair<int, int>, int> edges;
  for (const auto& t : soup.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const int a = id(t[k]), b = id(t[(k + 1) % 3]);
      if (a != b) ++edges[{std::min(a, b), std::max(a, b)}];
    }
  Seams seams;
  for (const auto& [edge, count] : edges) {
    seams.open += count == 1 ? 1 : 0;
    seams.manifold = seams.manifold && count <= 2;
  }
  return seams;
}

Surroundings unit_path() { return {Eigen::Vector3d(0.9, -0.2, 0), Eigen::Vector3d(1, 0.3, 0.2)}; }

TriangleSoup sphere(int n) {
  const auto manifold = make_parametric_manifold({.surface = parametric::Sphere{}});
  Points u(2, 2);
  u << 0, 1, 0, n * 0.1;
  return chart_surface(*manifold, *manifold, u);
}

}  // namespace

TEST_CASE("scene: a closed level set is drawn as a whole, on the surface, without holes") {
  const LevelSet domain(make_sphere_function(3, 1));
  std::vector<std::string> notes;
  const TriangleSoup soup = level_surface(domain, domain.function(), unit_path(), nullptr, notes);
  CHECK(notes.empty());
  CHECK(soup.triangles.size() > 1000);
  for (const Eigen::Vector3d& x : soup.vertices) REQUIRE(x.norm() == Approx(1).margin(1e-12));
  const Seams seams = seams_of(soup);
  CHECK(seams.open == 0);
  CHECK(seams.manifold);
}

TEST_CASE("scene: what goes on is cut, and what lies beyond a bound is not drawn") {
  const LevelSet gyroid(make_gyroid_function(2));
  std::vector<std::string> notes;
  CHECK(level_surface(gyroid, gyroid.function(), unit_path(), nullptr, notes).triangles.size() > 100);
  CHECK(notes.size() == 1);

  BoxOptions box;
  box.lower = Eigen::Vector3d(-2, -2, -2);
  box.upper = Eigen::Vector3d(2, 2, 0.5);
  const BoundedLevelSet cut(make_sphere_function(3, 1), Box(3, box));
  const TriangleSoup soup = level_surface(cut, cut.function(), unit_path(), nullptr, notes);
  double top = -1;
  for (const auto& t : soup.triangles)
    for (const int v : t) top = std::max(top, soup.vertices[static_cast<std::size_t>(v)][2]);
  CHECK(top == Approx(0.5).margin(0.02));
}

TEST_CASE("scene: charts are drawn over whole periods and from pole to pole") {
  CHECK(seams_of(sphere(1)).open == 0);
  for (const char* type : {"torus", "klein_bottle"}) {
    CAPTURE(type);
    const auto manifold = make_parametric_manifold({.surface = form<parametric::Surface>(type)});
    Points u(2, 3);
    u << 5.0, 6.0, 7.2, 0.4, 0.8, 1.1;
    CHECK(seams_of(chart_surface(*manifold, *manifold, u)).open == 0);
  }
  const auto moebius = make_parametric_manifold({.surface = parametric::MoebiusStrip{}});
  Points u(2, 2);
  u << 2.4, 4.2, -0.3, 0.1;
  const TriangleSoup soup = chart_surface(*moebius, *moebius, u);
  double widest = 0;
  for (const Eigen::Vector3d& x : soup.vertices) widest = std::max(widest, x.norm());
  CHECK(widest == Approx(1.5));  // up to its edge
  CHECK(seams_of(soup).open > 0);
}

TEST_CASE("scene: thinning keeps to its budget, and to what is near the path") {
  const TriangleSoup full = sphere(1);
  Points focus(3, 1);
  focus.col(0) = full.vertices[full.vertices.size() / 2];
  const TriangleSoup few = thinned(full, focus, 1500);
  CHECK(few.triangles.size() <= 1500);
  CHECK(few.triangles.size() > 300);
  const auto at_focus = [&](const Eigen::Vector3d& x) { return (x - focus.col(0)).norm() < 1e-12; };
  CHECK(std::any_of(few.vertices.begin(), few.vertices.end(), at_focus));
  for (const Eigen::Vector3d& x : few.vertices) CHECK(x.norm() == Approx(1).margin(0.05));
  CHECK(thinned(full, Points(3, 0), full.triangles.size()).triangles.size() == full.triangles.size());
}

TEST_CASE("scene: the plane shows the cost, and where there is none") {
  const Problem problem = bead(Eigen::Vector2d(0, 0), Eigen::Vector2d(3, -1));
  const Scene scene = make_scene(problem, find(problem, 15));
  REQUIRE(scene.cost);
  CHECK(scene.lines.path.cols() == 17);
  const Raster& raster = *scene.cost;
  CHECK(raster.values.size() == static_cast<std::size_t>(raster.columns) * static_cast<std::size_t>(raster.rows));
  CHECK(std::isinf(raster.values.back()));  // above the level of rest
  // Below it, one over the speed of the fall.
  CHECK(raster.values.front() == Approx(1 / std::sqrt(-2 * raster.lower[1])).epsilon(1e-6));
  CHECK_FALSE(
      make_scene(between(space(2), make_euclidean_cost(2), Eigen::Vector2d(0, 0), Eigen::Vector2d(1, 1)),
                 find(between(space(2), make_euclidean_cost(2), Eigen::Vector2d(0, 0), Eigen::Vector2d(1, 1)), 5))
          .cost);
}

TEST_CASE("scene: the potential that bounds all paths, where they were searched") {
  const Problem problem = between(box(Eigen::Vector2d(-1, -1), Eigen::Vector2d(4, 1)), make_euclidean_cost(2),
                                  Eigen::Vector2d(0, 0), Eigen::Vector2d(3, 0));
  FindOptions options;
  options.points = 15;
  options.post_processors = {std::make_shared<BracketPostProcessor>(GlobalBudget{.tolerance = 1e-3})};
  const Scene scene = make_scene(problem, find_path(problem, StraightInitializer(), Newton(), options));
  REQUIRE(scene.potential);
  const Raster& raster = *scene.potential;
  CHECK(raster.values.size() == static_cast<std::size_t>(raster.columns) * static_cast<std::size_t>(raster.rows));
  double low = 1e9, high = -1e9;
  for (const double value : raster.values)
    if (std::isfinite(value)) low = std::min(low, value), high = std::max(high, value);
  CHECK(high - low > 2.5);  // of the distance 3 of the ends, but for squares around them
  CHECK(high - low < 4.2);  // to the farthest corner it is 4.12
  const Scene again = read_scene(scene_json(scene), "scene.json");
  REQUIRE(again.potential);
  CHECK(again.potential->columns == raster.columns);
  CHECK(std::isfinite(again.potential->values[raster.values.size() / 2]) ==
        std::isfinite(raster.values[raster.values.size() / 2]));
}

TEST_CASE("scene: a map of heights has its ground in the sun, and no other chart has") {
  const auto on_map = [](const parametric::Surface& surface) {
    const Problem problem = between(make_parametric_manifold({.surface = surface}), make_euclidean_cost(3),
                                    Eigen::Vector2d(-1, -1), Eigen::Vector2d(1, 1));
    return make_scene(problem, find(problem, 15));
  };
  const auto by_formula = [](const char* x, const char* y, const char* z) {
    return parametric::Formula{.x = x, .y = y, .z = z};
  };
  const Scene scene = on_map(by_formula("u", "v", "exp(-u^2 - v^2)"));
  REQUIRE(scene.relief);
  const Raster& raster = *scene.relief;
  CHECK(raster.values.size() == static_cast<std::size_t>(raster.columns) * static_cast<std::size_t>(raster.rows));
  const auto at = [&raster](double x, double y) {
    const Eigen::Vector2d part = (Eigen::Vector2d(x, y) - raster.lower).cwiseQuotient(raster.upper - raster.lower);
    const auto i = static_cast<std::size_t>(std::lround(part[0] * (raster.columns - 1))),
               j = static_cast<std::size_t>(std::lround(part[1] * (raster.rows - 1)));
    return raster.values[j * static_cast<std::size_t>(raster.columns) + i];
  };
  CHECK(at(0, 0) == Approx(std::sqrt(0.5)).epsilon(0.01));  // level ground under a sun 45 degrees up
  CHECK(at(-0.5, 0.5) > 0.95);                              // a slope to the north-west
  CHECK(at(0.5, -0.5) < 0.4);
  CHECK(at(0.5, 0.5) == Approx(at(-0.5, -0.5)));
  const Scene again = read_scene(scene_json(scene), "scene.json");
  REQUIRE(again.relief);
  CHECK(again.relief->columns == raster.columns);
  CHECK(again.relief->values.front() == Approx(raster.values.front()).epsilon(1e-3));

  const Scene lake = on_map(by_formula("u", "v", "sqrt(u*v + 1.2)"));  // no ground in two corners
  REQUIRE(lake.relief);
  CHECK(std::isinf(lake.relief->values[static_cast<std::size_t>(lake.relief->columns) - 1]));
  CHECK(std::isfinite(lake.relief->values.front()));

  CHECK_FALSE(on_map(by_formula("u", "v", "u + v")).relief);  // a plane is even
  CHECK_FALSE(on_map(by_formula("v", "u", "exp(-u^2 - v^2)")).relief);
  CHECK_FALSE(on_map(parametric::Sphere{}).relief);
}

TEST_CASE("scene: boxes with open sides, spaces without a picture") {
  const double infinity = std::numeric_limits<double>::infinity();
  const Problem boxed = between(box(Eigen::Vector2d(0, -infinity), Eigen::Vector2d(3, 0)), make_euclidean_cost(2),
                                Eigen::Vector2d(0, 0), Eigen::Vector2d(2, -1));
  const Scene scene = make_scene(boxed, find(boxed, 5));
  REQUIRE(scene.lower.size() == 2);
  CHECK(scene.lower[0] == 0);
  CHECK(std::isinf(scene.lower[1]));
  CHECK(scene.upper == Eigen::VectorXd(Eigen::Vector2d(3, 0)));
  const Problem seven = between(space(7), make_euclidean_cost(7), Eigen::VectorXd::Zero(7), Eigen::VectorXd::Ones(7));
  const Scene none = make_scene(seven, find(seven, 5));
  CHECK(none.dimension == 7);
  CHECK(none.lines.path.size() == 0);
}

TEST_CASE("scene: its file reads back as what was written") {
  Scene scene;
  scene.dimension = 3;
  scene.up = Eigen::Vector3d::UnitY();
  scene.surface = sphere(1);
  scene.lines.path = Points::Random(3, 5);
  scene.lines.first = Points::Random(3, 2);
  scene.lines.others = {Points::Random(3, 4)};
  scene.lower = Eigen::Vector3d(-1, -std::numeric_limits<double>::infinity(), 0);
  scene.upper = Eigen::Vector3d(1, 1, 1);
  scene.surfels = {{Eigen::Vector3d(1, 2, 3)}, {Eigen::Vector3d(0, 0, 1)}, 0.5};
  scene.notes = {"a \"note\" </script>"};
  const Scene read = read_scene(scene_json(scene), "scene.json");
  CHECK(read.up == scene.up);
  CHECK(read.surface.triangles == scene.surface.triangles);
  for (std::size_t i = 0; i < scene.surface.vertices.size(); ++i)
    REQUIRE((read.surface.vertices[i] - scene.surface.vertices[i]).norm() < 2e-6);
  CHECK((read.lines.path - scene.lines.path).norm() < 1e-5);
  CHECK(read.lines.others.size() == 1);
  CHECK(std::isinf(read.lower[1]));
  CHECK(read.notes == scene.notes);
  CHECK(scene_json(read) == scene_json(read_scene(scene_json(read), "again")));
}

TEST_CASE("scene: a damaged file is an error that names it") {
  const auto damaged = GENERATE(
      std::string("{"), std::string("[]"), std::string("{\"dimension\":3}"),
      std::string(R"({"dimension":3,"up":[0,0,1],"notes":[],"surface":{"vertices":[0,0,0],"triangles":[0,0,1]}})"),
      std::string(R"({"dimension":3,"up":[0,0,1],"notes":[],"surface":{"vertices":[0,0],"triangles":[]}})"),
      std::string(R"({"dimension":2,"up":[0,0,1],"notes":[],)"
                  R"("cost":{"columns":3,"rows":2,"lower":[0,0],"upper":[1,1],"values":[1]}})"),
      std::string(R"({"dimension":0,"up":[0,0,1],"notes":[]})"));
  CAPTURE(damaged);
  CHECK_THROWS_WITH(read_scene(damaged, "dir/scene.json"), Contains("dir/scene.json"));
  CHECK_THROWS_AS(read_scene(damaged, "dir/scene.json"), InputError);
}

TEST_CASE("scene: obstacles, margins, the free part and the hand of a robot are written and read") {
  Scene scene;
  scene.dimension = 2;
  Points square(2, 4);
  square << 0, 1, 1, 0, 0, 0, 1, 0;
  scene.lines.path = scene.lines.first = square;
  scene.obstacles = {square};
  scene.margins = {2 * square};
  scene.free = {3 * square, 4 * square};
  scene.strip.poses = {{square}};
  scene.strip.hand = 5 * square;
  scene.strip.hand_in_space = Points::Constant(3, 2, 0.5);
  const Scene read = read_scene(scene_json(scene), "a scene");
  REQUIRE(read.obstacles.size() == 1);
  REQUIRE(read.margins.size() == 1);
  REQUIRE(read.free.size() == 2);
  CHECK(read.curves.empty());
  CHECK(read.obstacles[0].isApprox(square));
  CHECK(read.margins[0].isApprox(2 * square));
  CHECK(read.free[1].isApprox(4 * square));
  CHECK(read.strip.hand.isApprox(5 * square));
  CHECK(read.strip.hand_in_space.isApprox(scene.strip.hand_in_space));
}

TEST_CASE("scene: a robot in space and its obstacles are written and read") {
  Scene scene;
  scene.dimension = 7;
  scene.strip.poses = {{Points::Zero(2, 3)}};
  Workspace& workspace = scene.strip.workspace;
  workspace.unit = "m";
  workspace.lower = {-1, -1, 0};
  workspace.upper = {1, 1, 1};
  workspace.capsules = {{1, {0, 0, 0.25}, {0, 0.5, 0}, 0.125}};
  workspace.plates = {{0, {Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitY()}}};
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitZ()));
  workspace.poses = {{{}, {turn, {1, 2, 3}}}, {{turn, {3, 2, 1}}, {}}};
  workspace.obstacles = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  workspace.notes = {"a note"};
  const std::string text = scene_json(scene);
  const Workspace read = read_scene(text, "a scene").strip.workspace;
  CHECK(read.unit == "m");
  CHECK(read.lower == workspace.lower);
  CHECK(read.upper == workspace.upper);
  REQUIRE(read.capsules.size() == 1);
  CHECK(read.capsules[0].link == 1);
  CHECK(read.capsules[0].to == workspace.capsules[0].to);
  CHECK(read.capsules[0].radius == 0.125);
  REQUIRE(read.plates.size() == 1);
  CHECK(read.plates[0].corners[2] == Eigen::Vector3d::UnitY());
  REQUIRE(read.poses.size() == 2);
  CHECK(read.poses[0][1].turn.angularDistance(turn) < 2e-4);
  CHECK(read.poses[1][0].origin == Eigen::Vector3d(3, 2, 1));
  CHECK(read.obstacles.triangles == workspace.obstacles.triangles);
  CHECK(read.ground.triangles.empty());
  CHECK(read.notes == workspace.notes);
  std::string broken = text;
  broken.replace(broken.find("\"capsules\":[1"), 13, "\"capsules\":[9");
  CHECK_THROWS_AS(read_scene(broken, "a scene"), InputError);
}

}  // namespace leastcost::test
