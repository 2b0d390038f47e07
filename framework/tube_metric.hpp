// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include <leastcost/framework/encloses_metric.hpp>
#include <leastcost/framework/problem.hpp>

namespace leastcost {

/// A small matrix of jets, N x N, row by row.
template <int N>
using JetMatrix = std::array<IntervalJet<N>, static_cast<std::size_t>(N* N)>;
template <int N>
using JetPoint = std::array<IntervalJet<N>, static_cast<std::size_t>(N)>;

/// The metric tensor of a problem in a flat space, enclosed.
template <int N>
class TubeMetric {
 public:
  explicit TubeMetric(const Problem& problem) : cost_(find_ability<EnclosesMetric>(*problem.cost)) {}

  /// Whether there is one: a flat space of N dimensions, and a cost by formula.
  static bool exists(const Problem& problem) {
    const ConstraintManifold& domain = *problem.manifold;
    return domain.dimensions().coordinate == N && domain.shape() == Shape::flat &&
           find_ability<HasChart>(domain) == nullptr && find_ability<EnclosesMetric>(*problem.cost) != nullptr;
  }

  /// G at u, which depends on N variables.
  JetMatrix<N> operator()(const JetPoint<N>& u) const {
    std::array<IntervalJet<N>, static_cast<std::size_t>(N * (N + 1) / 2)> upper;
    cost_->enclose_metric(u, upper);
    JetMatrix<N> g;
    std::size_t k = 0;
    for (std::size_t i = 0; i < N; ++i)
      for (std::size_t j = i; j < N; ++j) g[N * i + j] = g[N * j + i] = upper[k++];
    return g;
  }

 private:
  const EnclosesMetric* cost_;
};

}  // namespace leastcost
