// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <limits>
#include <span>
#include <sstream>
#include <string>

#include <leastcost/framework/cost/has_conformal_metric.hpp>
#include <leastcost/framework/cost/segment_cost_function.hpp>

namespace leastcost {

template <class S, int D>
std::span<const S> numbers_of(const Point<S, D>& x) {
  return {x.data(), static_cast<std::size_t>(x.size())};
}

/// c(a, b) = n(m) |b - a| with n in the middle m: the integral of n along the segment to second order, and exactly
/// where n is linear. +infinity where n is negative, infinite or NaN at an end or in the middle.
///
/// Field: `template <class S> S operator()(std::span<const S> x) const`, negative or not finite outside its domain, for
/// intervals unknown where x may lie outside; `std::string unit() const`; and `std::string
/// why_outside(std::span<const double> x) const`, the words after "at (1, 2) ".
template <class Field, int D>
struct IsotropicLength {
  static constexpr int dim = D;
  Field n;

  CostTraits traits() const { return {.unit = n.unit(), .symmetric = true}; }

  template <class S>
  Point<S, D> residual(const Point<S, D>& a, const Point<S, D>& b) const {
    Point<S, D> u = b - a;
    if (!inside(plain<S>(a)) || !inside(plain<S>(b)) || !inside(plain<S>(Point<S, D>(0.5 * (a + b)))))
      return Point<S, D>::Constant(a.size(), S(std::numeric_limits<double>::infinity()));
    const Point<S, D> middle = 0.5 * (a + b);
    const S factor = n(numbers_of<S, D>(middle));
    for (Eigen::Index i = 0; i < u.size(); ++i) u[i] *= factor;
    return u;
  }
  template <class S>
  S value(const Point<S, D>& a, const Point<S, D>& b) const {
    return residual<S>(a, b).squaredNorm();
  }

  /// q = g(m) |u|^2 with g = n^2 and u = b - a: n is differentiated in m alone, half as many directions as both ends
  /// have.
  double gradient(const Point<double, D>& a, const Point<double, D>& b, Point<double, D>& ga,
                  Point<double, D>& gb) const requires(D != Eigen::Dynamic) {
    const double q = value<double>(a, b);
    if (!std::isfinite(q)) return q;
    const Point<double, D> u = b - a;
    const auto g = squared_index<Dual<double, D>>(Point<double, D>(0.5 * (a + b)));
    for (int i = 0; i < D; ++i) {
      const double in_u = 2 * g.value * u[i], in_m = 0.5 * u.squaredNorm() * g.d[static_cast<std::size_t>(i)];
      ga[i] = in_m - in_u;
      gb[i] = in_m + in_u;
    }
    return q;
  }
  void hessian(const Point<double, D>& a, const Point<double, D>& b, Eigen::Ref<Points> h) const
      requires(D != Eigen::Dynamic) {
    using Square = Eigen::Matrix<double, D, D>;
    const Point<double, D> u = b - a;
    const auto g = squared_index<Dual<Dual<double, D>, D>>(Point<double, D>(0.5 * (a + b)));
    const double length2 = u.squaredNorm();
    Square mixed, in_m;  // second derivatives of q; mixed: rows u, columns m
    for (int i = 0; i < D; ++i)
      for (int k = 0; k < D; ++k) {
        const auto row = static_cast<std::size_t>(i), column = static_cast<std::size_t>(k);
        mixed(i, k) = 2 * u[i] * g.d[column].value;
        in_m(i, k) = 0.25 * length2 * g.d[row].d[column];
      }
    const Square in_u = 2 * g.value.value * Square::Identity();
    const Square both = 0.5 * (mixed + mixed.transpose()), across = 0.5 * (mixed.transpose() - mixed);
    h.topLeftCorner(D, D) = in_u - both + in_m;
    h.bottomRightCorner(D, D) = in_u + both + in_m;
    h.topRightCorner(D, D) = across - in_u + in_m;
    h.bottomLeftCorner(D, D) = h.topRightCorner(D, D).transpose();
  }

  double line_element(const Eigen::VectorXd& x, const Eigen::VectorXd& v) const {
    const double factor = n(std::span<const double>(x.data(), static_cast<std::size_t>(x.size())));
    return factor >= 0 && std::isfinite(factor) ? factor * v.norm() : std::numeric_limits<double>::infinity();
  }

  std::string why_infinite(const Eigen::VectorXd& a, const Eigen::VectorXd& b) const {
    const Eigen::VectorXd middle = (a + b) / 2;
    for (const Eigen::VectorXd& x : {a, b, middle}) {
      if (inside(Point<double, D>(x))) continue;
      std::ostringstream out;
      out << "at " << x.format(Eigen::IOFormat(6, Eigen::DontAlignCols, ", ", ", ", "", "", "(", ")")) << " "
          << n.why_outside({x.data(), static_cast<std::size_t>(x.size())});
      return out.str();
    }
    return "";
  }

 private:
  bool inside(const Point<double, D>& x) const {
    const double factor = n(numbers_of<double, D>(x));
    return factor >= 0 && std::isfinite(factor);
  }
  template <class S>
  static Point<double, D> plain(const Point<S, D>& x) {
    Point<double, D> p(x.size());
    for (Eigen::Index i = 0; i < x.size(); ++i) p[i] = innermost(x[i]);
    return p;
  }
  /// n^2 at a place, with its derivatives.
  template <class S>
  S squared_index(const Point<double, D>& place) const {
    Point<S, D> x;
    for (int i = 0; i < D; ++i) {
      const auto k = static_cast<std::size_t>(i);
      x[i] = S(place[i]);
      x[i].d[k] = 1.0;
      if constexpr (!std::is_same_v<S, Dual<double, D>>) x[i].value.d[k] = 1;
    }
    const S factor = n(numbers_of<S, D>(x));
    return factor * factor;
  }
};

template <class Field, int D>
class IsotropicLengthCost : public SegmentCostOf<IsotropicLength<Field, D>>,
                            public ConformalMetricBy<IsotropicLengthCost<Field, D>> {
 public:
  using SegmentCostOf<IsotropicLength<Field, D>>::SegmentCostOf;

  Eigen::MatrixXd base() const override { return Eigen::MatrixXd::Identity(this->dim(), this->dim()); }
  template <class Jet>
  Jet squared_index(std::span<const Jet> x) const {
    const Jet n = this->function().n(x);
    return n > Jet(0.0) ? square(n) : Jet::unknown();
  }
};

}  // namespace leastcost
