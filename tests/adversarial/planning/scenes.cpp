// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "tests/adversarial/planning/scenes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <utility>

namespace leastcost::test {
namespace {

using judge::Place;
using judge::Scene;
using judge::Thing;

/// Random numbers that are the same with every standard library.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : engine_(seed * 0x9E3779B97F4A7C15u + 1) {}
  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_() >> 11) * 0x1p-53;
  }
  /// Evenly in its logarithm.
  double around(double low, double high) { return std::exp(between(std::log(low), std::log(high))); }
  int whole(int low, int high) { return std::min(high, low + static_cast<int>(between(0, high - low + 1))); }
  Place place(int dimension, double low, double high) {
    Place x(static_cast<std::size_t>(dimension));
    for (double& v : x) v = between(low, high);
    return x;
  }
  Place direction(int dimension) {
    for (;;) {
      Place x = place(dimension, -1, 1);
      double square = 0;
      for (const double v : x) square += v * v;
      if (square > 1 || square < 0.01) continue;
      for (double& v : x) v /= std::sqrt(square);
      return x;
    }
  }

 private:
  std::mt19937_64 engine_;
};

double distance(const Place& a, const Place& b) {
  double square = 0;
  for (std::size_t k = 0; k < a.size(); ++k) square += (a[k] - b[k]) * (a[k] - b[k]);
  return std::sqrt(square);
}

Thing ball(Place center, double radius) { return {Thing::Kind::ball, radius, {std::move(center)}}; }
Thing box(Place lower, Place upper) { return {Thing::Kind::box, 0, {std::move(lower), std::move(upper)}}; }

/// From one corner of [0, 10]^d to the opposite one.
Scene empty_scene(int dimension) {
  const auto d = static_cast<std::size_t>(dimension);
  Scene scene;
  scene.dimension = dimension;
  scene.source = Place(d, 0.0);
  scene.target = Place(d, 10.0);
  return scene;
}

/// Balls at random places that leave the ends free.
void scatter(Dice& dice, Scene& scene, int count, double least, double most) {
  for (int tries = 0; count > 0 && tries < 100000; ++tries) {
    const Place center = dice.place(scene.dimension, 0, 10);
    const double radius = dice.around(least, most), keep = radius + scene.clearance + 1e-3;
    if (distance(center, scene.source) < keep || distance(center, scene.target) < keep) continue;
    scene.things.push_back(ball(center, radius));
    --count;
  }
}

PlannedScene balls(std::uint64_t seed, int dimension) {
  Dice dice(seed);
  PlannedScene made{empty_scene(dimension), dice.whole(30, 120)};
  made.scene.clearance = dice.whole(0, 1) * dice.around(1e-3, 0.3);
  scatter(dice, made.scene, dice.whole(1, 30), 0.2, dimension == 2 ? 1.2 : 2);
  return made;
}

/// Far smaller than a segment.
PlannedScene tiny_balls(std::uint64_t seed, int dimension) {
  Dice dice(seed);
  PlannedScene made{empty_scene(dimension), dice.whole(10, 60)};
  made.scene.clearance = dice.whole(0, 1) * dice.around(1e-4, 1e-2);
  scatter(dice, made.scene, 60, 1e-4, 3e-2);
  // Some exactly where the straight line runs.
  for (int i = dice.whole(1, 5); i > 0; --i)
    made.scene.things.push_back(
        ball(Place(static_cast<std::size_t>(dimension), dice.between(0.5, 9.5)), dice.around(1e-4, 3e-2)));
  return made;
}

/// A wall of discs, one behind the other, with a gap of 1.01 to 3 times what a path must keep from both of its sides.
PlannedScene corridor(std::uint64_t seed) {
  Dice dice(seed);
  PlannedScene made{empty_scene(2), dice.whole(30, 120)};
  Scene& scene = made.scene;
  scene.clearance = dice.around(0.02, 0.3);
  const int walls = dice.whole(1, 3);
  for (int w = 0; w < walls; ++w) {
    const double radius = dice.between(0.2, 0.6), x = 2.5 + 2.5 * w, gap = 2 * scene.clearance * dice.between(1.01, 3),
                 middle = dice.between(1, 9), reach = radius + gap / 2;
    for (double y = middle + reach; y < 16; y += 1.8 * radius) scene.things.push_back(ball({x, y}, radius));
    for (double y = middle - reach; y > -6; y -= 1.8 * radius) scene.things.push_back(ball({x, y}, radius));
  }
  return made;
}

/// A channel between two walls, as long as many segments or shorter than one.
PlannedScene channel(std::uint64_t seed) {
  Dice dice(seed);
  PlannedScene made{empty_scene(2), dice.whole(8, 120)};
  Scene& scene = made.scene;
  scene.clearance = dice.around(0.02, 0.3);
  const double half = scene.clearance * dice.between(1.01, 3), middle = dice.between(2, 8), from = dice.between(1, 4),
               to = from + dice.around(1e-3, 5);
  scene.things.push_back(box({from, middle + half}, {to, middle + half + 30}));
  scene.things.push_back(box({from, middle - half - 30}, {to, middle - half}));
  return made;
}

/// Walls as thin as 1e-6, each with an end to go around.
PlannedScene thin_walls(std::uint64_t seed, int dimension) {
  Dice dice(seed);
  PlannedScene made{empty_scene(dimension), dice.whole(20, 100)};
  Scene& scene = made.scene;
  scene.clearance = dice.around(1e-3, 0.3);
  const int walls = dice.whole(1, 4);
  for (int w = 0; w < walls; ++w) {
    const double x = 1.5 + 2 * w + dice.between(0, 0.5), thick = dice.around(1e-6, 0.1), open = dice.between(0, 10);
    const bool above = dice.whole(0, 1) == 1;
    Place lower = {x, above ? -5 : open}, upper = {x + thick, above ? open : 15};
    if (dimension == 3) lower.push_back(-20), upper.push_back(30);
    scene.things.push_back(box(lower, upper));
  }
  return made;
}

/// A wall across space with a hole in it.
PlannedScene window(std::uint64_t seed) {
  Dice dice(seed);
  PlannedScene made{empty_scene(3), dice.whole(20, 100)};
  Scene& scene = made.scene;
  scene.clearance = dice.around(0.02, 0.3);
  const double half = scene.clearance * dice.between(1.2, 5), y = dice.between(2, 8), z = dice.between(2, 8),
               x = dice.between(3, 7), thick = dice.around(1e-4, 1);
  const auto part = [&](double y0, double y1, double z0, double z1) {
    scene.things.push_back(box({x, y0, z0}, {x + thick, y1, z1}));
  };
  part(-20, y - half, -20, 30);
  part(y + half, 30, -20, 30);
  part(y - half, y + half, -20, z - half);
  part(y - half, y + half, z + half, 30);
  return made;
}

/// Stars with 3 to 9 corners, not convex.
PlannedScene polygons(std::uint64_t seed) {
  Dice dice(seed);
  PlannedScene made{empty_scene(2), dice.whole(30, 120)};
  Scene& scene = made.scene;
  scene.clearance = dice.around(1e-3, 0.2);
  for (int count = dice.whole(1, 12), tries = 0; count > 0 && tries < 1000; ++tries) {
    const Place center = dice.place(2, 0, 10);
    const double size = dice.between(0.3, 1.5);
    if (std::min(distance(center, scene.source), distance(center, scene.target)) < size + scene.clearance + 0.01)
      continue;
    const int corners = dice.whole(3, 9);
    Thing star{Thing::Kind::polygon, 0, {}};
    for (int i = 0; i < corners; ++i) {
      const double angle = 2 * std::numbers::pi * (i + dice.between(0, 0.8)) / corners,
                   far = size * dice.between(corners == 3 ? 0.8 : 0.3, 1);
      star.corners.push_back({center[0] + far * std::cos(angle), center[1] + far * std::sin(angle)});
    }
    scene.things.push_back(star);
    --count;
  }
  return made;
}

/// Ends exactly at the clearance of a ball, a hair within it, or deep in it.
PlannedScene contact(std::uint64_t seed, int dimension) {
  Dice dice(seed);
  PlannedScene made{empty_scene(dimension), dice.whole(20, 100)};
  Scene& scene = made.scene;
  scene.clearance = dice.whole(0, 1) * dice.around(1e-3, 0.3);
  const int kind = dice.whole(0, 5);
  for (const bool at_source : {true, false}) {
    Place& end = at_source ? scene.source : scene.target;
    if (dice.whole(0, 1) == 0 && !at_source) continue;
    const double radius = dice.between(0.2, 2), keep = radius + scene.clearance;
    const double inside = kind == 0 ? dice.around(1e-6, 0.1) : kind == 1 ? dice.around(1e-16, 1e-10) : 0;
    const Place way = dice.direction(dimension);
    Place center = end;
    for (std::size_t k = 0; k < center.size(); ++k) center[k] += (keep - inside) * way[k];
    scene.things.push_back(ball(center, radius));
  }
  scatter(dice, scene, dice.whole(0, 8), 0.2, 1);
  return made;
}

/// Something stands where an end is.
PlannedScene on_an_end(std::uint64_t seed, int dimension) {
  Dice dice(seed);
  PlannedScene made = balls(seed, dimension);
  Scene& scene = made.scene;
  const Place at = dice.whole(0, 1) == 0 ? scene.source : scene.target;
  if (dice.whole(0, 1) == 0) {
    scene.things.push_back(ball(at, dice.around(1e-3, 1)));
  } else {
    scene.clearance = std::max(scene.clearance, 1e-3);
    Place lower = at, upper = at;
    for (std::size_t k = 0; k < lower.size(); ++k) lower[k] -= 0.1, upper[k] += 0.2;
    scene.things.push_back(box(lower, upper));
  }
  return made;
}

/// A family in the plane or in space.
SceneFamily in(int dimension, const char* name, PlannedScene (*make)(std::uint64_t, int)) {
  return {std::string(name) + (dimension == 2 ? " 2D" : " 3D"),
          [make, dimension](std::uint64_t seed) { return make(seed, dimension); }};
}

}  // namespace

const std::vector<SceneFamily>& scene_families() {
  static const std::vector<SceneFamily> all = {
      in(2, "balls", balls),           in(3, "balls", balls),           in(2, "tiny balls", tiny_balls),
      in(3, "tiny balls", tiny_balls), {"corridors", corridor},         {"channels", channel},
      in(2, "thin walls", thin_walls), in(3, "thin walls", thin_walls), {"windows", window},
      {"polygons", polygons},          in(2, "contact", contact),       in(3, "contact", contact),
      in(2, "on an end", on_an_end),   in(3, "on an end", on_an_end)};
  return all;
}

}  // namespace leastcost::test
