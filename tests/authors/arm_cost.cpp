// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// Costs of a stranger in seven dimensions, of both kinds: q alone, and a residual. Compiled only: tests/authors asks
// that this takes 10 seconds at most and draws no warning.
#include <cmath>
#include <memory>

#include <leastcost/framework/segment_cost_function.hpp>

namespace {

using namespace leastcost;

/// Kinetic energy of a planar arm with seven joints: a Riemannian metric of the joint angles.
struct ArmMotion {
  static constexpr int dim = 7;
  CostTraits traits() const { return {.unit = "sqrt(J) s"}; }
  template <class S>
  S value(const Point<S, 7>& a, const Point<S, 7>& b) const {
    using std::cos, std::sin;
    const Point<S, 7> rate = b - a, angle = 0.5 * (a + b);
    S q = 0.1 * rate.squaredNorm();
    S sum(0.0), turn(0.0), x(0.0), y(0.0);
    for (int i = 0; i < 7; ++i) {
      sum += angle[i];
      turn += rate[i];
      x -= sin(sum) * turn;
      y += cos(sum) * turn;
      q += x * x + y * y;
    }
    return q;
  }
};

/// A metric by its entries, and a root of it as residual.
struct Field {
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

std::shared_ptr<const SegmentCost> make_arm_cost();
std::shared_ptr<const SegmentCost> make_field_cost();

std::shared_ptr<const SegmentCost> make_arm_cost() { return make_segment_cost(ArmMotion{}); }
std::shared_ptr<const SegmentCost> make_field_cost() { return make_segment_cost(Field{}); }
