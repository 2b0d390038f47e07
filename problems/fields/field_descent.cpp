// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/fields/field_descent.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>

#include <leastcost/framework/domain/manifold.hpp>
#include "problems/fields/grid_search.hpp"

namespace leastcost {
namespace {

using Eigen::Vector2d;

constexpr double kLost = std::numeric_limits<double>::infinity();
constexpr double kReach = 2;  // of a step, in steps of the lattice

Vector2d in_steps(const CostField& field, const Vector2d& x) { return (x - field.lower).cwiseQuotient(field.step); }

/// The nodes that a step from there may end at, along one axis.
std::int32_t first_near(const CostField& field, const Vector2d& at, std::size_t d) {
  return static_cast<std::int32_t>(
      std::clamp(std::floor(at[static_cast<Eigen::Index>(d)] - kReach), 0.0, field.count[d] - 1.0));
}
std::int32_t last_near(const CostField& field, const Vector2d& at, std::size_t d) {
  return static_cast<std::int32_t>(
      std::clamp(std::ceil(at[static_cast<Eigen::Index>(d)] + kReach), 0.0, field.count[d] - 1.0));
}

/// Between four values in a row, a cubic through the two in the middle (Catmull, Rom).
double cubic(const std::array<double, 4>& v, double t) {
  return v[1] +
         0.5 * t * (v[2] - v[0] + t * (2 * v[0] - 5 * v[1] + 4 * v[2] - v[3] + t * (3 * (v[1] - v[2]) + v[3] - v[0])));
}

class FieldDescent {
 public:
  FieldDescent(const CostField& field, const Problem& problem) : field_(field), problem_(problem), moves_(problem) {}

  /// From the place on to the nearest of those of the field; without points where it is lost on the way.
  std::vector<Vector2d> way(const Vector2d& place) const {
    std::vector<Vector2d> way = {place};
    const std::size_t most = 8 * (field_.values.size() + 100);
    double here = kLost;
    while (way.size() < most) {
      const Step end = last_step(way.back()), next = next_step(way.back(), here);
      if (!(std::min(end.total, next.total) < kLost)) break;
      const bool as_the_field = here < kLost && end.total <= (1 + kRounding) * here;
      if (end.total < kLost && (end.total <= next.total || as_the_field)) {
        if (end.to != way.back() || way.size() == 1) way.push_back(end.to);
        return way;
      }
      way.push_back(next.to);
      here = next.value;
    }
    return {};
  }

 private:
  static constexpr double kRounding = 1e-9;
  struct Step {
    double total = kLost;  ///< of the whole way
    double value = kLost;  ///< of the field where the step ends
    Vector2d to = Vector2d::Zero();
  };

  Eigen::VectorXd ambient(const Vector2d& u) const { return positions(*problem_.manifold, {u, {}, true}).col(0); }
  double move(const Vector2d& from, const Vector2d& to) const {
    const Eigen::VectorXd a = ambient(from), b = ambient(to);
    const double cost = field_.to_places ? moves_.cost(a, b) : moves_.cost(b, a);
    return cost < kLost && moves_.clear(a, b, kLost) ? cost : kLost;
  }

  Vector2d in_steps(const Vector2d& x) const { return leastcost::in_steps(field_, x); }

  /// Straight to a place of the field that is near.
  Step last_step(const Vector2d& x) const {
    Step best;
    for (const Eigen::VectorXd& place : field_.places) {
      if (in_steps(x - place + field_.lower).norm() > 2 * kReach) continue;
      const double cost = move(x, place);
      if (cost < best.total) best = {cost, 0, place};
    }
    return best;
  }

  /// NaN where a value is missing.
  double value_at(const Vector2d& x) const {
    const Vector2d at = in_steps(x);
    std::array<std::int32_t, 2> low{};
    for (std::size_t d = 0; d < 2; ++d) {
      const double along = at[static_cast<Eigen::Index>(d)];
      if (!(along >= 0) || !(along <= field_.count[d] - 1.0)) return std::nan("");
      low[d] = std::min(static_cast<std::int32_t>(along), field_.count[d] - 2);
    }
    const double s = at[0] - low[0], t = at[1] - low[1];
    if (low[0] > 0 && low[1] > 0 && low[0] + 2 < field_.count[0] && low[1] + 2 < field_.count[1]) {
      std::array<double, 4> rows{};
      for (std::int32_t j = 0; j < 4; ++j) {
        std::array<double, 4> row{};
        for (std::int32_t i = 0; i < 4; ++i)
          row[static_cast<std::size_t>(i)] = field_.value(low[0] + i - 1, low[1] + j - 1);
        rows[static_cast<std::size_t>(j)] = cubic(row, s);
      }
      const double value = cubic(rows, t);
      if (std::isfinite(value)) return value;
    }
    const auto corner = [&](std::int32_t i, std::int32_t j) { return field_.value(low[0] + i, low[1] + j); };
    return (1 - t) * ((1 - s) * corner(0, 0) + s * corner(1, 0)) + t * ((1 - s) * corner(0, 1) + s * corner(1, 1));
  }

  /// The least of the field and the move over a circle around x and the nodes within it, where the field is lower than
  /// `below`: no way goes in circles.
  Step next_step(const Vector2d& x, double below) const {
    constexpr int kDirections = 32, kHalvings = 8;
    constexpr double kLoss = 0.01;  // of the value: beside cells without data, and between dear ones, nodes know better
    Step best;
    double angle = 0;
    const auto look = [&](const Vector2d& to, double value) {
      if (!(value < below) || !(value < best.total)) return false;
      const double total = value + move(x, to);
      if (!(total < best.total)) return false;
      best = {total, value, to};
      return true;
    };
    const auto turn = [&](double a) {
      const Vector2d to = x + kReach * field_.step.cwiseProduct(Vector2d(std::cos(a), std::sin(a)));
      if (look(to, value_at(to))) angle = a;
    };
    constexpr double kWidth = 2 * std::numbers::pi / kDirections;
    for (int k = 0; k < kDirections; ++k) turn(k * kWidth);
    if (best.total < kLost)
      for (double width = kWidth / 2; width > kWidth / (1 << kHalvings); width /= 2) {
        const double middle = angle;
        turn(middle + width);
        turn(middle - width);
      }
    if (best.total < kLost && below < kLost && best.total <= (1 + kLoss) * below) return best;
    const Vector2d at = in_steps(x);
    for (std::int32_t j = first_near(field_, at, 1); j <= last_near(field_, at, 1); ++j)
      for (std::int32_t i = first_near(field_, at, 0); i <= last_near(field_, at, 0); ++i)
        look(field_.node(i, j), field_.value(i, j));
    return best;
  }

  const CostField& field_;
  const Problem& problem_;
  MoveCheck moves_;
};

}  // namespace

bool is_reached(const CostField& field, const Vector2d& x) {
  const Vector2d at = in_steps(field, x);
  for (std::int32_t j = first_near(field, at, 1); j <= last_near(field, at, 1); ++j)
    for (std::int32_t i = first_near(field, at, 0); i <= last_near(field, at, 0); ++i)
      if (std::isfinite(field.value(i, j))) return true;
  return false;
}

std::vector<Vector2d> steepest_way(const CostField& field, const Problem& problem, const Vector2d& place) {
  return FieldDescent(field, problem).way(place);
}

}  // namespace leastcost
