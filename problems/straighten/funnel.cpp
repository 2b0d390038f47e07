// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/straighten/funnel.hpp"

#include "problems/straighten/plane_vectors.hpp"

namespace leastcost {
namespace {}  // namespace

void Funnel::add(Chain& own, Chain& other, double side, const Touch& p) {
  // The left chain turns left everywhere; what p makes turn right is no longer part of it.
  while (!own.empty()) {
    const Eigen::Vector2d& b = own.points.back().at;
    const Eigen::Vector2d& a = own.points.size() - own.front > 1 ? own.points[own.points.size() - 2].at : apex_;
    const Eigen::Vector2d ab = b - a, bp = p.at - b;
    const double turn = side * cross(ab, bp);
    if (on_line(turn, p.at - a) ? ab.dot(bp) >= 0 : turn > 0) break;
    own.points.pop_back();
  }
  // p behind the other chain: the string bends around that chain, whose vertices become part of the path.
  while (own.empty() && !other.empty()) {
    const Touch& r = other.points[other.front];
    const Eigen::Vector2d ar = r.at - apex_, ap = p.at - apex_;
    const double turn = side * cross(ar, ap);
    if (on_line(turn, ap) ? ap.squaredNorm() < ar.squaredNorm() : turn > 0) break;
    apex_ = r.at;
    touched_.push_back(r);
    ++other.front;
  }
  if (own.empty()) own.clear();
  own.points.push_back(p);
}

const std::vector<Touch>& Funnel::pull(std::span<const UnfoldedDoor> doors, const Eigen::Vector2d& end) {
  left_.clear();
  right_.clear();
  touched_.clear();
  apex_.setZero();
  for (std::size_t i = 0; i < doors.size(); ++i) {
    const UnfoldedDoor& d = doors[i];
    if (i == 0 || d.left_vertex != doors[i - 1].left_vertex) add(left_, right_, 1.0, {d.left_vertex, i, d.left});
    if (i == 0 || d.right_vertex != doors[i - 1].right_vertex) add(right_, left_, -1.0, {d.right_vertex, i, d.right});
  }
  add(left_, right_, 1.0, {-1, doors.size(), end});
  for (std::size_t k = left_.front; k + 1 < left_.points.size(); ++k) touched_.push_back(left_.points[k]);
  return touched_;
}

}  // namespace leastcost
