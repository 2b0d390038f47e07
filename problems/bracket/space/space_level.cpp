// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/bracket/space/space_level.hpp"

#include <algorithm>
#include <cmath>

namespace leastcost::bracket {
namespace {

constexpr int kFieldCorrections = 3;
constexpr int kFieldDeflations = 4;

/// The cost of a straight move from the end by Simpson's rule, less what a curve saves.
double straight_cost_in_space(const SpaceDensity& density, const EndBall& ball, const Eigen::Vector3d& end,
                              const Eigen::Vector3d& middle) {
  const Eigen::Vector3d d = end - ball.place;
  const double n0 = density.density(ball.place), r = d.norm();
  const double across = ball.slope.cross(d).squaredNorm();  // |g across d|^2 r^2
  return r * (n0 + 4 * density.density(middle) + density.density(end)) / 6 - r * across / (24 * n0);
}

double largest_finite(const std::vector<double>& u) {
  double largest = 0;
  for (const double value : u)
    if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
  return largest;
}

/// Slope of a spline's coefficients at a node by central differences, times 2 h.
Eigen::Vector3d central_difference(const NodeSet& nodes, const std::vector<double>& u, int node) {
  const std::array<int, 6>& b = nodes.beside(node);
  const auto at = [&](std::size_t k) { return u[static_cast<std::size_t>(b[k])]; };
  return {at(1) - at(0), at(3) - at(2), at(5) - at(4)};
}

/// As in the plane: whether fronts meet about a node.
bool is_at_shock_in_space(const SpaceLevel& level, const std::vector<double>& u, int node) {
  constexpr double kKinkInSpace = 0.2;  // of n: a slope that falls by more within two cells is a shock's
  const std::array<int, 6>& b = level.nodes.beside(node);
  const auto size = [&](int k) { return std::abs(u[static_cast<std::size_t>(k)]); };
  const double least = -kKinkInSpace * level.grid.h * level.density[static_cast<std::size_t>(node)];
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (size(b[2 * axis]) + size(b[2 * axis + 1]) - 2 * size(node) < least) return true;
  return false;
}

void correct(const SpaceLevel& level, const std::vector<double>& u, SpaceFront& front) {
  constexpr double kLeast = 0.6, kMost = 1.05;  // beyond is a shock, where fronts meet
  for (const int node : front.order) {
    const auto at = static_cast<std::size_t>(node);
    if (is_at_shock_in_space(level, u, node)) continue;
    const double factor = 2 * level.grid.h * level.density[at] / central_difference(level.nodes, u, node).norm();
    if (factor > kLeast && factor < kMost) front.density[at] *= factor;
  }
}

}  // namespace

double SpaceMedium::marched(const SpaceGrid& grid, const Place& cell) const {
  constexpr double kScale = 6;  // cells; the fourth power is flat where searched cells reach into an obstacle
  const Eigen::Vector3d x = grid.in_box(grid.node(cell));
  const double deep = depth ? std::max(0.0, depth(x)) / (kScale * grid.h) : 0;
  return density.density(x) * (1 + deep * deep * deep * deep);
}

void fill_density(const SpaceMedium& medium, SpaceLevel& level, const StopLook& look) {
  level.density.assign(level.nodes.size() + 1, kInfinity);
  for (std::size_t node = 0; node < level.nodes.size(); ++node) {
    look.now_and_then();
    const double n = medium.marched(level.grid, level.nodes.places()[node]);
    if (n > 0) level.density[node] = n;  // not where it is unknown
  }
}

SpaceLevel whole_space_level(const SpaceMedium& medium, const Eigen::AlignedBox3d& box, int cells,
                             const StopLook& look) {
  SpaceLevel level;
  level.grid = SpaceGrid::over(box, cells);
  const Place& last = level.grid.cells;
  std::vector<Place> places;
  for (int k = 0; k <= last[2] + 1; ++k)
    for (int j = 0; j <= last[1] + 1; ++j)
      for (int i = 0; i <= last[0] + 1; ++i) places.push_back({i, j, k});
  level.nodes = NodeSet(std::move(places), last);
  level.searched.assign(level.nodes.size() + 1, 0);
  for (int node = 0; node < level.nodes.none(); ++node) {
    look.now_and_then();
    const Place& p = level.nodes.place(node);
    if (!level.grid.is_cell(p) || medium.is_blocked(level.grid, p)) continue;
    level.searched[static_cast<std::size_t>(node)] = 1;
    level.cells.push_back(node);
    level.floor_of.push_back(static_cast<int>(level.floors.size()));
    level.floors.push_back(space_floor(medium.density, level.grid.cell(p)));
  }
  fill_density(medium, level, look);
  return level;
}

SpaceFront front_around(const SpaceMedium& medium, const SpaceLevel& level, const EndBall& ball) {
  const SpaceGrid& grid = level.grid;
  SpaceFront front;
  front.density = level.density;
  front.values.assign(level.density.size(), kInfinity);
  const double reach = (ball.k + 2) * grid.h * std::sqrt(3.0);
  const int span = 2 * ball.k + 6;
  for (int k = -span; k <= span; ++k)
    for (int j = -span; j <= span; ++j)
      for (int i = -span; i <= span; ++i) {
        const Place p = {ball.middle[0] + i, ball.middle[1] + j, ball.middle[2] + k};
        if ((grid.node(p) - ball.place).norm() > reach) continue;
        const int node = level.nodes.find(p);
        if (node == level.nodes.none() || !(level.density[static_cast<std::size_t>(node)] < kInfinity)) continue;
        const Eigen::Vector3d end = grid.in_box(grid.node(p)), middle = grid.in_box(0.5 * (ball.place + grid.node(p)));
        const double beyond = (grid.node(p) - end).norm();
        const double cost = straight_cost_in_space(medium.density, ball, end, middle) +
                            beyond * level.density[static_cast<std::size_t>(node)];
        if (!std::isfinite(cost)) continue;
        front.values[static_cast<std::size_t>(node)] = cost;
        front.seeds.push_back(node);
      }
  return front;
}

std::vector<double> march(const SpaceLevel& level, SpaceFront& front, int corrections, SpaceMarching& marching) {
  for (int pass = 0;; ++pass) {
    std::vector<double> u = front.values;
    if (front.order.empty())
      marching.run(level.nodes, level.grid.h, front.density, front.seeds, u, front.order);
    else
      marching.follow(level.nodes, level.grid.h, front.density, front.order, u);
    if (!front.sign.empty())
      for (std::size_t node = 0; node < u.size(); ++node) u[node] *= front.sign[node];
    if (pass == corrections) return u;
    correct(level, u, front);
  }
}

double check(const SpaceLevel& level, const std::vector<double>& u, const EndBall& s, const EndBall& t,
             std::vector<double>& ratios, const StopLook& look) {
  const double largest = largest_finite(u);
  ratios.assign(u.size(), 0);
  double worst = 1;
  for (std::size_t k = 0; k < level.cells.size(); ++k) {
    look.now_and_then();
    const int node = level.cells[k];
    const Place& p = level.nodes.place(node);
    if ((s.valid && s.holds(p)) || (t.valid && t.holds(p))) continue;
    const CubeNet floor = level.floors[static_cast<std::size_t>(level.floor_of[k])].on_cell(level.grid, p);
    const double ratio = proved_ratio(around(level.nodes, u, node), level.grid.h, largest, floor);
    ratios[static_cast<std::size_t>(node)] = ratio;
    worst = std::max(worst, ratio);
  }
  return worst;
}

void deflate(const SpaceLevel& level, const std::vector<double>& ratios, SpaceFront& front) {
  constexpr double kBeyond = 1.1;
  std::vector<double> worst(ratios.size(), 1);
  for (const int node : level.cells) {
    const double ratio = ratios[static_cast<std::size_t>(node)];
    if (!(ratio > 1)) continue;
    for (const int row : level.nodes.rows_around(node))
      for (int p = -1; p <= 1; ++p) {
        double& here = worst[static_cast<std::size_t>(row + p)];
        here = std::max(here, ratio);
      }
  }
  for (std::size_t node = 0; node < worst.size(); ++node) {
    if (!(worst[node] > 1) || !std::isfinite(worst[node])) continue;
    const double factor = 1 + kBeyond * (worst[node] - 1);
    front.density[node] /= factor;
    if (!front.sign.empty()) front.values[node] /= factor;
  }
}

namespace {

/// The same of the seeds of an end, which are values of a straight move and no march changes: all by one factor.
void deflate_seeds(const std::vector<double>& ratios, SpaceFront& front) {
  double worst = 1;
  for (const int seed : front.seeds) {
    const double ratio = ratios[static_cast<std::size_t>(seed)];
    if (std::isfinite(ratio)) worst = std::max(worst, ratio);
  }
  for (const int seed : front.seeds) front.values[static_cast<std::size_t>(seed)] /= worst;
}

}  // namespace

SpaceDistance distance_field(const SpaceMedium& medium, const SpaceLevel& level, const EndBall& ball,
                             SpaceMarching& marching) {
  SpaceDistance field{ball, {}, front_around(medium, level, ball)};
  field.u = march(level, field.front, kFieldCorrections, marching);
  return field;
}

SpaceDistanceBound distance_bound(const SpaceLevel& level, SpaceDistance field, const Eigen::Vector3d& other,
                                  SpaceMarching& marching) {
  SpaceDistanceBound best{field.ball, {}};
  const auto there = static_cast<std::size_t>(level.nodes.find(level.grid.place_at(other)));
  double highest = -kInfinity;
  std::vector<double> ratios;
  for (int round = 0;; ++round) {
    const double ratio = check(level, field.u, field.ball, EndBall(), ratios, marching.look());
    const double offset = rim_minimum(level.grid, level.nodes, field.ball, level.searched, field.u, -1, ratio);
    const double bound = ratio < kInfinity ? field.u[there] / ratio + offset : -kInfinity;
    if (round == 0 || bound > highest) {
      highest = bound;
      best.ratio = ratio;
      best.offset = offset;
      best.u = field.u;
    }
    if (round == kFieldDeflations || !(ratio > 1)) return best;
    deflate(level, ratios, field.front);
    if (round > 0) deflate_seeds(ratios, field.front);
    field.u = march(level, field.front, 0, marching);
  }
}

}  // namespace leastcost::bracket
