// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
//
// Refraction against referees that share nothing with it: the ray parameter by bisection in long double where
// interfaces are parallel, Dijkstra over dense points on the interfaces where they dip.
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <leastcost/framework/base/errors.hpp>
#include "problems/layers/fastest_ray.hpp"
#include "problems/layers/ray_bound.hpp"
#include "problems/layers/snell.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/random.hpp"

namespace leastcost::test {
namespace {

using Vector = Eigen::VectorXd;
using Real = long double;

/// A stack across a direction, with ends given by their heights and their offset along the interfaces.
struct Stacked {
  Vector offsets, indices;
  double from = 0, to = 0, along = 0;
};

/// The highest or the lowest place of a path; the layer beyond it, along which it runs there, or -1.
struct Extreme {
  double height;
  int beyond;
};

/// The largest p X + sum of m h sqrt(n^2 - p^2) of paths between these heights; infinite where they meet no layer.
Real cost_between(const Stacked& s, const Extreme& bottom, const Extreme& top) {
  const double low = std::min(s.from, s.to), high = std::max(s.from, s.to);
  Real least_index = std::numeric_limits<Real>::infinity();
  std::vector<std::pair<Real, Real>> passed;  // index, way across
  for (int l = 0; l < static_cast<int>(s.indices.size()); ++l) {
    const double floor = l > 0 ? s.offsets[l - 1] : -1e300;
    const double ceiling = l < s.offsets.size() ? s.offsets[l] : 1e300;
    const auto part = [&](double a, double b) {
      return std::max<Real>(0, Real(std::min(b, ceiling)) - Real(std::max(a, floor)));
    };
    const Real across = part(low, high) + 2 * part(bottom.height, low) + 2 * part(high, top.height);
    const bool within = bottom.height == top.height && floor < low && low < ceiling;
    if (across > 0 || within || l == bottom.beyond || l == top.beyond)
      least_index = std::min<Real>(least_index, s.indices[l]);
    if (across > 0) passed.emplace_back(s.indices[l], across);
  }
  if (std::isinf(least_index)) return least_index;
  Real below = 0, above = least_index;
  for (int i = 0; i < 200; ++i) {
    const Real p = (below + above) / 2;
    Real reach = 0;
    for (const auto& [n, h] : passed) reach += h * p / std::sqrt((n - p) * (n + p));
    (reach <= s.along ? below : above) = p;
  }
  Real cost = below * s.along;
  for (const auto& [n, h] : passed) cost += h * std::sqrt((n - below) * (n + below));
  return cost;
}

/// The least cost over how far a path goes down and up.
Real least_cost(const Stacked& s) {
  const double low = std::min(s.from, s.to), high = std::max(s.from, s.to);
  std::vector<Extreme> bottoms = {{low, -1}}, tops = {{high, -1}};
  for (int k = 0; k < s.offsets.size(); ++k) {
    if (s.offsets[k] <= low) bottoms.push_back({s.offsets[k], k});
    if (s.offsets[k] >= high) tops.push_back({s.offsets[k], k + 1});
  }
  Real best = std::numeric_limits<Real>::infinity();
  for (const Extreme& bottom : bottoms)
    for (const Extreme& top : tops) best = std::min(best, cost_between(s, bottom, top));
  return best;
}

/// The same in a space whose last axis is turned.
struct Turned {
  LayerStack stack;
  Vector source, target;
};
Turned turned(const Stacked& s, int d, Random& random, bool turn) {
  Eigen::MatrixXd q = Eigen::MatrixXd::Identity(d, d);
  if (turn) q = Eigen::HouseholderQR<Eigen::MatrixXd>(random.matrix(d, d)).householderQ();
  const Vector normal = q.rightCols(1);
  Vector beside = q.leftCols(d - 1) * random.vector(d - 1).normalized();
  if (d == 2) beside = q.leftCols(1);
  return {LayerStack(normal.replicate(1, s.offsets.size()), s.offsets, s.indices), s.from * normal,
          s.to * normal + s.along * beside};
}

/// Between 1 and `most` interfaces, thin and thick; contrasts up to 10; sometimes an end on an interface.
Stacked draw(Random& random, int most) {
  const int k = random.integer(1, most);
  Stacked s;
  s.offsets.resize(k);
  s.indices.resize(k + 1);
  double h = 0;
  for (int i = 0; i < k; ++i) s.offsets[i] = h += std::pow(10.0, random.uniform(-3, 0.3));
  for (double& n : s.indices) n = std::pow(10.0, random.uniform(-0.5, 0.5));
  const auto end = [&] {
    if (random.uniform(0, 1) < 0.15) return s.offsets[random.integer(0, k - 1)];
    return random.uniform(-1, h + 1);
  };
  s.from = end();
  s.to = end();
  s.along = std::pow(10.0, random.uniform(-2, 1.3));
  return s;
}

}  // namespace

TEST_CASE("layers: the least cost of all words of parallel interfaces is that of the ray parameter") {
  Random random(20261124);
  double worst_cost = 0, worst_gap = 0;
  int excursions = 0;
  for (int i = 0; i < 400; ++i) {
    const Stacked s = draw(random, 12);
    const int d = 2 + i % 3;
    const bool turn = i % 2 == 1;
    const Turned t = turned(s, d, random, turn);
    const FastestRay found = fastest_ray(t.stack, t.source, t.target);
    CAPTURE(i, s.offsets.transpose(), s.indices.transpose(), s.from, s.to, s.along);
    REQUIRE(found.finished);
    REQUIRE(found.best);
    const double truth = static_cast<double>(least_cost(s));
    CHECK(found.best->cost == Approx(truth).epsilon(1e-12));
    CHECK(found.lower_bound <= truth * (1 + (turn ? 1e-14 : 0)));  // turning rounds the problem itself
    worst_cost = std::max(worst_cost, std::abs(found.best->cost / truth - 1));
    worst_gap = std::max(worst_gap, 1 - found.lower_bound / found.best->cost);
    excursions += found.best->word.size() >
                  static_cast<std::size_t>(std::abs(found.best->word.front() - found.best->word.back())) + 1;
  }
  CHECK(worst_cost <= 1e-13);
  CHECK(worst_gap <= 1e-11);
  CHECK(excursions >= 40);
}

namespace {

/// Interfaces through the heights 0, 1, ... of x = 0 that do not cross for |x| <= 4; ends between x = -3 and 3.
struct Dipping {
  LayerStack stack;
  Vector source, target;
};
Dipping draw_dipping(Random& random) {
  const int k = random.integer(1, 3);
  Eigen::MatrixXd normals(2, k);
  Vector offsets(k), indices(k + 1);
  for (int i = 0; i < k; ++i) {
    normals.col(i) << random.uniform(-0.12, 0.12), 1;
    offsets[i] = i;
  }
  for (double& n : indices) n = std::pow(10.0, random.uniform(-0.4, 0.4));
  const auto end = [&](double x) -> Vector { return Eigen::Vector2d(x, random.uniform(-0.5, k - 0.5)); };
  return {LayerStack(normals, offsets, indices), end(random.uniform(-3, -1)), end(random.uniform(1, 3))};
}

/// Dijkstra over points on all interfaces, |x| <= 4: the cost of a path that may be delivered, hence never below the
/// least.
double dense_cost(const Dipping& p, int per_interface) {
  const LayerStack& stack = p.stack;
  struct Node {
    Eigen::Vector2d x;
    int low, high;  // the layers that it touches
  };
  const int at_source = *stack.layer_of(p.source), at_target = *stack.layer_of(p.target);
  std::vector<Node> nodes = {{p.source, at_source, at_source}};
  for (int k = 0; k < stack.interfaces(); ++k)
    for (int i = 0; i <= per_interface; ++i) {
      const double x = -4 + 8.0 * i / per_interface;
      nodes.push_back({{x, (stack.offset(k) - stack.normal(k)[0] * x) / stack.normal(k)[1]}, k, k + 1});
    }
  nodes.push_back({p.target, at_target, at_target});
  std::vector<double> cost(nodes.size(), std::numeric_limits<double>::infinity());
  std::vector<bool> done(nodes.size(), false);
  cost[0] = 0;
  for (;;) {
    std::size_t best = nodes.size();
    for (std::size_t i = 0; i < nodes.size(); ++i)
      if (!done[i] && (best == nodes.size() || cost[i] < cost[best])) best = i;
    if (best + 1 == nodes.size()) return cost[best];
    done[best] = true;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      if (done[i]) continue;
      for (int l = std::max(nodes[i].low, nodes[best].low); l <= std::min(nodes[i].high, nodes[best].high); ++l)
        cost[i] = std::min(cost[i], cost[best] + stack.index(l) * (nodes[i].x - nodes[best].x).norm());
    }
  }
}

}  // namespace

TEST_CASE("layers: the least cost of dipping interfaces is that of dense points on them") {
  Random random(7);
  int turned_back = 0;
  for (int i = 0; i < 60; ++i) {
    const Dipping p = draw_dipping(random);
    const FastestRay found = fastest_ray(p.stack, p.source, p.target);
    CAPTURE(i, p.stack.indices().transpose(), p.source.transpose(), p.target.transpose());
    REQUIRE(found.finished);
    REQUIRE(found.best);
    const double dense = dense_cost(p, 400);
    CHECK(found.best->cost <= dense * (1 + 1e-14));
    CHECK(dense <= found.best->cost * (1 + 2e-3));  // points 0.02 apart, ends as near to an interface
    CHECK(found.lower_bound <= found.best->cost);
    CHECK(found.best->cost - found.lower_bound <= 1e-9 * found.best->cost);
    for (const Crossing& c : measure_crossings(p.stack, without_repeats(found.best->x)))
      CHECK(c.mismatch <= 1e-11 + c.rounding);
    turned_back += found.best->word.size() >
                   static_cast<std::size_t>(std::abs(found.best->word.front() - found.best->word.back())) + 1;
  }
  CHECK(turned_back >= 5);
}

/// Whatever vectors and places a bound is made of, it is one.
TEST_CASE("layers: a bound of a word holds for any slownesses") {
  Random random(11);
  int far = 0;
  for (int i = 0; i < 200; ++i) {
    const Dipping p = draw_dipping(random);
    const LayerWord word = [&] {
      LayerWord all;
      const int from = *p.stack.layer_of(p.source), to = *p.stack.layer_of(p.target);
      for (int l = from; l != to; l += to > from ? 1 : -1) all.push_back(l);
      all.push_back(to);
      return all;
    }();
    const RefractedRay ray = refracted_ray(p.stack, p.source, p.target, word);
    for (const double noise : {0.0, 1e-12, 1e-6, 0.1}) {
      RefractedRay off = ray;
      off.slowness += noise * random.matrix(2, static_cast<int>(off.slowness.cols()));
      for (Index j = 1; j + 1 < off.x.cols(); ++j) off.x.col(j) += noise * random.vector(2);
      const double bound = word_bound(p.stack, off, ray.cost);
      CHECK(bound <= ray.cost * (1 + 1e-15));
      if (noise == 0) CHECK(bound >= ray.cost * (1 - 1e-12));
      far += bound < 0.99 * ray.cost;
    }
  }
  CHECK(far > 50);  // the noise is felt
}

TEST_CASE("layers: words") {
  const LayerStack stack(Eigen::Vector2d(0, 2).replicate(1, 3), Eigen::Vector3d(0, 2, 4),
                         Eigen::Vector4d(1, 0.5, 2, 0.25));
  CHECK(stack.offset(1) == 1);  // in units of the normal
  CHECK(stack.is_parallel());
  CHECK(is_sensible(stack, {0, 1, 0}));
  CHECK_FALSE(is_sensible(stack, {1, 2, 1}));
  CHECK(is_sensible(stack, {1, 2, 3, 2, 1}));
  CHECK_FALSE(is_sensible(stack, {1, 0, 1}));
  CHECK(shortened(stack, {1, 0, 1, 2, 1, 2, 3}) == LayerWord{1, 2, 3});
  const auto word = [&](const std::vector<Eigen::Vector2d>& points) {
    Points x(2, static_cast<Index>(points.size()));
    for (std::size_t i = 0; i < points.size(); ++i) x.col(static_cast<Index>(i)) = points[i];
    return word_of_polyline(stack, x).value_or(LayerWord{});
  };
  CHECK(word({{0, -1}, {1, 3}}) == LayerWord{0, 1, 2, 3});
  CHECK(word({{0, -1}, {1, 0}, {2, 0}, {3, -1}}) == LayerWord{0, 1, 0});  // along the interface: the faster one
  CHECK(word({{0, -1}, {1, -2}}) == LayerWord{0});
  CHECK(word({{0, 0}, {1, -1}}) == LayerWord{0});  // from an interface
  CHECK(word({{0, 1}, {1, 0}}) == LayerWord{1});   // from one to the next
  CHECK(text(LayerWord{0, 1, 0}) == "0 1 0");
}

TEST_CASE("layers: places where interfaces have crossed are in no layer") {
  Eigen::MatrixXd normals(2, 2);
  normals << 1, -1, 1, 1;  // x + y = 0 below -x + y = 0: they cross at the origin, for x < 0 the order is lost
  const LayerStack stack(normals, Eigen::Vector2d(0, 0), Eigen::Vector3d(1, 2, 3));
  CHECK_FALSE(stack.is_parallel());
  CHECK(stack.layer_of(Eigen::Vector2d(0, -1)) == 0);
  CHECK(stack.layer_of(Eigen::Vector2d(1, 0)) == 1);
  CHECK(stack.layer_of(Eigen::Vector2d(0, 1)) == 2);
  CHECK_FALSE(stack.layer_of(Eigen::Vector2d(-1, 0)));
  CHECK(stack.layers_at(Eigen::Vector2d(0, 0)) == std::vector<int>{0, 1, 2});
  // From left of the crossing to left of it: around the place where there is no layer.
  const Eigen::Vector2d source(-1, -1.5), target(-1, 1.5);
  const FastestRay found = fastest_ray(stack, source, target);
  REQUIRE(found.best);
  CHECK(found.best->cost == Approx(4 * source.norm()).epsilon(1e-9));
  CHECK(found.lower_bound <= 4 * source.norm());
  CHECK(found.lower_bound >= 4 * source.norm() * (1 - 1e-6));
  // A box that no path fits into leaves the bound.
  FastestRayOptions options;
  options.allowed = [](const Points&) { return false; };
  const FastestRay none = fastest_ray(stack, source, target, options);
  CHECK_FALSE(none.best);
  CHECK(none.finished);
  CHECK(none.lower_bound == found.lower_bound);
}

TEST_CASE("layers: what is no stack is refused with its reason") {
  const Eigen::Vector2d up(0, 1);
  const auto key = [](const Eigen::MatrixXd& normals, const Vector& offsets, const Vector& indices) -> std::string {
    try {
      LayerStack(normals, offsets, indices);
    } catch (const OptionError& error) {
      return error.key();
    }
    return "";
  };
  CHECK(key(up, Vector(), Vector()) == "interfaces");
  CHECK(key(up, Vector::Zero(1), Eigen::Vector3d(1, 2, 3)) == "indices");
  CHECK(key(up, Vector::Zero(1), Eigen::Vector2d(1, 0)) == "indices");
  CHECK(key(up, Vector::Zero(1), Eigen::Vector2d(1, std::numeric_limits<double>::infinity())) == "indices");
  CHECK(key(Eigen::Vector2d::Zero(), Vector::Zero(1), Eigen::Vector2d(1, 2)) == "normals");
  CHECK(key(up.replicate(1, 2), Eigen::Vector2d(1, 1), Eigen::Vector3d(1, 2, 3)) == "interfaces");
  CHECK(key(up.replicate(1, 2), Eigen::Vector2d(1, 2), Eigen::Vector3d(1, 2, 3)).empty());
}

/// Legs that are much shorter than others, angles near the critical one, ends next to an interface: the bar may widen,
/// never lie.
TEST_CASE("layers: thin, steep and critical") {
  Random random(3);
  for (int i = 0; i < 200; ++i) {
    Stacked s;
    s.offsets = Eigen::Vector2d(0, std::pow(10.0, random.uniform(-9, -1)));
    s.indices = Eigen::Vector3d(random.uniform(0.2, 1), random.uniform(0.2, 3), random.uniform(1, 1.5));
    s.from = s.offsets[1] + std::pow(10.0, random.uniform(-9, 0));
    s.to = s.offsets[1] + std::pow(10.0, random.uniform(-9, 0));
    s.along = std::pow(10.0, random.uniform(-6, 2));
    const Turned t = turned(s, 2, random, false);
    const FastestRay found = fastest_ray(t.stack, t.source, t.target);
    CAPTURE(i, s.offsets.transpose(), s.indices.transpose(), s.from, s.to, s.along);
    REQUIRE(found.best);
    const double truth = static_cast<double>(least_cost(s));
    CHECK(found.lower_bound <= truth * (1 + 1e-15));
    CHECK(found.best->cost >= truth * (1 - 1e-14));
    CHECK(found.best->cost <= truth * (1 + 1e-9));
    CHECK(found.lower_bound >= truth * (1 - 1e-9));
  }
}

}  // namespace leastcost::test
