// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/fields/space_march.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include "problems/graph/monotone_queue.hpp"

namespace leastcost {
namespace {

using Place3 = std::array<std::int32_t, 3>;

constexpr double kNotReached = std::numeric_limits<double>::infinity();

/// The 26 nodes around one, in the order of their numbers: opposite ones add up to 25.
std::array<Place3, 26> ring_in_space() {
  std::array<Place3, 26> ring{};
  std::size_t next = 0;
  for (std::int32_t k = -1; k <= 1; ++k)
    for (std::int32_t j = -1; j <= 1; ++j)
      for (std::int32_t i = -1; i <= 1; ++i)
        if (i != 0 || j != 0 || k != 0) ring[next++] = {i, j, k};
  return ring;
}

}  // namespace

SpaceMarch::SpaceMarch(const Lattice& lattice, const std::vector<double>& densities, Passes passes)
    : lattice_(lattice), passes_(std::move(passes)), width_(lattice.count[0] + 2), height_(lattice.count[1] + 2) {
  const auto size = static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_) *
                    static_cast<std::size_t>(lattice.count[2] + 2);
  nodes_.assign(size, {kNotReached, {0, 0, 0}, std::numeric_limits<float>::infinity(), 0});
  final_.assign(size, 1);
  std::size_t next = 0;
  for (std::int32_t k = 0; k < lattice.count[2]; ++k)
    for (std::int32_t j = 0; j < lattice.count[1]; ++j)
      for (std::int32_t i = 0; i < lattice.count[0]; ++i) {
        const double n = densities[next++];
        if (!(n >= 0) || !(n < kNotReached)) continue;
        const auto here = static_cast<std::size_t>(number(i, j, k));
        nodes_[here].density = static_cast<float>(n);
        final_[here] = 0;
      }
  list_sides();
}

SpaceMarch::Vector SpaceMarch::place(std::int32_t node) const {
  return lattice_.place(node % width_ - 1, node / width_ % height_ - 1, node / width_ / height_ - 1);
}

void SpaceMarch::list_sides() {
  const std::array<Place3, 26> ring = ring_in_space();
  const auto add = [&](int corners, const std::array<Place3, 3>& at) {
    Side side{corners, {}, {}, 0, {}};
    for (std::size_t c = 0; c < 3; ++c) {
      side.node[c] = at[c][0] + width_ * (at[c][1] + height_ * at[c][2]);
      side.at[c] = lattice_.step.cwiseProduct(Vector(at[c][0], at[c][1], at[c][2]));
    }
    side.apart = side.at[0].norm();
    for (std::size_t c = 0; c < 2; ++c) side.legs[c] = (side.at[c + 1] - side.at[c]).norm();
    for (std::size_t k = 0; k < ring.size(); ++k)
      if (std::find(at.begin(), at.begin() + corners, ring[k]) != at.begin() + corners) sides_[k].push_back(side);
  };
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const auto& [i, j, l] = ring[k];
    ring_[k] = i + width_ * (j + height_ * l);
    moves_[k] = lattice_.step.cwiseProduct(Vector(i, j, l));
    if (std::abs(i) + std::abs(j) + std::abs(l) != 3) continue;
    // All triangles and edges below a corner of the cube, axis by axis; an edge belongs to two or four corners.
    for (const auto& [a, b] : {std::pair(0, 1), {0, 2}, {1, 0}, {1, 2}, {2, 0}, {2, 1}}) {
      const auto first = static_cast<std::size_t>(a), second = static_cast<std::size_t>(b);
      const Place3 corner = ring[k];
      Place3 axis{}, edge{};
      axis[first] = edge[first] = corner[first];
      edge[second] = corner[second];
      add(3, {axis, edge, corner});
      const std::size_t third = 3 - first - second;
      if (second < third) add(2, {axis, corner, corner});
      if (corner[third] > 0) add(2, {axis, edge, edge});
      if (first < second) add(2, {edge, corner, corner});
    }
  }
}

void SpaceMarch::start(const Vector& source, const std::function<double(const Vector&, const Vector&)>& cost) {
  constexpr double kReach = 3.5;  // steps, as in the plane
  const Vector at = (source - lattice_.lower).cwiseQuotient(lattice_.step);
  Place3 low{}, high{};
  for (std::size_t d = 0; d < 3; ++d) {
    const double along = at[static_cast<Eigen::Index>(d)];
    low[d] = static_cast<std::int32_t>(std::max(std::ceil(along - kReach), 0.0));
    high[d] = static_cast<std::int32_t>(std::min(std::floor(along + kReach), lattice_.count[d] - 1.0));
  }
  for (std::int32_t k = low[2]; k <= high[2]; ++k)
    for (std::int32_t j = low[1]; j <= high[1]; ++j)
      for (std::int32_t i = low[0]; i <= high[0]; ++i) {
        const std::int32_t number_here = number(i, j, k);
        Node& here = nodes_[static_cast<std::size_t>(number_here)];
        const Vector x = lattice_.place(i, j, k), move = x - source;
        if (move.cwiseQuotient(lattice_.step).norm() > kReach || !(here.density < kNotReached)) continue;
        const double c = cost(source, x);
        if (!(c < here.u) || (passes_ && !passes_(source, x))) continue;
        const double length = move.norm();
        here.u = c;
        for (int d = 0; d < 3; ++d)
          here.p[static_cast<std::size_t>(d)] = static_cast<float>(length > 0 ? move[d] / length : 0);
        here.length = static_cast<float>(length);
        started_.push_back(number_here);
      }
}

/// Newton steps towards the least of u + n |move| with the gradients at the corners.
void SpaceMarch::refine(const Node& here, const Side& side, const std::array<const Node*, 3>& corner,
                        std::array<double, 3>& share) {
  constexpr int kSteps = 2;
  const auto corners = static_cast<std::size_t>(side.corners), legs = corners - 1;
  std::array<Vector, 3> g;
  std::array<Vector, 2> leg;
  for (std::size_t c = 0; c < corners; ++c) g[c] = Vector(corner[c]->p[0], corner[c]->p[1], corner[c]->p[2]);
  for (std::size_t c = 0; c < legs; ++c) leg[c] = side.at[c + 1] - side.at[c];
  for (int step = 0; step < kSteps; ++step) {
    Vector p = Vector::Zero(), gradient = Vector::Zero();
    double n = 0.5 * double(here.density);
    for (std::size_t c = 0; c < corners; ++c) {
      p += share[c] * side.at[c];
      gradient += share[c] * g[c];
      n += 0.5 * share[c] * double(corner[c]->density);
    }
    const double length = p.norm();
    const auto value = [&](std::size_t c) { return corner[c]->u + 0.5 * g[c].dot(p - side.at[c]); };
    const auto growth = [&](std::size_t c) {
      return 0.5 * (double(corner[c + 1]->density) - double(corner[c]->density));
    };
    std::array<double, 2> slope{}, along{};
    std::array<std::array<double, 2>, 2> bend = {{{1, 0}, {0, 1}}};
    for (std::size_t c = 0; c < legs; ++c) along[c] = p.dot(leg[c]) / length;
    for (std::size_t c = 0; c < legs; ++c) {
      slope[c] = value(c + 1) - value(c) + 0.5 * gradient.dot(leg[c]) + growth(c) * length + n * along[c];
      for (std::size_t e = 0; e < legs; ++e)
        bend[c][e] = 0.5 * ((g[c + 1] - g[c]).dot(leg[e]) + (g[e + 1] - g[e]).dot(leg[c])) +
                     n * (leg[c].dot(leg[e]) - along[c] * along[e]) / length + growth(c) * along[e] +
                     growth(e) * along[c];
    }
    const double determinant = bend[0][0] * bend[1][1] - bend[0][1] * bend[1][0];
    if (!(bend[0][0] > 0) || !(determinant > 0)) return;
    const double first = share[1] + share[2] - (bend[1][1] * slope[0] - bend[0][1] * slope[1]) / determinant;
    const double second = share[2] - (bend[0][0] * slope[1] - bend[1][0] * slope[0]) / determinant;
    if (!(first > 0) || !(first < 1) || !(second >= 0) || !(second < first)) return;
    share = {1 - first, first - second, second};
  }
}

bool SpaceMarch::inside(const Node& here, const Side& side, std::int32_t number, Offer& offer) const {
  constexpr double kSameFront = 0.5;  // the cosine between the gradients of one front
  const auto corners = static_cast<std::size_t>(side.corners);
  std::array<const Node*, 3> corner{};
  for (std::size_t c = 0; c < corners; ++c) {
    const std::int32_t at = number + side.node[c];
    corner[c] = &node(at);
    if (final_[static_cast<std::size_t>(at)] == 0 || !(corner[c]->u < kNotReached)) return false;
  }
  // The least of linear u + n |move| over the plane: where the move has the slope of u, seen from the foot.
  double n = 0, squared = 0;
  std::array<double, 2> slope{};
  std::array<double, 3> share{};  // barycentric
  for (std::size_t c = 0; c + 1 < corners; ++c) {
    slope[c] = (corner[c + 1]->u - corner[c]->u) / side.legs[c];
    squared += slope[c] * slope[c];
  }
  for (std::size_t c = 0; c < corners; ++c) n += double(corner[c]->density) / double(corners);
  n = 0.5 * (n + double(here.density));
  const auto place_shares = [&](double slopes_squared) {
    const double rest = n * n - slopes_squared;
    if (!(rest > 0)) return false;
    const double scale = -side.apart / std::sqrt(rest);
    share = {1, 0, 0};
    double before = 1;
    for (std::size_t c = 0; c + 1 < corners; ++c) {
      const double along = scale * slope[c] / side.legs[c];
      if (!(along > 0) || !(along < before)) return false;
      share[c] -= along;
      share[c + 1] = along;
      before = along;
    }
    return true;
  };
  if (!place_shares(squared)) return false;
  bool one_front = true;
  for (std::size_t c = 0; c < corners; ++c) {
    const Node &a = *corner[c], &b = *corner[(c + 1) % corners];
    double cosine = 0;
    for (std::size_t d = 0; d < 3; ++d) cosine += double(a.p[d]) * double(b.p[d]);
    one_front = one_front && cosine >= kSameFront * double(a.density) * double(b.density);
  }
  if (one_front) refine(here, side, corner, share);
  offer.from.setZero();
  double between = 0, u = 0;
  for (std::size_t c = 0; c < corners; ++c) {
    offer.from += share[c] * side.at[c];
    between += share[c] * double(corner[c]->density);
    u += share[c] * corner[c]->u;
  }
  if (one_front)
    for (std::size_t c = 0; c < corners; ++c) {
      const Vector move = offer.from - side.at[c];
      for (std::size_t d = 0; d < 3; ++d)
        u += 0.5 * share[c] * double(corner[c]->p[d]) * move[static_cast<Eigen::Index>(d)];
    }
  offer.u = u + 0.5 * (double(here.density) + between) * offer.from.norm();
  return true;
}

bool SpaceMarch::take(std::int32_t number, const Offer& offer) {
  Node& here = nodes_[static_cast<std::size_t>(number)];
  if (!(offer.u < here.u)) return false;
  if (passes_) {
    const Vector x = place(number);
    if (!passes_(x + offer.from, x)) return false;
  }
  const double length = offer.from.norm();
  here.u = offer.u;
  for (std::size_t d = 0; d < 3; ++d)
    here.p[d] = static_cast<float>(-offer.from[static_cast<Eigen::Index>(d)] / length);
  here.length = static_cast<float>(length);
  return true;
}

/// As IsotropicMarch::finish(): a ray bends by what n grows across it, and the move is a chord.
void SpaceMarch::finish(std::int32_t number) {
  constexpr double kSmooth = 0.3;
  final_[static_cast<std::size_t>(number)] = 1;
  Node& here = nodes_[static_cast<std::size_t>(number)];
  const double n = here.density;
  const std::array<std::int32_t, 3> to = {1, width_, width_ * height_};
  Vector direction, bend = Vector::Zero();
  for (std::size_t d = 0; d < 3; ++d) {
    const auto axis = static_cast<Eigen::Index>(d);
    direction[axis] = here.p[d];
    const float before = node(number - to[d]).density, after = node(number + to[d]).density;
    if (std::isfinite(before) && std::isfinite(after))
      bend[axis] = 0.5 * double(here.length) * double(after - before) / (2 * lattice_.step[axis]);
  }
  if (n > 0 && bend.norm() < kSmooth * n) {
    direction += bend / n - bend.dot(direction) / n * direction;
    const double norm = direction.norm();
    if (norm > 0) direction /= norm;
  }
  for (std::size_t d = 0; d < 3; ++d) here.p[d] = static_cast<float>(n * direction[static_cast<Eigen::Index>(d)]);
}

bool SpaceMarch::improve(std::int32_t number, std::int32_t by, std::size_t k) {
  constexpr std::size_t kMostOffers = 32;
  const Node &here = node(number), &from = node(by);
  std::array<Offer, kMostOffers> offers;
  std::size_t count = 0;
  for (const Side& side : sides_[k]) {
    Offer& offer = offers[count];
    if (inside(here, side, number, offer) && offer.u < here.u) ++count;
  }
  offers[count] = {from.u + 0.5 * (double(from.density) + double(here.density)) * moves_[k].norm(), moves_[k]};
  if (offers[count].u < here.u) ++count;
  // An obstacle may block the cheapest.
  for (; count > 0; --count) {
    const auto last = offers.begin() + static_cast<std::ptrdiff_t>(count);
    const auto least = std::min_element(offers.begin(), last, [](const Offer& a, const Offer& b) { return a.u < b.u; });
    if (take(number, *least)) return true;
    *least = *(last - 1);
  }
  return false;
}

void SpaceMarch::run(const std::function<bool()>& stop) {
  constexpr int kNodesPerLook = 1024;
  MonotoneQueue<std::int32_t> queue;
  for (const std::int32_t number : started_) queue.push(node(number).u, number);
  started_.clear();
  for (int steps = 1; !queue.empty(); ++steps) {
    if (steps % kNodesPerLook == 0 && stop && stop())
      throw Interrupted("field: interrupted before all nodes were reached");
    const auto [c, by] = queue.pop();
    if (final_[static_cast<std::size_t>(by)] != 0) continue;
    finish(by);
    for (std::size_t k = 0; k < ring_.size(); ++k) {
      const std::int32_t number = by - ring_[k];
      if (final_[static_cast<std::size_t>(number)] == 0 && improve(number, by, k)) queue.push(node(number).u, number);
    }
  }
}

std::vector<double> SpaceMarch::values() const {
  std::vector<double> values;
  values.reserve(nodes_.size());
  for (std::int32_t k = 0; k < lattice_.count[2]; ++k)
    for (std::int32_t j = 0; j < lattice_.count[1]; ++j)
      for (std::int32_t i = 0; i < lattice_.count[0]; ++i) values.push_back(node(number(i, j, k)).u);
  return values;
}

}  // namespace leastcost
