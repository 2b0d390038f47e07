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
                  Point<double, D>& gb) const {
    const double q = value<double>(a, b);
    if (!std::isfinite(q)) return ga.setZero(), gb.setZero(), q;
    const Point<double, D> u = b - a;
    double g = 0;
    Point<double, D> slope(a.size());
    squared_index(0.5 * (a + b), g, slope);
    set_slopes(g, slope, u, ga, gb);
    return q;
  }
  double derivatives(const Point<double, D>& a, const Point<double, D>& b, Point<double, D>& ga, Point<double, D>& gb,
                     Eigen::Ref<Points> h) const {
    const double q = value<double>(a, b);
    if (!std::isfinite(q)) return q;
    const Index d = D == Eigen::Dynamic ? a.size() : D;
    const Point<double, D> u = b - a;
    double g = 0;
    Point<double, D> slope(d);
    Square bend(d, d);
    squared_index(0.5 * (a + b), g, slope, bend);
    set_slopes(g, slope, u, ga, gb);
    const double quarter = 0.25 * u.squaredNorm();
    // Second derivatives of q by u alone, by u and m, and by m alone.
    for (Index k = 0; k < d; ++k)
      for (Index i = 0; i < d; ++i) {
        const double in_u = i == k ? 2 * g : 0, in_m = quarter * bend(i, k);
        const double both = u[i] * slope[k] + u[k] * slope[i], across = u[k] * slope[i] - u[i] * slope[k];
        h(i, k) = in_u - both + in_m;
        h(d + i, d + k) = in_u + both + in_m;
        h(i, d + k) = h(d + k, i) = across - in_u + in_m;
      }
    return q;
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
  using Square =
      Eigen::Matrix<double, D, D, 0, D == Eigen::Dynamic ? kMaxDimension : D, D == Eigen::Dynamic ? kMaxDimension : D>;

  static void set_slopes(double g, const Point<double, D>& slope, const Point<double, D>& u, Point<double, D>& ga,
                         Point<double, D>& gb) {
    const double half = 0.5 * u.squaredNorm();
    for (Index i = 0; i < u.size(); ++i) {
      const double in_u = 2 * g * u[i], in_m = half * slope[i];
      ga[i] = in_m - in_u;
      gb[i] = in_m + in_u;
    }
  }

  /// g = n^2 at a place and its slope.
  void squared_index(const Point<double, D>& place, double& g, Point<double, D>& slope) const {
    if constexpr (D != Eigen::Dynamic) {
      Point<Dual<double, D>, D> x;
      for (int i = 0; i < D; ++i) {
        x[i] = Dual<double, D>(place[i]);
        x[i].d[static_cast<std::size_t>(i)] = 1;
      }
      const Dual<double, D> jet = square_of(x);
      g = jet.value;
      for (int i = 0; i < D; ++i) slope[i] = jet.d[static_cast<std::size_t>(i)];
    } else {
      Point<detail::Dual1, D> x = detail::constants<detail::Dual1, D>(place);
      for (Index i = 0; i < x.size(); ++i) {
        x[i].d[0] = 1;
        const detail::Dual1 jet = square_of(x);
        g = jet.value;
        slope[i] = jet.d[0];
        x[i].d[0] = 0;
      }
    }
  }

  /// g = n^2 at a place, its slope and its second derivatives.
  void squared_index(const Point<double, D>& place, double& g, Point<double, D>& slope, Square& bend) const {
    if constexpr (D != Eigen::Dynamic) {
      using S = Dual<Dual<double, D>, D>;
      Point<S, D> x;
      for (int i = 0; i < D; ++i) {
        const auto k = static_cast<std::size_t>(i);
        x[i] = S(place[i]);
        x[i].value.d[k] = 1;
        x[i].d[k] = 1.0;
      }
      const S jet = square_of(x);
      g = jet.value.value;
      for (int i = 0; i < D; ++i) {
        slope[i] = jet.d[static_cast<std::size_t>(i)].value;
        for (int k = 0; k < D; ++k) bend(i, k) = jet.d[static_cast<std::size_t>(i)].d[static_cast<std::size_t>(k)];
      }
    } else {
      Point<detail::Dual11, D> x = detail::constants<detail::Dual11, D>(place);
      for (Index i = 0; i < x.size(); ++i) {
        x[i].d[0].value = 1;
        for (Index k = 0; k <= i; ++k) {
          x[k].value.d[0] = 1;
          const detail::Dual11 jet = square_of(x);
          g = jet.value.value;
          slope[i] = jet.d[0].value;
          bend(i, k) = bend(k, i) = jet.d[0].d[0];
          x[k].value.d[0] = 0;
        }
        x[i].d[0].value = 0;
      }
    }
  }

  template <class S>
  S square_of(const Point<S, D>& x) const {
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
