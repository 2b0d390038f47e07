// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/post_processors/taut.hpp>

#include <optional>
#include <utility>

#include <leastcost/framework/base/checked.hpp>
#include <leastcost/framework/base/errors.hpp>
#include "problems/obstacles/crossing_word.hpp"
#include "problems/post_processors/plan_curve.hpp"
#include "problems/taut/taut_path.hpp"
#include "problems/taut/tight_string.hpp"

namespace leastcost {
namespace {

constexpr double kLeastExcess = 1e-10;  ///< a full circle is then a polyline of 200,000 sides
constexpr double kMostExcess = 0.01;

std::optional<TightPath> tight(const Walls& walls, const Points& start, double excess, const Monitor& monitor) {
  if (walls.dimension() == 3) {
    auto string = tight_string(walls, start, excess, monitor);
    if (!string) return std::nullopt;
    return TightPath{std::move(string->polyline), string->length, string->length - string->excess};
  }
  auto path = taut_path(walls, start, excess, monitor.deadline);
  if (!path) return std::nullopt;
  return TightPath{std::move(path->polyline), path->length, path->least};
}

std::optional<TightPath> shorter(std::optional<TightPath> a, std::optional<TightPath> b) {
  if (!a || (b && b->least < a->least)) return b;
  return a;
}

}  // namespace

void TautOptions::fields(FieldVisitor& visit) {
  visit.field("excess", excess,
              {.help = "Largest relative excess of the polyline's length over the curve's, at round corners.",
               .minimum = kLeastExcess,
               .maximum = kMostExcess});
}

TautPostProcessor::TautPostProcessor(TautOptions options) : options_(checked(options)) {}

PostProcessed TautPostProcessor::apply(const Problem& problem, const FirstPath& first, PostProcessed current,
                                       const Monitor& monitor) const {
  const Walls& walls = walls_of(problem, "taut");
  const double unit = cost_of_length(problem, "taut");
  std::optional<TightPath> best = tight(walls, first.path.u, options_.excess, monitor);
  if (!best || walls.dimension() != 2 || !of_one_class(walls, first.path.u, current.chain.u).value_or(false))
    best = shorter(std::move(best), tight(walls, current.chain.u, options_.excess, monitor));
  if (!best)
    current.notes.emplace_back(
        "taut: neither the first path nor the solved one could be pulled tight; the solved one is kept (in space, "
        "obstacles must be convex)");
  else if (!deliver_plan(problem, walls, unit, *best, monitor, current))
    current.notes.emplace_back(
        "taut: the taut path, or the polyline around it, would leave the domain; the solved one is kept");
  return current;
}

}  // namespace leastcost
