// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// Least-cost paths on real rasters against the best path over the 16-neighbour grid under the same cost: the length and
// Tobler's walking time on the bicubic terrain, and a smooth cost map with the heights as costs. Random connected
// pairs, both directions. With seconds for a bracket: how far the least cost may be below at most.
//   raster_table FOLDER [PAIRS] [SEED] [SECONDS]     FOLDER: that of jacksboro_dem.csv, volcano.csv and elev.csv
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <limits>
#include <map>
#include <memory>
#include <numeric>
#include <queue>
#include <random>
#include <vector>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/search/find_path.hpp>
#include <leastcost/problems/costs/cost_map.hpp>
#include <leastcost/problems/costs/euclidean.hpp>
#include <leastcost/problems/costs/walking.hpp>
#include <leastcost/problems/initializers/waypoints.hpp>
#include <leastcost/problems/kernels/kernels.hpp>
#include <leastcost/problems/manifolds/data/terrain.hpp>
#include <leastcost/problems/manifolds/euclidean.hpp>
#include <leastcost/problems/post_processors/bracket.hpp>
#include <leastcost/solvers/newton.hpp>
#include "problems/readers/file_content.hpp"
#include "problems/readers/raster_reader.hpp"

namespace {

using namespace leastcost;
namespace fs = std::filesystem;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr int kPieces = 8;  ///< of a grid move, on the surface

struct Task {
  const char* name;
  RasterOptions options;
};

struct Setting {
  RasterGrid raster;
  std::shared_ptr<const ConstraintManifold> manifold;
  std::shared_ptr<const SegmentCost> cost;
};

/// What a straight move on the map costs along the surface.
double cost_on_surface(const Setting& s, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  Points u(2, kPieces + 1);
  for (int i = 0; i <= kPieces; ++i) u.col(i) = a + (b - a) * i / kPieces;
  const Points x = positions(*s.manifold, {u, {}, true});
  return x.allFinite() ? total_cost(*s.cost, {{x.data(), x.rows(), x.cols()}, {}, false}) : kInfinity;
}

/// The least-cost path over moves to 16 neighbours, by Dijkstra's algorithm; empty where there is none.
class GridPaths {
 public:
  explicit GridPaths(const Setting& setting) : s_(setting) {}

  Points find(int from, int to, double& cost) {
    const auto count = static_cast<std::size_t>(s_.raster.rows) * static_cast<std::size_t>(s_.raster.columns);
    std::vector<double> best(count, kInfinity);
    std::vector<int> before(count, -1);
    using Open = std::pair<double, int>;
    std::priority_queue<Open, std::vector<Open>, std::greater<>> open;
    best[static_cast<std::size_t>(from)] = 0;
    open.push({0, from});
    while (!open.empty()) {
      const auto [value, node] = open.top();
      open.pop();
      if (node == to) break;
      if (value > best[static_cast<std::size_t>(node)]) continue;
      each_move(node, [&](int next, double move) {
        double& known = best[static_cast<std::size_t>(next)];
        if (!(value + move < known)) return;
        known = value + move;
        before[static_cast<std::size_t>(next)] = node;
        open.push({known, next});
      });
    }
    cost = best[static_cast<std::size_t>(to)];
    std::vector<Eigen::Vector2d> places;
    if (std::isfinite(cost))
      for (int node = to; node >= 0; node = before[static_cast<std::size_t>(node)]) places.push_back(place(node));
    Points path(2, static_cast<Index>(places.size()));
    for (std::size_t i = 0; i < places.size(); ++i) path.col(static_cast<Index>(i)) = places[places.size() - 1 - i];
    return path;
  }

  Eigen::Vector2d place(int node) const { return s_.raster.place(node / s_.raster.columns, node % s_.raster.columns); }

 private:
  template <class Visit>
  void each_move(int node, const Visit& visit) {
    const int row = node / s_.raster.columns, column = node % s_.raster.columns;
    std::size_t k = 0;
    std::vector<double>& known = moves_[node];
    const bool fresh = known.empty();
    for (int dr = -2; dr <= 2; ++dr)
      for (int dc = -2; dc <= 2; ++dc) {
        if (std::abs(dr) + std::abs(dc) == 0 || std::gcd(dr, dc) != 1) continue;  // 16 directions
        const int r = row + dr, c = column + dc;
        const bool inside = r >= 0 && r < s_.raster.rows && c >= 0 && c < s_.raster.columns;
        const int next = r * s_.raster.columns + c;
        if (fresh) known.push_back(inside ? cost_on_surface(s_, place(node), place(next)) : kInfinity);
        const double move = known[k++];
        if (std::isfinite(move)) visit(next, move);
      }
  }

  const Setting& s_;
  std::map<int, std::vector<double>> moves_;
};

struct Row {
  int pairs = 0, below = 0, certified = 0, failed = 0;
  double gain = 0, least_gain = kInfinity;
  std::vector<double> seconds = {}, gaps = {};
};

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values.empty() ? std::numeric_limits<double>::quiet_NaN() : values[values.size() / 2];
}

double now() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// From the grid path, in its direction.
void solve(const Setting& s, const Points& grid, double grid_cost, double bracket_seconds, Row& row) {
  Problem problem;
  problem.manifold = s.manifold;
  problem.cost = s.cost;
  problem.kernel = make_kernel<Expm1Square>();
  problem.source.u = grid.col(0);
  problem.target.u = grid.col(grid.cols() - 1);
  FindOptions options;
  options.points = std::clamp(static_cast<int>(2 * grid.cols()), 40, 800);
  if (bracket_seconds > 0)
    options.post_processors = {
        std::make_shared<BracketPostProcessor>(GlobalBudget{.tolerance = 1e-3, .max_seconds = bracket_seconds})};
  const double start = now();
  ++row.pairs;
  try {
    const Result result =
        find_path(problem, WaypointsInitializer(grid.middleCols(1, grid.cols() - 2)), Newton(), options);
    row.seconds.push_back(now() - start);
    const double cost = result.certificate.measured && std::isfinite(result.certificate.estimate.value)
                            ? result.certificate.estimate.value
                            : result.curve.cost;
    const double gain = 1 - cost / grid_cost;
    row.below += gain > 0 ? 1 : 0;
    row.certified += result.status == Status::certified ? 1 : 0;
    row.gain += gain;
    row.least_gain = std::min(row.least_gain, gain);
    if (result.certificate.global && result.certificate.global->lower_bound > 0)
      row.gaps.push_back(result.certificate.global->gap);
    if (std::getenv("LEASTCOST_RASTER_REASONS") != nullptr && !(gain > 0))
      std::printf("    %.9g is above the grid's %.9g\n", cost, grid_cost);
    if (std::getenv("LEASTCOST_RASTER_REASONS") != nullptr)
      for (const CertificateFailure& f : result.certificate.failures) std::printf("    %s\n", f.message.c_str());
  } catch (const Error& error) {
    ++row.failed;
    if (std::getenv("LEASTCOST_RASTER_REASONS") != nullptr) std::printf("    %s\n", error.what());
  }
}

void run(const char* name, const char* what, const Setting& s, int pairs, unsigned seed, double bracket_seconds) {
  std::mt19937_64 random(seed);
  std::uniform_int_distribution<int> any(0, s.raster.rows * s.raster.columns - 1);
  GridPaths grid(s);
  Row row;
  while (row.pairs < 2 * pairs) {
    const int a = any(random), b = any(random);
    double cost = 0, back = 0;
    const Points there = grid.find(a, b, cost);
    if (there.cols() < 8) continue;
    const Points home = grid.find(b, a, back);
    solve(s, there, cost, bracket_seconds, row);
    solve(s, home, back, bracket_seconds, row);
  }
  std::printf("%-12s %-10s %5d %7d %10d %7d %9.2f %% %9.3f %% %10.3f s", name, what, row.pairs, row.below,
              row.certified, row.failed, 100 * row.gain / std::max(1, row.pairs - row.failed), 100 * row.least_gain,
              median(row.seconds));
  if (bracket_seconds > 0)
    std::printf("   gap %.2e median, %.2e largest, of %zu", median(row.gaps),
                row.gaps.empty() ? 1 : *std::max_element(row.gaps.begin(), row.gaps.end()), row.gaps.size());
  std::printf("\n");
  std::fflush(stdout);
}

RasterOptions in_degrees(double cell, double longitude, double latitude) {
  RasterOptions o;
  o.cell = Eigen::VectorXd::Constant(1, cell);
  o.origin = Eigen::Vector2d(longitude, latitude);
  o.degrees = true;
  return o;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fprintf(stderr, "raster_table FOLDER [PAIRS] [SEED] [SECONDS]\n");
    return 2;
  }
  const fs::path folder = argv[1];
  const int pairs = argc > 2 ? std::atoi(argv[2]) : 100;
  const auto seed = static_cast<unsigned>(argc > 3 ? std::atoi(argv[3]) : 1);
  const double seconds = argc > 4 ? std::atof(argv[4]) : 0;
  RasterOptions volcano, luxembourg = in_degrees(1.0 / 120, 5.741666666666666, 50.19166666666666 - 90.0 / 120);
  volcano.cell = Eigen::VectorXd::Constant(1, 10);
  luxembourg.nodata = -32768;
  const std::vector<Task> tasks = {{"volcano.csv", volcano},
                                   {"elev.csv", luxembourg},
                                   {"jacksboro_dem.csv", in_degrees(1.0 / 1200, -84.4137, 36.4462)}};
  std::printf("%-12s %-10s %5s %7s %10s %7s %11s %11s %12s\n", "raster", "cost", "paths", "below", "certified",
              "failed", "mean gain", "least gain", "median CPU");
  for (const Task& task : tasks) {
    const fs::path file = folder / task.name;
    const RasterGrid raster = placed(read_csv_raster(read_content(file), file.string()), task.options);
    const Eigen::Vector2d lower = raster.place(0, 0), upper = raster.place(raster.rows - 1, raster.columns - 1);
    const std::string name = file.stem().string();
    const auto terrain = std::make_shared<const TerrainManifold>(raster);
    run(name.c_str(), "length", {raster, terrain, make_euclidean_cost(3)}, pairs, seed, seconds);
    run(name.c_str(), "walking", {raster, terrain, make_walking_cost({}, 3)}, pairs, seed, seconds);
    const EuclideanManifoldOptions box{2, {Eigen::VectorXd(lower), Eigen::VectorXd(upper)}};
    run(name.c_str(), "cost_map",
        {raster, std::make_shared<const EuclideanManifold>(box),
         make_cost_map(raster, CostMapInterpolation::smooth, 2)},
        pairs, seed, seconds);
  }
}
