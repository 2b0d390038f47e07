// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include <leastcost/problems/costs/metric_field.hpp>
#include "tests/support/random.hpp"
#include "tests/support/trials.hpp"

namespace leastcost::test {

/// As many as the environment says, else so many.
inline int planted_problems(int otherwise) {
  const char* text = std::getenv("LEASTCOST_BRACKET_PROBLEMS");  // NOLINT(concurrency-mt-unsafe)
  return text == nullptr ? trials(otherwise) : std::atoi(text);
}

/// A medium with a known least cost: u without critical points, n = |grad u|, and a target on the flow of grad u from
/// the source. Every path costs at least u(target) - u(source), and the flow costs that: |grad u| <= n everywhere, with
/// equality along it. An error e of the integration moves the target off the flow: the least cost is then larger, by
/// O(e^2).
struct PlantedMedium {
  struct Wave {
    double size, kx, ky, phase;
  };
  double ax = 1, ay = 0;
  std::vector<Wave> waves;
  Eigen::AlignedBox2d box;
  Eigen::Vector2d source = Eigen::Vector2d::Zero(), target = Eigen::Vector2d::Zero();
  std::vector<Eigen::Vector2d> flow;  ///< from the source to the target

  static PlantedMedium random(Random& random) {
    PlantedMedium m;
    m.box = {Eigen::Vector2d(0, 0), Eigen::Vector2d(random.uniform(0.5, 1.5), random.uniform(0.5, 1.5))};
    const double angle = random.uniform(0, 6.283185307179586);
    m.ax = std::cos(angle);
    m.ay = std::sin(angle);
    double room = random.uniform(0.1, 0.75);
    for (int k = 0, count = random.integer(1, 4); k < count; ++k) {
      const double frequency = random.uniform(1, 12), turn = random.uniform(0, 6.283185307179586);
      const double slope = room * random.uniform(0.3, 0.6);
      room -= slope;
      m.waves.push_back({slope / frequency, frequency * std::cos(turn), frequency * std::sin(turn),
                         random.uniform(0, 6.283185307179586)});
    }
    const Eigen::Vector2d size = m.box.sizes();
    // Begins on the side of the box that the flow comes from.
    m.source = m.box.center() - 0.38 * size.cwiseProduct(Eigen::Vector2d(m.ax, m.ay)) +
               0.08 * size.cwiseProduct(Eigen::Vector2d(random.uniform(-1, 1), random.uniform(-1, 1)));
    m.follow_flow();
    return m;
  }

  double u(const Eigen::Vector2d& x) const {
    double sum = ax * x[0] + ay * x[1];
    for (const Wave& w : waves) sum += w.size * std::sin(w.kx * x[0] + w.ky * x[1] + w.phase);
    return sum;
  }
  Eigen::Vector2d gradient(const Eigen::Vector2d& x) const {
    Eigen::Vector2d sum(ax, ay);
    for (const Wave& w : waves)
      sum += w.size * std::cos(w.kx * x[0] + w.ky * x[1] + w.phase) * Eigen::Vector2d(w.kx, w.ky);
    return sum;
  }
  double density(const Eigen::Vector2d& x) const { return gradient(x).norm(); }
  /// The farthest that a place of the flow is from one of those that are kept, nearly.
  double flow_step() const { return box.sizes().minCoeff() / 1000; }
  double least_cost() const { return u(target) - u(source); }

  /// n^2 as a formula.
  std::string squared() const {
    std::ostringstream fx, fy;
    fx.precision(17);
    fy.precision(17);
    fx << "(" << ax;
    fy << "(" << ay;
    for (const Wave& w : waves) {
      std::ostringstream wave;
      wave.precision(17);
      wave << " * cos((" << w.kx << ") * x + (" << w.ky << ") * y + (" << w.phase << "))";
      fx << " + (" << w.size * w.kx << ")" << wave.str();
      fy << " + (" << w.size * w.ky << ")" << wave.str();
    }
    return fx.str() + ")^2 + " + fy.str() + ")^2";
  }
  std::shared_ptr<const SegmentCost> cost() const {
    const std::string n2 = squared();
    return make_metric_field_cost({.field = metric::Formula{{n2, "0", n2}, {}}}, 2);
  }

 private:
  Eigen::Vector2d direction(const Eigen::Vector2d& x) const { return gradient(x).normalized(); }

  /// Runge and Kutta's, to the rim of a box within the box, or as far as it is wide.
  void follow_flow() {
    const Eigen::Vector2d rim = 0.04 * box.sizes();
    const Eigen::AlignedBox2d inner(box.min() + rim, box.max() - rim);
    const double step = flow_step();
    flow = {source};
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

}  // namespace leastcost::test
