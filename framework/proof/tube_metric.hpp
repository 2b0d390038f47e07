// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <leastcost/framework/cost/encloses_metric.hpp>
#include <leastcost/framework/domain/encloses_chart.hpp>
#include <leastcost/framework/domain/encloses_level_set.hpp>
#include <leastcost/framework/problem/problem.hpp>

namespace leastcost {

/// A small matrix of jets, D x D, row by row.
template <int N, int D = N>
using JetMatrix = std::array<IntervalJet<N>, static_cast<std::size_t>(D* D)>;
template <int N, int D = N>
using JetPoint = std::array<IntervalJet<N>, static_cast<std::size_t>(D)>;

/// The metric tensor of a problem in its D coordinates, which are functions of N variables, enclosed: of a flat space,
/// of the one around a surface, or pulled back to a chart.
template <int N, int D>
class TubeMetric {
 public:
  explicit TubeMetric(const Problem& problem)
      : cost_(find_ability<EnclosesMetric>(*problem.cost)),
        chart_(find_ability<EnclosesChart>(*problem.manifold)),
        ambient_(static_cast<std::size_t>(problem.manifold->dimensions().ambient)) {
    const auto* surface = find_ability<EnclosesLevelSet>(*problem.manifold);
    if (surface != nullptr) surface_ = surface->level_set_enclosure();
  }

  /// Whether there is one: the cost is a formula, and the domain a flat space of N dimensions, a chart by formula or,
  /// for D = N + 1, a surface by formula.
  static bool exists(const Problem& problem) {
    const ConstraintManifold& domain = *problem.manifold;
    const Dimensions dimensions = domain.dimensions();
    if (dimensions.coordinate != D || find_ability<EnclosesMetric>(*problem.cost) == nullptr) return false;
    const bool chart = find_ability<HasChart>(domain) != nullptr;
    if constexpr (D > N) return dimensions.tangent == N && !chart && find_ability<EnclosesLevelSet>(domain) != nullptr;
    if (!chart) return domain.shape() == Shape::flat;
    return N == 2 && dimensions.ambient <= static_cast<Index>(kMostAmbient) &&
           find_ability<EnclosesChart>(domain) != nullptr;
  }

  /// G at u.
  JetMatrix<N, D> operator()(const JetPoint<N, D>& u) const {
    if constexpr (N == 2 && D == 2)
      if (chart_ != nullptr) {
        std::array<Jet, kMostAmbient> x;
        std::array<Jet, N * kMostAmbient> jacobian;
        chart_->enclose_chart(u, std::span(x).first(ambient_), std::span(jacobian).first(N * ambient_));
        return pulled_back(x, jacobian);
      }
    std::array<Jet, kEntries> upper;
    cost_->enclose_metric(u, std::span(upper).first(static_cast<std::size_t>(D * (D + 1) / 2)));
    JetMatrix<N, D> g;
    std::size_t k = 0;
    for (std::size_t i = 0; i < D; ++i)
      for (std::size_t j = i; j < D; ++j) g[D * i + j] = g[D * j + i] = upper[k++];
    return g;
  }

  /// That on which the tube lies, for D > N.
  const LevelSetEnclosure& surface() const { return *surface_; }

  /// J'G J at the ambient position x, a function of N variables whose derivatives are J, row by row.
  JetMatrix<N> pulled_back(std::span<const IntervalJet<N>> x, std::span<const IntervalJet<N>> jacobian) const {
    std::array<Jet, kEntries> upper;
    cost_->enclose_metric(x.first(ambient_), upper);
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

 private:
  using Jet = IntervalJet<N>;
  static constexpr std::size_t kMostAmbient = 3, kEntries = kMostAmbient * (kMostAmbient + 1) / 2;

  static bool is_zero(const IntervalJet<N>& x) { return x.is_constant() && x.value().hi == 0; }

  const EnclosesMetric* cost_;
  const EnclosesChart* chart_;
  const LevelSetEnclosure* surface_ = nullptr;
  std::size_t ambient_;
};

}  // namespace leastcost
