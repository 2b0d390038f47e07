// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "framework/search/free_passage.hpp"

#include <algorithm>

#include <leastcost/framework/cost/has_free_places.hpp>
#include <leastcost/framework/domain/checks_moves.hpp>
#include "framework/base/point_text.hpp"
#include "framework/energy/spacing.hpp"

namespace leastcost {
namespace {

constexpr double kReached = 1e-6;  ///< of the distance of the farther end from the free places

/// Of a problem in which a straight move is one of the domain.
const HasFreePlaces* free_places(const Problem& problem, const CoordinatePath& path) {
  const ConstraintManifold& domain = *problem.manifold;
  if (path.ring || path.segment_count() < 3 || domain.shape() != Shape::flat) return nullptr;
  if (find_ability<HasChart>(domain) != nullptr || find_ability<ChecksMoves>(domain) != nullptr) return nullptr;
  return find_ability<HasFreePlaces>(*problem.cost);
}

std::optional<FreePassage> free_passage(const Problem& problem, const CoordinatePath& path) {
  const HasFreePlaces* places = free_places(problem, path);
  if (places == nullptr) return std::nullopt;
  FreePassage passage = places->free_passage(path.u.col(0), path.u.rightCols(1), path.segment_count());
  // A box without the free places does not let it through.
  const double size = extent_of(passage.points);
  if (!(problem.manifold->residual({passage.points, {}, false}) <= kReached * size)) return std::nullopt;
  return passage;
}

bool reaches_free_place(const Problem& problem, const CoordinatePath& path) {
  const HasFreePlaces* places = free_places(problem, path);
  if (places == nullptr) return false;
  const double far = std::max(places->distance_to_free(path.u.col(0)), places->distance_to_free(path.u.rightCols(1)));
  for (Index i = 1; i + 1 < path.u.cols(); ++i)
    if (places->distance_to_free(path.u.col(i)) <= kReached * far) return true;
  return false;
}

double spread_where_paid(const Eigen::VectorXd& costs, Index free) {
  Eigen::VectorXd paid(costs.size() - 1);
  paid << costs.head(free), costs.tail(costs.size() - free - 1);
  return spread(paid);
}

}  // namespace

void join_at_free_place(const Search&, Outcome& out) {
  Result& result = out.result;
  if (out.free_segment || !reaches_free_place(out.solved, result.path)) return;
  const std::optional<FreePassage> passage = free_passage(out.solved, result.path);
  if (!passage) return;
  out.free_segment = passage->free;
  result.path.u = passage->points;
  result.notes.push_back(
      "collapsed: the path collapsed onto places where moves cost nothing; the cheapest path through them is "
      "delivered. It costs " +
      short_number(passage->cost, 6) + ", and a move of cost 0 joins its two parts");
}

void judge_free_passage(const Search&, Outcome& out) {
  Result& result = out.result;
  if (out.free_segment) {
    result.certificate.spacing = spread_where_paid(result.costs, *out.free_segment);
    return;
  }
  const std::optional<FreePassage> passage = free_passage(out.solved, result.path);
  if (!passage || !(passage->cost < result.curve.cost)) return;
  const TwoNumbers texts = told_apart(passage->cost, result.curve.cost, 6);
  result.notes.push_back("cheaper: the path through the places where moves cost nothing costs " + texts.first +
                         ", but this path costs " + texts.second + ", and is the cheapest only locally");
}

}  // namespace leastcost
