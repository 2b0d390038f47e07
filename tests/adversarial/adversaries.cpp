// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "tests/adversarial/adversaries.hpp"

#include <cstdio>
#include <limits>
#include <random>
#include <utility>

#include <leastcost/problems/costs/metric_field.hpp>
#include <leastcost/problems/costs/metric_tensor.hpp>
#include <leastcost/problems/manifolds/implicit.hpp>
#include <leastcost/problems/manifolds/parametric.hpp>
#include "tests/support/compose.hpp"
#include "tests/support/pi.hpp"

namespace leastcost::test {
namespace {

using Eigen::Vector2d, Eigen::Vector3d;
using Real = long double;

/// Draws that are the same with every standard library.
class Draw {
 public:
  Draw(std::uint64_t family, std::uint64_t seed) : engine_(1000003 * seed + family) { engine_.discard(8); }
  double uniform(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_() >> 11) * 0x1p-53;
  }
  double decades(double low, double high) { return std::exp(uniform(std::log(low), std::log(high))); }
  int integer(int low, int high) { return static_cast<int>(uniform(low, high + 1)); }

 private:
  std::mt19937_64 engine_;
};

std::string text(double x) {
  char buffer[40];
  std::snprintf(buffer, sizeof buffer, "(%.17g)", x);
  return buffer;
}

template <class F>
Real integral(F f, Real a, Real b, int parts) {  // Simpson
  const Real h = (b - a) / parts;
  Real sum = 0;
  for (int i = 0; i < parts; ++i) {
    const Real x = a + h * static_cast<Real>(i);
    sum += f(x) + 4 * f(x + h / 2) + f(x + h);
  }
  return sum * h / 6;
}

std::function<std::optional<TrueGeodesic>(const Result&)> known(Real length) {
  return [length](const Result&) { return TrueGeodesic{static_cast<double>(length), true}; };
}

std::shared_ptr<const Initializer> straight() { return std::make_shared<const StraightInitializer>(); }

std::shared_ptr<const SegmentCost> field(std::vector<std::string> entries) {
  MetricFieldOptions options;
  options.field = metric::Formula{std::move(entries)};
  return make_metric_field_cost(options, 2);
}

Problem on_ellipsoid(const Vector3d& axes, Draw& draw) {
  const auto manifold = make_parametric_manifold({.surface = parametric::Ellipsoid{axes}});
  const auto place = [&](double around) { return Vector2d(around, std::asin(draw.uniform(-1, 1))); };
  const Vector2d from = place(0), to = place(draw.uniform(-kPi, kPi));
  return between(manifold, make_euclidean_cost(3), from, to);
}

Adversary ellipsoid(std::uint64_t seed, int points) {
  Problem problem = oblate_pair(seed);
  return {problem, straight(), points,
          [problem](const Result& r) { return geodesic_near(Vector3d(1, 1, 0.2), problem, r); }};
}

Adversary chart(std::uint64_t seed) {
  Draw draw(2, seed);
  const Vector3d axes(draw.uniform(0.4, 1.6), draw.uniform(0.4, 1.6), draw.uniform(0.4, 1.6));
  Problem problem = on_ellipsoid(axes, draw);
  return {problem, straight(), draw.integer(12, 80),
          [problem, axes](const Result& r) { return geodesic_near(axes, problem, r); }};
}

/// The same without a chart, whose poles are no places of the surface.
Adversary level_set(std::uint64_t seed) {
  Draw draw(14, seed);
  const Vector3d axes(draw.uniform(0.4, 1.6), draw.uniform(0.4, 1.6), draw.uniform(0.4, 1.6));
  const Problem in_chart = on_ellipsoid(axes, draw);
  const auto place = [&](const PathEnd& end) {
    Vector3d x;
    x << axes[0] * std::cos(end.u[1]) * std::cos(end.u[0]), axes[1] * std::cos(end.u[1]) * std::sin(end.u[0]),
        axes[2] * std::sin(end.u[1]);
    return x;
  };
  const Problem problem = between(make_implicit_manifold({.surface = implicit::Ellipsoid{axes}}),
                                  make_euclidean_cost(3), place(in_chart.source), place(in_chart.target));
  return {problem, straight(), draw.integer(12, 80),
          [problem, axes](const Result& r) { return geodesic_near(axes, problem, r); }};
}

/// The waist of x^2 + y^2 / b^2 - k z^2 = 1, an ellipse: a strict minimum however small k is.
Adversary ring(std::uint64_t seed) {
  Draw draw(3, seed);
  const double b = draw.uniform(0.6, 1), k = draw.decades(1e-5, 1), lift = draw.uniform(0.02, 0.2);
  const ImplicitManifoldOptions options{
      .surface = implicit::Formula{.f = "x^2 + y^2/" + text(b) + "^2 - " + text(k) + "*z^2 - 1"}};
  Points loop(3, 24);
  for (Index i = 0; i < 24; ++i) {
    const double t = 2 * kPi * static_cast<double>(i) / 24;
    loop.col(i) = Vector3d(std::cos(t), b * std::sin(t), lift * (std::sin(2 * t) + 0.5));
  }
  const Real e = b;
  const auto speed = [e](Real t) { return std::sqrt(std::sin(t) * std::sin(t) + e * e * std::cos(t) * std::cos(t)); };
  return {closed(make_implicit_manifold(options), make_euclidean_cost(3)),
          std::make_shared<const WaypointsInitializer>(loop), draw.integer(16, 64),
          known(4 * integral(speed, 0, std::acos(Real(0)), 2000))};
}

/// Constant tensors of a condition up to 1e13.
Adversary tensor(std::uint64_t seed) {
  Draw draw(4, seed);
  const double turn = draw.uniform(0, kPi), condition = draw.decades(1, 1e13), size = draw.decades(1e-3, 1e3);
  const double c = std::cos(turn), s = std::sin(turn), l = size * condition;
  const double xx = size * c * c + l * s * s, xy = (size - l) * c * s, yy = size * s * s + l * c * c;
  const Vector2d d(draw.uniform(-1, 1), draw.uniform(-1, 1));
  const Real x = d[0], y = d[1], q = Real(xx) * x * x + 2 * Real(xy) * x * y + Real(yy) * y * y;
  std::shared_ptr<const SegmentCost> cost;
  if (draw.uniform(0, 1) < 0.5) {
    cost = field({text(xx), text(xy), text(yy)});
  } else {
    Eigen::Matrix2d m;
    m << xx, xy, xy, yy;
    try {
      cost = make_metric_tensor_cost({.matrix = m}, 2);
    } catch (const Error&) {  // refused as it is not positive definite to rounding
      cost = field({text(xx), text(xy), text(yy)});
    }
  }
  return {between(space(2), cost, Vector2d(0, 0), d), straight(), draw.integer(15, 100), known(std::sqrt(q))};
}

/// The plane, sheared by x + a sin(k y): straight lines in disguise.
Adversary pulled_back(std::uint64_t seed) {
  Draw draw(5, seed);
  const double a = draw.uniform(0.05, 0.6), k = draw.uniform(0.5, 6);
  const std::string q = text(a) + "*" + text(k) + "*cos(" + text(k) + "*y)";
  const Vector2d from(draw.uniform(-1, 1), draw.uniform(-1, 1)), to(draw.uniform(-1, 1), draw.uniform(-1, 1));
  const auto image = [a, k](const Vector2d& p) {
    return Eigen::Matrix<Real, 2, 1>(Real(p[0]) + Real(a) * std::sin(Real(k) * Real(p[1])), Real(p[1]));
  };
  return {between(space(2), field({"1", q, "1+(" + q + ")^2"}), from, to), straight(), draw.integer(20, 100),
          known((image(to) - image(from)).norm())};
}

/// A path from (-1, 0) to (1, rise) where the index n depends on x alone: by Snell's law p = n
/// sin(angle) is constant. `limits`: between them Simpson's rule with 4000 parts resolves n.
template <class Index>
Adversary stratified(const std::string& n, Index index, const std::vector<Real>& limits, double rise, int points) {
  constexpr int kParts = 4000;
  std::vector<std::pair<Real, Real>> nodes;  // weight, n^2
  for (std::size_t i = 0; i + 1 < limits.size(); ++i) {
    const Real h = (limits[i + 1] - limits[i]) / (2 * kParts);
    for (int k = 0; k <= 2 * kParts; ++k) {
      const Real here = index(limits[i] + h * static_cast<Real>(k));
      nodes.emplace_back(h / 3 * static_cast<Real>(k == 0 || k == 2 * kParts ? 1 : k % 2 == 1 ? 4 : 2), here * here);
    }
  }
  Real least = std::numeric_limits<Real>::infinity();
  for (const auto& node : nodes) least = std::min(least, std::sqrt(node.second));
  // The rise grows with p: Newton's steps, halved back into what is left of [0, least].
  Real low = 0, high = least, p = 0;
  for (int i = 0; i < 100 && high - low > 1e-18L * least; ++i) {
    Real y = 0, slope = 0;
    for (const auto& [weight, n2] : nodes) {
      const Real root2 = n2 - p * p, part = weight / std::sqrt(root2);
      y += p * part;
      slope += part * n2 / root2;
    }
    (y < Real(rise) ? low : high) = p;
    const Real next = p - (y - Real(rise)) / slope;
    if (std::abs(next - p) <= 1e-18L * least) break;
    p = next > low && next < high ? next : (low + high) / 2;
  }
  // Where p nearly is the least n the path runs along a layer, and Simpson's rule is no truth: half of its parts tell.
  constexpr Real kTrue = 1e-11L;
  Real time = 0, time_of_half = 0;
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    const auto& [weight, n2] = nodes[k];
    const Real part = weight * n2 / std::sqrt(n2 - p * p);
    const std::size_t in_limits = k % (2 * kParts + 1);
    time += part;
    if (in_limits == 0 || in_limits == 2 * kParts)
      time_of_half += 2 * part;
    else if (in_limits % 2 == 0)
      time_of_half += 2 * part * (in_limits % 4 == 2 ? 2 : 1);
  }
  const bool is_true = std::abs(time - time_of_half) <= kTrue * time;
  const std::string squared = "(" + n + ")^2";
  // A path that turns back, in a layer where n is small, is another local minimum: nothing is known of its cost.
  const auto truth = [time, is_true](const Result& r) -> std::optional<TrueGeodesic> {
    if (!is_true) return std::nullopt;
    const Eigen::VectorXd x = r.path.u.row(0);
    for (Eigen::Index i = 0; i + 1 < x.size(); ++i)
      if (!(x[i] < x[i + 1])) return std::nullopt;
    return TrueGeodesic{static_cast<double>(time), true};
  };
  return {between(space(2), field({squared, "0", squared}), Vector2d(-1, 0), Vector2d(1, rise)), straight(), points,
          truth};
}

constexpr double kWidthAtHalf = 1.665;  ///< of exp(-x^2), where it is half as high

/// n(x) = 1 + A exp(-((x - c) / w)^2).
Adversary wall(Draw& draw, double height, double w) {
  const double c = draw.uniform(-0.5, 0.5);
  const auto index = [=](Real x) {
    return 1 + Real(height) * std::exp(-(x - Real(c)) * (x - Real(c)) / (Real(w) * Real(w)));
  };
  const Real a = std::max<Real>(-1, Real(c) - 7 * Real(w)), b = std::min<Real>(1, Real(c) + 7 * Real(w));
  const double rise = draw.uniform(0, 1.5);
  Adversary made = stratified("1+" + text(height) + "*exp(-((x-" + text(c) + ")/" + text(w) + ")^2)", index,
                              {-1, a, b, 1}, rise, draw.integer(30, 120));
  made.feature = kWidthAtHalf * w * (1 + 0.8 * height);  // the mean index there
  return made;
}

Adversary layered(std::uint64_t seed) {
  Draw draw(6, seed);
  const double height = draw.uniform(0.1, 3), w = draw.decades(2e-3, 0.5);
  return wall(draw, height, w);
}

/// Walls of any height that are mostly narrower than a segment.
Adversary narrow_wall(std::uint64_t seed) {
  Draw draw(9, seed);
  const double height = draw.decades(1e-3, 10), w = draw.decades(1e-4, 0.05);
  return wall(draw, height, w);
}

/// n(x) = 1 + A cos(k x + phase), from smooth to much finer than the segments.
Adversary rippled(std::uint64_t seed) {
  Draw draw(10, seed);
  const double height = draw.decades(1e-3, 0.6), k = draw.decades(1, 2000), phase = draw.uniform(0, 6.28);
  std::vector<Real> limits;
  for (int i = 0; i <= 16; ++i) limits.push_back(-1 + Real(i) / 8);
  const double rise = draw.uniform(0, 1.5);
  Adversary made = stratified(
      "1+" + text(height) + "*cos(" + text(k) + "*x+" + text(phase) + ")",
      [=](Real x) { return 1 + Real(height) * std::cos(Real(k) * x + Real(phase)); }, limits, rise,
      draw.integer(12, 150));
  made.feature = kPi / k * (1 - height);
  return made;
}

/// n(x) = 1 + A cos(k (x + 1.2)^2): every frequency up to that of the end. Held out: nothing was chosen on it.
Adversary chirp(std::uint64_t seed) {
  Draw draw(12, seed);
  const double height = draw.decades(1e-3, 0.6), k = draw.decades(1, 500);
  std::vector<Real> limits;
  for (int i = 0; i <= 16; ++i) limits.push_back(-1 + Real(i) / 8);
  const double rise = draw.uniform(0, 1.5);
  Adversary made = stratified(
      "1+" + text(height) + "*cos(" + text(k) + "*(x+1.2)^2)",
      [=](Real x) { return 1 + Real(height) * std::cos(Real(k) * (x + Real(1.2)) * (x + Real(1.2))); }, limits, rise,
      draw.integer(12, 150));
  made.feature = kPi / (4.4 * k) * (1 - height);  // the last ripple
  return made;
}

/// n(x) = 1 - A log((x - c)^2 + w^2) / 10: a wall with a logarithmic foot. Held out: nothing was chosen on it.
Adversary logarithmic_wall(std::uint64_t seed) {
  Draw draw(13, seed);
  const double height = draw.decades(1e-2, 1), w = draw.decades(1e-4, 0.2), c = draw.uniform(-0.5, 0.5);
  const auto index = [=](Real x) {
    return 1 + Real(height) / 10 * (2 - std::log((x - Real(c)) * (x - Real(c)) + Real(w) * Real(w)));
  };
  std::vector<Real> limits = {-1};
  for (const double part : {-100., -30., -10., -3., 3., 10., 30., 100.}) {
    const Real x = Real(c) + Real(part) * Real(w);
    if (x > limits.back() && x < 1) limits.push_back(x);
  }
  limits.push_back(1);
  const double rise = draw.uniform(0, 1.5);
  Adversary made = stratified("1+" + text(height) + "/10*(2-log((x-" + text(c) + ")^2+" + text(w) + "^2))", index,
                              limits, rise, draw.integer(12, 150));
  made.feature = 2 * w;
  return made;
}

/// z = a sin(k x): the sheet unrolls.
Adversary corrugated(std::uint64_t seed) {
  Draw draw(7, seed);
  const double k = draw.decades(0.5, 60), a = draw.uniform(0.05, 1) / k;
  parametric::Formula surface{.x = "u", .y = "v", .z = text(a) + "*sin(" + text(k) + "*u)"};
  const Vector2d from(draw.uniform(-1, 0), 0), to(draw.uniform(0.2, 1), draw.uniform(0, 1.5));
  const Real across =
      integral([&](Real x) { return std::sqrt(1 + std::pow(Real(a) * Real(k) * std::cos(Real(k) * x), 2)); }, from[0],
               to[0], 4000);
  return {between(make_parametric_manifold({.surface = surface}), make_euclidean_cost(3), from, to), straight(),
          draw.integer(20, 120), known(std::hypot(across, Real(to[1])))};
}

/// The same by its equation, with ripples that may be much finer than the segments.
Adversary corrugated_level_set(std::uint64_t seed) {
  Draw draw(15, seed);
  const double k = draw.decades(0.5, 600), a = draw.uniform(0.05, 1) / k;
  const implicit::Formula surface{.f = "z - " + text(a) + "*sin(" + text(k) + "*x)"};
  const auto place = [&](double x, double y) { return Vector3d(x, y, a * std::sin(k * x)); };
  const Vector3d from = place(draw.uniform(-1, 0), 0), to = place(draw.uniform(0.2, 1), draw.uniform(0, 1.5));
  const Real across =
      integral([&](Real x) { return std::sqrt(1 + std::pow(Real(a) * Real(k) * std::cos(Real(k) * x), 2)); }, from[0],
               to[0], 4000);
  return {between(make_implicit_manifold({.surface = surface}), make_euclidean_cost(3), from, to), straight(),
          draw.integer(20, 120), known(std::hypot(across, Real(to[1]))), kPi / k};
}

/// n(x) = 1 - 0.5 cos(2 pi k x), along x: commensurate with the levels where k is a multiple of the segments.
Adversary washboard(std::uint64_t seed) {
  Draw draw(8, seed);
  const int k = draw.integer(1, 300);
  const std::string n = "(1-0.5*cos(2*3.141592653589793*" + std::to_string(k) + "*x))^2";
  return {between(space(2), field({n, "0", n}), Vector2d(0, 0), Vector2d(1, 0)), straight(), draw.integer(20, 127),
          known(1), 0.25 / k};
}

}  // namespace

std::optional<TrueGeodesic> geodesic_near(const Vector3d& axes, const Problem& problem, const Result& result) {
  if (result.path.u.cols() < 3 || !result.certificate.measured) return std::nullopt;
  const Points x = positions(*problem.manifold, result.path);
  // The chord turns by half of what the path turns in a segment: two of them give the direction at the start.
  const Vector3d a = x.col(0), next = a + 2 * (x.col(1) - a) - 0.5 * (x.col(2) - a);
  return EllipsoidShooting(axes).between(a, x.rightCols(1), next, result.certificate.estimate.value);
}

Problem oblate_pair(std::uint64_t seed) {
  Draw draw(1, seed);
  return on_ellipsoid(Vector3d(1, 1, 0.2), draw);
}

const std::vector<AdversaryFamily>& adversary_families() {
  static const std::vector<AdversaryFamily> families = {
      {"ellipsoid f = 0.8, n = 50", [](std::uint64_t seed) { return ellipsoid(seed, 50); }},
      {"ellipsoid f = 0.8, n = 100", [](std::uint64_t seed) { return ellipsoid(seed, 100); }},
      {"ellipsoid f = 0.8, few points",
       [](std::uint64_t seed) { return ellipsoid(seed, 6 + static_cast<int>(seed / 2 % 36)); }, false},
      {"ellipsoids in charts", chart},
      {"rings on necks", ring},
      {"constant tensors", tensor},
      {"pull-back metrics", pulled_back},
      {"layered media", layered, false},
      {"corrugated sheets", corrugated},
      {"ellipsoids by equation", level_set},
      {"corrugated sheets by equation", corrugated_level_set, false},
      {"washboards", washboard, false},
      {"narrow walls", narrow_wall, false},
      {"ripples", rippled, false},
      {"chirps (held out)", chirp, false},
      {"logarithmic walls (held out)", logarithmic_wall, false}};
  return families;
}

}  // namespace leastcost::test
