// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/cloud/neighbour_search.hpp>

#include <algorithm>
#include <nanoflann.hpp>
#include <utility>

namespace leastcost {
namespace {

/// The points as nanoflann wants to see them.
struct Adaptor {
  std::vector<Eigen::Vector3d> points;
  std::size_t kdtree_get_point_count() const { return points.size(); }
  double kdtree_get_pt(std::size_t i, std::size_t axis) const { return points[i][static_cast<Eigen::Index>(axis)]; }
  template <class Box>
  bool kdtree_get_bbox(Box&) const {
    return false;
  }
};

/// Collects everything within a radius straight into the caller's list.
class WithinRadius {
 public:
  using DistanceType = double;
  WithinRadius(double squared, std::vector<Neighbour>& out) : squared_(squared), out_(out) {}
  std::size_t size() const { return out_.size(); }
  bool full() const { return true; }
  bool addPoint(double squared, std::int32_t index) {  // NOLINT(readability-identifier-naming): nanoflann's name
    if (squared < squared_) out_.push_back({index, squared});
    return true;
  }
  double worstDist() const { return squared_; }  // NOLINT(readability-identifier-naming)

 private:
  double squared_;
  std::vector<Neighbour>& out_;
};

}  // namespace

struct NeighbourSearch::Tree {
  using Index = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Adaptor, double, std::int32_t>,
                                                    Adaptor, 3, std::int32_t>;
  static constexpr std::size_t kLeafSize = 12;
  explicit Tree(std::vector<Eigen::Vector3d> p) : adaptor{std::move(p)}, index(3, adaptor, {kLeafSize}) {}
  Adaptor adaptor;
  Index index;
};

NeighbourSearch::NeighbourSearch(std::vector<Eigen::Vector3d> points)
    : tree_(std::make_unique<Tree>(std::move(points))) {}
NeighbourSearch::~NeighbourSearch() = default;
NeighbourSearch::NeighbourSearch(NeighbourSearch&&) noexcept = default;
NeighbourSearch& NeighbourSearch::operator=(NeighbourSearch&&) noexcept = default;

const std::vector<Eigen::Vector3d>& NeighbourSearch::points() const { return tree_->adaptor.points; }

Neighbour NeighbourSearch::nearest(const Eigen::Vector3d& x) const {
  Neighbour best;
  nanoflann::KNNResultSet<double, std::int32_t> results(1);
  results.init(&best.index, &best.squared_distance);
  tree_->index.findNeighbors(results, x.data(), nanoflann::SearchParams());
  return best;
}

void NeighbourSearch::nearest(const Eigen::Vector3d& x, int k, std::vector<Neighbour>& out) const {
  const std::size_t wanted = std::min(static_cast<std::size_t>(k), points().size());
  std::vector<std::int32_t> indices(wanted);
  std::vector<double> squared(wanted);
  nanoflann::KNNResultSet<double, std::int32_t> results(wanted);
  results.init(indices.data(), squared.data());
  tree_->index.findNeighbors(results, x.data(), nanoflann::SearchParams());
  out.resize(results.size());
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = {indices[i], squared[i]};
}

void NeighbourSearch::within(const Eigen::Vector3d& x, double radius, std::vector<Neighbour>& out) const {
  out.clear();
  WithinRadius results(radius * radius, out);
  tree_->index.findNeighbors(results, x.data(), nanoflann::SearchParams());
}

}  // namespace leastcost
