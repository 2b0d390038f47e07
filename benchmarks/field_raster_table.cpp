// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// The library's field over a raster of costs, bilinear, on one thread: processor time without and with the estimate of
// its error. Beside others: benchmarks/fields/field_peers.py, which calls this program.
//   field_raster_table COSTS CELLS COLUMN ROW     doubles row by row, the lowest y first; NaN: no data
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <memory>

#include <leastcost/problems/costs/cost_map.hpp>
#include <leastcost/problems/fields/cost_field.hpp>
#include <leastcost/problems/manifolds/euclidean.hpp>

int main(int argc, char** argv) {
  using namespace leastcost;
  if (argc != 5) return std::fprintf(stderr, "usage: field_raster_table COSTS CELLS COLUMN ROW\n"), 2;
  RasterGrid grid;
  grid.rows = grid.columns = std::atoi(argv[2]);
  grid.cell = Eigen::Vector2d::Ones();
  grid.corner = Eigen::Vector2d::Zero();
  grid.source = argv[1];
  grid.values.resize(std::size_t(grid.rows) * std::size_t(grid.columns));
  std::ifstream in(argv[1], std::ios::binary);
  if (!in.read(reinterpret_cast<char*>(grid.values.data()), std::streamsize(grid.values.size() * sizeof(double))))
    return std::fprintf(stderr, "%s: too short\n", argv[1]), 1;
  Problem problem;
  problem.manifold = std::make_shared<const EuclideanManifold>(EuclideanManifoldOptions{2, {}});
  problem.cost = make_cost_map(grid, CostMapInterpolation::bilinear, 2);
  problem.source.u = Eigen::Vector2d(std::atof(argv[3]) + 0.5, std::atof(argv[4]) + 0.5);
  problem.target.u = problem.source.u + Eigen::Vector2d(1, 0);
  for (const bool estimates : {false, true}) {
    const std::clock_t begin = std::clock();
    const CostField field = costs_from(problem, {problem.source.u}, {.estimate_error = estimates});
    std::printf("%.4f%c", double(std::clock() - begin) / CLOCKS_PER_SEC, estimates ? '\n' : ' ');
    if (field.values.empty()) return 1;
  }
}
