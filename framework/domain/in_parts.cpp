// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "framework/domain/in_parts.hpp"

#include <limits>

#include <leastcost/framework/domain/fits_segments.hpp>
#include <leastcost/framework/domain/goes_beyond_bounds.hpp>
#include <leastcost/framework/domain/makes_on_demand.hpp>

namespace leastcost {
namespace {

/// A point of a cloud takes some 30 us, one of a chart less than 1.
constexpr Index kColumnPart = 16, kChartPart = 512;
constexpr Index kBoundPart = 2;  ///< one of a robot on its way between bounds, some 200 us

/// What moves and projections ask for, where it takes longer than they do, and where there is a clock to look at.
const MakesOnDemand* made_on_demand(const ConstraintManifold& manifold, const Deadline& deadline) {
  return deadline && manifold.shape() == Shape::polyhedral ? find_ability<MakesOnDemand>(manifold) : nullptr;
}

bool whole(const CoordinatePath& path, const Deadline& deadline, Index part = kColumnPart) {
  return !deadline || path.u.cols() <= part;
}

/// Columns of a path, as a ring: all of them are free.
CoordinatePath part_of(const CoordinatePath& path, Index begin, Index count) {
  CoordinatePath part{path.u.middleCols(begin, count), {}, true};
  if (!path.sites.empty()) part.sites.assign(path.sites.begin() + begin, path.sites.begin() + begin + count);
  return part;
}

/// `width` columns of `out` for every column of the path, as make(part, columns) fills them, `most` at a time.
template <class Make>
void fill_in_parts(const CoordinatePath& path, Index most, const Deadline& deadline, Points& out, Make make) {
  if (whole(path, deadline, most)) return make(path, 0, out);
  Points of_part;
  in_parts(path.u.cols(), most, deadline, [&](Index begin, Index count) {
    make(part_of(path, begin, count), begin, of_part);
    const Index width = of_part.cols() / count;
    if (begin == 0) out.resize(of_part.rows(), width * path.u.cols());
    out.middleCols(width * begin, width * count) = of_part;
  });
}

/// The free points of a path moved by move(part, steps, first of them, moved).
template <class Move>
void move_in_parts(const CoordinatePath& from, const Points& step, Index most, const Deadline& deadline,
                   const Move& move, CoordinatePath& to) {
  if (whole(from, deadline, most)) return move(from, step, 0, to);
  prepare_like(from, to);
  to.u = from.u;
  CoordinatePath moved;
  const Index first = from.free_begin(), columns = from.u.cols();
  in_parts(step.cols(), most, deadline, [&](Index begin, Index count) {
    // With its neighbours, fixed, as they are by now: what keeps moves from being drawn through something sees them.
    CoordinatePath part{Points(from.u.rows(), count + 2), {}, false};
    for (Index k = 0; k < count + 2; ++k) {
      const Index column = (first + begin + k - 1 + columns) % columns;
      part.u.col(k) = to.u.col(column);
      if (!to.sites.empty()) part.sites.push_back(to.site(column));
    }
    move(part, step.middleCols(begin, count), begin, moved);
    to.u.middleCols(first + begin, count) = moved.u.middleCols(1, count);
    if (!to.sites.empty()) std::copy_n(moved.sites.begin() + 1, count, to.sites.begin() + first + begin);
  });
}

}  // namespace

Projection project(const ConstraintManifold& manifold, CoordinatePath& path, const Deadline& deadline) {
  if (const auto* parts = made_on_demand(manifold, deadline); parts != nullptr && parts->is_asked_by(path))
    parts->make(deadline);
  // Out of several obstacles at once a point may take milliseconds.
  const Index columns = find_ability<FitsSegments>(manifold) != nullptr ? 1 : kColumnPart;
  if (!deadline || path.u.cols() <= columns) return manifold.project(path);
  Projection result;
  in_parts(path.u.cols(), columns, deadline, [&](Index begin, Index count) {
    CoordinatePath part = part_of(path, begin, count);
    const Projection projection = manifold.project(part);
    path.u.middleCols(begin, count) = part.u;
    if (!part.sites.empty()) {
      path.sites.resize(static_cast<std::size_t>(path.u.cols()), kNoSite);
      std::copy(part.sites.begin(), part.sites.end(), path.sites.begin() + begin);
    }
    result.moved = std::max(result.moved, projection.moved);
    for (const Index failed : projection.failed) result.failed.push_back(begin + failed);
  });
  return result;
}

void tangent_bases(const ConstraintManifold& manifold, const CoordinatePath& path, Points& bases,
                   const Deadline& deadline) {
  fill_in_parts(path, kColumnPart, deadline, bases,
                [&](const CoordinatePath& part, Index, Points& out) { manifold.tangent_bases(part, out); });
}

double residual(const ConstraintManifold& manifold, const CoordinatePath& path, const Deadline& deadline) {
  if (const auto* parts = made_on_demand(manifold, deadline); parts != nullptr && parts->is_asked_by(path))
    parts->make(deadline);
  if (whole(path, deadline)) return manifold.residual(path);
  double worst = 0;
  in_parts(path.u.cols(), kColumnPart, deadline, [&](Index begin, Index count) {
    const double here = manifold.residual(part_of(path, begin, count));
    worst = here > worst || !(here == here) ? here : worst;
  });
  return worst;
}

void retract(const ConstraintManifold& manifold, const CoordinatePath& from, const Points& step, CoordinatePath& to,
             const Deadline& deadline, bool beyond) {
  const auto* unbounded = beyond ? find_ability<GoesBeyondBounds>(manifold) : nullptr;
  const auto move = [&](const CoordinatePath& a, const Points& s, Index, CoordinatePath& b) {
    unbounded != nullptr ? unbounded->retract_beyond(a, s, b) : manifold.retract(a, s, b);
  };
  if (manifold.shape() == Shape::flat) return move(from, step, 0, to);
  if (const auto* parts = made_on_demand(manifold, deadline)) parts->make(deadline);
  const Index most = find_ability<FitsSegments>(manifold) != nullptr ? kBoundPart : kColumnPart;
  move_in_parts(from, step, most, deadline, move, to);
}

void retract_onto(const SeesBounds& domain, const CoordinatePath& from, const Points& step,
                  const BoundsOfPoints& bounds, CoordinatePath& to, const Deadline& deadline) {
  BoundsOfPoints of_part;
  const auto move = [&](const CoordinatePath& a, const Points& s, Index begin, CoordinatePath& b) {
    of_part.assign(bounds.begin() + begin, bounds.begin() + begin + s.cols());
    domain.retract_onto(a, s, of_part, b);
  };
  move_in_parts(from, step, kBoundPart, deadline, move, to);
}

void embed(const HasChart& chart, const CoordinatePath& path, Points& x, const Deadline& deadline) {
  fill_in_parts(path, kChartPart, deadline, x,
                [&](const CoordinatePath& part, Index, Points& out) { chart.embed(part, out); });
}

void jacobians(const HasChart& chart, const CoordinatePath& path, Points& j, const Deadline& deadline) {
  fill_in_parts(path, kChartPart, deadline, j,
                [&](const CoordinatePath& part, Index, Points& out) { chart.jacobians(part, out); });
}

void embed_with_jacobians(const HasChart& chart, const CoordinatePath& path, Points& x, Points& j,
                          const Deadline& deadline) {
  if (whole(path, deadline, kChartPart)) return chart.embed_with_jacobians(path, x, j);
  Points part_x, part_j;
  const Index columns = path.u.cols();
  in_parts(columns, kChartPart, deadline, [&](Index begin, Index count) {
    chart.embed_with_jacobians(part_of(path, begin, count), part_x, part_j);
    const Index width = part_j.cols() / count;
    if (begin == 0) {
      x.resize(part_x.rows(), columns);
      j.resize(part_j.rows(), width * columns);
    }
    x.middleCols(begin, count) = part_x;
    j.middleCols(width * begin, width * count) = part_j;
  });
}

void curvatures(const HasChart& chart, const CoordinatePath& path, const Points& weights, Points& h,
                const Deadline& deadline) {
  fill_in_parts(path, kChartPart, deadline, h, [&](const CoordinatePath& part, Index begin, Points& out) {
    chart.curvatures(part, weights.middleCols(begin, part.u.cols()), out);
  });
}

}  // namespace leastcost
