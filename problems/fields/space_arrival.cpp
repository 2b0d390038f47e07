// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/fields/space_arrival.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <Eigen/LU>

#include <leastcost/framework/base/errors.hpp>
#include "problems/graph/monotone_queue.hpp"

namespace leastcost {
namespace {

constexpr double kNothingArrives = std::numeric_limits<double>::infinity();

}  // namespace

SpaceArrival::SpaceArrival(const Lattice& lattice, const std::vector<DriftMetric>& elements, Passes passes)
    : lattice_(lattice), passes_(std::move(passes)), width_(lattice.count[0] + 2), height_(lattice.count[1] + 2) {
  const auto size = static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_) *
                    static_cast<std::size_t>(lattice.count[2] + 2);
  nodes_.assign(size, {kNothingArrives, {}, {}});
  fixed_.assign(size, 0);
  std::size_t next = 0;
  for (std::int32_t k = 0; k < lattice.count[2]; ++k)
    for (std::int32_t j = 0; j < lattice.count[1]; ++j)
      for (std::int32_t i = 0; i < lattice.count[0]; ++i) node(number(i, j, k)).element = elements[next++];
  list_sides();
}

SpaceArrival::Vector SpaceArrival::place(std::int32_t node) const {
  return lattice_.place(node % width_ - 1, node / width_ % height_ - 1, node / width_ / height_ - 1);
}

/// Corners of the ring are the nodes of a cube: a triangle has one on an axis, one on an edge and one at a corner of
/// it.
void SpaceArrival::list_sides() {
  std::array<std::array<std::int32_t, 3>, 26> at{};
  std::size_t next = 0;
  for (std::int32_t k = -1; k <= 1; ++k)
    for (std::int32_t j = -1; j <= 1; ++j)
      for (std::int32_t i = -1; i <= 1; ++i) {
        if (i == 0 && j == 0 && k == 0) continue;
        at[next] = {i, j, k};
        ring_[next] = i + width_ * (j + height_ * k);
        places_[next++] = lattice_.step.cwiseProduct(Vector(i, j, k));
      }
  const auto rank = [&](std::size_t n) { return std::abs(at[n][0]) + std::abs(at[n][1]) + std::abs(at[n][2]); };
  // Node n lies below node m where it is m with some coordinates set to 0.
  const auto below = [&](std::size_t n, std::size_t m) {
    bool all = rank(n) < rank(m);
    for (std::size_t d = 0; d < 3; ++d) all = all && (at[n][d] == 0 || at[n][d] == at[m][d]);
    return all;
  };
  for (std::size_t a = 0; a < ring_.size(); ++a) {
    sides_.push_back({1, {a, a, a}});
    for (std::size_t b = 0; b < ring_.size(); ++b) {
      if (!below(a, b)) continue;
      sides_.push_back({2, {a, b, b}});
      for (std::size_t c = 0; c < ring_.size(); ++c)
        if (below(b, c)) sides_.push_back({3, {a, b, c}});
    }
  }
  for (const Side& side : sides_)
    for (std::size_t c = 0; c < side.corners; ++c) with_[side.at[c]].push_back(side);
}

void SpaceArrival::start(const Vector& source, const std::function<double(const Vector&, const Vector&)>& cost) {
  constexpr double kReach = 3.5;  // steps, as in SpaceMarch
  const Vector at = (source - lattice_.lower).cwiseQuotient(lattice_.step);
  std::array<std::int32_t, 3> low{}, high{};
  for (std::size_t d = 0; d < 3; ++d) {
    const double along = at[static_cast<Eigen::Index>(d)];
    low[d] = static_cast<std::int32_t>(std::max(std::ceil(along - kReach), 0.0));
    high[d] = static_cast<std::int32_t>(std::min(std::floor(along + kReach), lattice_.count[d] - 1.0));
  }
  for (std::int32_t k = low[2]; k <= high[2]; ++k)
    for (std::int32_t j = low[1]; j <= high[1]; ++j)
      for (std::int32_t i = low[0]; i <= high[0]; ++i) {
        const std::int32_t there = number(i, j, k);
        const Vector x = lattice_.place(i, j, k), move = x - source;
        if (move.cwiseQuotient(lattice_.step).norm() > kReach || node(there).element.is_blocked()) continue;
        const double c = cost(source, x);
        if (!(c < node(there).u) || (passes_ && !passes_(source, x))) continue;
        take(there, {c, move});
        fixed_[static_cast<std::size_t>(there)] = 1;
        started_.push_back(there);
      }
}

const SpaceArrival::Node* SpaceArrival::corner(std::int32_t number, const Side& side, std::size_t c) const {
  const Node& there = node(number + ring_[side.at[c]]);
  return there.u < kNothingArrives ? &there : nullptr;
}

/// With M = A over the plane v = v0 + E m of moves and d the slopes of u there, |v| is sqrt(h^2 + (m - f).G(m - f)),
/// G = E'AE, f the foot of the perpendicular and h its length: the sum is least at m = f - h G^-1 d / sqrt(1 - d.G^-1
/// d).
bool SpaceArrival::least_over(const Side& side, const DriftMetric& element, const std::array<double, 3>& u,
                              Shares& shares) const {
  shares = {1, 0, 0};
  if (side.corners == 1) return true;
  const Eigen::Matrix3d a = element.matrix();
  const Vector b = element.drift(), first = -places_[side.at[0]], lowered = a * first;
  const Vector e0 = -places_[side.at[1]] - first, a0 = a * e0;
  const double d0 = u[1] - u[0] + b.dot(e0), g00 = e0.dot(a0), r0 = e0.dot(lowered);
  if (side.corners == 2) {
    const double rest = 1 - d0 * d0 / g00, height = first.dot(lowered) - r0 * r0 / g00;
    if (!(rest > 0) || !(height > 0)) return false;
    const double m = -(r0 + d0 * std::sqrt(height / rest)) / g00;
    shares = {1 - m, m, 0};
    return true;
  }
  const Vector e1 = -places_[side.at[2]] - first, a1 = a * e1;
  const double d1 = u[2] - u[0] + b.dot(e1), g11 = e1.dot(a1), g01 = e0.dot(a1), r1 = e1.dot(lowered);
  const double determinant = g00 * g11 - g01 * g01;
  const auto solved = [&](double x, double y) {
    return std::pair((g11 * x - g01 * y) / determinant, (g00 * y - g01 * x) / determinant);
  };
  const auto [s0, s1] = solved(d0, d1);
  const auto [f0, f1] = solved(r0, r1);
  const double rest = 1 - d0 * s0 - d1 * s1, height = first.dot(lowered) - r0 * f0 - r1 * f1;
  if (!(rest > 0) || !(height > 0)) return false;
  const double scale = std::sqrt(height / rest);
  const double m0 = -f0 - scale * s0, m1 = -f1 - scale * s1;
  shares = {1 - m0 - m1, m0, m1};
  return true;
}

bool SpaceArrival::over(std::int32_t number, const Side& side, bool sharp, Offer& offer) const {
  constexpr double kBeside = -0.5;  // a share, of where the gradients may yet lead back
  constexpr int kSteps = 4;
  const Node& here = node(number);
  std::array<const Node*, 3> corners{};
  std::array<Vector, 3> at, gradient;
  std::array<double, 3> u{};
  for (std::size_t c = 0; c < side.corners; ++c) {
    corners[c] = corner(number, side, c);
    if (corners[c] == nullptr) return false;
    u[c] = corners[c]->u;
    at[c] = places_[side.at[c]];
  }
  Shares shares{};
  const auto lies_within = [&](double least) {
    return std::all_of(shares.begin(), shares.begin() + static_cast<std::ptrdiff_t>(side.corners),
                       [least](double share) { return share >= least; });
  };
  if (!least_over(side, here.element, u, shares)) return false;
  if (!lies_within(sharp ? kBeside : 0)) return false;
  if (sharp) {
    for (std::size_t c = 0; c < side.corners; ++c)
      gradient[c] = Vector(corners[c]->gradient[0], corners[c]->gradient[1], corners[c]->gradient[2]);
    // Corners whose gradients differ more belong to two fronts.
    for (std::size_t c = 0; c < side.corners; ++c)
      for (std::size_t e = 0; e < c; ++e) {
        const Vector edge = at[c] - at[e];
        const double both_ways = here.element(edge) + here.element(-edge);
        sharp = sharp && std::abs((gradient[c] - gradient[e]).dot(edge)) < both_ways / 2;
      }
  }
  Vector p;
  double value = 0;
  const auto look = [&] {
    p.setZero();
    for (std::size_t c = 0; c < side.corners; ++c) p += shares[c] * at[c];
  };
  for (int step = 0; sharp && side.corners > 1 && step < kSteps; ++step) {
    look();
    Vector mean = Vector::Zero();
    for (std::size_t c = 0; c < side.corners; ++c) mean += shares[c] * gradient[c];
    std::array<double, 3> tangent{};
    for (std::size_t c = 0; c < side.corners; ++c) tangent[c] = u[c] + 0.5 * (gradient[c] - mean).dot(p - at[c]);
    if (!least_over(side, here.element, tangent, shares) || !lies_within(kBeside)) return false;
  }
  if (!lies_within(0)) return false;
  look();
  double element = here.element(-p);
  for (std::size_t c = 0; c < side.corners; ++c) {
    value += shares[c] * (u[c] + (sharp ? 0.5 * gradient[c].dot(p - at[c]) : 0));
    element += shares[c] * corners[c]->element(-p);
  }
  offer = {value + 0.5 * element, -p};
  return true;
}

const SpaceArrival::Offer* SpaceArrival::passing(std::int32_t number, std::vector<Offer>& offers) const {
  const auto cheaper = [](const Offer& a, const Offer& b) { return a.u < b.u; };
  while (!offers.empty()) {
    const auto least = std::min_element(offers.begin(), offers.end(), cheaper);
    if (!passes_) return &*least;
    const Vector x = place(number);
    if (passes_(x - least->move, x)) return &*least;
    *least = offers.back();
    offers.pop_back();
  }
  return nullptr;
}

/// The gradient is that of the line element: of sqrt(v.Av) + b.v by v.
void SpaceArrival::take(std::int32_t number, const Offer& offer) {
  Node& here = node(number);
  here.u = offer.u;
  const Vector lowered = here.element.matrix() * offer.move;
  const double length = std::sqrt(lowered.dot(offer.move));
  const Vector gradient = length > 0 ? Vector(lowered / length + here.element.drift()) : Vector(Vector::Zero());
  for (std::size_t d = 0; d < 3; ++d) here.gradient[d] = static_cast<float>(gradient[static_cast<Eigen::Index>(d)]);
}

bool SpaceArrival::improve(std::int32_t number, std::size_t by) {
  constexpr double kNoBetter = 1e-6;  // a gain of this part of a cost is not passed on
  const Node& here = node(number);
  if (here.element.is_blocked()) return false;
  offers_.clear();
  Offer offer{};
  for (const Side& side : with_[by]) {
    double least = kNothingArrives;
    for (std::size_t c = 0; c < side.corners; ++c) least = std::min(least, node(number + ring_[side.at[c]]).u);
    if (least < here.u && over(number, side, false, offer) && offer.u < here.u * (1 - kNoBetter))
      offers_.push_back(offer);
  }
  const Offer* best = passing(number, offers_);
  if (best == nullptr) return false;
  take(number, *best);
  fixed_[static_cast<std::size_t>(number)] = 0;
  return true;
}

void SpaceArrival::spread(const std::function<bool()>& stop) {
  constexpr int kNodesPerLook = 1024;
  MonotoneQueue<std::int32_t> queue;
  for (const std::int32_t number : started_) queue.push(node(number).u, number);
  for (int steps = 1; !queue.empty(); ++steps) {
    if (steps % kNodesPerLook == 0 && stop && stop())
      throw Interrupted("field: interrupted before all nodes were reached");
    const auto [c, by] = queue.pop();
    if (c > node(by).u) continue;
    for (std::size_t k = 0; k < ring_.size(); ++k) {
      const std::int32_t number = by - ring_[k];
      if (improve(number, k)) queue.push(node(number).u, number);
    }
  }
}

bool SpaceArrival::sharpen_node(std::int32_t number) {
  constexpr double kSettled = 1e-6;  // of the cost
  offers_.clear();
  Offer offer{};
  for (const Side& side : sides_)
    if (over(number, side, true, offer)) offers_.push_back(offer);
  const Offer* best = passing(number, offers_);
  if (best == nullptr) return false;
  const bool changed = std::abs(best->u - node(number).u) > kSettled * node(number).u;
  take(number, *best);
  return changed;
}

/// As ArrivalField::sharpen().
void SpaceArrival::sharpen(const std::function<bool()>& stop) {
  constexpr int kMostSweeps = 100, kNodesPerLook = 256;
  constexpr unsigned char kMostTurns = 20;  // of a node
  std::vector<std::int32_t> order;
  order.reserve(nodes_.size());
  for (std::int32_t n = 0; n < static_cast<std::int32_t>(nodes_.size()); ++n)
    if (node(n).u < kNothingArrives && fixed_[static_cast<std::size_t>(n)] == 0) order.push_back(n);
  std::sort(order.begin(), order.end(), [this](std::int32_t a, std::int32_t b) { return node(a).u < node(b).u; });
  std::vector<unsigned char> waiting(nodes_.size(), 1), turns(nodes_.size(), 0);
  bool changed = true;
  int steps = 0;
  for (int sweep = 0; changed && sweep < kMostSweeps; ++sweep) {
    changed = false;
    for (const std::int32_t number : order) {
      const auto n = static_cast<std::size_t>(number);
      if (waiting[n] == 0 || turns[n] >= kMostTurns) continue;
      if (++steps % kNodesPerLook == 0 && stop && stop())
        throw Interrupted("field: interrupted before all nodes were reached");
      waiting[n] = 0;
      ++turns[n];
      if (!sharpen_node(number)) continue;
      changed = true;
      for (const std::int32_t to : ring_) waiting[static_cast<std::size_t>(number + to)] = 1;
    }
  }
}

void SpaceArrival::run(const std::function<bool()>& stop) {
  spread(stop);
  sharpen(stop);
}

std::vector<double> SpaceArrival::values() const {
  std::vector<double> values;
  values.reserve(nodes_.size());
  for (std::int32_t k = 0; k < lattice_.count[2]; ++k)
    for (std::int32_t j = 0; j < lattice_.count[1]; ++j)
      for (std::int32_t i = 0; i < lattice_.count[0]; ++i) values.push_back(node(number(i, j, k)).u);
  return values;
}

}  // namespace leastcost
