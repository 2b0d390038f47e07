// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// A cost of a stranger in seven dimensions, by a residual. Compiled only: tests/authors asks that this takes 10
// seconds at most and draws no warning.
#include <cmath>
#include <memory>

#include <leastcost/framework/cost/segment_cost_function.hpp>

namespace {

using namespace leastcost;

/// A metric by its entries, and a root of it as residual.
struct RootOfMetric {
  static constexpr int dim = 7;
  CostTraits traits() const { return {.unit = "length"}; }
  template <class S>
  Point<S, 7> residual(const Point<S, 7>& a, const Point<S, 7>& b) const {
    using std::cos, std::exp, std::sin;
    const Point<S, 7> d = b - a, m = 0.5 * (a + b);
    Eigen::Matrix<S, 7, 7> root = Eigen::Matrix<S, 7, 7>::Identity();
    for (int i = 0; i < 7; ++i)
      for (int j = 0; j < i; ++j) root(i, j) = 0.1 * sin(m[i]) * cos(m[j]) * exp(-m[i] * m[j]);
    return root.transpose() * d;
  }
  template <class S>
  S value(const Point<S, 7>& a, const Point<S, 7>& b) const {
    return residual<S>(a, b).squaredNorm();
  }
};

}  // namespace

std::shared_ptr<const SegmentCost> make_root_cost();
std::shared_ptr<const SegmentCost> make_root_cost() { return make_segment_cost(RootOfMetric{}); }
