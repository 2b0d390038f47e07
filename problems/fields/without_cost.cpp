// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/fields/without_cost.hpp"

#include <algorithm>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/cost/segment_cost.hpp>
#include <leastcost/framework/domain/manifold.hpp>
#include "framework/base/point_text.hpp"

namespace leastcost {

std::string why_without_cost(const Problem& problem, const Eigen::VectorXd& u) {
  const Points x = positions(*problem.manifold, {u, {}, true});
  const SegmentCost& cost = *problem.cost;
  if (!x.allFinite() || x.rows() != cost.dim()) return "";
  if (const auto* explains = find_ability<ExplainsInfinity>(cost)) {
    std::string why = explains->why_infinite(x.col(0), x.col(0));
    if (!why.empty()) return why;
  }
  if (find_ability<HasChart>(*problem.manifold) != nullptr) return "";
  constexpr double kMove = 1e-6;  // of the coordinates: a cost that knows moves alone
  double some = 0;
  for (Eigen::Index k = 0; k < x.rows(); ++k)
    for (const double sign : {1.0, -1.0}) {
      some = cost.line_element(x.col(0), sign * Eigen::VectorXd::Unit(x.rows(), k));
      if (some >= 0 && std::isfinite(some)) return "";
    }
  if (const auto* explains = find_ability<ExplainsInfinity>(cost)) {
    const Eigen::VectorXd move = kMove * (1 + x.col(0).norm()) * Eigen::VectorXd::Unit(x.rows(), 0);
    std::string why = explains->why_infinite(x.col(0) - move / 2, x.col(0) + move / 2);
    if (!why.empty()) return why;
  }
  return "at " + point_text(x.col(0)) + " the cost of a unit of length is " + short_number(some, 6);
}

std::string why_some_without_cost(const Problem& problem, const std::vector<double>& values,
                                  const std::function<Eigen::VectorXd(std::size_t)>& node) {
  constexpr std::size_t kMost = 20'000;
  const auto without = static_cast<std::size_t>(
      std::count_if(values.begin(), values.end(), [](double value) { return !std::isfinite(value); }));
  const std::size_t each = without / kMost + 1;
  std::size_t seen = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (std::isfinite(values[i]) || seen++ % each != 0) continue;
    std::string why = why_without_cost(problem, node(i));
    if (!why.empty()) return why;
  }
  return "";
}

void check_cost_at(const Problem& problem, const std::vector<Eigen::VectorXd>& places) {
  for (const Eigen::VectorXd& place : places) {
    const std::string why = why_without_cost(problem, place);
    if (!why.empty()) throw InputError("field: no path leaves the place " + point_text(place) + ": " + why);
  }
}

}  // namespace leastcost
