// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// Construction of ClosestPointTree.
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include <leastcost/problems/mesh/closest_point.hpp>

namespace leastcost {
namespace {

using Eigen::Vector3d;

/// Double area relative to the product of two sides, below which a triangle counts as thin. Between this and zero the
/// inside test errs by about 1e-16 / this, which is harmless.
constexpr double kThin = 1e-7;

/// So much work is done between two looks at the clock: some 0.3 ms.
constexpr std::int32_t kPart = 4096;

/// Calls visit(i) for all i of [first, last).
template <class Visit>
void visit_all(std::int32_t first, std::int32_t last, const Deadline& deadline, Visit visit) {
  for (std::int32_t i = first; i < last; ++i) {
    if ((i - first) % kPart == kPart - 1) look_at_clock(deadline);
    visit(i);
  }
}

}  // namespace

ClosestPointTree::Triangle ClosestPointTree::make_triangle(const TriangleMesh& mesh, std::int32_t f) {
  const std::array<std::int32_t, 3>& v = mesh.face(f);
  Triangle t;
  t.face = f;
  double longest = -1;
  for (std::int8_t k = 0; k < 3; ++k) {
    const double length = (mesh.position(v[(k + 2) % 3]) - mesh.position(v[(k + 1) % 3])).squaredNorm();
    if (length > longest) t.rotation = k;
    longest = std::max(longest, length);
  }
  for (int k = 0; k < 3; ++k) {
    t.corner[k] = mesh.position(v[(k + t.rotation) % 3]);
    const bool backwards = v[(k + t.rotation + 1) % 3] > v[(k + t.rotation + 2) % 3];
    t.backwards = static_cast<std::int8_t>(t.backwards | (backwards ? 1 << k : 0));
  }
  const Vector3d ab = t.corner[1] - t.corner[0];
  const Vector3d ac = t.corner[2] - t.corner[0];
  const Vector3d normal = ab.cross(ac);
  const double squared = normal.squaredNorm();
  t.thin = !(normal.norm() > kThin * ab.norm() * ac.norm());
  t.gradient[0] = squared > 0 ? Vector3d(ac.cross(normal) / squared) : Vector3d(Vector3d::Zero());
  t.gradient[1] = squared > 0 ? Vector3d(normal.cross(ab) / squared) : Vector3d(Vector3d::Zero());
  if (!t.gradient[0].allFinite() || !t.gradient[1].allFinite()) t.gradient[0] = t.gradient[1] = Vector3d::Zero();
  return t;
}

/// Top-down construction: the best of 16 planes per axis by the surface area heuristic, the median where that fails
/// or the tree gets deep.
struct ClosestPointTree::Builder {
  // At most kMedianDepth + 31 levels: nearest() relies on fewer than 96.
  static constexpr std::int32_t kLeafSize = 4;
  static constexpr int kBins = 16;
  /// From here on every split halves: 31 more levels are enough for all face numbers.
  static constexpr int kMedianDepth = 60;

  struct Item {
    Vector3d lower, upper;
    std::int32_t face;
    double middle(int axis) const { return 0.5 * lower[axis] + 0.5 * upper[axis]; }
  };
  struct Box {
    Vector3d lower = Vector3d::Constant(std::numeric_limits<double>::infinity());
    Vector3d upper = Vector3d::Constant(-std::numeric_limits<double>::infinity());
    void add(const Vector3d& low, const Vector3d& high) {
      lower = lower.cwiseMin(low).eval();
      upper = upper.cwiseMax(high).eval();
    }
    double half_area() const {
      const Vector3d d = (upper - lower).cwiseMax(0.0);
      return d.x() * d.y() + d.y() * d.z() + d.z() * d.x();
    }
  };
  struct Plane {
    int axis = 0;
    int bin = -1;  // the last bin on the left; -1: none found
    double cost = std::numeric_limits<double>::infinity();
  };
  struct Range {
    std::int32_t node, first, last;
    int depth;
  };

  Builder(const TriangleMesh& mesh, const Deadline& until) : deadline(until) {
    items.reserve(static_cast<std::size_t>(mesh.face_count()));
    visit_all(0, mesh.face_count(), deadline, [&](std::int32_t f) {
      Box box;
      for (const std::int32_t v : mesh.face(f)) box.add(mesh.position(v), mesh.position(v));
      items.push_back({box.lower, box.upper, f});
    });
  }

  static int bin_of(const Item& item, int axis, const Box& middles) {
    const double width = middles.upper[axis] - middles.lower[axis];
    return std::min(kBins - 1, static_cast<int>(kBins * ((item.middle(axis) - middles.lower[axis]) / width)));
  }

  Plane best_plane(const Range& range, int axis, const Box& middles) const {
    std::array<Box, kBins> boxes;
    std::array<std::int32_t, kBins> counts{};
    visit_all(range.first, range.last, deadline, [&](std::int32_t i) {
      const Item& item = items[static_cast<std::size_t>(i)];
      const std::size_t bin = static_cast<std::size_t>(bin_of(item, axis, middles));
      boxes[bin].add(item.lower, item.upper);
      ++counts[bin];
    });
    std::array<double, kBins> right_cost{};
    Box right;
    std::int32_t right_count = 0;
    for (std::size_t bin = kBins - 1; bin > 0; --bin) {
      right.add(boxes[bin].lower, boxes[bin].upper);
      right_count += counts[bin];
      right_cost[bin] = right_count * right.half_area();
    }
    Plane best;
    Box left;
    std::int32_t left_count = 0;
    for (std::size_t bin = 0; bin + 1 < kBins; ++bin) {
      left.add(boxes[bin].lower, boxes[bin].upper);
      left_count += counts[bin];
      const double cost = left_count * left.half_area() + right_cost[bin + 1];
      const bool splits = left_count > 0 && left_count < range.last - range.first;
      if (splits && cost < best.cost) best = {axis, static_cast<int>(bin), cost};
    }
    return best;
  }

  /// Reorders the items of the range and returns where its right half begins.
  std::int32_t split(const Range& range) {
    Box middles;
    visit_all(range.first, range.last, deadline, [&](std::int32_t i) {
      const Item& item = items[static_cast<std::size_t>(i)];
      const Vector3d middle(item.middle(0), item.middle(1), item.middle(2));
      middles.add(middle, middle);
    });
    Plane best;
    for (int axis = 0; axis < 3 && range.depth < kMedianDepth; ++axis) {
      if (!(middles.upper[axis] > middles.lower[axis])) continue;
      const Plane plane = best_plane(range, axis, middles);
      if (plane.cost < best.cost) best = plane;
    }
    const auto begin = items.begin() + range.first, end = items.begin() + range.last;
    if (best.bin >= 0) {
      const auto left = [&](const Item& item) { return bin_of(item, best.axis, middles) <= best.bin; };
      return static_cast<std::int32_t>(std::partition(begin, end, left) - items.begin());
    }
    Eigen::Index widest = 0;
    (middles.upper - middles.lower).maxCoeff(&widest);
    const int axis = static_cast<int>(widest);
    const std::int32_t half = range.first + (range.last - range.first) / 2;
    std::nth_element(begin, items.begin() + half, end, [axis](const Item& a, const Item& b) {
      return std::pair(a.middle(axis), a.face) < std::pair(b.middle(axis), b.face);
    });
    return half;
  }

  void run(std::vector<Node>& nodes) {
    nodes.resize(2);
    std::int32_t visited = 0;
    std::vector<Range> open = {{0, 0, static_cast<std::int32_t>(items.size()), 0}};
    while (!open.empty()) {
      const Range range = open.back();
      open.pop_back();
      if (++visited % kPart == 0) look_at_clock(deadline);  // most ranges are small
      Box box;
      visit_all(range.first, range.last, deadline, [&](std::int32_t i) {
        box.add(items[static_cast<std::size_t>(i)].lower, items[static_cast<std::size_t>(i)].upper);
      });
      Node& node = nodes[static_cast<std::size_t>(range.node)];
      node.lower = box.lower;
      node.upper = box.upper;
      if (range.last - range.first <= kLeafSize) {
        node.first = range.first;
        node.count = range.last - range.first;
        continue;
      }
      const std::int32_t half = split(range);
      const std::int32_t children = static_cast<std::int32_t>(nodes.size());
      node.first = children;
      nodes.resize(nodes.size() + 2);
      nodes[static_cast<std::size_t>(children)].parent = nodes[static_cast<std::size_t>(children) + 1].parent =
          range.node;
      open.push_back({children + 1, half, range.last, range.depth + 1});
      open.push_back({children, range.first, half, range.depth + 1});
    }
  }

  Deadline deadline;
  std::vector<Item> items;
};

ClosestPointTree::ClosestPointTree(const TriangleMesh& mesh, const Deadline& deadline) {
  Builder builder(mesh, deadline);
  builder.run(nodes_);
  triangles_.reserve(builder.items.size());
  visit_all(0, static_cast<std::int32_t>(builder.items.size()), deadline, [&](std::int32_t i) {
    triangles_.push_back(make_triangle(mesh, builder.items[static_cast<std::size_t>(i)].face));
  });
  leaf_of_face_.resize(triangles_.size());
  for (std::size_t n = 0; n < nodes_.size(); ++n) {
    for (std::int32_t i = nodes_[n].first; i < nodes_[n].first + nodes_[n].count; ++i) {
      leaf_of_face_[static_cast<std::size_t>(triangles_[static_cast<std::size_t>(i)].face)] =
          static_cast<std::int32_t>(n);
    }
  }
}

}  // namespace leastcost
