// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <cmath>
#include <memory>
#include <numbers>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/problem/clearance.hpp>
#include <leastcost/framework/search/find_path.hpp>
#include <leastcost/problems/costs/euclidean.hpp>
#include <leastcost/problems/initializers/dijkstra.hpp>
#include <leastcost/problems/kernels/kernels.hpp>
#include <leastcost/problems/manifolds/data/map.hpp>
#include <leastcost/problems/obstacles/free_space.hpp>
#include <leastcost/problems/obstacles/map_obstacles.hpp>
#include <leastcost/problems/post_processors/straighten.hpp>
#include <leastcost/solvers/lbfgs.hpp>
#include "problems/occupancy/free_mesh.hpp"
#include "problems/readers/occupancy_reader.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/compose.hpp"
#include "tests/support/random.hpp"

namespace leastcost::test {
namespace {

/// A grid from rows of text, the first one lowest.
OccupancyGrid grid_of(const std::vector<std::string>& rows) {
  std::string text =
      "type octile\nheight " + std::to_string(rows.size()) + "\nwidth " + std::to_string(rows[0].size()) + "\nmap\n";
  for (const std::string& row : rows) text += row + "\n";
  return read_moving_ai(text, "a.map", {});
}

OccupancyGrid random_grid(Random& random, int rows, int columns, int of_ten_blocked) {
  std::vector<std::string> text(static_cast<std::size_t>(rows));
  for (std::string& row : text)
    for (int i = 0; i < columns; ++i) row += random.integer(1, 10) <= of_ten_blocked ? '@' : '.';
  text[0][0] = '.';
  return grid_of(text);
}

template <class Read>
std::string refusal_of(Read read) {
  try {
    read();
    return "accepted";
  } catch (const InputError& error) {
    return error.what();
  }
}

std::string map_refusal(const std::string& text) {
  return refusal_of([&] { read_moving_ai(text, "a.map", {}); });
}

std::string pgm_refusal(const std::string& text) {
  return refusal_of([&] { read_pgm(text, "a.pgm"); });
}

double shortest(const OccupancyGrid& grid, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  Problem problem{
      std::make_shared<const MapManifold>(grid), make_euclidean_cost(2), make_kernel<Expm1Square>(), {a}, {b}};
  FindOptions options;
  options.post_processors = {std::make_shared<const StraightenPostProcessor>()};
  const Result result = find_path(problem, DijkstraInitializer(), Lbfgs(), options);
  CHECK(result.status == Status::certified);
  return result.curve.cost;
}

}  // namespace

TEST_CASE("Moving AI reader: cells, and what is wrong, with its line") {
  const OccupancyGrid grid = grid_of({"@.G", "STW"});
  CHECK((grid.rows == 2 && grid.columns == 3));
  CHECK((!grid.free(0, 0) && grid.free(0, 1) && grid.free(0, 2)));
  CHECK((grid.free(1, 0) && !grid.free(1, 1) && !grid.free(1, 2)));
  CHECK((!grid.free(-1, 0) && !grid.free(0, 3) && !grid.free(2, 0)));
  const std::string header = "type octile\nheight 2\nwidth 3\nmap\n";
  CHECK(map_refusal(header + "...\r\n@@@\r\n") == "accepted");
  CHECK_THAT(map_refusal(""), Catch::Contains("a.map:"));
  CHECK_THAT(map_refusal("type tile\n"), Catch::Contains("a.map:1: expected the type octile, found 'tile'"));
  CHECK_THAT(map_refusal("type octile\nwidth 3\n"), Catch::Contains("a.map:2: expected 'height'"));
  CHECK_THAT(map_refusal("type octile\nheight -2\nwidth 3\nmap\n...\n"), Catch::Contains("-2 x 3 cells"));
  CHECK_THAT(map_refusal("type octile\nheight 99999999999\nwidth 99999999999\nmap\n"), Catch::Contains("at most"));
  CHECK_THAT(map_refusal("type octile\nheight 9999\nwidth 9999\nmap\n"), Catch::Contains("bytes left"));
  CHECK_THAT(map_refusal(header + "...\n....\n"), Catch::Contains("a.map:6: expected a row of 3 cells, found 4"));
  CHECK_THAT(map_refusal(header + "...\n.x.\n"), Catch::Contains("a.map:6: cell 1 is 'x'"));
  CHECK_THAT(map_refusal(header + "...\n... .\n"), Catch::Contains("unexpected '.'"));
  CHECK_THAT(map_refusal(header + "......\n"), Catch::Contains("a.map:5:"));
  CHECK_THAT(map_refusal(header + "...\n...\n...\n"), Catch::Contains("more rows"));
}

TEST_CASE("PGM reader: text and binary, and what is wrong") {
  const GreyImage text = read_pgm("P2 # comment\n3 2\n# more\n15\n0 1 2\n3 4 15\n", "a.pgm");
  CHECK((text.rows == 2 && text.columns == 3 && text.maximum == 15));
  CHECK(text.values == std::vector<std::uint16_t>{0, 1, 2, 3, 4, 15});
  const GreyImage bytes = read_pgm(std::string("P5\n2 1\n255\n") + '\x0a' + '\xff', "a.pgm");
  CHECK(bytes.values == std::vector<std::uint16_t>{10, 255});
  const GreyImage wide = read_pgm(std::string("P5 1 1 65535\n") + '\x01' + '\x02', "a.pgm");
  CHECK(wide.values == std::vector<std::uint16_t>{258});
  CHECK_THAT(pgm_refusal("P6\n1 1\n255\nabc"), Catch::Contains("a.pgm:1: expected P2 or P5"));
  CHECK_THAT(pgm_refusal("P5\n4 4\n255\nabc"), Catch::Contains("16 pixels are announced"));
  CHECK_THAT(pgm_refusal("P2\n2 1\n7\n1 8\n"), Catch::Contains("a.pgm:4: a pixel of 8"));
  CHECK_THAT(pgm_refusal("P2\n2 1\n70000\n1 8\n"), Catch::Contains("a.pgm:3:"));
  CHECK_THAT(pgm_refusal("P2\n2 2\n7\n1 7 7\n"), Catch::Contains("the file ends before a pixel"));
  CHECK_THAT(pgm_refusal("P2\n0 2\n7\n"), Catch::Contains("0 cells"));
}

TEST_CASE("occupancy of an image: thresholds, unknown, upside down") {
  const GreyImage image = read_pgm("P2\n2 2\n255\n0 254\n205 100\n", "a.pgm");
  OccupancyOptions options;
  options.cell = 0.5;
  options.origin = Eigen::Vector2d(-1, 2);
  const OccupancyGrid grid = occupancy_of(image, options);
  CHECK((!grid.free(1, 0) && grid.free(1, 1)));   // the first row of the image is the upper one
  CHECK((!grid.free(0, 0) && !grid.free(0, 1)));  // 205: occupancy 0.196 is not below the threshold; 100: 0.61
  CHECK(grid.corner(1, 1) == Eigen::Vector2d(-0.5, 2.5));
  CHECK(grid.unknown == std::vector<bool>{true, true, false, false});
  options.unknown = UnknownCells::free;
  CHECK((occupancy_of(image, options).free(0, 0) && occupancy_of(image, options).free(0, 1)));
  options.negate = true;
  CHECK((occupancy_of(image, options).free(1, 0) && !occupancy_of(image, options).free(1, 1)));
}

TEST_CASE("free boxes part the free cells, blocking boxes hold what can be reached and no free cell") {
  Random random;
  for (int round = 0; round < 50; ++round) {
    const OccupancyGrid grid = random_grid(random, random.integer(1, 12), random.integer(1, 12), round % 10);
    std::vector<int> times(grid.blocked.size(), 0), blocking = times;
    const auto count = [&](const std::vector<CellBox>& boxes, std::vector<int>& in) {
      for (const CellBox& box : boxes)
        for (int row = box.row; row < box.row_end; ++row)
          for (int column = box.column; column < box.column_end; ++column) ++in[grid.index(row, column)];
    };
    count(free_boxes(grid), times);
    count(blocking_boxes(grid), blocking);
    for (int row = 0; row < grid.rows; ++row)
      for (int column = 0; column < grid.columns; ++column) {
        const bool free = grid.free(row, column);
        REQUIRE(times[grid.index(row, column)] == (free ? 1 : 0));
        if (free) REQUIRE(blocking[grid.index(row, column)] == 0);
        bool beside = false;
        for (int r = row - 1; r <= row + 1; ++r)
          for (int c = column - 1; c <= column + 1; ++c) beside = beside || grid.free(r, c);
        if (!free && beside) REQUIRE(blocking[grid.index(row, column)] > 0);
      }
  }
}

TEST_CASE("free mesh: the area of the free cells, joined as the cells are") {
  Random random;
  for (int round = 0; round < 50; ++round) {
    const OccupancyGrid grid = random_grid(random, random.integer(1, 12), random.integer(1, 12), round % 10);
    const TriangleMesh mesh(free_mesh(grid, free_boxes(grid)).triangles);
    CHECK(mesh.non_manifold_edges().empty());
    CHECK(mesh.flipped_halfedges().empty());
    double area = 0, border = 0;
    for (const auto& [a, b, c] : mesh.faces()) {
      const Eigen::Vector3d u = mesh.position(b) - mesh.position(a), v = mesh.position(c) - mesh.position(a);
      REQUIRE(u.x() * v.y() - u.y() * v.x() > 0);
      area += (u.x() * v.y() - u.y() * v.x()) / 2;
    }
    for (std::int32_t h = 0; h < 3 * mesh.face_count(); ++h)
      if (mesh.across(h) == TriangleMesh::kBorder)
        border += (mesh.position(mesh.head(h)) - mesh.position(mesh.tail(h))).norm();
    CHECK(area == Approx(std::count(grid.blocked.begin(), grid.blocked.end(), false)));
    int sides = 0, parts = 0;  // of free cells beside blocked ones; components over sides
    std::vector<int> part(grid.blocked.size(), -1);
    for (int row = 0; row < grid.rows; ++row)
      for (int column = 0; column < grid.columns; ++column) {
        if (!grid.free(row, column)) continue;
        for (const auto& [r, c] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}})
          sides += grid.free(row + r, column + c) ? 0 : 1;
        if (part[grid.index(row, column)] >= 0) continue;
        std::vector<std::pair<int, int>> stack = {{row, column}};
        part[grid.index(row, column)] = parts;
        while (!stack.empty()) {
          const auto [y, x] = stack.back();
          stack.pop_back();
          for (const auto& [r, c] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}})
            if (grid.free(y + r, x + c) && part[grid.index(y + r, x + c)] < 0) {
              part[grid.index(y + r, x + c)] = parts;
              stack.emplace_back(y + r, x + c);
            }
        }
        ++parts;
      }
    CHECK(border == Approx(sides));
    CHECK(static_cast<int>(mesh.component_sizes().size()) == parts);
  }
}

TEST_CASE("map: shortest paths around corners, by hand") {
  const OccupancyGrid block = grid_of({".....", ".....", "..@..", ".....", "....."});
  // Around the corners (2, 3) and (3, 3) of the block, or below it: both are as long.
  CHECK(shortest(block, {0.5, 2.5}, {4.5, 2.5}) == Approx(2 * std::hypot(1.5, 0.5) + 1).epsilon(1e-14));
  CHECK(shortest(block, {0.5, 3.0}, {4.5, 3.0}) == Approx(4).epsilon(1e-14));  // along the wall
  CHECK(shortest(block, {0.5, 0.5}, {4.5, 4.5}) == Approx(2 * std::hypot(1.5, 2.5)).epsilon(1e-14));
  const OccupancyGrid door = grid_of({".....", "@@@@.", "....."});
  CHECK(shortest(door, {0, 0}, {0, 3}) == Approx(2 * std::hypot(4, 1) + 1).epsilon(1e-14));
}

TEST_CASE("map: two blocked cells that touch in a corner leave no way between them") {
  const OccupancyGrid pinched = grid_of({".@", "@."});
  Problem problem{std::make_shared<const MapManifold>(pinched),
                  make_euclidean_cost(2),
                  make_kernel<Expm1Square>(),
                  {Eigen::Vector2d(0.5, 0.5)},
                  {Eigen::Vector2d(1.5, 1.5)}};
  CHECK_THROWS_AS(find_path(problem, DijkstraInitializer(), Lbfgs(), {}), InitializationError);
  const std::string why = refusal_of([&] { MapManifold(grid_of({"@@", "@@"})); });
  CHECK_THAT(why, Catch::Contains("no free cell"));
  CHECK_THAT(refusal_of([] { map_obstacles(grid_of({"..", ".."})); }), Catch::Contains("no blocked cell"));
}

TEST_CASE("map obstacles: an end in unknown cells is refused as one, with the option that lets it be there") {
  const GreyImage image = read_pgm("P2\n4 1\n255\n254 100 0 254\n", "a.pgm");  // free, unknown, occupied, free
  OccupancyOptions options;
  const auto why_at = [&](double x) {
    Problem problem;
    problem.manifold = std::make_shared<const FreeSpace>(space(2), map_obstacles(occupancy_of(image, options)), 0.1);
    return why_in_clearance(problem, {Eigen::Vector2d(x, 0.5)});
  };
  CHECK_THAT(why_at(1.5), Catch::Contains("the unknown cells") && Catch::Contains("unknown: free"));
  CHECK_THAT(why_at(2.5), Catch::Contains("the box from"));
  CHECK(why_at(0.5).empty());
  options.unknown = UnknownCells::free;
  CHECK(why_at(1.5).empty());
}

}  // namespace leastcost::test
