// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include <leastcost/problems/bracket/search/bracket.hpp>
#include <leastcost/problems/costs/metric_field.hpp>
#include <leastcost/problems/costs/zermelo.hpp>
#include "tests/problems/planted_media.hpp"

namespace leastcost::test {

/// A metric or a wind with a known least cost, as a PlantedMedium: u without critical points, H(x, grad u) = 1 for the
/// dual norm H, and a target on the flow of dH/dp from the source.
///
/// Metric: G = (I + (ratio^2 - 1) e e') scaled so that grad u' G^-1 grad u = 1, e = (cos f, sin f) with f a wave: moves
/// along e cost `ratio` times as much as moves across. Wind: w of two waves, V = (1 - w.grad u) / |grad u|.
struct PlantedDirections {
  PlantedMedium medium;  ///< u, the box and the source
  bool wind = false;
  double ratio = 1;
  PlantedMedium::Wave turn = {}, first = {}, second = {};
  Eigen::Vector2d steady = Eigen::Vector2d::Zero();
  Eigen::Vector2d target = Eigen::Vector2d::Zero();
  std::vector<Eigen::Vector2d> flow;

  static PlantedDirections metric(Random& random, double ratio) {
    PlantedDirections m = with_medium(random);
    m.ratio = ratio;
    m.turn = wave(random, random.uniform(0, 0.6));
    m.turn.phase = random.uniform(0, 3.2);
    m.follow_flow();
    return m;
  }
  /// |w| is at most `strength` times half of what keeps it below V.
  static PlantedDirections windy(Random& random, double strength) {
    PlantedDirections m = with_medium(random);
    m.wind = true;
    double steepest = 0;
    for (int k = 0; k < 2000; ++k) {
      const Eigen::Vector2d x = m.medium.box.min() + m.medium.box.sizes().cwiseProduct(
                                                         Eigen::Vector2d(random.uniform(0, 1), random.uniform(0, 1)));
      steepest = std::max(steepest, m.medium.gradient(x).norm());
    }
    const double most = 0.49 * strength / steepest, part = random.uniform(0, 1), angle = random.uniform(0, 6.3);
    m.steady = most * part * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    m.first = wave(random, most * (1 - part) / 1.5);
    m.second = wave(random, most * (1 - part) / 1.5);
    m.follow_flow();
    return m;
  }

  double u(const Eigen::Vector2d& x) const { return medium.u(x); }
  double least_cost() const { return u(target) - u(medium.source); }

  std::shared_ptr<const SegmentCost> cost() const {
    const std::string gx = slope(0), gy = slope(1);
    if (wind) {
      const std::string wx = text(steady[0]) + " + " + text(first, "sin"),
                        wy = text(steady[1]) + " + " + text(second, "sin");
      const std::string speed =
          "(1 - (" + wx + ") * " + gx + " - (" + wy + ") * " + gy + ") / sqrt(" + gx + "^2 + " + gy + "^2)";
      return make_zermelo_cost({.speed = speed, .flow = flow::Formula{{wx, wy}}}, 2);
    }
    const std::string m = text(ratio * ratio - 1), f = "(" + text(turn, "sin") + ")";
    const std::string a = "(1 + " + m + " * cos" + f + "^2)", b = "(" + m + " * cos" + f + " * sin" + f + ")",
                      c = "(1 + " + m + " * sin" + f + "^2)";
    const std::string scale = "((" + c + " * " + gx + "^2 - 2 * " + b + " * " + gx + " * " + gy + " + " + a + " * " +
                              gy + "^2) / " + text(ratio * ratio) + ")";
    return make_metric_field_cost(
        {.field = metric::Formula{{a + " * " + scale, b + " * " + scale, c + " * " + scale}, {}}}, 2);
  }

 private:
  static PlantedDirections with_medium(Random& random) {
    PlantedDirections m;
    m.medium = PlantedMedium::random(random);
    return m;
  }
  static PlantedMedium::Wave wave(Random& random, double size) {
    const double frequency = random.uniform(1, 6), way = random.uniform(0, 6.3);
    return {size, frequency * std::cos(way), frequency * std::sin(way), random.uniform(0, 6.3)};
  }
  static std::string text(double x) {
    std::ostringstream out;
    out.precision(17);
    out << "(" << x << ")";
    return out.str();
  }
  static std::string argument(const PlantedMedium::Wave& w) {
    return text(w.kx) + " * x + " + text(w.ky) + " * y + " + text(w.phase);
  }
  /// size * sin(k.x) + phase of the angle of a metric, size * sin(k.x + phase) of a wind.
  std::string text(const PlantedMedium::Wave& w, const std::string& function) const {
    return text(w.size) + " * " + function + "(" + argument(w) + ")" + (wind ? "" : " + " + text(w.phase));
  }
  std::string slope(int axis) const {
    std::string sum = "(" + text(axis == 0 ? medium.ax : medium.ay);
    for (const PlantedMedium::Wave& w : medium.waves)
      sum += " + " + text(w.size * (axis == 0 ? w.kx : w.ky)) + " * cos(" + argument(w) + ")";
    return sum + ")";
  }

  static double value(const PlantedMedium::Wave& w, const Eigen::Vector2d& x) {
    return w.size * std::sin(w.kx * x[0] + w.ky * x[1] + w.phase);
  }
  /// Unit vector along dH/dp.
  Eigen::Vector2d direction(const Eigen::Vector2d& x) const {
    const Eigen::Vector2d p = medium.gradient(x);
    if (wind) {
      const Eigen::Vector2d w = steady + Eigen::Vector2d(value(first, x), value(second, x));
      return (w + (1 - w.dot(p)) / p.squaredNorm() * p).normalized();
    }
    const double f = value(turn, x) + turn.phase;
    const Eigen::Vector2d e(std::cos(f), std::sin(f));
    return (p - (1 - 1 / (ratio * ratio)) * e.dot(p) * e).normalized();
  }

  /// As PlantedMedium's.
  void follow_flow() {
    const Eigen::Vector2d rim = 0.04 * medium.box.sizes();
    const Eigen::AlignedBox2d inner(medium.box.min() + rim, medium.box.max() - rim);
    const double step = medium.box.sizes().minCoeff() / 1000;
    flow = {medium.source};
    for (int k = 0; k < 1200; ++k) {
      const Eigen::Vector2d x = flow.back(), a = direction(x), b = direction(x + step / 2 * a),
                            c = direction(x + step / 2 * b), d = direction(x + step * c);
      const Eigen::Vector2d next = x + step / 6 * (a + 2 * b + 2 * c + d);
      if (!inner.contains(next)) break;
      flow.push_back(next);
    }
    target = flow.back();
  }
};

/// Largest H(x, grad u) at random places where the inequality is said to be proved, over the ratio that is proved.
inline double worst_dual(const BracketPotential& potential, const CostDual& dual, const Eigen::AlignedBox2d& box,
                         Random& random) {
  double worst = 0;
  for (int k = 0; k < 300; ++k) {
    const Eigen::Vector2d x(random.uniform(box.min()[0], box.max()[0]), random.uniform(box.min()[1], box.max()[1]));
    if (!potential.is_checked(x)) continue;
    const Eigen::Vector2d p = potential.gradient(x);
    worst = std::max(worst, dual.dual(x)(p[0], p[1]) / potential.ratio());
  }
  return worst;
}

}  // namespace leastcost::test
