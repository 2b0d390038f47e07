// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include <leastcost/problems/bracket/space_density.hpp>
#include <leastcost/problems/costs/metric_field.hpp>
#include <leastcost/problems/costs/refractive_index.hpp>
#include "tests/support/random.hpp"

namespace leastcost::test {

inline std::shared_ptr<const SpaceDensity> isotropic_density(const std::string& n) {
  return space_density_of(make_refractive_index_cost({.index = refraction::Formula{n, {}}}, 3));
}

/// A medium in space with a known least cost, as PlantedMedium is one in the plane: u without critical points, n =
/// |grad u|, and a target on the flow of grad u from the source. Every path costs at least u(target) - u(source), and
/// the flow costs that. An error e of the integration moves the target off the flow: the least cost is then larger, by
/// O(e^2).
struct PlantedSpace {
  struct Wave {
    double size, phase;
    Eigen::Vector3d k;
  };
  Eigen::Vector3d a = Eigen::Vector3d::UnitX();
  std::vector<Wave> waves;
  Eigen::AlignedBox3d box;
  Eigen::Vector3d source = Eigen::Vector3d::Zero(), target = Eigen::Vector3d::Zero();
  std::vector<Eigen::Vector3d> flow;  ///< from the source to the target

  static PlantedSpace random(Random& random) {
    const auto direction = [&]() -> Eigen::Vector3d {
      return Eigen::Vector3d(random.normal(), random.normal(), random.normal()).normalized();
    };
    PlantedSpace m;
    m.box = {Eigen::Vector3d(0, 0, 0),
             Eigen::Vector3d(random.uniform(0.6, 1.4), random.uniform(0.6, 1.4), random.uniform(0.6, 1.4))};
    m.a = direction();
    double room = random.uniform(0.1, 0.7);
    for (int k = 0, count = random.integer(1, 3); k < count; ++k) {
      const double frequency = random.uniform(1, 8), slope = room * random.uniform(0.3, 0.6);
      room -= slope;
      m.waves.push_back({slope / frequency, random.uniform(0, 6.283185307179586), frequency * direction()});
    }
    // Begins on the side of the box that the flow comes from.
    const Eigen::Vector3d size = m.box.sizes();
    m.source =
        m.box.center() - 0.36 * size.cwiseProduct(m.a) +
        0.06 * size.cwiseProduct(Eigen::Vector3d(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)));
    m.follow_flow();
    return m;
  }

  double u(const Eigen::Vector3d& x) const {
    double sum = a.dot(x);
    for (const Wave& w : waves) sum += w.size * std::sin(w.k.dot(x) + w.phase);
    return sum;
  }
  Eigen::Vector3d gradient(const Eigen::Vector3d& x) const {
    Eigen::Vector3d sum = a;
    for (const Wave& w : waves) sum += w.size * std::cos(w.k.dot(x) + w.phase) * w.k;
    return sum;
  }
  double density(const Eigen::Vector3d& x) const { return gradient(x).norm(); }
  /// The farthest that a place of the flow is from one of those that are kept, nearly.
  double flow_step() const { return box.sizes().minCoeff() / 1000; }
  double least_cost() const { return u(target) - u(source); }

  /// n^2 as a formula.
  std::string squared() const {
    std::string sum;
    for (int axis = 0; axis < 3; ++axis) {
      std::ostringstream f;
      f.precision(17);
      f << (axis == 0 ? "(" : " + (") << a[axis];
      for (const Wave& w : waves)
        f << " + (" << w.size * w.k[axis] << ") * cos((" << w.k[0] << ") * x + (" << w.k[1] << ") * y + (" << w.k[2]
          << ") * z + (" << w.phase << "))";
      sum += f.str() + ")^2";
    }
    return sum;
  }
  std::shared_ptr<const SegmentCost> cost() const {
    const std::string n2 = squared();
    return make_metric_field_cost({.field = metric::Formula{{n2, "0", "0", n2, "0", n2}, {}}}, 3);
  }

 private:
  Eigen::Vector3d direction(const Eigen::Vector3d& x) const { return gradient(x).normalized(); }

  /// Runge and Kutta's, to the rim of a box within the box, or as far as it is wide.
  void follow_flow() {
    const Eigen::Vector3d rim = 0.05 * box.sizes();
    const Eigen::AlignedBox3d inner(box.min() + rim, box.max() - rim);
    const double step = flow_step();
    flow = {source};
    for (int k = 0; k < 1200; ++k) {
      const Eigen::Vector3d x = flow.back(), d1 = direction(x), d2 = direction(x + step / 2 * d1),
                            d3 = direction(x + step / 2 * d2), d4 = direction(x + step * d3);
      const Eigen::Vector3d next = x + step / 6 * (d1 + 2 * d2 + 2 * d3 + d4);
      if (!inner.contains(next)) break;
      flow.push_back(next);
    }
    target = flow.back();
  }
};

}  // namespace leastcost::test
