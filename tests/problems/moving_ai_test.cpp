// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// Moving AI maps (N. Sturtevant, Benchmarks for grid-based pathfinding, 2012): taut paths against the listed octile
// optima and against routes over cells with straight shortcuts; no blocked cell is cut, by a check in integers.
#include <memory>
#include <string>

#include <leastcost/framework/domain/checks_moves.hpp>
#include <leastcost/framework/search/find_path.hpp>
#include <leastcost/problems/costs/euclidean.hpp>
#include <leastcost/problems/initializers/dijkstra.hpp>
#include <leastcost/problems/initializers/grid.hpp>
#include <leastcost/problems/kernels/kernels.hpp>
#include <leastcost/problems/manifolds/data/map.hpp>
#include <leastcost/problems/manifolds/euclidean.hpp>
#include <leastcost/problems/obstacles/free_space.hpp>
#include <leastcost/problems/obstacles/map_obstacles.hpp>
#include <leastcost/problems/post_processors/straighten.hpp>
#include <leastcost/problems/post_processors/trace.hpp>
#include <leastcost/solvers/lbfgs.hpp>
#include <leastcost/solvers/newton.hpp>
#include "problems/readers/occupancy_reader.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/cell_check.hpp"
#include "tests/support/data.hpp"
#include "tests/support/scenario.hpp"

namespace leastcost::test {
namespace {

struct Benchmark {
  CellRows rows;
  OccupancyGrid grid;
  std::vector<ScenarioPair> pairs;
};

std::optional<Benchmark> load(const std::string& name, std::size_t pairs) {
  const auto map = data_file("planning/" + name + ".map"), scenario = data_file("planning/" + name + ".map.scen");
  if (!map || !scenario) return std::nullopt;
  return Benchmark{read_rows(map->string()), read_moving_ai(content(*map), map->string(), {}),
                   spread_over(read_scenario(*scenario), pairs)};
}

bool cuts(const CellRows& rows, const Points& line) {
  for (Index i = 0; i + 1 < line.cols(); ++i)
    if (cuts_blocked_cell(rows, line.col(i), line.col(i + 1))) return true;
  return false;
}

double length_of_line(const Points& line) {
  return (line.rightCols(line.cols() - 1) - line.leftCols(line.cols() - 1)).colwise().norm().sum();
}

/// Every cell of a route whose turns are given, and its ends.
std::vector<Eigen::Vector2d> all_cells(const Points& turns) {
  std::vector<Eigen::Vector2d> cells;
  for (Index i = 0; i + 1 < turns.cols(); ++i) {
    const Eigen::Vector2d way = turns.col(i + 1) - turns.col(i);
    const int steps = std::max(1, static_cast<int>(std::lround(way.cwiseAbs().maxCoeff())));
    for (int k = 0; k < steps; ++k) cells.emplace_back(turns.col(i) + way * k / steps);
  }
  cells.emplace_back(turns.rightCols(1));
  return cells;
}

/// Length of the route with line-of-sight shortcuts, taken greedily.
double length_with_shortcuts(const CellRows& rows, const Points& turns) {
  const std::vector<Eigen::Vector2d> cells = all_cells(turns);
  Eigen::Vector2d last = cells.front();
  double length = 0;
  for (std::size_t i = 1; i < cells.size(); ++i) {
    if (i + 1 < cells.size() && !cuts_blocked_cell(rows, last, cells[i + 1])) continue;
    length += (cells[i] - last).norm();
    last = cells[i];
  }
  return length;
}

/// The map's own first path, the solve, and the path straightened.
void check_taut_paths(const std::string& name, std::size_t pairs) {
  const auto data = load(name, pairs);
  if (!data) return;
  const auto domain = std::make_shared<const MapManifold>(data->grid);
  FindOptions options;
  options.post_processors = {std::make_shared<const TracePostProcessor>(),
                             std::make_shared<const StraightenPostProcessor>()};
  double relative = 0;
  for (const ScenarioPair& pair : data->pairs) {
    CAPTURE(name, pair.source.transpose(), pair.target.transpose());
    Problem problem{domain, make_euclidean_cost(2), make_kernel<Expm1Square>(), {pair.source}, {pair.target}};
    const Result result = find_path(problem, DijkstraInitializer(), Lbfgs(), options);
    REQUIRE(result.status == Status::certified);
    REQUIRE_FALSE(cuts(data->rows, result.first.path.u));
    REQUIRE_FALSE(cuts(data->rows, result.curve.x));
    REQUIRE(length_of_line(result.curve.x) == Approx(result.curve.cost).epsilon(1e-12));
    REQUIRE(Eigen::Vector2d(result.curve.x.col(0)) == pair.source);
    REQUIRE(Eigen::Vector2d(result.curve.x.rightCols(1)) == pair.target);
    CHECK(length_of_line(result.first.path.u) == Approx(pair.optimum).margin(1.01 * pair.rounding));
    CHECK(result.curve.cost <= pair.optimum + 1.01 * pair.rounding);
    relative += result.curve.cost / length_with_shortcuts(data->rows, result.first.path.u) - 1;
  }
  CHECK(relative / static_cast<double>(data->pairs.size()) < 0);
}

}  // namespace

TEST_CASE("Moving AI: taut paths cut no cell and are no longer than the octile optimum") {
  const auto& [name, pairs] =
      GENERATE(table<const char*, int>({{"arena", 60}, {"arena2", 20}, {"32room_000", 4}, {"maze512-16-0", 4}}));
  check_taut_paths(name, static_cast<std::size_t>(pairs));
}

TEST_CASE("Moving AI: the same for 200 pairs of each map", "[.slow]") {
  check_taut_paths(GENERATE("arena", "arena2", "32room_000", "maze512-16-0"), 200);
}

namespace {

/// First paths of the grid initializer beside the map as obstacles; the delivered path where it is solved for.
void check_clearance(const std::string& name, std::size_t pairs, int points) {
  constexpr double kClearance = 0.4, kRounding = 1e-9;
  const auto data = load(name, pairs);
  if (!data) return;
  EuclideanManifoldOptions plane;
  plane.box.lower = Eigen::Vector2d(0, 0);
  plane.box.upper = Eigen::Vector2d(data->grid.columns, data->grid.rows);
  const auto domain = std::make_shared<const FreeSpace>(std::make_shared<const EuclideanManifold>(plane),
                                                        map_obstacles(data->grid), kClearance);
  const auto least = [&](const Points& line) {
    double distance = 1;
    for (Index i = 0; i + 1 < line.cols(); ++i)
      distance = std::min(distance, distance_from_cells(data->rows, line.col(i), line.col(i + 1), kClearance));
    return distance;
  };
  for (const ScenarioPair& pair : data->pairs) {
    CAPTURE(name, pair.source.transpose(), pair.target.transpose());
    Problem problem{domain, make_euclidean_cost(2), make_kernel<Expm1Square>(), {pair.source}, {pair.target}};
    const GridInitializer grid({.resolution = 1.0, .refinements = 0});
    const FirstPath first = grid.first_path(problem, {});
    CHECK(least(first.path.u) >= kClearance - kRounding);
    CHECK(length_of_line(first.path.u) <= pair.optimum + 1.01 * pair.rounding);
    if (points == 0) continue;
    FindOptions options;
    options.points = points;
    options.certificate.enabled = false;
    const Result result = find_path(problem, grid, Newton(), options);
    CHECK(least(result.curve.x) >= kClearance - kRounding);
    CHECK(result.curve.cost <= length_of_line(first.path.u) * (1 + 1e-3));
  }
}

}  // namespace

TEST_CASE("Moving AI: with a clearance the solved path keeps it", "[.slow]") { check_clearance("arena", 40, 200); }

TEST_CASE("Moving AI: with a clearance the route over the grid keeps it", "[slow_sanitized]") {
  const auto& [name, pairs] =
      GENERATE(table<const char*, int>({{"arena", 20}, {"arena2", 5}, {"32room_000", 1}, {"maze512-16-0", 1}}));
  check_clearance(name, static_cast<std::size_t>(pairs), 0);
}

}  // namespace leastcost::test
