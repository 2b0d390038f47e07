// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/mesh/closest_point.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace leastcost {
namespace {

using Eigen::Vector3d;

/// Deferred nodes of a traversal: at most one per level, and the builder keeps the depth below this.
constexpr std::size_t kMaxDepth = 96;

/// Squared distance from p to a box, length units squared; 0 inside.
double squared_distance(const Vector3d& p, const Vector3d& lower, const Vector3d& upper) {
  double sum = 0;
  for (int k = 0; k < 3; ++k) {
    const double d = std::max(std::max(lower[k] - p[k], p[k] - upper[k]), 0.0);
    sum += d * d;
  }
  return sum;
}

}  // namespace

struct ClosestPointTree::Best {
  double squared = std::numeric_limits<double>::max();  // an infinite candidate is no answer
  std::int32_t slot = -1;
  std::int32_t face = -1;
  std::int32_t hint = -1;
  Vector3d position = Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
  std::array<double, 3> weights = {0, 0, 0};  // of the corners as the triangle record has them

  void offer(double candidate, std::int32_t candidate_slot, std::int32_t candidate_face, const Vector3d& where,
             const std::array<double, 3>& candidate_weights) {
    if (!(candidate <= squared)) return;  // also when it is not a number
    if (candidate == squared && candidate_face != hint && (face == hint || candidate_face >= face)) return;
    squared = candidate;
    slot = candidate_slot;
    face = candidate_face;
    position = where;
    weights = candidate_weights;
  }
};

/// The nearest point of a triangle is inside it or on a side that p's projection lies beyond. Sides are computed from
/// their lower vertex to their higher one, so that both faces of an edge come to bitwise the same answer.
void ClosestPointTree::visit_triangle(const Vector3d& p, std::int32_t slot, Best& best) const {
  const Triangle& t = triangles_[static_cast<std::size_t>(slot)];
  const Vector3d& a = t.corner[0];
  const Vector3d ap = p - a;
  const double wb = ap.dot(t.gradient[0]);
  const double wc = ap.dot(t.gradient[1]);
  const std::array<double, 3> inside = {1 - wb - wc, wb, wc};
  if (inside[0] >= 0 && wb >= 0 && wc >= 0) {
    const Vector3d q = a + wb * (t.corner[1] - a) + wc * (t.corner[2] - a);
    best.offer((p - q).squaredNorm(), slot, t.face, q, inside);
    if (!t.thin) return;
  }
  for (int k = 0; k < 3; ++k) {
    if (inside[static_cast<std::size_t>(k)] >= 0 && !t.thin) continue;
    const int backwards = (t.backwards >> k) & 1;
    const int from = (k + 1 + backwards) % 3;
    const int to = (k + 2 - backwards) % 3;
    const Vector3d side = t.corner[to] - t.corner[from];
    const double along = (p - t.corner[from]).dot(side);
    const double length = side.squaredNorm();
    std::array<double, 3> weights = {0, 0, 0};
    const double s = along <= 0 ? 0.0 : along >= length ? 1.0 : along / length;
    weights[static_cast<std::size_t>(from)] = 1 - s;
    weights[static_cast<std::size_t>(to)] = s;
    const Vector3d q = s < 1 ? Vector3d(t.corner[from] + s * side) : t.corner[to];
    best.offer((p - q).squaredNorm(), slot, t.face, q, weights);
  }
}

void ClosestPointTree::visit_subtree(const Vector3d& p, std::int32_t root, Best& best) const {
  struct Deferred {
    std::int32_t node;
    double squared;
  };
  std::array<Deferred, kMaxDepth> stack;
  std::size_t deferred = 0;
  std::int32_t at = root;
  while (true) {
    const Node& node = nodes_[static_cast<std::size_t>(at)];
    if (node.count == 0) {
      const Node& left = nodes_[static_cast<std::size_t>(node.first)];
      const Node& right = nodes_[static_cast<std::size_t>(node.first) + 1];
      const double left_squared = squared_distance(p, left.lower, left.upper);
      const double right_squared = squared_distance(p, right.lower, right.upper);
      const bool right_first = right_squared < left_squared;
      const double farther = right_first ? left_squared : right_squared;
      if (farther <= best.squared) stack[deferred++] = {node.first + (right_first ? 0 : 1), farther};
      if (std::min(left_squared, right_squared) <= best.squared) {
        at = node.first + (right_first ? 1 : 0);
        continue;
      }
    } else {
      for (std::int32_t i = node.first; i < node.first + node.count; ++i) visit_triangle(p, i, best);
    }
    do {
      if (deferred == 0) return;
      --deferred;
    } while (stack[deferred].squared > best.squared);
    at = stack[deferred].node;
  }
}

ClosestPoint ClosestPointTree::nearest(const Vector3d& p, std::int32_t hint) const {
  Best best;
  if (hint >= 0 && static_cast<std::size_t>(hint) < leaf_of_face_.size()) {
    // From the hint's leaf upwards: by the time large boxes are met the answer is known, and they are only compared.
    best.hint = hint;
    std::int32_t at = leaf_of_face_[static_cast<std::size_t>(hint)];
    visit_subtree(p, at, best);
    for (; at != 0; at = nodes_[static_cast<std::size_t>(at)].parent) {
      const Node& sibling = nodes_[static_cast<std::size_t>(at ^ 1)];
      if (squared_distance(p, sibling.lower, sibling.upper) <= best.squared) visit_subtree(p, at ^ 1, best);
    }
  } else {
    visit_subtree(p, 0, best);
  }
  ClosestPoint result;
  result.where.face = best.face;
  result.position = best.position;
  result.distance = best.face >= 0 ? std::sqrt(best.squared) : std::numeric_limits<double>::quiet_NaN();
  if (best.face < 0) return result;
  const int rotation = triangles_[static_cast<std::size_t>(best.slot)].rotation;
  for (int k = 0; k < 3; ++k) result.where.barycentric[(k + rotation) % 3] = best.weights[static_cast<std::size_t>(k)];
  return result;
}

}  // namespace leastcost
