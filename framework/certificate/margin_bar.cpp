// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "framework/certificate/margin_bar.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include <leastcost/framework/domain/fits_segments.hpp>
#include <leastcost/framework/energy/path_energy.hpp>
#include <leastcost/framework/path/kernel.hpp>

namespace leastcost {
namespace {

constexpr double kFalls = 3;  ///< by this factor at least between two levels: 4 at second order

/// H = s: the energy is the cost itself.
struct CostItself {
  static constexpr KernelKind kind = KernelKind::linear_at_zero;
  static constexpr bool strictly_convex = false;
  Jet2 operator()(double q) const {
    const double s = std::sqrt(q);
    return s > 0 ? Jet2{s, 0.5 / s, -0.25 / (s * q)} : Jet2{};
  }
};

std::map<int, double> costs_by_obstacle(const Problem& problem, const Refinement& refinement, std::size_t level,
                                        const Deadline& deadline) {
  Problem measured = problem;
  measured.manifold = refinement.domains[level];
  measured.kernel = make_kernel<CostItself>();
  std::map<int, double> costs;
  const auto* domain = find_ability<FitsSegments>(*measured.manifold);
  if (domain == nullptr) return costs;
  PathEnergy energy(measured, 1, deadline);
  Points gradient;
  energy.value_and_gradient(refinement.paths[level], gradient);
  for (const MarginCost& margin : domain->margin_costs(refinement.paths[level], gradient))
    costs[margin.obstacle] = margin.cost;
  return costs;
}

}  // namespace

double margin_bar(const Problem& problem, const Refinement& refinement, const Deadline& deadline) {
  if (find_ability<FitsSegments>(*problem.manifold) == nullptr) return 0;
  std::vector<std::map<int, double>> levels;
  for (std::size_t k = 0; k < refinement.paths.size(); ++k)
    levels.push_back(costs_by_obstacle(problem, refinement, k, deadline));
  if (levels.empty()) return 0;
  double bar = 0;
  for (const auto& margin : levels.back()) {  // obstacle and cost
    double finer = margin.second;
    const bool falls = std::all_of(std::next(levels.rbegin()), levels.rend(), [&](const auto& level) {
      const auto found = level.find(margin.first);
      const bool less = found != level.end() && kFalls * finer <= found->second;
      if (less) finer = found->second;
      return less;
    });
    if (!falls) bar += margin.second;
  }
  return bar;
}

}  // namespace leastcost
