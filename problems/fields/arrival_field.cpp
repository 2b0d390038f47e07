// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/fields/arrival_field.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/cost/segment_cost.hpp>
#include <leastcost/framework/domain/manifold.hpp>

namespace leastcost {
namespace {

constexpr double kNoBetter = 1e-5;  ///< a gain of this part of a cost is not passed on

struct LeastOnEdge {
  double cost, t;
};

/// The least over t in [0, 1] of (1 - t) a + t b + c(t), where c(t)^2 is the parabola through the squares of three
/// costs, at t = 0, 1/2 and 1: exact where c comes from a metric.
LeastOnEdge least_on_edge(double a, double b, const std::array<double, 3>& c) {
  LeastOnEdge best = a + c[0] <= b + c[2] ? LeastOnEdge{a + c[0], 0} : LeastOnEdge{b + c[2], 1};
  const double first = c[0] * c[0], middle = c[1] * c[1], last = c[2] * c[2], slope = b - a;
  const double p2 = 2 * (first + last) - 4 * middle, p1 = 4 * middle - 3 * first - last;
  const double d = 4 * p2 * first - p1 * p1;
  if (!(p2 > slope * slope) || !(d > 0)) {
    const double half = (a + b) / 2 + c[1];
    return half < best.cost ? LeastOnEdge{half, 0.5} : best;
  }
  const double s = -slope * std::sqrt(d / (p2 - slope * slope)), t = (s - p1) / (2 * p2);
  if (!(t > 0) || !(t < 1)) return best;
  const double inner = a + t * slope + std::sqrt((s * s + d) / (4 * p2));
  return inner < best.cost ? LeastOnEdge{inner, t} : best;
}

}  // namespace

ArrivalField::ArrivalField(const Problem& problem, const MoveCheck& moves, const LatticeBox& box, int cells,
                           const Way& how, const std::function<bool()>& stop)
    : problem_(problem), moves_(moves), how_(how) {
  lay(box, cells);
  if (!how.exact) {
    Eigen::Matrix2Xd u(2, static_cast<Eigen::Index>(arrivals_.size()));
    for (std::int32_t node = 0; node < static_cast<std::int32_t>(arrivals_.size()); ++node)
      u.col(node) = coordinates({node, node, 0});
    node_moves_.emplace(problem, u, step_);
    keep_off(how.margin);
    mark_doubtful();
  }
  spread(stop);
  if (how_.whole && node_moves_ && !node_moves_->any_carried()) sharpen(stop);
  if (!how_.whole) arrive_at_target();
}

void ArrivalField::lay(const LatticeBox& box, int cells) {
  lower_ = box.lower, upper_ = box.upper;
  const Eigen::Vector2d size = upper_ - lower_;
  for (std::size_t d = 0; d < 2; ++d) {
    const auto k = static_cast<Eigen::Index>(d);
    const double along = how_.cells ? (*how_.cells)[d] : std::max(1.0, std::round(size[k] / size.maxCoeff() * cells));
    lattice_.count[d] = static_cast<std::int32_t>(along) + 1;
    step_[k] = size[k] / along;
  }
  const auto nodes = static_cast<std::int32_t>(lattice_.size());
  const auto more = static_cast<Index>(how_.sources.size());
  CoordinatePath all{Points(2, nodes + 2 + more), {}, true};
  for (std::int32_t node = 0; node < nodes; ++node) all.u.col(node) = coordinates({node, node, 0});
  all.u.col(nodes) = problem_.source.u;
  all.u.col(nodes + 1) = problem_.target.u;
  for (Index i = 0; i < more; ++i) all.u.col(nodes + 2 + i) = how_.sources[static_cast<std::size_t>(i)];
  x_ = positions(*problem_.manifold, all);
  source_ = x_.col(nodes);
  target_ = x_.col(nodes + 1);
  more_sources_ = x_.rightCols(more);
  arrivals_.resize(static_cast<std::size_t>(nodes));
  clear_.assign(2 * static_cast<std::size_t>(nodes), -1);
  ends_.resize(x_.rows(), 2);
}

template <class Visit>
void ArrivalField::beside_blocked(int reach, const Visit& visit) const {
  if (!node_moves_->any_blocked()) return;
  for (std::int32_t node = 0; node < static_cast<std::int32_t>(arrivals_.size()); ++node) {
    if (!node_moves_->blocked(node)) continue;
    const std::array<std::int32_t, 3> at = lattice_.place(node);
    for (std::int32_t j = std::max(at[1] - reach, 0); j <= std::min(at[1] + reach, lattice_.count[1] - 1); ++j)
      for (std::int32_t i = std::max(at[0] - reach, 0); i <= std::min(at[0] + reach, lattice_.count[0] - 1); ++i)
        visit(i, j);
  }
}

void ArrivalField::keep_off(int margin) {
  if (margin == 0) return;
  const Window near_source = around(problem_.source.u, margin + kEndReach),
               near_target = around(problem_.target.u, margin + kEndReach);
  const auto in = [](const Window& w, std::int32_t i, std::int32_t j) {
    return i >= w.low[0] && i <= w.high[0] && j >= w.low[1] && j <= w.high[1];
  };
  std::vector<std::int32_t> left_out;
  beside_blocked(margin, [&](std::int32_t i, std::int32_t j) {
    if (!in(near_source, i, j) && !in(near_target, i, j)) left_out.push_back(lattice_.number({i, j, 0}));
  });
  for (const std::int32_t node : left_out) node_moves_->block(node);
}

void ArrivalField::mark_doubtful() {
  doubtful_.assign(arrivals_.size(), 0);
  beside_blocked(1, [&](std::int32_t i, std::int32_t j) {
    doubtful_[static_cast<std::size_t>(lattice_.number({i, j, 0}))] = 1;
  });
}

/// As Dijkstra, but that a node is worked off again when it becomes cheaper. When all is done there are leaps to what
/// is not reached yet: where a current carries all moves into a narrow cone no neighbour may lie in it.
void ArrivalField::spread(const std::function<bool()>& stop) {
  Queue queue;
  worked_off_.assign(arrivals_.size(), kNever);
  leave_source(problem_.source.u, source_, queue);
  for (std::size_t i = 0; i < how_.sources.size(); ++i)
    leave_source(how_.sources[i], more_sources_.col(static_cast<Index>(i)), queue);
  work_off(queue, false, stop);
  if (isotropic()) return;
  queue = {};
  for (std::int32_t node = 0; node < static_cast<std::int32_t>(arrivals_.size()); ++node)
    if (known(node)) queue.push(arrivals_[static_cast<std::size_t>(node)].cost, node);
  work_off(queue, true, stop);
}

void ArrivalField::leave_source(const Eigen::Vector2d& u, const Eigen::VectorXd& x, Queue& queue) {
  const Window start = around(u, kEndReach);
  for (std::int32_t j = start.low[1]; j <= start.high[1]; ++j)
    for (std::int32_t i = start.low[0]; i <= start.high[0]; ++i) {
      const std::int32_t node = lattice_.number({i, j, 0});
      const double c = move(x, x_.col(node));
      if (!(c < value(node)) || !moves_.clear(x, x_.col(node), kNever)) continue;
      arrivals_[static_cast<std::size_t>(node)].cost = c;
      starts_.emplace_back(node, coordinates({node, node, 0}) - u);
      queue.push(c, node);
    }
}

void ArrivalField::work_off(Queue& queue, bool leaping, const std::function<bool()>& stop) {
  constexpr int kNodesPerLook = 256;
  constexpr double kSlack = 1.05;  // beyond the target, where nodes may still become cheaper
  double least_at_target = kNever;
  for (int steps = 1; !queue.empty(); ++steps) {
    if (steps % kNodesPerLook == 0 && stop())
      throw Interrupted("eikonal: interrupted while the arrival costs were computed");
    const auto [c, node] = queue.pop();
    if (c > arrivals_[static_cast<std::size_t>(node)].cost) continue;
    if (c > least_at_target * (isotropic() ? 1 : kSlack)) return;
    if ((isotropic() || is_carried()) && !how_.whole) least_at_target = std::min(least_at_target, c + last_move(node));
    if (leaping) leap(node, queue);
    double& worked = worked_off_[static_cast<std::size_t>(node)];
    if (worked <= c) continue;  // what it leads to is known
    worked = c;
    const std::array<std::int32_t, 3> at = lattice_.place(node);
    for (std::size_t k = 0; k < kRing.size(); ++k) {
      const std::int32_t i = at[0] + kRing[k][0], j = at[1] + kRing[k][1];
      if (i < 0 || j < 0 || i >= lattice_.count[0] || j >= lattice_.count[1]) continue;
      const std::int32_t neighbour = lattice_.number({i, j, 0});
      if (isotropic() && arrivals_[static_cast<std::size_t>(neighbour)].cost <= c) continue;
      // Seen from there this node lies on the other side.
      if (improve(neighbour, node, (k + kRing.size() / 2) % kRing.size()))
        queue.push(arrivals_[static_cast<std::size_t>(neighbour)].cost, neighbour);
    }
  }
}

double ArrivalField::last_move(std::int32_t node) const {
  const std::array<std::int32_t, 3> at = lattice_.place(node);
  const Window near = around(problem_.target.u, kEndReach);
  if (at[0] < near.low[0] || at[1] < near.low[1] || at[0] > near.high[0] || at[1] > near.high[1]) return kNever;
  return moves_.clear(x_.col(node), target_, kNever) ? move(x_.col(node), target_) : kNever;
}

/// To nodes further away in other directions than those of neighbours.
void ArrivalField::leap(std::int32_t node, Queue& queue) {
  constexpr std::int32_t kFurthest = 5;
  const std::array<std::int32_t, 3> at = lattice_.place(node);
  for (std::int32_t dj = -kFurthest; dj <= kFurthest; ++dj)
    for (std::int32_t di = -kFurthest; di <= kFurthest; ++di) {
      const std::int32_t i = at[0] + di, j = at[1] + dj;
      if (std::gcd(di, dj) != 1 || i < 0 || j < 0 || i >= lattice_.count[0] || j >= lattice_.count[1]) continue;
      const std::int32_t there = lattice_.number({i, j, 0});
      Arrival& arrival = arrivals_[static_cast<std::size_t>(there)];
      if (known(there) || !x_.col(there).allFinite()) continue;
      try_edge({node, node}, x_.col(there), arrival);
      if (known(there)) queue.push(arrival.cost, there);
    }
}

/// Over the two edges around a node that end in one of its neighbours.
bool ArrivalField::improve(std::int32_t node, std::int32_t by, std::size_t k) {
  if (node_moves_ ? node_moves_->blocked(node) : !x_.col(node).allFinite()) return false;
  const std::array<std::int32_t, 3> at = lattice_.place(node);
  Arrival& arrival = arrivals_[static_cast<std::size_t>(node)];
  Arrival best = arrival;
  best.cost *= 1 - kNoBetter;
  const double before = best.cost;
  for (const int turn : {1, -1}) {
    const auto& [di, dj] = kRing[(k + kRing.size() + static_cast<std::size_t>(turn)) % kRing.size()];
    const std::int32_t i = at[0] + di, j = at[1] + dj;
    const bool inside = i >= 0 && j >= 0 && i < lattice_.count[0] && j < lattice_.count[1];
    const std::int32_t other = inside ? lattice_.number({i, j, 0}) : by;
    if (node_moves_ && try_triangle(node, by, other, k, turn, best)) continue;
    const double least = is_carried() ? least_move(node, by, other, k, turn) : 0;
    if (least < best.cost) try_edge({by, other}, x_.col(node), best, kNever, least);
  }
  if (!(best.cost < before)) return false;
  arrival = best;
  return true;
}

/// What an exact move to a node from the edge between `by` and `other` costs at least, about; infinite where none is
/// possible. An edge has many such moves, and most are impossible or too dear.
double ArrivalField::least_move(std::int32_t node, std::int32_t by, std::int32_t other, std::size_t k, int turn) const {
  constexpr double kLeast = 0.3;  // of the least line element of the three nodes
  const NodeMoves& moves = *node_moves_;
  const std::size_t first = turn > 0 ? k : k + kRing.size() - 1, toward = how_.reversed ? kRing.size() / 2 : 0;
  const std::size_t edge = (first + toward) % kRing.size();
  return kLeast * std::min({moves.least(node, edge), moves.least(by, edge), moves.least(other, edge)});
}

bool ArrivalField::try_triangle(std::int32_t node, std::int32_t by, std::int32_t other, std::size_t k, int turn,
                                Arrival& best, double bend) const {
  const NodeMoves& moves = *node_moves_;
  // The way to a source takes the same moves the other way round.
  const std::size_t all = moves.directions(), parts = moves.parts();
  const std::size_t direction = (parts * k + (how_.reversed ? all / 2 : 0)) % all;
  const auto turned = [&](std::size_t part) { return (direction + (turn > 0 ? part : all - part)) % all; };
  const double u = cost({by, by, 0});
  const double from_by = 0.5 * (moves.cost(node, direction) + moves.cost(by, direction));
  if (!std::isfinite(from_by)) return false;
  const auto take = [&](double c, const Place& from) {
    if (c < best.cost && passes(from, node)) best = {c, from};
  };
  if (other != by && known(other) && !moves.blocked(other)) {
    const double rise = cost({other, other, 0}) - u;
    // Where some directions are impossible all are looked at; elsewhere the sum is convex along the edge.
    std::array<double, NodeMoves::kMostParts + 1> from_part{};
    const auto ask = [&](std::size_t part) {
      const double t = double(part) / double(parts);
      const std::size_t d = turned(part);
      from_part[part] = 0.5 * (moves.cost(node, d) + (1 - t) * moves.cost(by, d) + t * moves.cost(other, d)) +
                        0.5 * t * (1 - t) * bend;
      return t * rise + from_part[part];
    };
    std::size_t least_part = 0, last_part = parts;
    if (moves.any_carried())
      for (std::size_t part = 0; part <= parts; ++part)
        if (!std::isfinite(ask(part))) return false;
    while (least_part < last_part) {
      const std::size_t between = (least_part + last_part) / 2;
      if (ask(between) <= ask(between + 1))
        last_part = between;
      else
        least_part = between + 1;
    }
    const std::size_t middle = std::clamp<std::size_t>(least_part, 1, parts - 1);
    const double first = double(middle - 1) / double(parts), width = 2 / double(parts);
    for (const std::size_t part : {middle - 1, middle, middle + 1})
      if (!std::isfinite(ask(part))) return false;
    const LeastOnEdge least = least_on_edge(u + first * rise, u + (first + width) * rise,
                                            {from_part[middle - 1], from_part[middle], from_part[middle + 1]});
    const double t = first + width * least.t;
    if (t > 0 && t < 1 && least.cost < best.cost && clear({by, other})) take(least.cost, {by, other, t});
  }
  take(u + from_by, {by, by, 0});
  return true;
}

bool ArrivalField::passes(const Place& from, std::int32_t node) const {
  if (!moves_.among_obstacles() && doubtful_[static_cast<std::size_t>(node)] == 0) return true;
  const Eigen::VectorXd a = position(from);
  if (!moves_.clear(a, x_.col(node), kNever)) return false;
  return doubtful_[static_cast<std::size_t>(node)] == 0 || move(a, x_.col(node)) < kNever;
}

void ArrivalField::arrive_at_target() {
  const Window near_target = around(problem_.target.u, kEndReach), near_source = around(problem_.source.u, kEndReach);
  const std::array<std::int32_t, 3> middle = around(problem_.target.u, 0).low;
  bool near = true;
  for (std::size_t d = 0; d < 2; ++d)
    near = near && middle[d] >= near_source.low[d] && middle[d] <= near_source.high[d];
  const double straight = near ? move(source_, target_) : kNever;
  if (straight < kNever && moves_.clear(source_, target_, kNever)) at_target_.cost = straight;
  for (const Edge& edge : edges_in(near_target)) try_edge(edge, target_, at_target_);
}

ArrivalField::Arrival ArrivalField::over_edge(const Edge& edge, const Eigen::VectorXd& x, double below,
                                              double least) const {
  constexpr int kSamples = 8, kSections = 8;
  Arrival best;
  const auto look = [&](double t) {
    const Place place{edge.a, edge.b, t};
    if (!(cost(place) < below) || cost(place) + least >= best.cost) return;
    const double c = cost(place) + move_from(place, x);
    if (c < best.cost) best = {c, place};
  };
  for (int k = 0; k <= kSamples; ++k) look(static_cast<double>(k) / kSamples);
  // The best sample halved between its neighbours: near a least value an error of the place counts by its square.
  for (double width = 0.5 / kSamples; best.cost < kNever && width > 0.5 / kSamples / (1 << kSections / 2); width /= 2) {
    const double t = best.from.t;
    if (t - width >= 0) look(t - width);
    if (t + width <= 1) look(t + width);
  }
  return best;
}

void ArrivalField::try_edge(const Edge& edge, const Eigen::VectorXd& x, Arrival& best, double below,
                            double least) const {
  const auto take = [&](const Arrival& arrival) {
    if (arrival.cost < best.cost && moves_.clear(position(arrival.from), x, kNever)) best = arrival;
  };
  const bool both = edge.a != edge.b && known(edge.b);
  if (!known(edge.a) ||
      std::min(cost({edge.a, edge.a, 0}), both ? cost({edge.b, edge.b, 0}) : kNever) + least >= best.cost)
    return;
  if (both && clear(edge)) take(over_edge(edge, x, below, least));
  const Place node{edge.a, edge.a, 0};
  if (cost(node) < below) take({cost(node) + move_from(node, x), node});
}

bool ArrivalField::clear(const Edge& edge) const {
  const bool upward = lattice_.place(edge.a)[0] == lattice_.place(edge.b)[0];
  signed char& kept = clear_[2 * static_cast<std::size_t>(std::min(edge.a, edge.b)) + (upward ? 1 : 0)];
  if (kept < 0) kept = moves_.clear(x_.col(edge.a), x_.col(edge.b), kNever) ? 1 : 0;
  return kept == 1;
}

double ArrivalField::move(const Eigen::Ref<const Eigen::VectorXd>& a,
                          const Eigen::Ref<const Eigen::VectorXd>& b) const {
  if (moves_.euclidean()) return (b - a).norm();
  ends_.col(how_.reversed ? 1 : 0) = a;
  ends_.col(how_.reversed ? 0 : 1) = b;
  return cost_of_ends();
}

/// Asked millions of times where a current carries moves: without a vector of its own.
double ArrivalField::move_from(const Place& place, const Eigen::VectorXd& x) const {
  if (moves_.euclidean()) return (x - position(place)).norm();
  auto from = ends_.col(how_.reversed ? 1 : 0);
  from = x_.col(place.a);
  if (place.t > 0) from += place.t * (x_.col(place.b) - x_.col(place.a));
  ends_.col(how_.reversed ? 0 : 1) = x;
  return cost_of_ends();
}

double ArrivalField::cost_of_ends() const {
  double q = 0;
  problem_.cost->squared_costs({{ends_.data(), ends_.rows(), 2}, {}, false}, {&q, 1});
  return std::sqrt(q);
}

double ArrivalField::cost(const Place& place) const {
  const double a = arrivals_[static_cast<std::size_t>(place.a)].cost;
  return place.a == place.b ? a : a + place.t * (arrivals_[static_cast<std::size_t>(place.b)].cost - a);
}

Eigen::Vector2d ArrivalField::coordinates(const Place& place) const {
  const auto of = [&](std::int32_t node) {
    const std::array<std::int32_t, 3> at = lattice_.place(node);
    return Eigen::Vector2d(lower_ + step_.cwiseProduct(Eigen::Vector2d(at[0], at[1]))).cwiseMin(upper_).eval();
  };
  return of(place.a) + place.t * (of(place.b) - of(place.a));
}

ArrivalField::Window ArrivalField::around(const Eigen::Vector2d& u, int reach) const {
  Window window{};
  for (std::size_t d = 0; d < 2; ++d) {
    const auto k = static_cast<Eigen::Index>(d);
    const double last = lattice_.count[d] - 1, at = std::round((u[k] - lower_[k]) / step_[k]);
    window.low[d] = static_cast<std::int32_t>(std::clamp(at - reach, 0.0, last));
    window.high[d] = static_cast<std::int32_t>(std::clamp(at + reach, 0.0, last));
  }
  return window;
}

std::optional<double> ArrivalField::arrival_cost() const {
  return at_target_.cost < kNever ? std::optional(at_target_.cost) : std::nullopt;
}

}  // namespace leastcost
