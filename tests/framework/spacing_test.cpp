// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "framework/energy/spacing.hpp"

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/cost/segment_cost_function.hpp>
#include "tests/support/catch.hpp"
#include "tests/support/compose.hpp"
#include "tests/support/sample_domains.hpp"

namespace leastcost::test {
namespace {

/// A polyline with given points, as the rows of a matrix of two columns.
CoordinatePath polyline(std::initializer_list<Eigen::Vector2d> points, bool ring = false) {
  CoordinatePath path{Points(2, static_cast<Index>(points.size())), {}, ring};
  Index i = 0;
  for (const Eigen::Vector2d& p : points) path.u.col(i++) = p;
  return path;
}

Problem plane(std::shared_ptr<const SegmentCost> cost = make_euclidean_cost(2)) {
  return between(space(2), std::move(cost), Eigen::Vector2d(0, 0), Eigen::Vector2d(1, 0));
}

/// Length, but infinite above y = 1.
struct UnderACeiling {
  static constexpr int dim = 2;
  CostTraits traits() const { return {}; }
  template <class S>
  S value(const Point<S, 2>& a, const Point<S, 2>& b) const {
    if (innermost(a[1]) > 1 || innermost(b[1]) > 1) return S(std::numeric_limits<double>::infinity());
    return (b - a).squaredNorm();
  }
};

}  // namespace

TEST_CASE("spread: max / min - 1", "[framework]") {
  CHECK(spread(Eigen::Vector3d(2, 2, 2)) == 0);
  CHECK(spread(Eigen::Vector3d(1, 3, 2)) == 2);
  CHECK(spread(Eigen::Vector3d(1, 0, 2)) == std::numeric_limits<double>::infinity());
}

TEST_CASE("samples of a polyline are equally spaced in cost, whatever its own points", "[framework]") {
  const Problem problem = plane();
  const CoordinatePath uneven = polyline({{0, 0}, {1e-9, 0}, {0.9, 0}, {0.9, 0}, {0.900001, 0}, {0.95, 0}, {1, 0}});
  for (const int n : {1, 2, 17, 300}) {
    const CoordinatePath path = sample_equally(problem, uneven, n);
    CHECK(path.u.cols() == n + 2);
    CHECK((path.u.col(0) == problem.source.u && path.u.col(n + 1) == problem.target.u));
    CHECK(spread(PathEnergy(problem, 1).costs(path)) < 1e-9);
  }
  const CoordinatePath bent = polyline({{0, 0}, {0.5, 2}, {3, 3}, {3.01, 3}, {4, 1}, {1, 0}});
  CHECK(spread(PathEnergy(problem, 1).costs(sample_equally(problem, bent, 40))) < 0.05);
  // A chord across a spike is short whatever its ends; what an exponential kernel needs is that none is long.
  const CoordinatePath spikes = polyline({{0, 0}, {0.1, 5}, {0.2, -3}, {4, 0.5}, {1, 0}});
  const Eigen::VectorXd costs = PathEnergy(problem, 1).costs(sample_equally(problem, spikes, 40));
  CHECK(costs.maxCoeff() < 1.2 * costs.mean());
}

TEST_CASE("samples of a bead's path from rest are equally spaced in time", "[framework]") {
  const int n = GENERATE(5, 20, 200, 2000);
  const Problem problem = bead(Eigen::Vector2d(0, 0), Eigen::Vector2d(3, -2));
  const CoordinatePath line = polyline({{0, 0}, {3, -2}});
  CHECK(spread(PathEnergy(problem, 1).costs(sample_equally(problem, line, n))) < 0.05);
}

TEST_CASE("samples of a ring close", "[framework]") {
  Problem problem = plane();
  problem.ring = true;
  const CoordinatePath square = polyline({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, true);
  const CoordinatePath path = sample_equally(problem, square, 32);
  CHECK((path.ring && path.u.cols() == 32));
  CHECK(PathEnergy(problem, 1).cost(path) == Approx(4));
  CHECK(spread(PathEnergy(problem, 1).costs(path)) < 1e-9);
}

TEST_CASE("a first path without length or with an infinite cost is an error in words", "[framework]") {
  CHECK_THROWS_AS(sample_equally(plane(), polyline({{0, 0}, {0, 0}}), 5), InitializationError);
  CHECK_THROWS_WITH(sample_equally(plane(make_segment_cost(UnderACeiling{})), polyline({{0, 0}, {0.5, 3}, {1, 0}}), 9),
                    Catch::Contains("infinite"));
}

TEST_CASE("refine: midpoints of order 4 inside, 3 at the ends, old points stay", "[framework]") {
  const bool ring = GENERATE(false, true);
  Problem problem = plane();
  problem.ring = ring;
  const double length = ring ? 2 * 3.14159265358979324 : 2;
  std::vector<double> inside, end;
  for (const int n : {8, 16, 32, 64}) {
    const auto at = [&](double i) { return Eigen::Vector2d(std::cos(length * i / n), std::sin(length * i / n)); };
    CoordinatePath path{Points(2, ring ? n : n + 1), {}, ring};
    for (Index i = 0; i < path.u.cols(); ++i) path.u.col(i) = at(static_cast<double>(i));
    const CoordinatePath fine = refine(problem, path);
    REQUIRE(fine.segment_count() == 2 * path.segment_count());
    REQUIRE(fine.ring == ring);
    double worst = 0;
    for (Index i = 0; i < path.u.cols(); ++i) CHECK(fine.u.col(2 * i) == path.u.col(i));
    for (Index i = 1; i + 1 < path.segment_count(); ++i)
      worst = std::max(worst, (fine.u.col(2 * i + 1) - at(static_cast<double>(i) + 0.5)).norm());
    inside.push_back(worst);
    end.push_back((fine.u.rightCols(ring ? 1 : 2).col(0) - at(n - 0.5)).norm());
  }
  for (std::size_t k = 1; k < inside.size(); ++k) {
    CHECK(std::log2(inside[k - 1] / inside[k]) > 3.8);
    CHECK(std::log2(end[k - 1] / end[k]) > (ring ? 3.8 : 2.8));
  }
}

TEST_CASE("refine: on a curved domain the new points lie on it, at the edge of a cost they stay inside",
          "[framework]") {
  const Problem arc =
      between(std::make_shared<Sphere>(), make_euclidean_cost(3), Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(0, 1, 0));
  const CoordinatePath path = sample_equally(arc, StraightInitializer().first_path(arc, {}).path, 4);
  CHECK(arc.manifold->residual(refine(arc, path)) < 1e-15);
  // Cubic midpoints of a plateau at the ceiling would overshoot it.
  const Problem problem = plane(make_segment_cost(UnderACeiling{}));
  const CoordinatePath plateau = polyline({{0, 0}, {0.2, 1}, {0.8, 1}, {1, 0}});
  CHECK(PathEnergy(problem, 1).costs(refine(problem, plateau)).allFinite());
}

}  // namespace leastcost::test
