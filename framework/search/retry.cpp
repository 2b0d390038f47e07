// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "framework/search/retry.hpp"

#include <limits>
#include <string>
#include <utility>

#include <leastcost/framework/energy/path_energy.hpp>
#include "framework/base/point_text.hpp"
#include "framework/energy/spacing.hpp"
#include "framework/search/reference_cost.hpp"

namespace leastcost {
namespace {

bool never(const Search&, const Outcome&, int) { return false; }

bool lacks_points_for_obstacles(const Search&, const Outcome& out, int tries) {
  constexpr double kShallower = 0.75;  // else points are not what it lacks
  constexpr int kMostTorn = 2;
  if (out.torn && tries < kMostTorn) return true;
  return out.depth > 0 && (tries == 0 || out.depth < kShallower * out.depth_before);
}

std::optional<Outcome> with_twice_the_points(const Search& search, const Outcome& out) {
  constexpr Index kMostPoints = 4000;
  const Index points = 2 * out.result.initial.free_count();
  if (!out.sampled || points > kMostPoints || search.finds_its_own()) return std::nullopt;
  std::optional<Outcome> next = resampled(search, out, out.result.first.path, points);
  if (next) next->depth_before = out.depth;
  return next;
}

/// Not judged: an attempt with more points is nearer to the path that is asked for, however deep its moves go.
bool always(const Search&, const Outcome&, Outcome&) { return true; }

bool another_way_is_cheaper(const Search&, const Outcome& out, int tries) {
  return out.curve.cheaper && !out.curve_fault && tries == 0;
}

std::optional<Outcome> from_cheaper_way(const Search& search, const Outcome& out) {
  if (!out.sampled) return std::nullopt;
  const Index points = out.result.path.free_count();
  std::optional<Outcome> next = resampled(search, out, *out.curve.cheaper, points);
  if (!next) return next;
  next->points = points;
  next->result.first.path = *out.curve.cheaper;  // whose class is kept from here on
  return next;
}

/// Where the new chain costs no less than the curve that was there, everything stays as it was.
bool costs_less(const Search& search, const Outcome& before, Outcome& attempt) {
  constexpr double kWorthSaying = 1e-9;  // relative
  const double cost = attempt.failed()
                          ? std::numeric_limits<double>::infinity()
                          : PathEnergy(attempt.solved, 1, search.monitor.limit()).cost(attempt.result.path);
  if (!(cost < before.curve.curve.cost * (1 - kWorthSaying))) return false;
  attempt.result.notes.push_back("a search over all paths found a cheaper path: it costs " +
                                 short_number(100 * (1 - cost / before.curve.curve.cost)) + " % less and is delivered");
  return true;
}

}  // namespace

std::optional<Outcome> resampled(const Search& search, const Outcome& before, const CoordinatePath& path,
                                 Index points) {
  const Deadline& deadline = search.monitor.limit();
  MaybeChain chain = try_sampling(before.problem, path, static_cast<int>(points), deadline);
  if (!chain || !(PathEnergy(before.problem, 1, deadline).cost(*chain.chain) > 0)) return std::nullopt;
  Outcome next = before;
  next.solved = next.problem;
  next.free_segment.reset();
  next.result.initial = std::move(*chain.chain);
  next.result.path = next.result.initial;
  set_reference_cost(search, next);
  return next;
}

const Retry kNoRetry = {never, nullptr, nullptr};
const Retry kDenserBetweenObstacles = {lacks_points_for_obstacles, with_twice_the_points, always};
const Retry kFromCheaperWay = {another_way_is_cheaper, from_cheaper_way, costs_less, true};

void note_denser_points(const Search&, Outcome& out) {
  const Index now = out.result.path.free_count();
  if (now > out.points)
    out.result.notes.push_back("used " + std::to_string(now) + " points instead of " + std::to_string(out.points) +
                               ": with fewer, moves between the points crossed obstacles");
}

}  // namespace leastcost
