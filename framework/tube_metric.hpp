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

/// The metric tensor of a problem in the coordinates in which its paths are given: that of the cost in a flat space,
/// pulled back to the chart on a surface, J'GJ.
template <int N>
class TubeMetric {
 public:
  explicit TubeMetric(const Problem& problem)
      : cost_(find_ability<EnclosesMetric>(*problem.cost)),
        chart_(find_ability<EnclosesEmbedding>(*problem.manifold)),
        ambient_(problem.manifold->dimensions().ambient) {}

  /// Whether there is one: cost and domain are formulas.
  static bool exists(const Problem& problem) {
    const Dimensions d = problem.manifold->dimensions();
    if (find_ability<EnclosesMetric>(*problem.cost) == nullptr || d.coordinate != N) return false;
    return problem.manifold->shape() == Shape::flat ||
           (N == 2 && find_ability<EnclosesEmbedding>(*problem.manifold) != nullptr);
  }

  /// G at u, which depends on N variables.
  JetMatrix<N> operator()(const JetPoint<N>& u) const {
    if (chart_ == nullptr) return of_cost(u);
    if constexpr (N == 2) return pulled_back(u);
    return {};
  }

 private:
  static constexpr std::size_t kUpper = N * (N + 1) / 2;

  JetMatrix<N> of_cost(const JetPoint<N>& u) const {
    std::array<IntervalJet<N>, kUpper> upper;
    cost_->enclose_metric(u, upper);
    JetMatrix<N> g;
    std::size_t k = 0;
    for (std::size_t i = 0; i < N; ++i)
      for (std::size_t j = i; j < N; ++j) g[N * i + j] = g[N * j + i] = upper[k++];
    return g;
  }

  JetMatrix<N> pulled_back(const JetPoint<N>& u) const {
    using Outer = EnclosesEmbedding::Jet;
    constexpr std::size_t kMost = 3;
    std::array<Outer, 2> at;
    for (std::size_t i = 0; i < 2; ++i) {
      at[i].value = u[i];
      at[i].d[i] = IntervalJet<2>(1.0);
    }
    std::array<Outer, kMost> x;
    chart_->enclose_embedding(at, x);
    std::array<IntervalJet<2>, kMost> place;
    for (std::size_t i = 0; i < kMost; ++i) place[i] = x[i].value;
    std::array<IntervalJet<2>, kMost*(kMost + 1) / 2> upper;
    cost_->enclose_metric(place, upper);
    JetMatrix<N> g;
    for (std::size_t p = 0; p < 2; ++p)
      for (std::size_t q = p; q < 2; ++q) {
        IntervalJet<2> sum(0.0);
        std::size_t k = 0;
        for (std::size_t i = 0; i < kMost; ++i)
          for (std::size_t j = i; j < kMost; ++j, ++k) {
            sum += upper[k] * x[i].d[p] * x[j].d[q];
            if (j > i) sum += upper[k] * x[j].d[p] * x[i].d[q];
          }
        g[2 * p + q] = g[2 * q + p] = sum;
      }
    return g;
  }

  const EnclosesMetric* cost_;
  const EnclosesEmbedding* chart_;
  int ambient_;
};

}  // namespace leastcost
