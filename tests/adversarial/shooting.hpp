// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

/// Geodesics of ellipsoids by shooting, in long double: a truth that shares nothing with the solver.
namespace leastcost::test {

struct TrueGeodesic {
  double length = 0;
  bool minimum = false;  ///< no conjugate point before its end
};

class EllipsoidShooting {
 public:
  using Real = long double;
  using Vector = Eigen::Matrix<Real, 3, 1>;

  explicit EllipsoidShooting(const Eigen::Vector3d& axes) : w_(axes.cast<Real>().cwiseAbs2().cwiseInverse()) {}

  /// The geodesic from a to b near a path of that length which leaves a towards `next`; nothing where shooting does not
  /// get there. Where the given direction does not lead there those around it are tried.
  std::optional<TrueGeodesic> between(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& next,
                                      double about) const {
    const Aim aim{onto(a.cast<Real>()), onto(b.cast<Real>()), about,
                  tangent(onto(a.cast<Real>()), (next - a).cast<Real>())};
    if (const auto found = newton(aim, 0)) return found;
    constexpr int kAngles = 60;
    constexpr Real kWidest = 0.6L;
    std::vector<std::pair<Real, Real>> misses;  // and their angles
    for (int i = -kAngles; i <= kAngles; ++i) {
      const Real angle = kWidest * static_cast<Real>(i) / kAngles;
      misses.emplace_back((shoot(aim.from, aim.at(angle, *this), about, kSteps / 10).x - aim.to).norm(), angle);
    }
    std::sort(misses.begin(), misses.end());
    for (std::size_t i = 0; i < 4; ++i)
      if (const auto found = newton(aim, misses[i].second)) return found;
    return std::nullopt;
  }

 private:
  static constexpr int kSteps = 10000;

  struct Aim {
    Vector from, to;
    Real about;
    Vector v;  ///< unit tangent at the start
    Vector at(Real angle, const EllipsoidShooting& on) const {
      return std::cos(angle) * v + std::sin(angle) * on.gradient(from).normalized().cross(v);
    }
  };

  std::optional<TrueGeodesic> newton(const Aim& aim, Real angle) const {
    Real length = aim.about;
    for (int round = 0; round < 30; ++round) {
      const State end = shoot(aim.from, aim.at(angle, *this), length, kSteps);
      const Vector miss = aim.to - end.x;
      const Vector across = gradient(end.x).normalized().cross(end.v);
      // (What is left along the normal is what integration drifts off the surface.)
      if (std::hypot(miss.dot(across), miss.dot(end.v)) < 1e-13L && miss.norm() < 1e-9L)
        return TrueGeodesic{static_cast<double>(length + miss.dot(end.v)), !end.conjugate};  // one more Newton step
      if (!(std::abs(end.j) > 1e-9L)) return std::nullopt;
      Real turn = miss.dot(across) / end.j, more = miss.dot(end.v);
      const Real too_much = std::max(std::abs(turn) / 0.05L, std::abs(more) / (0.1L * length));
      if (too_much > 1) turn /= too_much, more /= too_much;
      angle += turn;
      length += more;
      if (!(std::abs(length / aim.about - 1) < 0.1L) || !(std::abs(angle) < 1)) return std::nullopt;
    }
    return std::nullopt;
  }

  Vector tangent(const Vector& x, const Vector& v) const {
    const Vector normal = gradient(x).normalized();
    return (v - normal.dot(v) * normal).normalized();
  }

  /// Position, direction, and the Jacobi field of turning the start.
  struct State {
    Vector x, v;
    Real j = 0, dj = 1;
    bool conjugate = false;
  };

  Vector gradient(const Vector& x) const { return w_.cwiseProduct(x); }
  Vector onto(const Vector& x) const { return x / std::sqrt(x.dot(gradient(x))); }
  Real curvature(const Vector& x) const {
    const Real g2 = gradient(x).squaredNorm();
    return w_.prod() * x.dot(gradient(x)) / (g2 * g2);
  }
  State slope(const State& s) const {
    const Vector g = gradient(s.x);
    return {s.v, -s.v.dot(w_.cwiseProduct(s.v)) / g.squaredNorm() * g, s.dj, -curvature(s.x) * s.j};
  }
  static State step(const State& s, const State& d, Real h) {
    return {s.x + h * d.x, s.v + h * d.v, s.j + h * d.j, s.dj + h * d.dj};
  }
  State shoot(const Vector& from, const Vector& v, Real length, int steps) const {
    const Real h = length / static_cast<Real>(steps);
    State s{from, v};
    bool conjugate = false;
    for (int i = 0; i < steps; ++i) {
      const State a = slope(s), b = slope(step(s, a, h / 2)), c = slope(step(s, b, h / 2)), d = slope(step(s, c, h));
      s = {s.x + h / 6 * (a.x + 2 * b.x + 2 * c.x + d.x), s.v + h / 6 * (a.v + 2 * b.v + 2 * c.v + d.v),
           s.j + h / 6 * (a.j + 2 * b.j + 2 * c.j + d.j), s.dj + h / 6 * (a.dj + 2 * b.dj + 2 * c.dj + d.dj)};
      conjugate = conjugate || s.j < 0;
    }
    s.conjugate = conjugate;
    return s;
  }

  Vector w_;
};

}  // namespace leastcost::test
