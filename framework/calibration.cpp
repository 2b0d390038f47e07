// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "framework/calibration.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "framework/point_text.hpp"
#include "framework/symmetric_eigen.hpp"
#include "framework/tube_metric.hpp"

namespace leastcost {
namespace {

/// Gauss-Legendre nodes and weights on [0, 1], Abramowitz and Stegun 25.4.30.
constexpr std::array<double, 5> kNodes = {0.04691007703066800, 0.23076534494715845, 0.5, 0.76923465505284155,
                                          0.95308992296933200};
constexpr std::array<double, 5> kWeights = {0.11846344252809454, 0.23931433524968324, 0.28444444444444444,
                                            0.23931433524968324, 0.11846344252809454};

/// c0 + c1 s + c2 s^2 + c3 s^3.
struct Cubic {
  std::array<double, 4> c = {};

  /// With values a, b and slopes da, db at 0 and 1.
  static Cubic hermite(double a, double b, double da, double db) {
    return {{a, da, 3 * (b - a) - 2 * da - db, 2 * (a - b) + da + db}};
  }
  static Cubic line(double a, double b) { return {{a, b - a, 0, 0}}; }
  /// The same, around another origin.
  Cubic around(double t) const {
    return {
        {c[0] + t * (c[1] + t * (c[2] + t * c[3])), c[1] + t * (2 * c[2] + t * 3 * c[3]), c[2] + 3 * t * c[3], c[3]}};
  }
  Cubic derivative() const { return {{c[1], 2 * c[2], 3 * c[3], 0}}; }
  template <class S>
  S operator()(const S& s) const {
    return S(c[0]) + s * (S(c[1]) + s * (S(c[2]) + s * S(c[3])));
  }
  double at(double s) const { return c[0] + s * (c[1] + s * (c[2] + s * c[3])); }
};

/// One segment of the tube: the curve, its frame, and the matrix of the potential, as functions of t in [0, 1].
template <int N>
struct TubeSegment {
  static constexpr int K = N - 1;
  std::array<Cubic, N> curve;
  std::array<std::array<Cubic, K>, N> frame;
  std::array<std::array<Cubic, K>, K> w;
  std::array<std::array<std::array<Cubic, K>, K>, K> third;

  TubeSegment around(double t) const {
    TubeSegment moved = *this;
    for (Cubic& c : moved.curve) c = c.around(t);
    for (auto& row : moved.frame)
      for (Cubic& c : row) c = c.around(t);
    for (auto& row : moved.w)
      for (Cubic& c : row) c = c.around(t);
    for (auto& rows : moved.third)
      for (auto& row : rows)
        for (Cubic& c : row) c = c.around(t);
    return moved;
  }
};

/// What the dual norm of the potential needs at one place: t and z as jets in the variables 0 and 1 .. K.
template <int N>
class Field {
 public:
  static constexpr int K = N - 1;
  using Jet = IntervalJet<N>;
  using Small = Eigen::Matrix<double, K, K>;

  explicit Field(const TubeMetric<N>& metric) : metric_(metric) {}

  /// What is known of the curve alone for t in a range: its speed, and the part of its momentum across it.
  struct OnCurve {
    Jet speed;
    std::array<Jet, K> across, across_rate;
  };

  OnCurve on_curve(const TubeSegment<N>& segment, const Interval& range) const {
    const Jet t = IntervalJet<N>::variable(range, 0);
    JetPoint<N> x, dx;
    for (std::size_t i = 0; i < N; ++i) {
      x[i] = segment.curve[i](t);
      dx[i] = segment.curve[i].derivative()(t);
    }
    const JetMatrix<N> g = metric_(x);
    JetPoint<N> momentum;
    Jet speed2(0.0);
    for (std::size_t i = 0; i < N; ++i) {
      momentum[i] = Jet(0.0);
      for (std::size_t j = 0; j < N; ++j) momentum[i] += g[N * i + j] * dx[j];
      speed2 += momentum[i] * dx[i];
    }
    OnCurve out;
    out.speed = sqrt(speed2);
    for (std::size_t k = 0; k < K; ++k) {
      Jet sum(0.0);
      for (std::size_t i = 0; i < N; ++i) sum += segment.frame[i][k](t) * momentum[i];
      out.across[k] = sum / out.speed;
      out.across_rate[k] = out.across[k].derivative(0);
    }
    return out;
  }

  /// f = |grad u|^2 in the dual norm, and what of its Hessian across the curve does not depend on W and its rate.
  Jet squared_norm(const TubeSegment<N>& segment, const OnCurve& curve, const Interval& range,
                   const std::array<Interval, K>& across) const {
    const Jet t = IntervalJet<N>::variable(range, 0);
    std::array<Jet, K> z;
    for (std::size_t k = 0; k < K; ++k) z[k] = IntervalJet<N>::variable(across[k], static_cast<int>(k) + 1);
    return norm_of(gradient(segment, curve, t, z), metric_in_tube(segment, t, z));
  }

  /// The metric in the coordinates (t, z).
  JetMatrix<N> metric_in_tube(const TubeSegment<N>& segment, const Jet& t, const std::array<Jet, K>& z) const {
    JetPoint<N> x;
    JetMatrix<N> d;  // dx / d(t, z), column by column
    for (std::size_t i = 0; i < N; ++i) {
      x[i] = segment.curve[i](t);
      d[i] = segment.curve[i].derivative()(t);
      for (std::size_t k = 0; k < K; ++k) {
        const Jet n = segment.frame[i][k](t);
        x[i] += n * z[k];
        d[i] += segment.frame[i][k].derivative()(t) * z[k];
        d[N * (k + 1) + i] = n;
      }
    }
    const JetMatrix<N> g = metric_(x);
    JetMatrix<N> out;
    for (std::size_t p = 0; p < N; ++p) {
      JetPoint<N> gd;
      for (std::size_t i = 0; i < N; ++i) {
        gd[i] = Jet(0.0);
        for (std::size_t j = 0; j < N; ++j) gd[i] += g[N * i + j] * d[N * p + j];
      }
      for (std::size_t q = p; q < N; ++q) {
        Jet sum(0.0);
        for (std::size_t i = 0; i < N; ++i) sum += d[N * q + i] * gd[i];
        out[N * p + q] = out[N * q + p] = sum;
      }
    }
    return out;
  }

  /// du / d(t, z).
  JetPoint<N> gradient(const TubeSegment<N>& segment, const OnCurve& curve, const Jet& t,
                       const std::array<Jet, K>& z) const {
    JetPoint<N> y;
    y[0] = curve.speed;
    for (std::size_t k = 0; k < K; ++k) {
      y[0] += curve.across_rate[k] * z[k];
      y[k + 1] = curve.across[k];
      for (std::size_t l = 0; l < K; ++l) {
        y[k + 1] += segment.w[k][l](t) * z[l];
        const Jet zz = z[k] * z[l];
        y[0] += Jet(0.5) * (segment.w[k][l].derivative()(t) * zz);
        for (std::size_t m = 0; m < K; ++m) {
          y[m + 1] += Jet(0.5) * (segment.third[m][k][l](t) * zz);
          y[0] += Jet(1.0 / 6) * (segment.third[m][k][l].derivative()(t) * zz * z[m]);
        }
      }
    }
    return y;
  }

  /// y' g^-1 y, by elimination.
  static Jet norm_of(JetPoint<N> y, JetMatrix<N> g) {
    Jet sum(0.0);
    for (std::size_t i = N; i-- > 0;) {  // the direction along the curve last
      const Jet inverse = Jet(1.0) / g[N * i + i];
      sum += y[i] * y[i] * inverse;
      for (std::size_t j = 0; j < i; ++j) {
        const Jet factor = g[N * i + j] * inverse;
        y[j] -= factor * y[i];
        for (std::size_t k = 0; k < i; ++k) g[N * j + k] -= factor * g[N * i + k];
      }
    }
    return sum;
  }

 private:
  const TubeMetric<N>& metric_;
};

/// The coefficients of the Riccati equation at one place of the curve.
template <int N>
class RiccatiPoint {
 public:
  static constexpr int K = N - 1;
  using Small = Eigen::Matrix<double, K, K>;
  using Square = Eigen::Matrix<double, N, N>;
  using Vector = Eigen::Matrix<double, N, 1>;

  RiccatiPoint(const Field<N>& field, const TubeSegment<N>& segment, double t) {
    const TubeSegment<N> here = segment.around(t);
    const Interval zero(0);
    const typename Field<N>::OnCurve curve = field.on_curve(here, zero);
    std::array<IntervalJet<N>, K> z;
    for (int k = 0; k < K; ++k) z[static_cast<std::size_t>(k)] = IntervalJet<N>::variable(zero, k + 1);
    const JetMatrix<N> g = field.metric_in_tube(here, IntervalJet<N>::variable(zero, 0), z);
    Square g0;
    std::array<Square, K> g1;
    std::array<std::array<Square, K>, K> g2;
    for (std::size_t i = 0; i < N; ++i)
      for (std::size_t j = 0; j < N; ++j) {
        const IntervalJet<N>& entry = g[N * i + j];
        const auto r = static_cast<Index>(i), c = static_cast<Index>(j);
        g0(r, c) = entry.value().middle();
        for (int k = 0; k < K; ++k) {
          g1[static_cast<std::size_t>(k)](r, c) = entry.d(k + 1).middle();
          for (int l = 0; l < K; ++l)
            g2[static_cast<std::size_t>(k)][static_cast<std::size_t>(l)](r, c) = entry.d(k + 1, l + 1).middle();
        }
      }
    h_ = g0.inverse();
    y_[0] = curve.speed.value().middle();
    for (int k = 0; k < K; ++k) {
      const auto n = static_cast<std::size_t>(k);
      y_[k + 1] = curve.across[n].value().middle();
      across_rate_[k] = curve.across_rate[n].value().middle();
    }
    for (std::size_t k = 0; k < K; ++k) hy_[k] = -h_ * g1[k] * h_ * y_;
    for (int k = 0; k < K; ++k)
      for (int l = 0; l < K; ++l) {
        const auto a = static_cast<std::size_t>(k), b = static_cast<std::size_t>(l);
        const Square hkl = h_ * (g1[a] * h_ * g1[b] + g1[b] * h_ * g1[a] - g2[a][b]) * h_;
        free_(k, l) = y_.dot(hkl * y_);
      }
    // Where the curvature is negative extremals part by themselves, and the margin can be as large as half of it.
    own_margin_ = std::max(0.0, -symmetric_eigenvalues(free_).maxCoeff() / 4);
  }

  /// W' such that the Hessian of f across the curve is -2m, m at least `margin`.
  Small rate(const Small& w, double margin, double own_part) const {
    Eigen::Matrix<double, N, K> yz;
    yz.row(0) = across_rate_.transpose();
    yz.bottomRows(K) = w;
    Small rest = free_ + 2 * yz.transpose() * h_ * yz;
    for (int l = 0; l < K; ++l) {
      const Eigen::Matrix<double, K, 1> column = 2 * yz.transpose() * hy_[static_cast<std::size_t>(l)];
      rest.col(l) += column;
      rest.row(l) += column.transpose();
    }
    rest.diagonal().array() += 2 * (margin + own_part * own_margin_);
    return -rest / (2 * h_.row(0).dot(y_));
  }

  double momentum_across() const { return y_.template tail<K>().norm(); }

  using Cube = std::array<Small, K>;

  /// The rate of the third derivatives of u for which those of f vanish; `rest` are those of f without them.
  Cube third_rate(const Small& w, const Cube& c, const Cube& rest) const {
    Eigen::Matrix<double, N, K> yz;
    yz.row(0) = across_rate_.transpose();
    yz.bottomRows(K) = w;
    Eigen::Matrix<double, K, K> momentum_slope;  // d(Hy)_j / dz_k
    for (int k = 0; k < K; ++k) {
      const Vector slope = hy_[static_cast<std::size_t>(k)] + h_ * yz.col(k);
      momentum_slope.col(k) = slope.template tail<K>();
    }
    Cube out;
    const double along = 2 * h_.row(0).dot(y_);
    for (int k = 0; k < K; ++k)
      for (int l = 0; l < K; ++l)
        for (int m = 0; m < K; ++m) {
          double sum = rest[static_cast<std::size_t>(k)](l, m);
          for (int j = 0; j < K; ++j) {
            const Small& cj = c[static_cast<std::size_t>(j)];
            sum += 2 * (momentum_slope(j, k) * cj(l, m) + momentum_slope(j, l) * cj(k, m) +
                        momentum_slope(j, m) * cj(k, l));
          }
          out[static_cast<std::size_t>(k)](l, m) = -sum / along;
        }
    return out;
  }

 private:
  Square h_;
  Vector y_;
  Eigen::Matrix<double, K, 1> across_rate_;
  std::array<Vector, K> hy_;  ///< (dH / dz_k) y
  Small free_;                ///< y' d2H y
  double own_margin_ = 0;
};

template <int N>
class Calibrator {
 public:
  static constexpr int K = N - 1;
  using Small = Eigen::Matrix<double, K, K>;
  using Vector = Eigen::Matrix<double, N, 1>;
  using Square = Eigen::Matrix<double, N, N>;

  Calibrator(const Problem& problem, const CoordinatePath& chain, const CalibrationOptions& options,
             const Deadline& deadline)
      : metric_(problem), field_(metric_), chain_(chain), options_(options), deadline_(deadline) {
    out_.applies = true;
  }

  Calibration run() {
    if (!make_tube() || !solve_riccati()) return out_;
    verify();
    return out_;
  }

 private:
  bool fail(Index segment, std::string why) {
    out_.segment = segment;
    out_.trouble = std::move(why);
    return false;
  }

  Square metric_at(const Eigen::VectorXd& x) const {
    JetPoint<N> at;
    for (std::size_t i = 0; i < N; ++i) at[i] = IntervalJet<N>(x[static_cast<Index>(i)]);
    const JetMatrix<N> g = metric_(at);
    Square out;
    for (Index i = 0; i < N; ++i)
      for (Index j = 0; j < N; ++j) out(i, j) = g[static_cast<std::size_t>(N * i + j)].value().middle();
    return out;
  }

  /// dx/di at point i, of order 4.
  Vector slope(Index i) const {
    static constexpr double kStencils[3][5] = {{-25. / 12, 4, -3, 4. / 3, -1. / 4},
                                               {-1. / 4, -5. / 6, 3. / 2, -1. / 2, 1. / 12},
                                               {1. / 12, -2. / 3, 0, 2. / 3, -1. / 12}};
    const Index last = chain_.u.cols() - 1;
    const bool mirrored = i > last / 2;
    const Index from_end = mirrored ? last - i : i;
    const Index row = std::min<Index>(from_end, 2), begin = from_end - row;
    Vector d = Vector::Zero();
    for (Index j = 0; j < 5; ++j) d += kStencils[row][j] * chain_.u.col(mirrored ? last - begin - j : begin + j);
    return mirrored ? Vector(-d) : d;
  }

  /// A frame across d that is orthonormal under g, as little turned from `before` as can be.
  static Eigen::Matrix<double, N, K> frame(const Square& g, const Vector& d,
                                           const Eigen::Matrix<double, N, K>& before) {
    Eigen::Matrix<double, N, K> out;
    const Vector gd = g * d;
    if constexpr (N == 2) {
      out << -gd[1], gd[0];
      return out / std::sqrt(out.col(0).dot(g * out.col(0)));
    }
    for (int k = 0; k < K; ++k) {
      Vector n = before.col(k);
      n -= gd.dot(n) / gd.dot(d) * d;
      for (int l = 0; l < k; ++l) n -= out.col(l).dot(g * n) * out.col(l);
      out.col(k) = n / std::sqrt(n.dot(g * n));
    }
    return out;
  }

  bool make_tube() {
    const Index segments = chain_.segment_count();
    if (segments < 4) return fail(0, "too few points");
    Eigen::Matrix<double, N, K> across;
    Vector d = slope(0);
    Index longest = 0;
    d.cwiseAbs().maxCoeff(&longest);
    for (int k = 0; k < K; ++k) across.col(k) = Vector::Unit((longest + 1 + k) % N);
    across = frame(metric_at(chain_.u.col(0)), d, across);
    tube_.resize(static_cast<std::size_t>(segments));
    for (Index i = 0; i < segments; ++i) {
      look_at_clock(deadline_);
      const Vector next_d = slope(i + 1);
      const Eigen::Matrix<double, N, K> next = frame(metric_at(chain_.u.col(i + 1)), next_d, across);
      if (!next.allFinite() || !across.allFinite()) return fail(i, "the metric is not positive definite");
      TubeSegment<N>& segment = tube_[static_cast<std::size_t>(i)];
      for (Index r = 0; r < N; ++r) {
        const auto n = static_cast<std::size_t>(r);
        segment.curve[n] = Cubic::hermite(chain_.u(r, i), chain_.u(r, i + 1), d[r], next_d[r]);
        for (Index k = 0; k < K; ++k)
          segment.frame[n][static_cast<std::size_t>(k)] = Cubic::line(across(r, k), next(r, k));
      }
      d = next_d;
      across = next;
    }
    costs_.resize(segments);
    for (Index i = 0; i < segments; ++i) costs_[i] = cost(tube_[static_cast<std::size_t>(i)]);
    cost_ = costs_.sum();
    if (!std::isfinite(cost_)) return fail(0, "the curve costs infinitely much");
    set_widths();
    return true;
  }

  /// Half the width of the tube at each segment, in units of the cost: a part of a segment, both in cost and in
  /// coordinates, so that no soft direction makes it reach far.
  void set_widths() {
    const Index segments = chain_.segment_count();
    const double per_segment = static_cast<double>(segments) / static_cast<double>(options_.segments);
    widths_.resize(segments);
    for (Index i = 0; i < segments; ++i) {
      const TubeSegment<N>& segment = tube_[static_cast<std::size_t>(i)];
      double longest2 = 0;
      for (std::size_t k = 0; k < K; ++k) {
        double length2 = 0;
        for (const auto& row : segment.frame) length2 += row[k].c[0] * row[k].c[0];
        longest2 = std::max(longest2, length2);
      }
      const double length = (chain_.u.col(i + 1) - chain_.u.col(i)).norm();
      widths_[i] =
          kWidth * std::min(cost_ / static_cast<double>(options_.segments), per_segment * length / std::sqrt(longest2));
    }
    out_.half_width = widths_.minCoeff();
  }

  double cost(const TubeSegment<N>& segment) const {
    double sum = 0;
    for (std::size_t g = 0; g < kNodes.size(); ++g) {
      Vector x, dx;
      for (Index r = 0; r < N; ++r) {
        x[r] = segment.curve[static_cast<std::size_t>(r)].at(kNodes[g]);
        dx[r] = segment.curve[static_cast<std::size_t>(r)].derivative().at(kNodes[g]);
      }
      sum += kWeights[g] * std::sqrt(dx.dot(metric_at(x) * dx));
    }
    return sum;
  }

  /// W at the points, with the largest margin m of a few that leaves it bounded.
  bool solve_riccati() {
    for (const TubeSegment<N>& segment : tube_) {
      look_at_clock(deadline_);
      for (const double t : {0.0, 0.5, 1.0}) riccati_.emplace_back(field_, segment, t);
    }
    const double unit = std::numbers::pi / cost_;
    for (const double own : {1.0, 0.25, 0.0}) {
      own_part_ = own;
      for (double part = 64; part > 1e-2; part /= 2) {
        margin_ = part * unit * unit;
        if (!flattest()) continue;
        margin_ /= 4;
        flattest();
        solve_third();
        return true;
      }
    }
    return fail(-1, "no field of extremals: the path is not a strict minimum, or nearly not");
  }

  /// The third derivatives of u across the curve, so that those of f vanish on it: f then falls on both sides farther
  /// out.
  void solve_third() {
    using Cube = typename RiccatiPoint<N>::Cube;
    const auto plus = [](const Cube& a, const Cube& b, double factor) {
      Cube sum;
      for (std::size_t k = 0; k < K; ++k) sum[k] = a[k] + factor * b[k];
      return sum;
    };
    Cube c;
    c.fill(Small::Zero());
    for (std::size_t i = 0; i < tube_.size(); ++i) {
      look_at_clock(deadline_);
      std::array<Cube, 3> rest;
      std::array<Small, 3> w;
      for (int stage = 0; stage < 3; ++stage) {
        const TubeSegment<N> here = tube_[i].around(stage / 2.0);
        const IntervalJet<N> f = field_.squared_norm(here, field_.on_curve(here, Interval(0)), Interval(0), {});
        const auto s = static_cast<std::size_t>(stage);
        for (int k = 0; k < K; ++k)
          for (int l = 0; l < K; ++l) {
            w[s](k, l) = here.w[static_cast<std::size_t>(k)][static_cast<std::size_t>(l)].c[0];
            for (int m = 0; m < K; ++m) rest[s][static_cast<std::size_t>(k)](l, m) = f.d(k + 1, l + 1, m + 1).middle();
          }
      }
      const RiccatiPoint<N>* at = &riccati_[3 * i];
      const Cube k1 = at[0].third_rate(w[0], c, rest[0]), k2 = at[1].third_rate(w[1], plus(c, k1, 0.5), rest[1]),
                 k3 = at[1].third_rate(w[1], plus(c, k2, 0.5), rest[1]),
                 k4 = at[2].third_rate(w[2], plus(c, k3, 1), rest[2]);
      const Cube next = plus(plus(plus(plus(c, k1, 1. / 6), k2, 1. / 3), k3, 1. / 3), k4, 1. / 6);
      const Cube rate = at[2].third_rate(w[2], next, rest[2]);
      for (std::size_t k = 0; k < K; ++k)
        for (Index l = 0; l < K; ++l)
          for (Index m = 0; m < K; ++m)
            tube_[i].third[k][static_cast<std::size_t>(l)][static_cast<std::size_t>(m)] =
                Cubic::hermite(c[k](l, m), next[k](l, m), k1[k](l, m), rate[k](l, m));
      c = next;
    }
  }

  /// Whether W stays bounded from some start; from the one that keeps it smallest.
  bool flattest() {
    const double unit = std::numbers::pi / cost_;
    double best = std::numeric_limits<double>::infinity(), from = 0;
    for (double start = unit / 4; start < 64 * unit; start *= 1.5) {
      const double size = integrate(start);
      if (size < best) best = size, from = start;
    }
    return std::isfinite(best) && std::isfinite(integrate(from));
  }

  /// W from `start` times the identity; its largest entry, infinite where it does not stay bounded.
  double integrate(double start) {
    Small w = start * Small::Identity();
    const double most = 4 * static_cast<double>(tube_.size()) / cost_ + 100 * start;
    double largest = start;
    for (std::size_t i = 0; i < tube_.size(); ++i) {
      const RiccatiPoint<N>* at = &riccati_[3 * i];
      const Small k1 = at[0].rate(w, margin_, own_part_), k2 = at[1].rate(w + k1 / 2, margin_, own_part_),
                  k3 = at[1].rate(w + k2 / 2, margin_, own_part_), k4 = at[2].rate(w + k3, margin_, own_part_);
      Small next = w + (k1 + 2 * k2 + 2 * k3 + k4) / 6;
      next = (0.5 * (next + next.transpose())).eval();
      largest = std::max(largest, next.cwiseAbs().maxCoeff());
      if (!(largest <= most)) return std::numeric_limits<double>::infinity();
      const Small rate = at[2].rate(next, margin_, own_part_);
      for (Index r = 0; r < K; ++r)
        for (Index c = 0; c < K; ++c)
          tube_[i].w[static_cast<std::size_t>(r)][static_cast<std::size_t>(c)] =
              Cubic::hermite(w(r, c), next(r, c), k1(r, c), rate(r, c));
      w = next;
    }
    return largest;
  }

  void verify() {
    const double enough = std::max(kLeastGap, options_.gap / 2);
    Interval curve(0);
    double loss = 0, worst = 0;
    for (std::size_t i = 0; i < tube_.size(); ++i) {
      look_at_clock(deadline_);
      const double curvature = mean_curvature(tube_[i], widths_[static_cast<Index>(i)]);
      if (!(curvature < 0)) {
        fail(static_cast<Index>(i), "the cost is not resolved, or a path nearby is cheaper");
        return;
      }
      seen_ = 0;
      const double excess = slope2(tube_[i], {0, 1}, -2 * curvature * enough, 0) / (-2 * curvature);
      worst = std::max(worst, excess);
      loss += excess * costs_[static_cast<Index>(i)];
    }
    for (const TubeSegment<N>& segment : tube_) {
      look_at_clock(deadline_);
      curve += enclosed_cost(segment, {0, 1},
                             std::max(kLeastGap, enough / 10) * cost_ / static_cast<double>(tube_.size()), 0);
    }
    out_.gap = varies_little_across() ? loss / cost_ : worst;
    out_.upper = curve.hi;
    out_.lower = curve.lo * (1 - out_.gap);
    out_.proved = std::isfinite(out_.lower) && std::isfinite(out_.upper);
    if (!out_.proved) fail(0, "the cost of the curve has no bounds");
  }

  /// Whether u varies across the curve, at the joints of the tube, by less than a quarter of the least segment. Of each
  /// segment a path then pays du (1 - e / 2), and what it gains by crossing joints away from the curve, where e differs
  /// on both sides, is less than half of the sum of e du.
  bool varies_little_across() const {
    double most = 0;
    for (std::size_t i = 0; i < tube_.size(); ++i) {
      const double r = widths_[static_cast<Index>(i)] * std::sqrt(static_cast<double>(K));
      double w = 0, third = 0;
      for (std::size_t k = 0; k < K; ++k)
        for (std::size_t l = 0; l < K; ++l) {
          w += std::abs(tube_[i].w[k][l].c[0]);
          for (std::size_t m = 0; m < K; ++m) third += std::abs(tube_[i].third[k][l][m].c[0]);
        }
      most = std::max(most, r * (riccati_[3 * i].momentum_across() + r * (w / 2 + r * third / 6)));
    }
    return most <= costs_.minCoeff() / 4;
  }

  /// The cost of a part of the curve, by Taylor's theorem: the third derivative of the speed bounds what its parabola
  /// leaves out.
  Interval enclosed_cost(const TubeSegment<N>& segment, const Interval& range, double enough, int depth) const {
    constexpr int kDeepest = 6;
    const double middle = range.middle(), half = range.width() / 2 * (1 + 1e-15);
    const TubeSegment<N> here = segment.around(middle);
    const IntervalJet<N> all = field_.on_curve(here, {-half, half}).speed,
                         at = field_.on_curve(here, Interval(0)).speed;
    const Interval r(half), r3 = r * square(r), third = all.d(0, 0, 0);
    const double odd = third.width() * (r3 * r).hi / 24;
    const Interval sum = Interval(2) * at.value() * r + at.d(0, 0) * r3 / Interval(3) + Interval(-odd, odd);
    if (sum.width() <= enough || depth == kDeepest) return sum;
    return enclosed_cost(segment, {range.lo, middle}, enough / 2, depth + 1) +
           enclosed_cost(segment, {middle, range.hi}, enough / 2, depth + 1);
  }

  using Box = std::array<Interval, K>;

  /// c < 0 such that f(t, z) <= 1 + r.z + c |z|^2 / 2 in the tube, r the slope on the curve; not negative where that is
  /// not seen. f is the double integral of its Hessian along the way from the curve to z, so that a bound on each of a
  /// few shells around the curve is enough, and farther out it may be positive.
  double mean_curvature(const TubeSegment<N>& segment, double half_width) {
    constexpr int kShells = K == 1 ? 6 : 3;
    Box all;
    all.fill({-half_width, half_width});
    const CurvatureBound at_once = curvature_bound(segment, {0, 1}, all);
    if (is_good(at_once)) return at_once.bound;
    double sum = 0, slope = 0, worst = -std::numeric_limits<double>::infinity();  // the double integral, its slope
    for (int shell = 0; shell < kShells; ++shell) {
      const double lo = shell * half_width / kShells, hi = (shell + 1) * half_width / kShells;
      const double bound = shell_curvature(segment, {lo, hi});
      if (!std::isfinite(bound)) return std::numeric_limits<double>::infinity();
      // The integral over z^2 is a + b / z + c / z^2 within the shell.
      const double a = bound / 2, b = slope - bound * lo, c = sum - slope * lo + bound * lo * lo / 2;
      const auto mean = [&](double inverse) { return 2 * (a + inverse * (b + inverse * c)); };
      worst = std::max(worst, mean(1 / hi));
      if (lo > 0) worst = std::max(worst, mean(1 / lo));
      if (lo > 0 && c < 0 && -b / (2 * c) > 1 / hi && -b / (2 * c) < 1 / lo)
        worst = std::max(worst, mean(-b / (2 * c)));
      sum += (hi - lo) * (slope + bound * (hi - lo) / 2);
      slope += bound * (hi - lo);
    }
    return worst;
  }

  /// A bound of the eigenvalues of the Hessian of f across the curve where the largest coordinate is in `radius`.
  double shell_curvature(const TubeSegment<N>& segment, const Interval& radius) {
    double largest = -std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < K; ++k)
      for (const Interval& side : {radius, -radius}) {
        Box box;
        box.fill({-radius.hi, radius.hi});
        box[k] = side;
        largest = std::max(largest, largest_curvature(segment, {0, 1}, box, 0));
      }
    return largest;
  }

  struct CurvatureBound {
    double bound, at_center;
  };

  static bool is_good(const CurvatureBound& found) { return found.bound < 0 && found.bound <= found.at_center / 2; }

  /// A bound of the eigenvalues of the Hessian of f across the curve in a part of the tube, by the mean value theorem
  /// and Gershgorin's circles.
  CurvatureBound curvature_bound(const TubeSegment<N>& segment, const Interval& range, const Box& across) {
    ++boxes_;
    const double middle = range.middle(), half = range.width() / 2 * (1 + 1e-12);
    const TubeSegment<N> here = segment.around(middle);
    const Interval local(-half, half);
    Box center, off;
    for (std::size_t k = 0; k < K; ++k) {
      center[k] = Interval(across[k].middle());
      off[k] = across[k] - center[k];
    }
    const IntervalJet<N> f = field_.squared_norm(here, field_.on_curve(here, local), local, across);
    const IntervalJet<N> at = field_.squared_norm(here, field_.on_curve(here, Interval(0)), Interval(0), center);
    const auto second = [&](int k, int l) {
      Interval sum = at.d(k, l) + f.d(0, k, l) * local;
      for (int m = 1; m < N; ++m) sum += f.d(m, k, l) * off[static_cast<std::size_t>(m - 1)];
      return sum;
    };
    CurvatureBound out{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    for (int k = 1; k < N; ++k) {
      double row = second(k, k).hi, center_row = at.d(k, k).hi;
      for (int l = 1; l < N; ++l)
        if (l != k) row += second(k, l).magnitude(), center_row += at.d(k, l).magnitude();
      out.bound = std::max(out.bound, row);
      out.at_center = std::max(out.at_center, center_row);
    }
    if (std::isnan(out.bound)) out.bound = std::numeric_limits<double>::infinity();
    return out;
  }

  /// The same, halved in every direction until the bound is good.
  double largest_curvature(const TubeSegment<N>& segment, const Interval& range, const Box& across, int depth) {
    constexpr int kDeepest = K == 1 ? 5 : 3;
    const CurvatureBound found = curvature_bound(segment, range, across);
    if (is_good(found) || found.bound - found.at_center <= margin_ / 4 || depth == kDeepest) return found.bound;
    if (boxes_ > kMostBoxes * static_cast<Index>(tube_.size())) return found.bound;
    double largest = -std::numeric_limits<double>::infinity();
    for (int part = 0; part < 1 << N && largest < std::numeric_limits<double>::infinity(); ++part) {
      const double middle = range.middle();
      const Interval t = part & 1 ? Interval(middle, range.hi) : Interval(range.lo, middle);
      Box z = across;
      for (std::size_t k = 0; k < K; ++k) (part >> (k + 1) & 1 ? z[k].lo : z[k].hi) = across[k].middle();
      largest = std::max(largest, largest_curvature(segment, t, z, depth + 1));
    }
    return largest;
  }

  /// A bound of the squared slope of f across the curve, on the curve.
  double slope2(const TubeSegment<N>& segment, const Interval& range, double enough, int depth) {
    constexpr int kDeepest = 4;
    const double middle = range.middle(), half = range.width() / 2 * (1 + 1e-12);
    const TubeSegment<N> here = segment.around(middle);
    const Interval local(-half, half);
    const Box zero = {};
    const IntervalJet<N> on_curve = field_.squared_norm(here, field_.on_curve(here, local), local, zero),
                         at_middle = field_.squared_norm(here, field_.on_curve(here, Interval(0)), Interval(0), zero);
    double sum = 0, least = 0;
    for (int k = 1; k < N; ++k) {
      const Interval& there = at_middle.d(k);
      const Interval slope = there + (at_middle.d(0, k) + on_curve.d(0, 0, k) * local) * local;
      sum += slope.magnitude() * slope.magnitude();
      least += there.magnitude() * there.magnitude();
    }
    seen_ = std::max(seen_, least);
    if (sum <= std::max(enough, 2 * seen_) || depth == kDeepest)
      return std::isnan(sum) ? std::numeric_limits<double>::infinity() : sum;
    return std::max(slope2(segment, {range.lo, middle}, enough, depth + 1),
                    slope2(segment, {middle, range.hi}, enough, depth + 1));
  }

  static constexpr Index kMostBoxes = 200;    ///< per segment, in the mean
  static constexpr double kWidth = 0.25;      ///< of a segment, to each side
  static constexpr double kLeastGap = 1e-12;  ///< relative

  TubeMetric<N> metric_;
  Field<N> field_;
  const CoordinatePath& chain_;
  const CalibrationOptions& options_;
  const Deadline& deadline_;
  std::vector<TubeSegment<N>> tube_;
  std::vector<RiccatiPoint<N>> riccati_;
  Eigen::VectorXd costs_;
  Eigen::VectorXd widths_;
  double cost_ = 0, margin_ = 0, own_part_ = 1;
  Index boxes_ = 0;
  double seen_ = 0;  ///< largest squared slope met on the curve in a segment
  Calibration out_;
};

}  // namespace

Calibration calibrate(const Problem& problem, const CoordinatePath& chain, const CalibrationOptions& options,
                      const Deadline& deadline) {
  if (chain.ring) return {};
  if (TubeMetric<2>::exists(problem)) return Calibrator<2>(problem, chain, options, deadline).run();
  if (TubeMetric<3>::exists(problem)) return Calibrator<3>(problem, chain, options, deadline).run();
  return {};
}

}  // namespace leastcost
