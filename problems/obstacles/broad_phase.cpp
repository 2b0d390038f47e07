// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/obstacles/broad_phase.hpp"

#include <algorithm>
#include <boost/geometry/core/cs.hpp>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <iterator>
#include <optional>
#include <utility>

namespace leastcost {
namespace {

namespace bg = boost::geometry;

bool is_finite(const BroadPhase::Box& box) { return box.min().allFinite() && box.max().allFinite(); }

template <std::size_t D>
class BoxTree {
 public:
  using Point = bg::model::point<double, D, bg::cs::cartesian>;
  using Value = std::pair<bg::model::box<Point>, int>;

  /// Of the finite ones.
  explicit BoxTree(const std::vector<BroadPhase::Box>& boxes) : tree_(values(boxes)) {}

  void meeting(const BroadPhase::Box& box, std::vector<int>& found) const {
    for (auto it = tree_.qbegin(bg::index::intersects(of(box))); it != tree_.qend(); ++it) found.push_back(it->second);
  }

 private:
  static bg::model::box<Point> of(const BroadPhase::Box& box) {
    Point lower, upper;
    bg::set<0>(lower, box.min()[0]), bg::set<1>(lower, box.min()[1]);
    bg::set<0>(upper, box.max()[0]), bg::set<1>(upper, box.max()[1]);
    if constexpr (D == 3) bg::set<2>(lower, box.min()[2]), bg::set<2>(upper, box.max()[2]);
    return {lower, upper};
  }

  static std::vector<Value> values(const std::vector<BroadPhase::Box>& boxes) {
    std::vector<Value> all;
    all.reserve(boxes.size());
    for (std::size_t i = 0; i < boxes.size(); ++i)
      if (is_finite(boxes[i])) all.emplace_back(of(boxes[i]), static_cast<int>(i));
    return all;
  }

  bg::index::rtree<Value, bg::index::quadratic<16>> tree_;  // packed: all boxes are there from the start
};

}  // namespace

struct BroadPhase::Tree {
  std::optional<BoxTree<2>> plane;
  std::optional<BoxTree<3>> space;
};

BroadPhase::BroadPhase(std::vector<Box> boxes) : boxes_(std::move(boxes)) {
  auto tree = std::make_unique<Tree>();
  const Eigen::Index dimension = boxes_.empty() ? 0 : boxes_.front().dim();
  if (dimension == 2) tree->plane.emplace(boxes_);
  if (dimension == 3) tree->space.emplace(boxes_);
  tree_ = std::move(tree);
  for (std::size_t i = 0; i < boxes_.size() && (tree_->plane || tree_->space); ++i)
    if (!is_finite(boxes_[i])) everywhere_.push_back(static_cast<int>(i));
}

BroadPhase::~BroadPhase() = default;

void BroadPhase::meeting(const Box& box, std::vector<int>& found) const {
  found = everywhere_;
  if (tree_->plane) {
    tree_->plane->meeting(box, found);
  } else if (tree_->space) {
    tree_->space->meeting(box, found);
  } else {
    for (std::size_t i = 0; i < boxes_.size(); ++i)
      if (boxes_[i].intersects(box)) found.push_back(static_cast<int>(i));
  }
  std::sort(found.begin(), found.end());
}

}  // namespace leastcost
