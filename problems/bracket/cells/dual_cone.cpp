// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/bracket/cells/dual_cone.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <leastcost/framework/numbers/dual.hpp>
#include "problems/bracket/grid.hpp"

namespace leastcost::bracket {
namespace {

using Eigen::AlignedBox2d;
using Eigen::Vector2d;
using Jet = CostDual::Jet;

constexpr std::size_t kEntries = 5;

template <class S>
std::array<S, kEntries> entries(const DualNorm<S>& n) {
  return {n.xx, n.xy, n.yy, n.wx, n.wy};
}
template <class S>
DualNorm<S> from_entries(const std::array<S, kEntries>& f) {
  return {f[0], f[1], f[2], f[3], f[4]};
}

/// What an entry of the norm may differ from the linear one of the cone, d from the end.
struct Unsure {
  Interval value, x, y, xx, xy, yy;
  Interval at(const Interval& dx, const Interval& dy) const {
    return value + x * dx + y * dy + Interval(0.5) * (xx * square(dx) + Interval(2) * xy * dx * dy + yy * square(dy));
  }
};

/// Of a bounded function over a part of a box, from small parts of it: the hulls of its second derivatives.
bool hull_of_bends(const CostDual& dual, const AlignedBox2d& box, bool reversed, std::array<Unsure, kEntries>& out) {
  constexpr int kParts = 6;
  bool first = true;
  return for_parts_of<2>(box, kParts, [&](const AlignedBox2d& part) {
    const DualNorm<Jet> norm = dual.enclose_cell(part);
    const auto f = entries(reversed ? norm.reversed() : norm);
    for (std::size_t k = 0; k < kEntries; ++k) {
      const Interval xx = f[k].d(0, 0), xy = f[k].d(0, 1), yy = f[k].d(1, 1);
      if (!f[k].value().is_finite() || !xx.is_finite() || !xy.is_finite() || !yy.is_finite()) return false;
      out[k].xx = first ? xx : hull(out[k].xx, xx);
      out[k].xy = first ? xy : hull(out[k].xy, xy);
      out[k].yy = first ? yy : hull(out[k].yy, yy);
    }
    first = false;
    return true;
  });
}

/// The cone without factor and most, and what the norm at the end differs from it; false where nothing is known.
bool linear_at(const CostDual& dual, const Vector2d& end, bool reversed, DualCone& cone,
               std::array<Unsure, kEntries>& unsure) {
  DualNorm<Jet> norm = dual.enclose_cell({end, end});
  if (reversed) norm = norm.reversed();
  const auto f = entries(norm);
  std::array<double, kEntries> value{}, x{}, y{};
  for (std::size_t k = 0; k < kEntries; ++k) {
    const Interval v = f[k].value_at_center(), gx = f[k].d_at_center(0), gy = f[k].d_at_center(1);
    if (!v.is_finite() || !gx.is_finite() || !gy.is_finite()) return false;
    value[k] = v.middle(), x[k] = gx.middle(), y[k] = gy.middle();
    unsure[k].value = v - Interval(value[k]);
    unsure[k].x = gx - Interval(x[k]);
    unsure[k].y = gy - Interval(y[k]);
  }
  cone.at = from_entries(value), cone.dx = from_entries(x), cone.dy = from_entries(y);
  return true;
}

/// Directions from an end, and how far it is looked at in them.
struct Sector {
  double from, to, reach;
  std::array<Interval, 2> direction() const {
    return {leastcost::cos(Interval(from, to)), leastcost::sin(Interval(from, to))};
  }
};

/// Sectors that reach a little farther than what costs `most` under the norm at the end.
std::vector<Sector> sectors_of(const DualNorm<double>& at, double most) {
  constexpr double kBeyond = 1.15, kOverlap = 1e-12, kMost = 16384;
  const double half = 0.5 * (at.xx + at.yy), apart = std::hypot(0.5 * (at.xx - at.yy), at.xy);
  const double det = at.xx * at.yy - at.xy * at.xy;
  const double room = 1 - (at.yy * at.wx * at.wx - 2 * at.xy * at.wx * at.wy + at.xx * at.wy * at.wy) / det;
  const double wanted = 24 * (half + apart) / std::max(half - apart, 1e-300) / std::max(room * room, 1e-300);
  const auto count = static_cast<std::size_t>(std::clamp(wanted, 128.0, kMost));
  std::vector<Sector> out(count);
  const double step = 2 * std::numbers::pi / static_cast<double>(count);
  for (std::size_t k = 0; k < count; ++k) {
    const double angle = step * static_cast<double>(k), middle = angle + step / 2;
    out[k] = {angle - kOverlap, angle + step + kOverlap, kBeyond * most / at.cost(std::cos(middle), std::sin(middle))};
  }
  return out;
}

/// In one sector: what H(x, grad m) exceeds 1 by at most, and what m is at least at its end.
struct Excess {
  double most = kInfinity, at_end = 0;
};

/// With p and q the derivatives of F by the move and by the place, at the middle z = r omega / 2: grad m = p + r q / 2
/// and H(z, p) = 1. As q = -F dH/dz and dH/dp = omega / F there, first orders of H(x, grad m) - 1 cancel; this is the
/// rest, by sqrt(Q) <= s / 2 + Q / (2 s) with s = sqrt(p'Ap) = 1 - w.p.
Excess excess_of(const DualCone& cone, const std::array<Unsure, kEntries>& unsure, const Sector& sector) {
  using Slopes = Dual<Interval, 4>;
  const auto [ox, oy] = sector.direction();
  const Interval r(0, sector.reach), dx = r * ox, dy = r * oy, zx = Interval(0.5) * dx, zy = Interval(0.5) * dy;
  Slopes vx(ox, {}), vy(oy, {}), sx(zx, {}), sy(zy, {});
  vx.d[0] = vy.d[1] = sx.d[2] = sy.d[3] = Interval(1);
  const Slopes f = cone.norm<Slopes>(sx, sy).cost(vx, vy);
  const Interval px = f.d[0], py = f.d[1], ex = Interval(0.5) * r * f.d[2], ey = Interval(0.5) * r * f.d[3];
  if (!f.value.is_finite() || !(f.value.lo > 0) || !ex.is_finite() || !ey.is_finite()) return {};
  const DualNorm<Interval> at = cone.norm<Interval>(zx, zy);
  std::array<Interval, kEntries> off, change;
  const auto ax = entries(cone.dx), ay = entries(cone.dy);
  for (std::size_t k = 0; k < kEntries; ++k) {
    off[k] = unsure[k].at(dx, dy);
    change[k] = Interval(ax[k]) * zx + Interval(ay[k]) * zy + off[k];
  }
  const Interval s = Interval(1) - (at.wx * px + at.wy * py);
  const Interval room =
      Interval(1) - (at.yy * square(at.wx) - Interval(2) * at.xy * at.wx * at.wy + at.xx * square(at.wy)) /
                        (at.xx * at.yy - square(at.xy));
  if (!(s.lo > 0) || !(room.lo > 0) || !(at.xx.lo > 0)) return {};
  const auto quadratic = [](const std::array<Interval, kEntries>& a, const Interval& x, const Interval& y) {
    return a[0] * square(x) + Interval(2) * a[1] * x * y + a[2] * square(y);
  };
  const Interval mixed = ex * (change[0] * px + change[1] * py) + ey * (change[1] * px + change[2] * py);
  const Interval squares =
      quadratic(off, px, py) + Interval(2) * mixed + quadratic(entries(at), ex, ey) + quadratic(change, ex, ey);
  const Interval rest = squares / (Interval(2) * s) + off[3] * px + off[4] * py + change[3] * ex + change[4] * ey;
  return {rest.hi, (f.value * Interval(sector.reach)).lo};
}

/// The cone for what costs up to `most`; nothing where its excess is hopeless.
std::optional<DualCone> cone_up_to(const CostDual& dual, const AlignedBox2d& box, const Vector2d& end, bool reversed,
                                   double most) {
  constexpr double kHopeless = 1;
  DualCone cone;
  std::array<Unsure, kEntries> unsure;
  if (!linear_at(dual, end, reversed, cone, unsure)) return std::nullopt;
  const std::vector<Sector> sectors = sectors_of(cone.at, most);
  AlignedBox2d around(end);
  for (const Sector& sector : sectors) {
    if (!std::isfinite(sector.reach)) return std::nullopt;
    const auto [ox, oy] = sector.direction();
    const Interval r(0, sector.reach), x = Interval(end[0]) + r * ox, y = Interval(end[1]) + r * oy;
    around.extend(Vector2d(x.lo, y.lo)).extend(Vector2d(x.hi, y.hi));
  }
  if (!hull_of_bends(dual, around.intersection(box), reversed, unsure)) return std::nullopt;
  Excess all{0, kInfinity};
  for (const Sector& sector : sectors) {
    const Excess here = excess_of(cone, unsure, sector);
    if (!(here.most < kHopeless)) return std::nullopt;
    all = {std::max(all.most, here.most), std::min(all.at_end, here.at_end)};
  }
  cone.factor = (Interval(1) / (Interval(1) + Interval(all.most))).lo;
  cone.most = (Interval(cone.factor) * Interval(all.at_end)).lo;
  return cone;
}

}  // namespace

std::optional<DualCone> dual_cone(const CostDual& dual, const AlignedBox2d& box, const Vector2d& end, double reach,
                                  bool reversed) {
  DualNorm<double> at = dual.dual(end);
  if (reversed) at = at.reversed();
  constexpr int kDirections = 64;
  double most = 0;
  for (int k = 0; k < kDirections; ++k) {
    const double angle = 2 * std::numbers::pi * k / kDirections;
    most = std::max(most, reach * at.cost(std::cos(angle), std::sin(angle)));
  }
  for (const double part : {1.0, 0.6, 0.35, 0.2, 0.1}) {
    const std::optional<DualCone> cone = cone_up_to(dual, box, end, reversed, part * most);
    if (cone) return cone;
  }
  return std::nullopt;
}

}  // namespace leastcost::bracket
