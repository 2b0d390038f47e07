// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/costs/lagrangian/lagrangian_check.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <limits>
#include <random>
#include <sstream>
#include <vector>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/numbers/dual.hpp>
#include <leastcost/framework/numbers/interval_jet.hpp>
#include "framework/base/point_text.hpp"
#include "framework/base/symmetric_eigen.hpp"

namespace leastcost {
namespace {

constexpr int kBoxes = 20000;           ///< boxes that are looked at, at most
constexpr int kSamples = 400;           ///< places and directions in which homogeneity is measured
constexpr double kFlat = 1e-9;          ///< curvature across v, relative to F, below which there is none
constexpr double kHomogeneous = 1e-9;   ///< relative
constexpr double kSmallestPart = 1e-4;  ///< of a range, below which it is not halved

[[noreturn]] void refuse(const std::string& why) { throw OptionError("lagrangian", why); }

std::string tuple_text(const Eigen::VectorXd& x) {
  std::ostringstream out;
  out << x.format(Eigen::IOFormat(5, Eigen::DontAlignCols, ", ", ", ", "", "", "(", ")"));
  return out.str();
}

/// Places and directions: x, and v on the face v_face = sign of a cube. Ranges: those of x, then of the other
/// components of v.
struct DirectedBox {
  int face = 0;
  double sign = 1;
  std::vector<Interval> ranges;
};

/// What numbers say about F at a place.
enum class Finding { holds, outside };

/// What intervals say about F in a box: whether it holds, and how wide they are.
struct Enclosed {
  bool holds = false;
  double width = std::numeric_limits<double>::infinity();
};

class LagrangianChecker {
 public:
  LagrangianChecker(const Formula& formula, const LagrangianBox& box, int dim, bool any_shape)
      : formula_(formula), box_(box), dim_(static_cast<std::size_t>(dim)), any_shape_(any_shape) {}

  LagrangianCheck run(const LagrangianForm& form) {
    check_degree(form);
    LagrangianCheck out;
    const bool decided = box_.known() && dim_ <= 3 && halve();
    if ((!decided || any_shape_) && box_.known()) sample();  // whether F is convex is not asked of intervals then
    out.proved = decided && form.degree == 1;
    out.convex = convex_;
    out.note = note(out.proved);
    return out;
  }

 private:
  double value(const Eigen::VectorXd& x, const Eigen::VectorXd& v) const {
    std::vector<double> xv(x.begin(), x.end());
    xv.insert(xv.end(), v.begin(), v.end());
    return formula_(std::span<const double>(xv));
  }

  std::string note(bool proved) const {
    std::ostringstream out;
    out << "cost: F(x, v) is positive, homogeneous of degree 1 in v" << (convex_ && !any_shape_ ? " and convex" : "");
    if (!box_.known()) {
      out << " by assumption: neither the domain nor the ends give a box to check";
      return out.str();
    }
    out << (proved ? ", proved by intervals" : ", sampled") << " for x between " << tuple_text(box_.lower) << " and "
        << tuple_text(box_.upper);
    if (outside_) out << "; it is not defined everywhere in that box";
    return out.str();
  }

  /// Homogeneity by what the text says, or else by numbers.
  void check_degree(const LagrangianForm& form) {
    if (form.has_degree() && form.degree == 1) return;
    const double degree = form.has_degree() ? form.degree : measured_degree();
    if (std::abs(degree - 1) <= kHomogeneous) return;
    std::ostringstream out;
    if (std::abs(degree - 2) <= kHomogeneous)
      out << "F(x, 2 v) = 4 F(x, v): this is an energy, of degree 2 in v, but a cost per length has degree 1: use its "
             "root, \"sqrt(...)\"";
    else if (std::isfinite(degree))
      out << "F(x, v) has degree " << degree
          << " in v, but a cost per length has degree 1: F(x, l v) = l F(x, v) for l > 0";
    else
      out << "F(x, l v) is not a power of l > 0 times F(x, v), but a cost per length has F(x, l v) = l F(x, v)"
          << where_;
    refuse(out.str());
  }

  /// log2 of F(x, 2 v) / F(x, v), where it is the same everywhere; else infinite.
  double measured_degree() {
    std::mt19937_64 engine(1);
    double least = std::numeric_limits<double>::infinity(), most = -least;
    for (int i = 0; i < kSamples; ++i) {
      const Eigen::VectorXd x = random_place(engine), v = random_direction(engine);
      const double one = value(x, v);
      if (!(one > 0) || !std::isfinite(one)) continue;
      for (const double factor : {2.0, 0.3, 7.0}) {
        const double degree = std::log(value(x, factor * v) / one) / std::log(factor);
        if (!(std::max(most, degree) - std::min(least, degree) <= kHomogeneous)) {
          where_ = "; this fails at x = " + tuple_text(x) + ", v = " + tuple_text(v);
          return std::numeric_limits<double>::infinity();
        }
        least = std::min(least, degree), most = std::max(most, degree);
      }
    }
    return least <= most ? (least + most) / 2 : 1;  // nowhere defined: halve() and sample() say so
  }

  Eigen::VectorXd random_place(std::mt19937_64& engine) const {
    std::uniform_real_distribution<double> part(0, 1);
    Eigen::VectorXd x(static_cast<Eigen::Index>(dim_));
    for (Eigen::Index i = 0; i < x.size(); ++i)
      x[i] = box_.known() ? box_.lower[i] + part(engine) * (box_.upper[i] - box_.lower[i]) : part(engine);
    return x;
  }
  Eigen::VectorXd random_direction(std::mt19937_64& engine) const {
    std::normal_distribution<double> normal;
    Eigen::VectorXd v(static_cast<Eigen::Index>(dim_));
    do
      for (double& component : v) component = normal(engine);
    while (!(v.norm() > 1e-3));
    return v.normalized();
  }

  /// Whether intervals decided everywhere. Throws what is refuted.
  bool halve() {
    std::deque<DirectedBox> open = first_boxes();
    for (int looked = 0; !open.empty(); ++looked) {
      const DirectedBox box = std::move(open.front());
      open.pop_front();
      if (looked >= kBoxes) return false;
      if (by_intervals(box).holds) continue;
      if (by_numbers(middle_place(box), middle_direction(box)) == Finding::outside) {
        outside_ = true;
        return false;
      }
      if (!split(box, open)) return false;
    }
    return true;
  }

  std::deque<DirectedBox> first_boxes() const {
    std::deque<DirectedBox> boxes;
    for (std::size_t face = 0; face < dim_; ++face)
      for (const double sign : {-1.0, 1.0}) {
        DirectedBox box{static_cast<int>(face), sign, {}};
        for (std::size_t i = 0; i < dim_; ++i) {
          const auto k = static_cast<Eigen::Index>(i);
          box.ranges.emplace_back(box_.lower[k], box_.upper[k]);
        }
        box.ranges.resize(2 * dim_ - 1, Interval(-1, 1));
        boxes.push_back(box);
      }
    return boxes;
  }

  double full_width(std::size_t range) const {
    if (range >= dim_) return 2;
    const auto k = static_cast<Eigen::Index>(range);
    return box_.upper[k] - box_.lower[k];
  }

  /// Across the range that makes intervals narrowest where it is halved, or the widest.
  bool split(const DirectedBox& box, std::deque<DirectedBox>& open) const {
    std::size_t chosen = 0;
    double least = std::numeric_limits<double>::infinity(), part = 0;
    for (std::size_t i = 0; i < box.ranges.size(); ++i) {
      const double full = full_width(i), own = full > 0 ? box.ranges[i].width() / full : 0;
      if (!(own > kSmallestPart)) continue;
      DirectedBox half = box;
      half.ranges[i].hi = box.ranges[i].middle();
      const double width = by_intervals(half).width;
      if (width < least || (width == least && own > part)) chosen = i, least = width, part = own;
    }
    if (!(part > 0)) return false;
    DirectedBox lower = box, upper = box;
    lower.ranges[chosen].hi = upper.ranges[chosen].lo = box.ranges[chosen].middle();
    open.push_back(std::move(lower));
    open.push_back(std::move(upper));
    return true;
  }

  Eigen::VectorXd middle_place(const DirectedBox& box) const {
    Eigen::VectorXd x(static_cast<Eigen::Index>(dim_));
    for (std::size_t i = 0; i < dim_; ++i) x[static_cast<Eigen::Index>(i)] = box.ranges[i].middle();
    return x;
  }
  Eigen::VectorXd middle_direction(const DirectedBox& box) const {
    Eigen::VectorXd v(static_cast<Eigen::Index>(dim_));
    std::size_t next = dim_;
    for (Eigen::Index i = 0; i < v.size(); ++i) v[i] = i == box.face ? box.sign : box.ranges[next++].middle();
    return v;
  }

  /// In the plane F is differentiated in x and the free component of v; in space in the two of v alone.
  Enclosed by_intervals(const DirectedBox& box) const {
    return dim_ == 2 ? by_jets<3>(box, {0, 1, 2}) : by_jets<2>(box, {-1, -1, -1, 0, 1});
  }

  /// `variable`: number of the variable that each range is one of, -1: none, a constant of the jet.
  template <int N>
  Enclosed by_jets(const DirectedBox& box, std::array<int, 5> variable) const {
    using Jet = IntervalJet<N>;
    std::array<Jet, 6> xv;
    const auto jet = [&](std::size_t range) {
      return variable[range] < 0 ? Jet(box.ranges[range]) : Jet::variable(box.ranges[range], variable[range]);
    };
    for (std::size_t i = 0; i < dim_; ++i) xv[i] = jet(i);
    std::size_t next = dim_;
    for (std::size_t i = 0; i < dim_; ++i) xv[dim_ + i] = static_cast<int>(i) == box.face ? Jet(box.sign) : jet(next++);
    const Jet f = formula_(std::span<const Jet>(xv.data(), 2 * dim_));
    const bool positive = f > Jet(0.0);
    if (any_shape_) return {positive, f.value().width()};
    const int first = N == 3 ? 2 : 0;  // of the variables of v
    const Interval a = f.d(first, first);
    const double width = f.value().width() + a.width();
    if (dim_ == 2) return {positive && a > Interval(0), width};
    const Interval c = f.d(1, 1), b = f.d(0, 1);
    return {positive && a > Interval(0) && a * c > square(b), width + b.width() + c.width()};
  }

  void sample() {
    std::mt19937_64 engine(2);
    for (int i = 0; i < 10 * kSamples; ++i)
      if (by_numbers(random_place(engine), random_direction(engine)) == Finding::outside) outside_ = true;
  }

  /// Throws where F is refuted. Where it is defined for no direction the place lies outside its domain.
  Finding by_numbers(const Eigen::VectorXd& x, const Eigen::VectorXd& v) {
    const double f = value(x, v);
    if (!std::isfinite(f)) return Finding::outside;
    if (!(f > 0)) {
      const double back = value(x, -v);
      if (!(back > 0)) return Finding::outside;
      refuse("F(x, v) must be positive for every v but 0: at x = " + tuple_text(x) + " it is " + short_number(f, 6) +
             " for v = " + tuple_text(v));
    }
    const double bend = least_curvature(x, v);
    if (any_shape_) {
      convex_ = convex_ && bend > -kFlat * f;
      return Finding::holds;
    }
    if (bend > kFlat * f) return Finding::holds;
    std::ostringstream out;
    out << "F(x, v) must be strictly convex across v: at x = " << tuple_text(x) << ", v = " << tuple_text(v)
        << " its second derivative across v is " << bend
        << (dim_ == 2 ? "; to use its convex hull, which zigzags attain, set `convexify: true`" : "");
    refuse(out.str());
  }

  /// Least eigenvalue of F_vv across v, times |v|; v of length 1 gives it per F.
  double least_curvature(const Eigen::VectorXd& x, const Eigen::VectorXd& v) const {
    using S = Dual<Dual<double, 1>, 1>;
    const auto d = static_cast<Eigen::Index>(dim_);
    std::vector<S> xv(2 * dim_);
    Eigen::MatrixXd bend(d, d);
    const auto second = [&](Eigen::Index i, Eigen::Index j) {
      for (Eigen::Index k = 0; k < d; ++k) {
        xv[static_cast<std::size_t>(k)] = S(x[k]);
        S& w = xv[dim_ + static_cast<std::size_t>(k)];
        w = S(v[k]);
        if (k == i) w.value.d[0] = 1;
        if (k == j) w.d[0] = Dual<double, 1>(1.0);
      }
      return formula_(std::span<const S>(xv)).d[0].d[0];
    };
    for (Eigen::Index i = 0; i < d; ++i)
      for (Eigen::Index j = 0; j < d; ++j) bend(i, j) = second(i, j);
    // F_vv v = 0: shifted along v by its own size it keeps its other eigenvalues.
    const Eigen::VectorXd unit = v.normalized();
    const double size = bend.cwiseAbs().maxCoeff();
    if (!std::isfinite(size)) return -std::numeric_limits<double>::infinity();
    bend += (static_cast<double>(d) * size + 1) * unit * unit.transpose();
    return symmetric_eigenvalues((bend + bend.transpose()) / 2)[0] * v.norm();
  }

  const Formula& formula_;
  const LagrangianBox& box_;
  std::size_t dim_;
  bool any_shape_;
  bool outside_ = false;  ///< F is not defined somewhere
  bool convex_ = true;
  std::string where_;
};

}  // namespace

LagrangianCheck check_lagrangian(const Formula& formula, const LagrangianForm& form, const LagrangianBox& box, int dim,
                                 bool any_shape) {
  return LagrangianChecker(formula, box, dim, any_shape).run(form);
}

}  // namespace leastcost
