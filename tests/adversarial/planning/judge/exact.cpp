// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "tests/adversarial/planning/judge/exact.hpp"

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <stdexcept>

namespace judge {
namespace {

using Rational = boost::multiprecision::cpp_rational;

template <class T>
using PlaceOf = std::vector<T>;

template <class T>
PlaceOf<T> number(const Place& x) {
  return PlaceOf<T>(x.begin(), x.end());
}

template <class T>
PlaceOf<T> minus(const PlaceOf<T>& a, const PlaceOf<T>& b) {
  PlaceOf<T> d(a.size());
  for (std::size_t k = 0; k < a.size(); ++k) d[k] = a[k] - b[k];
  return d;
}

template <class T>
T dot(const PlaceOf<T>& a, const PlaceOf<T>& b) {
  T sum = 0;
  for (std::size_t k = 0; k < a.size(); ++k) sum += a[k] * b[k];
  return sum;
}

/// Squared distance of c from the segment a b.
template <class T>
T from_point(const PlaceOf<T>& a, const PlaceOf<T>& b, const PlaceOf<T>& c) {
  const PlaceOf<T> way = minus(b, a), to = minus(c, a);
  const T along = dot(to, way), length = dot(way, way);
  if (!(along > 0)) return dot(to, to);
  if (!(along < length)) {
    const PlaceOf<T> rest = minus(c, b);
    return dot(rest, rest);
  }
  PlaceOf<T> off(to);
  const T share = along / length;
  for (std::size_t k = 0; k < off.size(); ++k) off[k] -= share * way[k];
  return dot(off, off);
}

/// Squared distance of the segment a b from the box: least of parabolas between the planes of its sides.
template <class T>
T from_box(const PlaceOf<T>& a, const PlaceOf<T>& b, const PlaceOf<T>& lower, const PlaceOf<T>& upper) {
  const PlaceOf<T> way = minus(b, a);
  std::vector<T> bends = {T(0), T(1)};
  for (std::size_t k = 0; k < a.size(); ++k) {
    if (way[k] == 0) continue;
    for (const T& side : {lower[k], upper[k]}) {
      const T t = (side - a[k]) / way[k];
      if (t > 0 && t < 1) bends.push_back(t);
    }
  }
  std::sort(bends.begin(), bends.end());
  const auto square = [&](const T& t) {
    T sum = 0;
    for (std::size_t k = 0; k < a.size(); ++k) {
      const T x = a[k] + t * way[k];
      const T out = x < lower[k] ? T(lower[k] - x) : x > upper[k] ? T(x - upper[k]) : T(0);
      sum += out * out;
    }
    return sum;
  };
  T least = square(T(0));
  for (std::size_t i = 0; i + 1 < bends.size(); ++i) {
    const T &left = bends[i], &right = bends[i + 1];
    const T fl = square(left), fr = square(right), middle = (left + right) / 2, fm = square(middle);
    least = std::min({least, fr, fm});
    const T curved = fl - 2 * fm + fr;  // of the parabola through the three
    if (!(curved > 0)) continue;
    const T t = middle + (right - left) / 4 * (fl - fr) / curved;
    if (t > left && t < right) least = std::min(least, square(t));
  }
  return least;
}

template <class T>
T turn(const PlaceOf<T>& a, const PlaceOf<T>& b, const PlaceOf<T>& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/// Squared distance between two segments of the plane.
template <class T>
T between(const PlaceOf<T>& a, const PlaceOf<T>& b, const PlaceOf<T>& c, const PlaceOf<T>& d) {
  const T c_side = turn(a, b, c), d_side = turn(a, b, d), a_side = turn(c, d, a), b_side = turn(c, d, b);
  const auto apart = [](const T& x, const T& y) { return (x < 0 && y > 0) || (x > 0 && y < 0); };
  if (apart(c_side, d_side) && apart(a_side, b_side)) return T(0);
  return std::min({from_point(a, b, c), from_point(a, b, d), from_point(c, d, a), from_point(c, d, b)});
}

/// Whether x lies within a polygon, by the edges that a ray to the right crosses.
template <class T>
bool within(const std::vector<PlaceOf<T>>& corners, const PlaceOf<T>& x) {
  bool inside = false;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const PlaceOf<T>&p = corners[i], &q = corners[(i + 1) % corners.size()];
    if ((p[1] > x[1]) == (q[1] > x[1])) continue;
    const T side = turn(p, q, x);
    if (q[1] > p[1] ? side > 0 : side < 0) inside = !inside;
  }
  return inside;
}

template <class T>
T squared_distance(const Thing& thing, const Place& from, const Place& to) {
  const PlaceOf<T> a = number<T>(from), b = number<T>(to);
  std::vector<PlaceOf<T>> corners;
  for (const Place& x : thing.corners) corners.push_back(number<T>(x));
  if (thing.kind == Thing::Kind::ball) return from_point(a, b, corners.at(0));
  if (thing.kind == Thing::Kind::box) return from_box(a, b, corners.at(0), corners.at(1));
  if (a.size() != 2) throw std::runtime_error("a polygon lies in the plane");
  if (within(corners, a)) return T(0);
  T least = between(a, b, corners.back(), corners.front());
  for (std::size_t i = 0; i + 1 < corners.size(); ++i)
    least = std::min(least, between(a, b, corners[i], corners[i + 1]));
  return least;
}

}  // namespace

bool comes_nearer(const Thing& thing, double clearance, double tolerance, const Place& a, const Place& b) {
  const Rational limit = Rational(thing.radius) + Rational(clearance) - Rational(tolerance);
  return limit > 0 && squared_distance<Rational>(thing, a, b) < limit * limit;
}

double about_distance(const Thing& thing, const Place& a, const Place& b) {
  return std::sqrt(std::max(0.0, squared_distance<double>(thing, a, b)));
}

std::optional<Touch> first_touch(const Scene& scene, const std::vector<Place>& path, double tolerance) {
  const double far = 1e-6 * scene.diameter();  // what rounding of doubles is at least a million times less than
  for (std::size_t i = 0; i + 1 < path.size(); ++i)
    for (std::size_t j = 0; j < scene.things.size(); ++j) {
      const Thing& thing = scene.things[j];
      if (about_distance(thing, path[i], path[i + 1]) > thing.radius + scene.clearance + far) continue;
      if (comes_nearer(thing, scene.clearance, tolerance, path[i], path[i + 1])) return Touch{i, j};
    }
  return std::nullopt;
}

}  // namespace judge
