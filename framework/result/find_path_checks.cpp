// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "framework/result/find_path_checks.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include <leastcost/framework/base/checked.hpp>
#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/problem/clearance.hpp>
#include <leastcost/framework/result/other_images.hpp>
#include "framework/base/point_text.hpp"
#include "framework/base/sound_size.hpp"
#include "framework/problem/one_place.hpp"

namespace leastcost {
namespace {

/// Their squares would vanish or overflow.
void refuse_unsound_distance(const Problem& problem) {
  if (problem.ring || problem.based || problem.source.u.size() != problem.target.u.size()) return;
  CoordinatePath ends{Points(problem.source.u.size(), 2), {}, false};
  ends.u << problem.source.u, problem.target.u;
  const Points x = positions(*problem.manifold, ends);
  const double apart = (x.col(1) - x.col(0)).cwiseAbs().maxCoeff();
  if (apart > 0) check_sound_size("the distance from source to target", apart);
}

}  // namespace

void check(const FindOptions& options) {
  static_cast<void>(checked(options.certificate, "certificate"));
  if (options.points && *options.points < 1)
    throw InputError("a path must have at least one free point, not " + std::to_string(*options.points));
  constexpr int kMostAllowed = 100'000'000;
  if (options.points && *options.points > kMostAllowed)
    throw InputError("a path can have at most 10^8 free points, not " + std::to_string(*options.points));
  if (options.reference_cost && !(*options.reference_cost > 0 && std::isfinite(*options.reference_cost)))
    throw InputError("the reference cost must be positive and finite, not " + short_number(*options.reference_cost, 6));
  for (const auto& step : options.post_processors)
    if (!step) throw InputError("a post-processor is null");
}

void refuse_one_point(const Problem& problem) {
  refuse_unsound_distance(problem);
  if (!problem.ring && !problem.based && equal_up_to_rounding(problem.source, problem.target))
    throw InputError("source and target are the same point up to rounding: " + point_text(problem.source.u, 17) +
                     " and " + point_text(problem.target.u, 17) + "; for a closed path, use a ring (path.ring: true)");
  std::optional<PointImage> image;
  if (!ends_are_one_point(problem, &image) || image) return;
  throw InputError("source " + point_text(problem.source.u) + " and target " + point_text(problem.target.u) +
                   " are the same point of the domain; for a closed path, use a ring (path.ring: true)");
}

void refuse_end_in_clearance(const Problem& problem) {
  const auto check = [&](const PathEnd& end, const std::string& which) {
    if (end.u.size() == 0) return;
    const std::string why = why_in_clearance(problem, end);
    if (!why.empty()) throw InputError("end_in_clearance: the " + which + " " + why);
  };
  check(problem.source, "source");
  check(problem.target, "target");
}

void check_path(const Problem& problem, const CoordinatePath& path, Index least, const std::string& what) {
  const Index columns = path.u.cols(), rows = problem.manifold->dimensions().coordinate;
  if (path.ring != problem.ring)
    throw InputError(path.ring ? what + " is a ring, but the problem has two ends"
                               : what + " is open, but the problem is a ring");
  if (path.u.rows() == rows && columns == 1 && least == 2)
    throw InputError(what + " has one point only: source and target are " +
                     short_number((problem.target.u - problem.source.u).norm(), 3) +
                     " apart, which is nothing beside the rounding of points of this domain; move one of them, or, for "
                     "a closed path, use a ring (path.ring: true)");
  if (path.u.rows() != rows || columns < least)
    throw InputError(what + " is " + std::to_string(path.u.rows()) + " x " + std::to_string(columns) +
                     ", but this problem needs " + std::to_string(rows) + " rows and at least " +
                     std::to_string(least) + " columns");
  if (!path.sites.empty() && path.sites.size() != static_cast<std::size_t>(columns))
    throw InputError(what + " has " + std::to_string(path.sites.size()) + " sites for " + std::to_string(columns) +
                     " columns");
  if (!path.closing.identity() && (path.closing.sign.size() != rows || path.closing.shift.size() != rows))
    throw InputError(what + " has a closing map of the wrong dimension");
  if (!path.u.allFinite()) throw InputError(what + " has coordinates that are not finite");
}

void check_processed(const Problem& problem, const CoordinatePath& before, const PostProcessed& after) {
  const CoordinatePath& chain = after.chain;
  check_path(problem, chain, before.u.cols(), "the chain of a post-processor");
  if (chain.u.cols() != before.u.cols())
    throw InputError("a post-processor made " + std::to_string(chain.u.cols()) + " points of " +
                     std::to_string(before.u.cols()));
  constexpr double kSame = 1e-6;  // of the extent: what rounding and projections may move an end
  const double extent = extent_of(before.u);
  const Index last = chain.u.cols() - 1;
  if (!chain.ring && std::max((chain.u.col(0) - before.u.col(0)).norm(),
                              (chain.u.col(last) - before.u.col(last)).norm()) > kSame * extent)
    throw InputError("a post-processor moved an end of the path");
  if (after.curve_costs.size() != chain.segment_count())
    throw InputError("a post-processor returned " + std::to_string(after.curve_costs.size()) + " costs for " +
                     std::to_string(chain.segment_count()) + " segments");
  if (after.curve.x.rows() != problem.manifold->dimensions().ambient || after.curve.x.cols() < 2)
    throw InputError("a post-processor returned a curve of " + std::to_string(after.curve.x.rows()) + " x " +
                     std::to_string(after.curve.x.cols()) + " coordinates");
}

}  // namespace leastcost
