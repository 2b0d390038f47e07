// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "framework/search/more_points_help.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include <leastcost/framework/domain/manifold.hpp>

namespace leastcost {
namespace {

/// Failures that too few points may explain.
constexpr std::array<std::string_view, 9> kOfFewPoints = {"not_asymptotic",  "unresolved", "spacing",
                                                          "longest_segment", "doubling",   "bracket",
                                                          "error_bar",       "refinement", "dearer_than_first"};
/// What may be true of a chain that sees another cost than there is, but on its own has nothing to do with points.
constexpr std::array<std::string_view, 2> kBesideThem = {"saddle", "stationarity"};

}  // namespace

bool is_astray(const Problem& problem, const Certificate& c) {
  const bool mesh = problem.manifold->shape() == Shape::polyhedral;
  return std::any_of(c.failures.begin(), c.failures.end(), [&](const CertificateFailure& failure) {
    return std::find(kBesideThem.begin(), kBesideThem.end(), failure.name) != kBesideThem.end() ||
           (mesh && failure.name == "longest_segment");
  });
}

bool more_points_may_help(const Problem& problem, const Result& result) {
  const Certificate& c = result.certificate;
  if (!c.measured || result.status != Status::uncertified || result.curve.straightness) return false;
  // Where samples do not say what the domain is, no number of points does.
  const bool sampled = find_ability<HasUnresolvedPlaces>(*problem.manifold) != nullptr;
  const auto is_one_of = [](const auto& names, const CertificateFailure& failure) {
    return std::find(names.begin(), names.end(), failure.name) != names.end();
  };
  const auto of_few_points = [&](const CertificateFailure& failure) {
    return is_one_of(kOfFewPoints, failure) && !(sampled && failure.name == "unresolved");
  };
  const auto beside_them = [&](const CertificateFailure& failure) { return is_one_of(kBesideThem, failure); };
  return std::any_of(c.failures.begin(), c.failures.end(), of_few_points) &&
         std::all_of(c.failures.begin(), c.failures.end(),
                     [&](const auto& failure) { return of_few_points(failure) || beside_them(failure); });
}

}  // namespace leastcost
