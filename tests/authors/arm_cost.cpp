// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// A cost of a stranger in seven dimensions, by its q alone. Compiled only: tests/authors asks that this takes 10
// seconds at most and draws no warning.
#include <cmath>
#include <memory>

#include <leastcost/framework/cost/segment_cost_function.hpp>

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

}  // namespace

std::shared_ptr<const SegmentCost> make_arm_cost();
std::shared_ptr<const SegmentCost> make_arm_cost() { return make_segment_cost(ArmMotion{}); }
