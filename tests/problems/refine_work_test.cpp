// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/framework/search/find_path.hpp>

#include <algorithm>

#include <leastcost/problems/costs/cost_map.hpp>
#include <leastcost/problems/initializers/eikonal.hpp>
#include <leastcost/solvers/newton.hpp>
#include "tests/support/catch.hpp"
#include "tests/support/compose.hpp"

namespace leastcost::test {

TEST_CASE("refine_work: a solve with more points that takes long is stopped where the work is spent") {
  RasterGrid raster;
  raster.rows = raster.columns = 7;
  raster.values.assign(49, 1);
  for (int row = 2; row < 5; ++row)
    for (int column = 2; column < 5; ++column) raster.values[raster.index(row, column)] = 9;
  // Kinks along the sides of patches: Newton goes on to its limit of iterations, with forty evaluations in each.
  const Problem problem = between(space(2), make_cost_map(raster, CostMapInterpolation::bilinear, 2),
                                  Eigen::Vector2d(3.5, 6), Eigen::Vector2d(3.5, 1));
  const EikonalInitializer first({.cells = {}, .lower = {}, .upper = {}, .fallback = true});
  FindOptions options;
  options.points = 16;
  options.certificate.refine = 0;
  const Result once = find_path(problem, first, Newton(), options);
  double work = 0;  // evaluations times points
  const Counters& n = once.solve.counters;
  work += static_cast<double>((n.energies + n.gradients + n.hessians) * once.path.segment_count());
  for (const RefinementLevel& level : once.certificate.levels)
    work += static_cast<double>(level.evaluations * level.segments);

  options.certificate.refine = 6;
  options.certificate.refine_work = 5;
  double spent = 0;
  long evaluations = 0;
  Monitor monitor;
  monitor.observe = [&](const Progress& progress) {
    if (progress.more_points == nullptr || progress.iteration == nullptr) return;
    const long now = progress.iteration->evaluations;
    spent += static_cast<double>((now < evaluations ? now : now - evaluations) * (progress.more_points->points + 2));
    evaluations = now;
  };
  const Result result = find_path(problem, first, Newton(), options, monitor);
  constexpr double kSmallSearch = 4e4, kOneIteration = 1.05;
  CHECK(spent > 0);
  CHECK(spent < kOneIteration * options.certificate.refine_work * std::max(work, kSmallSearch));
  CHECK(result.status == Status::uncertified);
  CHECK(result.curve.cost == once.curve.cost);
  REQUIRE_FALSE(result.notes.empty());
  CHECK_THAT(result.notes.back(), Catch::Contains("to continue, increase certificate.refine_work"));
}

}  // namespace leastcost::test
