// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "framework/search/more_points_may_help.hpp"

#include <algorithm>

#include <leastcost/framework/domain/manifold.hpp>

namespace leastcost {
bool is_astray(const Problem& problem, const Certificate& c) {
  const bool mesh = problem.manifold->shape() == Shape::polyhedral;
  return std::any_of(c.failures.begin(), c.failures.end(), [&](const CertificateFailure& failure) {
    return consequences(failure.kind).points == PointsHelp::beside_others ||
           (mesh && failure.kind == Failure::longest_segment);
  });
}

bool more_points_may_help(const Problem& problem, const Result& result) {
  const Certificate& c = result.certificate;
  if (!c.measured || result.status != Status::uncertified || result.curve.straightness) return false;
  // Where samples do not say what the domain is, no number of points does.
  const bool sampled = find_ability<HasUnresolvedPlaces>(*problem.manifold) != nullptr;
  const auto help = [&](const CertificateFailure& failure) {
    return sampled && failure.kind == Failure::unresolved ? PointsHelp::no : consequences(failure.kind).points;
  };
  const auto may_help = [&](const CertificateFailure& failure) { return help(failure) == PointsHelp::maybe; };
  return std::any_of(c.failures.begin(), c.failures.end(), may_help) &&
         std::all_of(c.failures.begin(), c.failures.end(), [&](const CertificateFailure& failure) {
           return may_help(failure) || help(failure) == PointsHelp::beside_others;
         });
}

}  // namespace leastcost
