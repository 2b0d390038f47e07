// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "tests/adversarial/planning/judge/tangent_graph.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <queue>
#include <stdexcept>
#include <utility>
#include <vector>

namespace judge {
namespace {

using Real = long double;
using Point = std::complex<Real>;

constexpr Real kPi = std::numbers::pi_v<Real>;
constexpr Real kRounding = 1e-15L;  // of the size of the scene: what a tangent may cut off a disc

struct Disc {
  Point center;
  Real radius;
};

Real dot(Point a, Point b) { return a.real() * b.real() + a.imag() * b.imag(); }

Real distance(Point a, Point b, Point c) {
  const Point way = b - a;
  const Real length = std::norm(way);
  const Real t = length > 0 ? std::clamp(dot(c - a, way) / length, Real(0), Real(1)) : 0;
  return std::abs(a + t * way - c);
}

class Graph {
 public:
  explicit Graph(const Scene& scene) : size_(static_cast<Real>(scene.diameter())) {
    for (const Thing& thing : scene.things) {
      if (thing.kind != Thing::Kind::ball || thing.corners.at(0).size() != 2)
        throw std::runtime_error("a tangent graph is of discs in the plane");
      discs_.push_back({{thing.corners[0][0], thing.corners[0][1]}, Real(thing.radius) + Real(scene.clearance)});
    }
    on_.resize(discs_.size());
    // The ends are discs of radius 0: their tangents are those of a point.
    discs_.push_back({{scene.source[0], scene.source[1]}, 0});
    discs_.push_back({{scene.target[0], scene.target[1]}, 0});
    source_ = node(discs_[discs_.size() - 2].center), target_ = node(discs_.back().center);
  }

  std::optional<double> shortest() {
    for (const std::size_t end : {source_, target_})
      if (!clear(at_[end], at_[end], kNone, kNone)) return std::nullopt;
    for (std::size_t i = 0; i < discs_.size(); ++i)
      for (std::size_t j = i + 1; j < discs_.size(); ++j) join(i, j);
    for (std::size_t i = 0; i < on_.size(); ++i) arcs(i);
    return dijkstra();
  }

 private:
  static constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

  std::size_t node(Point x) {
    at_.push_back(x);
    next_.emplace_back();
    return at_.size() - 1;
  }

  void edge(std::size_t a, std::size_t b, Real length) {
    next_[a].emplace_back(b, length);
    next_[b].emplace_back(a, length);
  }

  /// Whether the segment keeps out of all discs but two.
  bool clear(Point a, Point b, std::size_t but, std::size_t and_but) const {
    for (std::size_t k = 0; k < on_.size(); ++k)
      if (k != but && k != and_but && distance(a, b, discs_[k].center) < discs_[k].radius - kRounding * size_)
        return false;
    return true;
  }

  std::size_t node_on(std::size_t disc, Point normal) {
    if (disc == on_.size()) return source_;
    if (disc == on_.size() + 1) return target_;
    const std::size_t made = node(discs_[disc].center + discs_[disc].radius * normal);
    on_[disc].emplace_back(std::arg(normal), made);
    return made;
  }

  /// The common tangents of two discs: unit normals n with n.(c_j - c_i) = s_i r_i - s_j r_j.
  void join(std::size_t i, std::size_t j) {
    const Disc &a = discs_[i], &b = discs_[j];
    const Point between = b.center - a.center;
    const Real apart = std::abs(between);
    if (!(apart > 0)) return;
    for (const Real side : {Real(1), Real(-1)})  // of the second disc against the first
      for (const Real turn : {Real(1), Real(-1)}) {
        if (side < 0 && (b.radius == 0 || a.radius == 0)) continue;  // a point has no sides
        if (a.radius == 0 && b.radius == 0 && turn < 0) continue;
        Real cosine = (a.radius - side * b.radius) / apart;
        if (std::abs(cosine) > 1 + kRounding * size_ / apart) continue;  // one within the other, or overlapping
        cosine = std::clamp(cosine, Real(-1), Real(1));
        const Point normal = between / apart * Point(cosine, turn * std::sqrt((1 - cosine) * (1 + cosine)));
        const Point p = a.center + a.radius * normal, q = b.center + side * b.radius * normal;
        if (!clear(p, q, i, j)) continue;
        const std::size_t from = node_on(i, normal);
        edge(from, node_on(j, side * normal), std::abs(q - p));
      }
  }

  /// Whether the arc of disc i from an angle on, counterclockwise over a span, meets no other disc.
  bool arc_clear(std::size_t i, Real from, Real span) const {
    const Disc& d = discs_[i];
    for (std::size_t k = 0; k < on_.size(); ++k) {
      if (k == i) continue;
      const Point to = discs_[k].center - d.center;
      const Real apart = std::abs(to), other = discs_[k].radius - kRounding * size_;
      if (apart >= d.radius + other || apart + other <= d.radius) continue;
      if (apart + d.radius < other) return false;
      const Real half = std::acos(std::clamp(
          (apart * apart + d.radius * d.radius - other * other) / (2 * apart * d.radius), Real(-1), Real(1)));
      Real ahead = std::fmod(std::arg(to) - half - from, 2 * kPi);  // where what it covers begins
      if (ahead < 0) ahead += 2 * kPi;
      if (ahead < span || ahead + 2 * half > 2 * kPi) return false;
    }
    return true;
  }

  void arcs(std::size_t i) {
    auto& touching = on_[i];
    // An end on the circle is joined to it.
    for (const std::size_t end : {source_, target_}) {
      const Point out = at_[end] - discs_[i].center;
      if (std::abs(std::abs(out) - discs_[i].radius) <= 8 * kRounding * size_)
        touching.emplace_back(std::arg(out), end);
    }
    std::sort(touching.begin(), touching.end());
    for (std::size_t k = 0; touching.size() > 1 && k < touching.size(); ++k) {
      const auto& [from, a] = touching[k];
      const auto& [to, b] = touching[(k + 1) % touching.size()];
      const Real span = k + 1 < touching.size() ? to - from : to - from + 2 * kPi;
      if (arc_clear(i, from, span)) edge(a, b, span * discs_[i].radius);
    }
  }

  std::optional<double> dijkstra() const {
    std::vector<Real> least(at_.size(), std::numeric_limits<Real>::infinity());
    using Entry = std::pair<Real, std::size_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
    open.emplace(least[source_] = 0, source_);
    while (!open.empty()) {
      const auto [length, at] = open.top();
      open.pop();
      if (at == target_) return static_cast<double>(length);
      if (length > least[at]) continue;
      for (const auto& [to, step] : next_[at])
        if (length + step < least[to]) open.emplace(least[to] = length + step, to);
    }
    return std::nullopt;
  }

  Real size_;
  std::vector<Disc> discs_;  // and the two ends
  std::vector<Point> at_;
  std::vector<std::vector<std::pair<std::size_t, Real>>> next_;
  std::vector<std::vector<std::pair<Real, std::size_t>>> on_;  // of a disc: angle and node
  std::size_t source_ = 0, target_ = 0;
};

}  // namespace

std::optional<double> shortest_among_discs(const Scene& scene) { return Graph(scene).shortest(); }

}  // namespace judge
