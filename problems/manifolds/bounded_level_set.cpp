// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/manifolds/bounded_level_set.hpp"

#include <limits>
#include <utility>

#include "framework/base/dense_solves.hpp"

namespace leastcost {
namespace {

/// A bound whose normal is this nearly normal to the level set does not bound it: it touches it.
constexpr double kTouching = 1e-9;
/// A step along a bound, up to rounding of the normal.
constexpr double kAlong = 1e-9;

/// F with some of its coordinates held: they have no gradient, so that no step moves them.
template <class Held>
class WithHeld final : public ConstraintFunction {
 public:
  WithHeld(const ConstraintFunction& function, const Held& held) : function_(function), held_(held) {}
  int inputs() const override { return function_.inputs(); }
  int outputs() const override { return function_.outputs(); }
  void evaluate(const Eigen::Ref<const Eigen::VectorXd>& x, Eigen::Ref<Eigen::VectorXd> value,
                Eigen::Ref<Points> gradients) const override {
    function_.evaluate(x, value, gradients);
    for (Index i = 0; i < x.size(); ++i)
      if (held_[static_cast<std::size_t>(i)] != 0) gradients.row(i).setZero();
  }

 private:
  const ConstraintFunction& function_;
  const Held& held_;
};

}  // namespace

BoundedLevelSet::BoundedLevelSet(std::shared_ptr<const ConstraintFunction> function, Box box)
    : LevelSet(std::move(function)), box_(std::move(box)) {}

/// The bounds that x lies on and that `holds(outward normal)` chooses.
template <class Holds>
BoundedLevelSet::Held BoundedLevelSet::held_by(const Eigen::VectorXd& x, Holds holds) const {
  Held held{};
  Points sides(x.size(), x.size()), basis(x.size(), dimensions().tangent);
  const int count = box_.active(x, sides);
  if (count == 0) return held;
  tangent_basis(x, basis);
  for (int k = 0; k < count; ++k) {
    const Eigen::VectorXd normal = basis * (basis.transpose() * sides.col(k));
    Index coordinate = 0;
    sides.col(k).cwiseAbs().maxCoeff(&coordinate);
    if (normal.norm() > kTouching && holds(normal.normalized()))
      held[static_cast<std::size_t>(coordinate)] = sides(coordinate, k) > 0 ? 1 : -1;
  }
  return held;
}

/// Onto the level set with the held coordinates on their bounds.
bool BoundedLevelSet::solve_held(Eigen::Ref<Eigen::VectorXd> x, const Held& held) const {
  for (Index i = 0; i < x.size(); ++i)
    if (const int side = held[static_cast<std::size_t>(i)]) x[i] = side > 0 ? box_.upper()[i] : box_.lower()[i];
  return solve(WithHeld<Held>(function(), held), x);
}

/// The coordinate that is farthest beyond its bounds, or -1.
int BoundedLevelSet::most_violated(const Eigen::VectorXd& x) const {
  Index worst = 0;
  const double by = (x - box_.upper()).cwiseMax(box_.lower() - x).maxCoeff(&worst);
  return by > 0 ? static_cast<int>(worst) : -1;
}

/// The held coordinate whose bound holds x back from `outside` the most: with outside - x = J' lambda + sum mu_j n_j,
/// the least mu_j < 0; or -1. Those that are kept do not count.
int BoundedLevelSet::most_pulling(const Eigen::VectorXd& outside, const Eigen::VectorXd& x, const Held& held,
                                  const Held& kept) const {
  const int k = function().outputs();
  Eigen::VectorXd value(k), off = outside - x;
  Points gradients(x.size(), k);
  function().evaluate(x, value, gradients);
  Points free = gradients;
  Eigen::VectorXd free_off = off;
  for (Index i = 0; i < x.size(); ++i)
    if (held[static_cast<std::size_t>(i)] != 0) free.row(i).setZero(), free_off[i] = 0;
  off -= gradients * least_squares(free, free_off);
  int worst = -1;
  double least = 0;
  for (Index i = 0; i < x.size(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    if (held[at] == 0 || kept[at] != 0 || held[at] * off[i] >= least) continue;
    least = held[at] * off[i];
    worst = static_cast<int>(i);
  }
  return worst;
}

/// The nearest point of the bounded level set on the bounds `kept`: one bound is taken up or let go at a time.
bool BoundedLevelSet::settle(Eigen::Ref<Eigen::VectorXd> x, const Held& kept) const {
  const Eigen::VectorXd outside = x;
  const int most = 4 * static_cast<int>(x.size());
  Held held = kept;
  bool bounded = held != Held{};
  for (int i = 0; i < most; ++i) {
    Eigen::VectorXd at = outside;
    if (!(bounded ? solve_held(at, held) : LevelSet::project_point(at))) return false;
    const int violated = most_violated(at);
    const int pulling = violated < 0 && bounded && i + 1 < most ? most_pulling(outside, at, held, kept) : -1;
    if (violated < 0 && pulling < 0) {
      x = at;
      return true;
    }
    if (violated >= 0)
      held[static_cast<std::size_t>(violated)] = at[violated] > box_.upper()[violated] ? 1 : -1;
    else
      held[static_cast<std::size_t>(pulling)] = 0;
    bounded = held != Held{};
  }
  return false;
}

bool BoundedLevelSet::project_point(Eigen::Ref<Eigen::VectorXd> x) const { return settle(x, {}); }

void BoundedLevelSet::retract(const CoordinatePath& from, const Points& step, CoordinatePath& to) const {
  prepare_like(from, to);
  const Index first = from.free_begin();
  for (Index i = 0; i < step.cols(); ++i) {
    const Eigen::VectorXd move = step.col(i);
    const Held kept = held_by(from.u.col(first + i), [&move](const Eigen::VectorXd& normal) {
      return normal.dot(move) >= -kAlong * move.norm();
    });
    auto x = to.u.col(first + i);
    x = from.u.col(first + i) + move;
    if (!settle(x, kept)) x.setConstant(std::numeric_limits<double>::quiet_NaN());
  }
}

void BoundedLevelSet::retract_beyond(const CoordinatePath& from, const Points& step, CoordinatePath& to) const {
  prepare_like(from, to);
  const Index first = from.free_begin();
  for (Index i = 0; i < step.cols(); ++i) {
    const Eigen::VectorXd move = step.col(i);
    const Held held = held_by(from.u.col(first + i), [&move](const Eigen::VectorXd& normal) {
      return std::abs(normal.dot(move)) <= kAlong * move.norm();
    });
    auto x = to.u.col(first + i);
    x = from.u.col(first + i) + move;
    if (!solve_held(x, held)) x.setConstant(std::numeric_limits<double>::quiet_NaN());
  }
}

int BoundedLevelSet::active_bounds(const CoordinatePath& path, Index column, Eigen::Ref<Points> normals) const {
  const Eigen::VectorXd x = path.u.col(column);
  int count = 0;
  held_by(x, [&](const Eigen::VectorXd& normal) {
    normals.col(count++) = normal;
    return true;
  });
  return count;
}

std::string BoundedLevelSet::why_not_projected(const Eigen::VectorXd& x) const {
  Eigen::VectorXd on = x;
  if (LevelSet::project_point(on))
    return "the nearest point of the whole set is outside the box, and none was found inside";
  return LevelSet::why_not_projected(x);
}

}  // namespace leastcost
