// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/costs/raster_density.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace leastcost {
namespace {

/// A range along an axis in sides of a patch, and the patches that it touches; none where it leaves them.
struct Span {
  Interval range;
  int first = 0, last = -1;

  Span(double least, double most, double origin, double side, int count) {
    constexpr double kRounding = 1e-9;  // as RasterPatches::inside: the outermost patches go on so far
    const Interval from = (Interval(least) - Interval(origin)) / Interval(side),
                   to = (Interval(most) - Interval(origin)) / Interval(side);
    range = {from.lo, to.hi};
    if (!(range.lo >= -kRounding && range.hi <= count + kRounding)) return;
    first = std::clamp(static_cast<int>(std::ceil(range.lo)) - 1, 0, count - 1);
    last = std::clamp(static_cast<int>(std::floor(range.hi)), 0, count - 1);
  }
  bool is_single() const { return first == last; }
  bool is_empty() const { return first > last; }
  /// The part of the range that lies in a patch; in the first and the last one also what lies beyond.
  std::array<double, 2> in_patch(int patch) const {
    return {patch == first ? range.lo : patch, patch == last ? range.hi : patch + 1.0};
  }
};

/// The patches that a box touches.
struct Touched {
  Span columns, rows;

  Touched(const RasterPatches& patches, const Eigen::Vector2d& least, const Eigen::Vector2d& most)
      : columns(least[0], most[0], patches.lower()[0], patches.cell()[0], patches.columns()),
        rows(least[1], most[1], patches.lower()[1], patches.cell()[1], patches.rows()) {}

  template <class Visit>
  void each(const Visit& visit) const {
    for (int row = rows.first; row <= rows.last; ++row)
      for (int column = columns.first; column <= columns.last; ++column) visit(RasterPatch{row, column});
  }
  bool all_known(const RasterPatches& patches) const {
    bool known = !columns.is_empty() && !rows.is_empty();
    each([&](const RasterPatch& patch) { known = known && patches.known(patch.row, patch.column); });
    return known;
  }
};

double bilinear(const std::array<double, 4>& z, double u, double v) {
  return (1 - v) * ((1 - u) * z[0] + u * z[1]) + v * ((1 - u) * z[2] + u * z[3]);
}

double largest_of(const std::array<double, 4>& z) {
  return std::max(std::max(std::abs(z[0]), std::abs(z[1])), std::max(std::abs(z[2]), std::abs(z[3])));
}

/// How far a bilinear function is from the polynomial of the patch `at`, at most: the difference is bilinear on each
/// patch, hence largest at a corner of the part that is touched.
double distance_from(const RasterFunction& n, const RasterPatch& at, const Touched& touched) {
  if (touched.columns.is_single() && touched.rows.is_single()) return 0;
  constexpr double kEps = std::numeric_limits<double>::epsilon();
  const std::array<double, 4> z = n.corners(at).value();
  double worst = std::numeric_limits<double>::min(), rounding = 0;  // kinks are told from their absence
  touched.each([&](const RasterPatch& patch) {
    const std::array<double, 4> other = n.corners(patch).value();
    const double size = std::max(largest_of(z), largest_of(other));
    for (const double row : touched.rows.in_patch(patch.row))
      for (const double column : touched.columns.in_patch(patch.column)) {
        const double u = column - at.column, v = row - at.row;
        const double here = bilinear(z, u, v), there = bilinear(other, column - patch.column, row - patch.row);
        worst = std::max(worst, std::abs(there - here));
        rounding = std::max(rounding, 64 * kEps * size * (1 + 2 * std::abs(u)) * (1 + 2 * std::abs(v)));
      }
  });
  return (worst + rounding) * (1 + 4 * kEps);
}

PlaneBends hull_of(const PlaneBends& a, const PlaneBends& b) {
  return {hull(a.xx, b.xx), hull(a.xy, b.xy), hull(a.yy, b.yy)};
}

PatchBounds hull_of(const PatchBounds& a, const PatchBounds& b) {
  return {hull(a.value, b.value), hull(a.dx, b.dx), hull(a.dy, b.dy)};
}

/// The hull of what is known in each patch that is touched, of the part of it.
template <class Known>
auto over_patches(const Touched& touched, const Known& known) {
  std::optional<decltype(known(RasterPatch{}, Interval(), Interval()))> all;
  touched.each([&](const RasterPatch& patch) {
    const std::array<double, 2> x = touched.columns.in_patch(patch.column), y = touched.rows.in_patch(patch.row);
    const auto here = known(patch, Interval(x[0], x[1]), Interval(y[0], y[1]));
    all = all ? hull_of(*all, here) : here;
  });
  return *all;
}

/// By the part of each patch that is touched; where these are many, by whole patches, which is much quicker.
PlaneBends bends_over(const RasterFunction& n, const Touched& touched) {
  const Span &columns = touched.columns, &rows = touched.rows;
  if (columns.last - columns.first <= 1 && rows.last - rows.first <= 1)
    return over_patches(touched, [&](const auto&... part) { return n.bends(part...); });
  const PlaneBends whole = n.bends({rows.first, columns.first}, {rows.last, columns.last});
  // The outermost patches go on beyond themselves by 1e-9 (Span), and change by less than twice the width per patch.
  const auto wider = [](const Interval& x) { return x + Interval(-1, 1) * Interval(4e-9 * x.width()); };
  return {wider(whole.xx), wider(whole.xy), wider(whole.yy)};
}

}  // namespace

DensityEnclosure enclose_over(const RasterFunction& n, const Eigen::AlignedBox2d& cell) {
  const Touched touched(n.patches(), cell.min(), cell.max()), middle(n.patches(), cell.center(), cell.center());
  if (!touched.all_known(n.patches()) || !middle.all_known(n.patches())) return DensityEnclosure::unknown();
  const RasterPatch patch{middle.rows.last, middle.columns.last};
  if (n.corners(patch)) {
    const PatchBounds at = n.enclose(patch, middle.columns.range, middle.rows.range);
    const PlaneBends bends = n.bends(patch, patch);
    return {at.value, at.dx, at.dy, bends.xx, bends.xy, bends.yy, distance_from(n, patch, touched)};
  }
  const PatchBounds at = over_patches(middle, [&](const auto&... part) { return n.enclose(part...); });
  const PlaneBends over = bends_over(n, touched);
  return {at.value, at.dx, at.dy, over.xx, over.xy, over.yy, 0};
}

}  // namespace leastcost
