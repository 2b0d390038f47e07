// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <leastcost/framework/encloses_chart.hpp>
#include <leastcost/framework/encloses_metric.hpp>
#include <leastcost/framework/problem.hpp>

namespace leastcost {

/// A small matrix of jets, N x N, row by row.
template <int N>
using JetMatrix = std::array<IntervalJet<N>, static_cast<std::size_t>(N* N)>;
template <int N>
using JetPoint = std::array<IntervalJet<N>, static_cast<std::size_t>(N)>;

/// The metric tensor of a problem in its coordinates, enclosed: of a flat space, or pulled back to a chart.
template <int N>
class TubeMetric {
 public:
  explicit TubeMetric(const Problem& problem)
      : cost_(find_ability<EnclosesMetric>(*problem.cost)),
        chart_(find_ability<EnclosesChart>(*problem.manifold)),
        ambient_(static_cast<std::size_t>(problem.manifold->dimensions().ambient)) {}

  /// Whether there is one: a flat space of N dimensions or a chart by formula, and a cost by formula.
  static bool exists(const Problem& problem) {
    const ConstraintManifold& domain = *problem.manifold;
    if (domain.dimensions().coordinate != N || find_ability<EnclosesMetric>(*problem.cost) == nullptr) return false;
    if (find_ability<HasChart>(domain) == nullptr) return domain.shape() == Shape::flat;
    return N == 2 && domain.dimensions().ambient <= static_cast<Index>(kMostAmbient) &&
           find_ability<EnclosesChart>(domain) != nullptr;
  }

  /// G at u, which depends on N variables.
  JetMatrix<N> operator()(const JetPoint<N>& u) const {
    if constexpr (N == 2)
      if (chart_ != nullptr) return pulled_back(u);
    std::array<IntervalJet<N>, kEntries> upper;
    cost_->enclose_metric(u, std::span(upper).first(static_cast<std::size_t>(N * (N + 1) / 2)));
    JetMatrix<N> g;
    std::size_t k = 0;
    for (std::size_t i = 0; i < N; ++i)
      for (std::size_t j = i; j < N; ++j) g[N * i + j] = g[N * j + i] = upper[k++];
    return g;
  }

 private:
  static constexpr std::size_t kMostAmbient = 3, kEntries = kMostAmbient * (kMostAmbient + 1) / 2;

  static bool is_zero(const IntervalJet<N>& x) { return x.is_constant() && x.value().hi == 0; }

  /// J'G J.
  JetMatrix<N> pulled_back(const JetPoint<N>& u) const {
    using Jet = IntervalJet<N>;
    std::array<Jet, kMostAmbient> x;
    std::array<Jet, N * kMostAmbient> jacobian;
    std::array<Jet, kEntries> upper;
    chart_->enclose_chart(u, std::span(x).first(ambient_), std::span(jacobian).first(N * ambient_));
    cost_->enclose_metric(std::span<const Jet>(x).first(ambient_), upper);
    JetMatrix<N> g;
    g.fill(Jet(0.0));
    for (std::size_t p = 0; p < N; ++p)
      for (std::size_t q = p; q < N; ++q) {
        Jet& sum = g[N * p + q];
        std::size_t k = 0;
        for (std::size_t i = 0; i < ambient_; ++i)
          for (std::size_t j = i; j < ambient_; ++j, ++k) {
            if (is_zero(upper[k])) continue;
            const Jet &ip = jacobian[N * i + p], &iq = jacobian[N * i + q], &jp = jacobian[N * j + p],
                      &jq = jacobian[N * j + q];
            sum += upper[k] * (i == j ? (p == q ? square(ip) : ip * iq) : ip * jq + iq * jp);
          }
        g[N * q + p] = sum;
      }
    return g;
  }

  const EnclosesMetric* cost_;
  const EnclosesChart* chart_;
  std::size_t ambient_;
};

}  // namespace leastcost
