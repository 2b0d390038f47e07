// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/fields/isotropic_march.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include "problems/fields/node_moves.hpp"

namespace leastcost {
namespace {

using Eigen::Vector2d;

constexpr double kUnreached = std::numeric_limits<double>::infinity();
constexpr std::size_t kChunk = 64;  // nodes of a batch: what they offer stays in the nearest cache

}  // namespace

/// What some nodes offer to those around them. Written one past the end, which moves on if the entry is one.
struct IsotropicMarch::Work {
  std::vector<Crossing> crossings = std::vector<Crossing>(16 * kChunk + 1);
  std::vector<Direct> directs = std::vector<Direct>(8 * kChunk + 1);
  std::size_t crossing_count = 0, direct_count = 0;
};

IsotropicMarch::IsotropicMarch(const Lattice& lattice, const std::vector<double>& densities, Passes passes)
    : lattice_(lattice), passes_(std::move(passes)), width_(lattice.count[0] + 2) {
  for (std::size_t k = 0; k < kRing.size(); ++k) {
    ring_[k] = kRing[k][0] + width_ * kRing[k][1];
    moves_[k] = lattice.step.cwiseProduct(Vector2d(kRing[k][0], kRing[k][1]));
    lengths_[k] = moves_[k].norm();
  }
  lay_triangles();
  const auto size = static_cast<std::size_t>(width_) * static_cast<std::size_t>(lattice.count[1] + 2);
  nodes_.assign(size, {kUnreached, 0, 0, std::numeric_limits<float>::infinity(), kBlocked});
  std::size_t next = 0;
  for (std::int32_t j = 0; j < lattice.count[1]; ++j)
    for (std::int32_t i = 0; i < lattice.count[0]; ++i) {
      const double n = densities[next++];
      if (!(n >= 0) || !(n < kUnreached)) continue;
      Node& node = nodes_[static_cast<std::size_t>(number(i, j))];
      node.density = static_cast<float>(n);
      node.state = kOpen;
    }
}

void IsotropicMarch::lay_triangles() {
  for (std::size_t t = 0; t < triangles_.size(); ++t) {
    const std::size_t k = t % 8, turn = t < 8 ? 1 : 7;
    const bool straight = k % 2 == 0;
    const std::int32_t node = ring_[k], other = ring_[(straight ? k + 2 * turn : k + turn) % 8],
                       fourth = ring_[(straight ? k + turn : k + 8 - turn) % 8];
    const std::int32_t near = straight ? 0 : other, far = straight ? other : 0;
    const bool off_x = std::abs(near - node) == 1;
    const double x = lattice_.step[0], y = lattice_.step[1];
    triangles_[t] = {
        node, near, far, fourth, (near > node ? 1 : -1) * (off_x ? x : y), (far > near ? 1 : -1) * (off_x ? y : x),
        off_x};
  }
}

Vector2d IsotropicMarch::place(std::int32_t node) const { return lattice_.place(node % width_ - 1, node / width_ - 1); }

void IsotropicMarch::start(const Vector2d& source,
                           const std::function<double(const Vector2d&, const Vector2d&)>& cost) {
  constexpr double kReach = 3.5;  // steps: nearer by the cubic would be less exact than the straight move
  const Vector2d at = (source - lattice_.lower).cwiseQuotient(lattice_.step);
  const auto low = [&](int axis) { return static_cast<std::int32_t>(std::max(std::ceil(at[axis] - kReach), 0.0)); };
  const auto high = [&](int axis) {
    return static_cast<std::int32_t>(
        std::min(std::floor(at[axis] + kReach), lattice_.count[static_cast<std::size_t>(axis)] - 1.0));
  };
  for (std::int32_t j = low(1); j <= high(1); ++j)
    for (std::int32_t i = low(0); i <= high(0); ++i) {
      const std::int32_t number_here = number(i, j);
      Node& node = nodes_[static_cast<std::size_t>(number_here)];
      const Vector2d here = lattice_.place(i, j), move = here - source;
      if (move.cwiseQuotient(lattice_.step).norm() > kReach || !(node.density < kUnreached)) continue;
      const double c = cost(source, here);
      if (!(c < node.u) || (passes_ && !passes_(source, here))) continue;
      node.u = c;
      node.px = static_cast<float>(move[0]), node.py = static_cast<float>(move[1]);
      started_.push_back(number_here);
    }
}

/// n is bilinear in the cell: its integral along a move is (n(node) + n(near)) / 2 + dn s, with the fourth corner in
/// dn. The slopes of u(s) + n(s) |move| at both ends of the edge say whether its least value is inside.
void IsotropicMarch::find_crossings(const Node& from, std::int32_t number, std::uint32_t triangles, Work& work) const {
  constexpr double kSameFront = 0.5;  // the cosine between the gradients of one front
  const double per_diagonal = 1 / lengths_[1];
  for (; triangles != 0; triangles &= triangles - 1) {
    const auto t = static_cast<std::uint32_t>(std::countr_zero(triangles));
    const Triangle& triangle = triangles_[t];
    const Node *const around = &from, &node = around[triangle.node], &a = around[triangle.near],
                      &b = around[triangle.far];
    const double ax = a.px, ay = a.py, bx = b.px, by = b.py, na = a.density, nb = b.density, nn = node.density;
    const double rise = b.u - a.u;
    const bool same = ax * bx + ay * by >= kSameFront * na * nb;
    const double slope_a = same ? triangle.edge * (triangle.off_x ? ay : ax) : rise;
    const double slope_b = same ? triangle.edge * (triangle.off_x ? by : bx) : rise;
    const double n = 0.5 * (nn + na);
    const double dn = (2 * (nb - na) + (double(around[triangle.fourth].density) - nn)) * (1.0 / 6);
    const double first = slope_a + dn * std::abs(triangle.off);
    const double last = slope_b + dn * lengths_[1] + (n + dn) * triangle.edge * triangle.edge * per_diagonal;
    work.crossings[work.crossing_count] = {a.u, rise,  slope_a - rise, slope_b - rise,         n,
                                           dn,  first, last,           number + triangle.node, t};
    work.crossing_count += std::size_t{first < 0} & std::size_t{last > 0};
  }
}

void IsotropicMarch::find_directs(const Node& from, std::int32_t number, std::uint32_t directions, Work& work) const {
  const Node* const around = &from;
  for (; directions != 0; directions &= directions - 1) {
    const auto k = static_cast<std::uint32_t>(std::countr_zero(directions));
    const Node& node = around[ring_[k]];
    const double ends = double(from.density) + double(node.density);
    const double others = k % 2 == 0
                              ? kUnreached
                              : double(around[ring_[(k + 1) % 8]].density) + double(around[ring_[(k + 7) % 8]].density);
    const double mean = others < kUnreached ? (2 * ends + others) * (1.0 / 6) : 0.5 * ends;
    const double u = from.u + mean * lengths_[k];
    work.directs[work.direct_count] = {u, number + ring_[k], k};
    work.direct_count += std::size_t{u < node.u};
  }
}

/// Looks for what a node that has become final offers to those around it. Bit k of a byte is for node k of the ring.
void IsotropicMarch::leave(std::int32_t number, Work& work) {
  constexpr std::uint8_t kStraight = 0x55;
  Node& from = nodes_[static_cast<std::size_t>(number)];
  from.state = kFinal;
  std::uint32_t states = 0;
  for (std::size_t k = 0; k < ring_.size(); ++k) states |= (&from)[ring_[k]].state << k;
  const auto byte = [](std::uint32_t bits) { return static_cast<std::uint8_t>(bits); };
  const std::uint8_t final = byte(states), known = byte(~(states >> 8)),
                     open = byte(~(states | states >> 8 | states >> 16));
  // Node k + n of the ring, as bit k. A move inside a cell needs all of its corners: nothing is known where one has no
  // cost.
  const auto after = [](std::uint8_t bits, int n) -> std::uint32_t { return std::rotr(bits, n); };
  const auto choose = [](std::uint32_t straight, std::uint32_t diagonal) {
    return (straight & kStraight) | (diagonal & ~std::uint32_t{kStraight});
  };
  const std::uint32_t next = open & choose(after(final, 2) & after(known, 1), after(final, 1) & after(known, -1));
  const std::uint32_t previous = open & choose(after(final, -2) & after(known, -1), after(final, -1) & after(known, 1));
  find_crossings(from, number, next | previous << 8, work);
  const std::uint32_t joined = passes_corners_ ? open : after(known, 1) & after(known, -1);
  find_directs(from, number, open & choose(open, joined), work);
}

/// Where on the edge the cost is least, by Newton's method from the secant of the slopes.
IsotropicMarch::Offer IsotropicMarch::over(const Crossing& c) const {
  constexpr int kSteps = 2;  // what is left counts by its square
  const Triangle& triangle = triangles_[c.triangle];
  const double pp = triangle.off * triangle.off, qq = triangle.edge * triangle.edge;
  double s = c.first / (c.first - c.last);
  for (int i = 0; i < kSteps; ++i) {
    const double n = c.n + c.dn * s, square = pp + qq * s * s, length = std::sqrt(square);
    const double du = c.rise + (1 - s) * (1 - 3 * s) * c.curve_near - s * (2 - 3 * s) * c.curve_far;
    const double ddu = (6 * s - 4) * c.curve_near + (6 * s - 2) * c.curve_far;
    // The derivatives, times the length and its cube.
    const double slope = du * length + c.dn * square + n * qq * s;
    const double curvature = (ddu * length + 2 * c.dn * qq * s) * square + n * pp * qq;
    if (!(curvature > 0)) break;
    s = std::clamp(s - slope * square / curvature, 0.0, 1.0);
  }
  const double length = std::sqrt(pp + qq * s * s);
  const double u =
      c.u + s * c.rise + s * (1 - s) * ((1 - s) * c.curve_near - s * c.curve_far) + (c.n + c.dn * s) * length;
  const double along = triangle.edge * s;
  return {u, triangle.off_x ? triangle.off : along, triangle.off_x ? along : triangle.off};
}

void IsotropicMarch::take(std::int32_t number, const Offer& offer, BucketQueue<std::int32_t>& queue) {
  Node& node = nodes_[static_cast<std::size_t>(number)];
  if (!(offer.u < node.u)) return;
  if (passes_) {
    const Vector2d here = place(number);
    if (!passes_(here + Vector2d(offer.x, offer.y), here)) return;
  }
  if (!(node.u < kUnreached) || !queue.together(node.u, offer.u)) queue.push(offer.u, number);
  node.u = offer.u;
  node.px = static_cast<float>(-offer.x);
  node.py = static_cast<float>(-offer.y);
}

/// Turns the direction of the last move into the gradient. A ray bends by what n grows across it: the move is a chord,
/// whose direction is that of the ray half a length earlier.
void IsotropicMarch::finish(std::int32_t number) {
  constexpr double kSmooth = 0.3;  // of n within a move: more is a jump, at which no gradient of n bends a ray
  Node& node = nodes_[static_cast<std::size_t>(number)];
  const double n = node.density;
  const auto growth = [&](std::int32_t to, double step) {
    const float before = nodes_[static_cast<std::size_t>(number - to)].density,
                after = nodes_[static_cast<std::size_t>(number + to)].density;
    const double rise = double(after) - double(before);
    return std::abs(rise) < kUnreached ? rise * (0.25 / step) : 0.0;  // not finite: no value on one side
  };
  const double x = node.px, y = node.py, length = std::sqrt(x * x + y * y);
  if (!(length > 0) || !(n > 0)) {
    node.px = node.py = 0;
    return;
  }
  // The bend, times the length and n.
  const double bx = length * growth(1, lattice_.step[0]), by = length * growth(width_, lattice_.step[1]);
  double gx = x / length, gy = y / length;
  if (bx * bx + by * by < kSmooth * kSmooth * n * n) {
    const double along = (bx * gx + by * gy) / n;
    gx += bx / n - along * gx, gy += by / n - along * gy;
    const double scale = 1 / std::sqrt(gx * gx + gy * gy);
    gx *= scale, gy *= scale;
  }
  node.px = static_cast<float>(n * gx);
  node.py = static_cast<float>(n * gy);
}

/// In the direction of the gradient, which lies between those to the ends of an edge, an end is at least p^2 / |(p, q)|
/// off the node. 0: n is so much lower somewhere than elsewhere that most buckets would be empty.
double IsotropicMarch::bucket_width() const {
  constexpr double kPart = 0.3;   // fronts bend, and u is linear where two meet
  constexpr double kFine = 1e-4;  // of what a step costs usually
  constexpr std::size_t kSample = 1000;
  const double shorter = lattice_.step.minCoeff();
  double least = kUnreached;
  std::vector<float> some;
  const std::size_t each = nodes_.size() / kSample + 1;
  some.reserve(kSample);
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const float n = nodes_[i].density;
    if (!(double(n) < kUnreached)) continue;
    least = std::min(least, double(n));
    if (i % each == 0) some.push_back(n);
  }
  if (some.empty() || !(least > 0)) return 0;
  std::nth_element(some.begin(), some.begin() + static_cast<std::ptrdiff_t>(some.size() / 2), some.end());
  const double width = kPart * least * shorter * shorter / lengths_[1];
  return width >= kFine * double(some[some.size() / 2]) * shorter ? width : 0;
}

/// Leaves in a batch the nodes that become final by it.
void IsotropicMarch::accept(std::vector<std::int32_t>& batch) {
  constexpr std::size_t kAhead = 6;
  std::size_t count = 0;
  for (std::size_t i = 0; i < batch.size(); ++i) {
    if (i + kAhead < batch.size()) {
      const Node* const later = &nodes_[static_cast<std::size_t>(batch[i + kAhead])];
      for (const std::int32_t row : {-width_, 0, width_})
        __builtin_prefetch(later + row - 1), __builtin_prefetch(later + row + 1);
    }
    Node& node = nodes_[static_cast<std::size_t>(batch[i])];
    if (node.state != kOpen) continue;
    node.state = kInBatch;
    finish(batch[i]);
    batch[count++] = batch[i];
  }
  batch.resize(count);
}

void IsotropicMarch::run(const std::function<bool()>& stop) {
  constexpr std::size_t kNodesPerLook = 4096;
  BucketQueue<std::int32_t> queue(bucket_width());
  for (const std::int32_t node : started_) queue.push(nodes_[static_cast<std::size_t>(node)].u, node);
  started_.clear();
  Work work;
  std::vector<std::int32_t> batch;
  for (std::size_t nodes = 0; queue.pop(batch); nodes += batch.size()) {
    if (nodes >= kNodesPerLook && stop) {
      if (stop()) throw Interrupted("field: interrupted before all nodes were reached");
      nodes = 0;
    }
    accept(batch);
    for (std::size_t begin = 0; begin < batch.size(); begin += kChunk) {
      work.crossing_count = work.direct_count = 0;
      for (std::size_t i = begin; i < std::min(begin + kChunk, batch.size()); ++i) leave(batch[i], work);
      for (std::size_t i = 0; i < work.crossing_count; ++i)
        take(work.crossings[i].node, over(work.crossings[i]), queue);
      for (std::size_t i = 0; i < work.direct_count; ++i) {
        const Direct& direct = work.directs[i];
        take(direct.node, {direct.u, -moves_[direct.ring][0], -moves_[direct.ring][1]}, queue);
      }
    }
  }
}

std::vector<double> IsotropicMarch::values() const {
  std::vector<double> values;
  values.reserve(nodes_.size());
  for (std::int32_t j = 0; j < lattice_.count[1]; ++j)
    for (std::int32_t i = 0; i < lattice_.count[0]; ++i)
      values.push_back(nodes_[static_cast<std::size_t>(number(i, j))].u);
  return values;
}

}  // namespace leastcost
