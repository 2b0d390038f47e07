// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/cells/cell_refraction.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "problems/cells/corner_turn.hpp"
#include "problems/cells/straight_runs.hpp"

namespace leastcost {
namespace {

using Eigen::Vector2d;

constexpr double kSame = 1e-13;         ///< of the cost
constexpr double kAtCorner = 1e-12;     ///< of a side
constexpr double kBesideCorner = 1e-3;  ///< of a cell: so near to a corner the least path may go through it
constexpr double kSnell = 1e-11;        ///< mismatch that is none
constexpr int kMostRounds = 200;

bool is_corner(const CellMap& map, const Vector2d& x) { return map.line_at(0, x[0]) && map.line_at(1, x[1]); }

/// The side that holds a place which is no corner; null within a cell.
std::optional<Gate> gate_of(const CellMap& map, const Vector2d& x) {
  for (const int across : {0, 1}) {
    if (!map.line_at(across, x[across])) continue;
    const int along = 1 - across;
    const CellRange cell = map.touched(along, x[along]);
    return Gate{along, x[across], map.line(along, cell.first), map.line(along, cell.first + 1)};
  }
  return std::nullopt;
}

double leg_cost(const CellMap& map, const Vector2d& a, const Vector2d& b) {
  const auto leg = map.leg(a, b);
  return leg ? leg->cost : std::numeric_limits<double>::infinity();
}

/// Without places that a straight leg within one cell replaces at no higher cost.
CellPath simplified(const CellMap& map, const CellPath& path) {
  CellPath out;
  for (const Vector2d& next : path) {
    if (!out.empty() && out.back() == next) continue;
    while (out.size() >= 2) {
      const Vector2d &before = out[out.size() - 2], &last = out.back();
      const double by_last = leg_cost(map, before, last) + leg_cost(map, last, next);
      if (!(leg_cost(map, before, next) <= by_last * (1 + kSame))) break;
      out.pop_back();
    }
    if (out.empty() || out.back() != next) out.push_back(next);
  }
  return out;
}

/// The part of a path between two places that stay, the sides between them as gates.
struct Part {
  GateChain chain;
  std::vector<double> s;
};

Part part_of(const CellMap& map, const CellPath& path, std::size_t from, std::size_t to) {
  Part part;
  part.chain.from = path[from];
  part.chain.to = path[to];
  for (std::size_t i = from; i < to; ++i) {
    const auto leg = map.leg(path[i], path[i + 1]);
    part.chain.units.push_back(leg ? leg->unit : std::numeric_limits<double>::infinity());
    if (i + 1 == to) break;
    part.chain.gates.push_back(*gate_of(map, path[i + 1]));
    part.s.push_back(path[i + 1][part.chain.gates.back().axis]);
  }
  return part;
}

/// What is as near to an end of its gate as rounding is put there.
void snap(const GateChain& chain, std::vector<double>& s) {
  for (std::size_t i = 0; i < s.size(); ++i) {
    const Gate& gate = chain.gates[i];
    const double near = kAtCorner * (gate.high - gate.low);
    if (s[i] - gate.low <= near) s[i] = gate.low;
    if (gate.high - s[i] <= near) s[i] = gate.high;
  }
}

void append(const GateChain& chain, const std::vector<double>& s, CellPath& path) {
  for (std::size_t i = 0; i < s.size(); ++i) path.push_back(chain.gates[i].at(s[i]));
}

/// Calls visit(from, to) for the parts of a path between its ends and corners.
template <class Visit>
void each_part(const CellMap& map, const CellPath& path, const Visit& visit) {
  std::size_t from = 0;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const bool stays = i + 1 == path.size() || is_corner(map, path[i]) || !gate_of(map, path[i]);
    if (!stays) continue;
    visit(from, i);
    from = i;
  }
}

class Refraction {
 public:
  Refraction(const CellMap& map, CellPath path, const std::function<void()>& look)
      : map_(map), look_(look), path_(std::move(path)), cost_(cost_of(map, path_)) {}

  RefractedCellPath run() {
    take(simplified(map_, path_));
    bool changed = true;
    for (int round = 0; round < kMostRounds && changed; ++round) {
      if (look_) look_();
      solve_parts();
      changed = turn_at_corners();
    }
    if (changed) solve_parts();
    straighten_runs();
    settle_beside_corners();
    return {path_, cost_, cost_ - excess(), !changed};
  }

 private:
  /// Where it is no dearer.
  bool take(const CellPath& path) {
    const double cost = cost_of(map_, path);
    if (!(cost <= cost_ * (1 + kSame))) return false;
    path_ = path;
    cost_ = cost;
    return true;
  }

  void solve_parts() {
    solve_parts([](const Part& part) { return least_places(part.chain, part.s); });
    polish_parts();
  }
  void polish_parts() {
    constexpr int kPolishes = 20;  // a place that comes to a corner parts the path anew
    for (int k = 0; k < kPolishes; ++k) {
      const CellPath before = path_;
      solve_parts([](const Part& part) {
        std::vector<double> s = part.s;
        polish(part.chain, s);
        return s;
      });
      if (path_.size() == before.size() && corners() == corners_of(before)) return;
    }
  }
  template <class Solve>
  void solve_parts(const Solve& solve) {
    CellPath next = {path_.front()};
    each_part(map_, path_, [&](std::size_t from, std::size_t to) {
      const Part part = part_of(map_, path_, from, to);
      std::vector<double> s = solve(part);
      snap(part.chain, s);
      append(part.chain, part.chain.cost(s) <= part.chain.cost(part.s) * (1 + kSame) ? s : part.s, next);
      next.push_back(path_[to]);
    });
    take(simplified(map_, next));
  }
  std::size_t corners_of(const CellPath& path) const {
    return static_cast<std::size_t>(
        std::count_if(path.begin(), path.end(), [&](const Vector2d& x) { return is_corner(map_, x); }));
  }
  std::size_t corners() const { return corners_of(path_); }

  /// Goes round corners where that is cheaper; whether it was anywhere.
  bool turn_at_corners() {
    CellPath next = {path_.front()};
    bool changed = false;
    for (std::size_t i = 1; i + 1 < path_.size(); ++i) {
      const bool turned = is_corner(map_, path_[i]) && turn_at(next.back(), path_[i], path_[i + 1], next);
      changed = changed || turned;
      if (!turned) next.push_back(path_[i]);
    }
    next.push_back(path_.back());
    return changed && take(simplified(map_, next));
  }
  bool turn_at(const Vector2d& a, const Vector2d& corner, const Vector2d& b, CellPath& next) const {
    const double now = leg_cost(map_, a, corner) + leg_cost(map_, corner, b);
    double least = now;
    CellPath best;
    for (const bool anticlockwise : {true, false}) {
      const auto turn = corner_turn(map_, a, corner, b, anticlockwise);
      if (!turn || !(steepest_fall(*turn, corner) > 0)) continue;
      std::vector<double> s;
      for (const Gate& gate : turn->chain.gates) s.push_back(corner[gate.axis]);
      s = least_places(turn->chain, s);
      polish(turn->chain, s);
      const double cost = turn->chain.cost(s);
      if (!(cost < least)) continue;
      least = cost;
      best.clear();
      append(turn->chain, s, best);
    }
    if (best.empty() || !(least < now - kSame * cost_)) return false;
    next.insert(next.end(), best.begin(), best.end());
    return true;
  }

  void straighten_runs() {
    const CellPath path = path_;
    const double cost = cost_, worst = worst_mismatch();
    if (!(worst > kSnell)) return;
    take(with_straight_runs(map_, path_));
    if (worst_mismatch() < worst) return;
    path_ = path;
    cost_ = cost;
  }
  /// Where two sides are crossed right beside their corner, and the least path goes through it as the cells around cost
  /// the same, the barrier keeps both places off it and Newton's steps do not bring them there.
  void settle_beside_corners() {
    const std::vector<Crossing> all = crossings();
    for (const Crossing& crossing : all)
      if (crossing.mismatch > kSnell + crossing.rounding) try_through(nearest_corner(crossing.place));
  }
  std::vector<Crossing> crossings() const {
    Eigen::Matrix2Xd polyline(2, static_cast<Eigen::Index>(path_.size()));
    for (std::size_t i = 0; i < path_.size(); ++i) polyline.col(static_cast<Eigen::Index>(i)) = path_[i];
    return measure_cell_crossings(map_, polyline);
  }
  double worst_mismatch() const {
    double worst = 0;
    for (const Crossing& crossing : crossings()) worst = std::max(worst, crossing.mismatch - crossing.rounding);
    return worst;
  }
  Vector2d nearest_corner(const Vector2d& x) const {
    Vector2d corner;
    for (const int axis : {0, 1}) {
      const CellRange cell = map_.touched(axis, x[axis]);
      const double low = map_.line(axis, cell.first), high = map_.line(axis, cell.last + 1);
      const double middle = map_.line(axis, cell.last);  // where x is on a line
      corner[axis] = cell.first < cell.last ? middle : x[axis] - low < high - x[axis] ? low : high;
    }
    return corner;
  }
  bool is_beside(const Vector2d& x, const Vector2d& corner) const {
    for (const int axis : {0, 1}) {
      const CellRange cell = map_.touched(axis, corner[axis]);
      const double size = map_.line(axis, cell.last + 1) - map_.line(axis, cell.last);
      if (!(std::abs(x[axis] - corner[axis]) <= kBesideCorner * size)) return false;
    }
    return true;
  }
  /// By a corner in the place of what lies beside it, where that costs no more and obeys Snell's law better.
  void try_through(const Vector2d& corner) {
    CellPath next;
    for (std::size_t i = 0; i < path_.size(); ++i) {
      const bool stays = i == 0 || i + 1 == path_.size() || !is_beside(path_[i], corner);
      const Vector2d& place = stays ? path_[i] : corner;
      if (next.empty() || next.back() != place) next.push_back(place);
    }
    const CellPath path = path_;
    const double cost = cost_, worst = worst_mismatch();
    path_ = simplified(map_, next);
    cost_ = cost_of(map_, path_);
    polish_parts();
    if (cost_ <= cost * (1 + kSame) && worst_mismatch() < worst) return;
    path_ = path;
    cost_ = cost;
  }

  double excess() const {
    const double places = static_cast<double>(path_.size());
    double sum = 8 * std::numeric_limits<double>::epsilon() * places * cost_;
    each_part(map_, path_, [&](std::size_t from, std::size_t to) {
      const Part part = part_of(map_, path_, from, to);
      sum += excess_above_least(part.chain, part.s);
    });
    return sum;
  }

  const CellMap& map_;
  const std::function<void()>& look_;
  CellPath path_;
  double cost_;
};

Crossing crossing_at(const CellMap& map, const Vector2d& a, const Vector2d& x, const Vector2d& b) {
  constexpr double kNoCrossing = 2;
  Crossing c;
  c.place = x;
  c.mismatch = kNoCrossing;
  const auto before = map.leg(a, x), after = map.leg(x, b);
  if (!before || !after) return c;
  const double larger = std::max(before->unit, after->unit);
  c.from = before->row * map.columns() + before->column;
  c.to = after->row * map.columns() + after->column;
  c.index_before = before->unit;
  c.index_after = after->unit;
  const double ulps = 16 * std::numeric_limits<double>::epsilon() *
                      std::max({a.cwiseAbs().maxCoeff(), x.cwiseAbs().maxCoeff(), b.cwiseAbs().maxCoeff()});
  c.rounding = ulps * (1 / (x - a).norm() + 1 / (b - x).norm());
  if (leg_cost(map, a, b) < (before->cost + after->cost) * (1 - kSame)) return c;  // within one cell
  if (is_corner(map, x)) {
    c.mismatch = 0;
    for (const bool anticlockwise : {true, false})
      if (const auto turn = corner_turn(map, a, x, b, anticlockwise))
        c.mismatch = std::max(c.mismatch, steepest_fall(*turn, x) / larger);
    return c;
  }
  const auto gate = gate_of(map, x);
  if (!gate) return c;
  c.interface = *map.line_at(1 - gate->axis, gate->line);
  const Vector2d u = (x - a).normalized(), v = (b - x).normalized();
  const int across = 1 - gate->axis;
  c.angle_before = std::atan2(std::abs(u[gate->axis]), std::abs(u[across]));
  c.angle_after = std::atan2(std::abs(v[gate->axis]), std::abs(v[across]));
  c.slowness = before->unit * std::abs(u[gate->axis]);
  c.mismatch = std::abs(before->unit * u[gate->axis] - after->unit * v[gate->axis]) / larger;
  return c;
}

}  // namespace

RefractedCellPath refract_in_cells(const CellMap& map, const CellPath& path, const std::function<void()>& look) {
  return Refraction(map, path, look).run();
}

std::vector<Crossing> measure_cell_crossings(const CellMap& map, const Eigen::Ref<const Eigen::Matrix2Xd>& polyline) {
  std::vector<Crossing> all;
  double cost = 0;
  for (Eigen::Index i = 0; i + 1 < polyline.cols(); ++i) cost += leg_cost(map, polyline.col(i), polyline.col(i + 1));
  for (Eigen::Index i = 1; i + 1 < polyline.cols(); ++i) {
    const Vector2d a = polyline.col(i - 1), x = polyline.col(i), b = polyline.col(i + 1);
    all.push_back(crossing_at(map, a, x, b));
    // An end a rounding away from a corner, say: whatever the angle is, going past x saves no more than twice this leg.
    const double to_end =
        std::min(i == 1 ? leg_cost(map, a, x) : cost, i + 2 == polyline.cols() ? leg_cost(map, x, b) : cost);
    if (std::isfinite(cost) && 2 * to_end <= kSame * cost) all.back().rounding = 2;
  }
  if (polyline.cols() == 2 && !map.leg(polyline.col(0), polyline.col(1))) {
    Crossing c;
    c.place = (polyline.col(0) + polyline.col(1)) / 2;
    c.mismatch = 2;
    all.push_back(c);
  }
  return all;
}

}  // namespace leastcost
