// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/taut/unheld_bends.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "framework/base/dense_solves.hpp"
#include "problems/taut/polyline_length.hpp"

namespace leastcost {
namespace {

using Eigen::Vector3d;

/// A string with small forces on it gives way until the changes of its tension balance them: half of their squares,
/// summed along it, is gained.
class Tension {
 public:
  void push(const Vector3d& force) { force_ += force; }
  void run(double side) {
    length_ += side;
    squares_ += side * force_.squaredNorm();
    sum_ += side * force_;
  }
  double gain() const { return length_ > 0 ? std::max(0.0, squares_ - sum_.squaredNorm() / length_) / 2 : 0; }

 private:
  Vector3d force_ = Vector3d::Zero(), sum_ = Vector3d::Zero();
  double length_ = 0, squares_ = 0;
};

/// How obstacles hold a bend.
struct Held {
  Vector3d left;     ///< the part of it that no push against the planes makes
  double slack = 0;  ///< what the string would gain if it came up to the planes that it leans on: push times gap
};

/// Of pushes against at most three planes, which make any vector that can be made, those that leave the least: the part
/// that is left counts by the way that the vertex has. Only the nearest planes are asked; what others would hold counts
/// as left.
Held hold(const Vector3d& bend, double way, std::vector<SupportPlane>& planes) {
  constexpr std::size_t kMostAsked = 12;
  if (planes.size() > kMostAsked) {
    std::nth_element(planes.begin(), planes.begin() + kMostAsked, planes.end(),
                     [](const SupportPlane& a, const SupportPlane& b) { return a.gap < b.gap; });
    planes.resize(kMostAsked);
  }
  Held best{bend, 0};
  std::vector<const SupportPlane*> by;
  const auto look = [&](auto& self, std::size_t next) -> void {
    if (!by.empty()) {
      Points normals(3, static_cast<Index>(by.size()));
      for (Index k = 0; k < normals.cols(); ++k) normals.col(k) = by[static_cast<std::size_t>(k)]->normal;
      const Eigen::VectorXd pushes = least_squares(normals, bend);
      if (pushes.minCoeff() < 0) return;  // a larger set with this one in it may still do, but so does one without
      Held held{bend - normals * pushes, 0};
      for (Index k = 0; k < pushes.size(); ++k)
        held.slack += pushes[k] * std::max(0.0, by[static_cast<std::size_t>(k)]->gap);
      if (held.left.norm() * way + held.slack < best.left.norm() * way + best.slack) best = held;
    }
    if (by.size() == 3) return;
    for (std::size_t k = next; k < planes.size(); ++k) {
      by.push_back(&planes[k]);
      self(self, k + 1);
      by.pop_back();
    }
  };
  look(look, 0);
  return best;
}

}  // namespace

Unheld unheld_bends(const Walls& walls, const Points& polyline, const Deadline& deadline) {
  constexpr double kBeside = 1e-3;  // of the length: what a string may lean on
  Unheld all;
  const double length = polyline_length(polyline);
  const auto* convex = find_ability<HasSupportPlanes>(walls);
  std::vector<SupportPlane> after, before;
  Tension all_left, to_the_side;
  for (Index i = 0; i + 1 < polyline.cols(); ++i) {
    look_at_clock(deadline);
    const Vector3d out = polyline.col(i + 1) - polyline.col(i);
    std::swap(before, after);
    if (convex != nullptr) convex->planes(polyline.col(i), polyline.col(i + 1), kBeside * length, after);
    if (i > 0) {
      const Vector3d in = polyline.col(i) - polyline.col(i - 1), side = in.cross(out).normalized();
      before.insert(before.end(), after.begin(), after.end());
      const Held held = hold(in.normalized() - out.normalized(), std::min(in.norm(), out.norm()), before);
      all.largest = std::max(all.largest, held.left.norm());
      all.gain += held.slack;
      all_left.push(held.left);
      to_the_side.push(side.dot(held.left) * side);
    }
    all_left.run(out.norm());
    to_the_side.run(out.norm());
  }
  all.gain += all_left.gain();
  all.sideways = to_the_side.gain();
  return all;
}

}  // namespace leastcost
