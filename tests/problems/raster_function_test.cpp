// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/raster/raster_function.hpp"

#include <leastcost/framework/base/errors.hpp>
#include "tests/problems/sample_rasters.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/random.hpp"

namespace leastcost::test {
namespace {

RasterGrid noise(int rows, int columns, Random& random) {
  return raster_of(rows, columns, [&](double, double) { return random.uniform(1, 9); });
}

Eigen::Vector2d place_in(const RasterFunction& f, Random& random) {
  const Eigen::Vector2d lower = f.patches().lower(), upper = f.patches().upper();
  return {random.uniform(lower[0], upper[0]), random.uniform(lower[1], upper[1])};
}

/// Derivatives against differences, and bounds of patches against values.
void check_function(const RasterFunction& f, Random& random) {
  constexpr double kStep = 1e-6;
  for (int k = 0; k < 300; ++k) {
    const Eigen::Vector2d x = place_in(f, random), cells = f.patches().in_cells(x[0], x[1]);
    const RasterPatch patch = f.patches().at(cells[0], cells[1]).value();
    const PlaneJet jet = f.at(x[0], x[1]);
    CAPTURE(x.transpose());
    for (int axis = 0; axis < 2; ++axis) {
      const Eigen::Vector2d step = kStep * Eigen::Vector2d::Unit(axis);
      const auto beside = [&](double sign) {  // the polynomial of the patch goes on
        const Eigen::Vector2d at = f.patches().in_cells(x[0] + sign * step[0], x[1] + sign * step[1]);
        return f.in_patch(patch, at[0], at[1]);
      };
      const PlaneJet ahead = beside(1), behind = beside(-1);
      CHECK(jet.gradient[axis] == Approx((ahead.value - behind.value) / (2 * kStep)).margin(1e-6));
      const Eigen::Vector2d bend = (ahead.gradient - behind.gradient) / (2 * kStep);
      CHECK(jet.hessian(0, axis) == Approx(bend[0]).margin(1e-4));
      CHECK(jet.hessian(1, axis) == Approx(bend[1]).margin(1e-4));
    }
    const PatchBounds bounds = f.bounds(patch);
    CHECK(bounds.value.contains(jet.value));
    CHECK(bounds.dx.contains(jet.gradient[0]));
    CHECK(bounds.dy.contains(jet.gradient[1]));
  }
}

}  // namespace

TEST_CASE("bilinear: through the values, derivatives and bounds") {
  Random random;
  const RasterGrid raster = noise(5, 7, random);
  const BilinearFunction f(raster);
  for (int row = 0; row < 5; ++row)
    for (int column = 0; column < 7; ++column) {
      const Eigen::Vector2d at = raster.place(row, column);
      CHECK(f.at(at[0], at[1]).value == Approx(raster.value(row, column)).epsilon(1e-14));
    }
  check_function(f, random);
  const PatchBounds bounds = f.bounds({1, 2});
  CHECK(bounds.value.hi == std::max({raster.value(1, 2), raster.value(1, 3), raster.value(2, 2), raster.value(2, 3)}));
}

TEST_CASE("bicubic through the values: C2, derivatives, bounds, order 4") {
  Random random;
  const RasterGrid raster = noise(6, 8, random);
  const SplineFunction f = SplineFunction::through(raster);
  for (int row = 0; row < 6; ++row)
    for (int column = 0; column < 8; ++column) {
      const Eigen::Vector2d at = raster.place(row, column);
      CHECK(f.at(at[0], at[1]).value == Approx(raster.value(row, column)).epsilon(1e-13));
    }
  check_function(f, random);
  for (int k = 0; k < 50; ++k) {  // value, slopes and bends of two patches agree on the line between them
    const double row = random.uniform(0, 5);
    const auto column = static_cast<double>(random.integer(1, 6));
    const RasterPatch right = f.patches().at(column, row).value(), left{right.row, right.column - 1};
    const PlaneJet a = f.in_patch(left, column, row), b = f.in_patch(right, column, row);
    CHECK(a.value == Approx(b.value).epsilon(1e-12));
    CHECK((a.gradient - b.gradient).norm() <= 1e-10);
    CHECK((a.hessian - b.hessian).norm() <= 1e-9);
  }
  const auto error = [&](int finer) {
    RasterGrid smooth =
        raster_of(8 * finer, 8 * finer, [&](double x, double y) { return waves(x / finer, y / finer); });
    const SplineFunction g = SplineFunction::through(smooth);
    double worst = 0;
    for (double at = 0.3; at < 7; at += 0.37) {
      const double x = g.patches().lower()[0] + at * 0.5 * finer, y = g.patches().lower()[1] + at * 0.25 * finer;
      worst = std::max(worst, std::abs(g.at(x, y).value - waves(x / finer, y / finer)));
    }
    return worst;
  };
  CHECK(error(2) / error(4) >= 11);  // 16, but for the borders
}

TEST_CASE("bicubic near the values: between the 16 around, derivatives, bounds") {
  Random random;
  const RasterGrid raster = noise(6, 8, random);
  const SplineFunction f = SplineFunction::near(raster);
  check_function(f, random);
  const Eigen::Vector2d at = raster.place(2, 3);
  double mean = 0;
  for (int r = -1; r <= 1; ++r)
    for (int c = -1; c <= 1; ++c) mean += (r == 0 ? 4 : 1) * (c == 0 ? 4 : 1) * raster.value(2 + r, 3 + c) / 36;
  CHECK(f.at(at[0], at[1]).value == Approx(mean).epsilon(1e-13));
  const RasterGrid flat = raster_of(4, 5, [](double, double) { return 7.0; });
  CHECK(SplineFunction::near(flat).at(flat.place(0, 0)[0], flat.place(0, 0)[1]).value == Approx(7).epsilon(1e-14));
}

TEST_CASE("a missing value takes the patches away that need it, and changes the others little") {
  const RasterGrid whole = raster_of(9, 9, waves), gap = with_gap(whole, 4, 4);
  const BilinearFunction linear(gap);
  const SplineFunction cubic = SplineFunction::through(gap), all = SplineFunction::through(whole);
  int missing_linear = 0, missing_cubic = 0;
  for (int row = 0; row < 8; ++row)
    for (int column = 0; column < 8; ++column) {
      missing_linear += linear.patches().known(row, column) ? 0 : 1;
      missing_cubic += cubic.patches().known(row, column) ? 0 : 1;
      if (!cubic.patches().known(row, column)) continue;
      const double u = column + 0.5, v = row + 0.5;
      CHECK(std::abs(cubic.in_patch({row, column}, u, v).value - all.in_patch({row, column}, u, v).value) <= 0.01);
    }
  CHECK(missing_linear == 4);
  CHECK(missing_cubic == 16);
  const Eigen::Vector2d at = gap.place(4, 4);
  CHECK(std::isnan(cubic.at(at[0], at[1]).value));
  CHECK_THAT(cubic.patches().why_unknown(at[0], at[1]), Catch::Contains("of made.asc (from 0), there is no data"));
  CHECK_THAT(cubic.patches().why_unknown(100, 0), Catch::Contains("is outside the values of made.asc"));
  CHECK(cubic.patches().why_unknown(gap.place(0, 0)[0], gap.place(0, 0)[1]) == "");
}

TEST_CASE("a line is cut where patches meet, and its pieces add up") {
  Random random;
  const RasterFunction& f = BilinearFunction(noise(6, 8, random));
  using V = Eigen::Vector2d;
  const auto pieces = [&](const V& a, const V& b) {
    std::vector<double> at = {0};
    const bool known = f.patches().cut<double>(a, b, [&](const RasterPatch& patch, double from, double to) {
      CHECK(from == at.back());
      const V middle = a + 0.5 * (from + to) * (b - a);
      CHECK((middle[0] >= patch.column - 1e-9 && middle[0] <= patch.column + 1 + 1e-9));
      CHECK((middle[1] >= patch.row - 1e-9 && middle[1] <= patch.row + 1 + 1e-9));
      at.push_back(to);
    });
    CHECK(known);
    CHECK(at.back() == 1);
    return at.size() - 1;
  };
  CHECK(pieces(V(0.5, 0.5), V(0.9, 0.1)) == 1);
  CHECK(pieces(V(0.5, 0.5), V(3.5, 0.5)) == 4);
  CHECK(pieces(V(3.5, 0.5), V(0.5, 2.5)) == 6);
  CHECK(pieces(V(0, 0), V(5, 5)) == 5);     // through corners
  CHECK(pieces(V(2, 0.25), V(2, 4)) == 4);  // along a line, and to its end
  CHECK(pieces(V(7, 5), V(7, 5)) == 1);     // a point, in the last corner
  for (int k = 0; k < 200; ++k)
    pieces(V(random.uniform(0, 7), random.uniform(0, 5)), V(random.uniform(0, 7), random.uniform(0, 5)));
  pieces(V(-1e-12, 5 + 1e-12), V(7 + 1e-12, -1e-12));  // bounds that are computed in another way
  CHECK_FALSE(f.patches().cut<double>(V(1, 1), V(8, 1), [](const RasterPatch&, double, double) {}));
}

TEST_CASE("rasters too small for a function are refused") {
  CHECK_THROWS_AS(SplineFunction::through(raster_of(3, 9, waves)), InputError);
  CHECK_THROWS_AS(BilinearFunction(raster_of(1, 9, waves)), InputError);
  CHECK_THROWS_AS(SplineFunction::through(with_gap(with_gap(raster_of(4, 5, waves), 1, 2), 2, 2)), InputError);
}

TEST_CASE("bicubic: bounds of second derivatives over a part of a patch are those of the polynomial there") {
  Random random;
  const RasterGrid raster = noise(7, 6, random);
  for (const SplineFunction& f : {SplineFunction::through(raster), SplineFunction::near(raster)})
    for (const double size : {1e-9, 1e-3, 0.2, 1.0}) {
      const RasterPatch patch{random.integer(1, 4), random.integer(1, 3)};
      const double column = patch.column + random.uniform(0, 1 - size), row = patch.row + random.uniform(0, 1 - size);
      const PlaneBends part = f.bends(patch, {column, column + size}, {row, row + size});
      const PlaneBends whole = f.bends(patch, patch);
      Interval xx(f.in_patch(patch, column, row).hessian(0, 0)), xy(f.in_patch(patch, column, row).hessian(0, 1));
      for (int k = 0; k < 400; ++k) {
        const double across = column + size * (k % 20) / 19, up = row + size * (k / 20) / 19;  // NOLINT
        const PlaneJet at = f.in_patch(patch, across, up);
        const PatchBounds there = f.enclose(patch, across, up);
        constexpr double kRounding = 1e-11;
        const auto lies_in = [](const Interval& bounds, double value) {
          return bounds.lo - kRounding <= value && value <= bounds.hi + kRounding;
        };
        CHECK(lies_in(there.value, at.value));
        CHECK(lies_in(there.dx, at.gradient[0]));
        CHECK(lies_in(there.dy, at.gradient[1]));
        CHECK(there.value.width() < kRounding);
        for (const PlaneBends& bends : {part, whole}) {
          CHECK(lies_in(bends.xx, at.hessian(0, 0)));
          CHECK(lies_in(bends.xy, at.hessian(0, 1)));
          CHECK(lies_in(bends.yy, at.hessian(1, 1)));
        }
        xx = hull(xx, at.hessian(0, 0));
        xy = hull(xy, at.hessian(0, 1));
      }
      CHECK(part.xx.width() < 2 * xx.width() + 1e-10);
      CHECK(part.xy.width() < 2 * xy.width() + 1e-10);
    }
}

}  // namespace leastcost::test
