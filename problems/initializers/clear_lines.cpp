// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/initializers/clear_lines.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <leastcost/framework/problem/clearance.hpp>

namespace leastcost {
namespace {

using Place = Eigen::VectorXd;

constexpr int kMostIfQuick = 8;        ///< rounds of shortcuts
constexpr int kPiecesOfStep = 2;       ///< before they are bisected
constexpr double kLongestPiece = 1.5;  ///< a projected piece may be so much longer than the piece

using Places = std::vector<Place>;

double length(Places::const_iterator from, Places::const_iterator to) {
  double sum = 0;
  for (; from != to; ++from) sum += (*(from + 1) - *from).norm();
  return sum;
}

/// The k-th of the ends of equal pieces; the last is b itself.
Place part_way(const Place& a, const Place& b, int k, int pieces) {
  return k == pieces ? b : Place(a + static_cast<double>(k) / pieces * (b - a));
}

}  // namespace

ClearLines::ClearLines(const Problem& problem, double step)
    : problem_(problem),
      obstacles_(find_ability<ChecksMoves>(*problem.manifold)),
      box_(find_ability<HasBox>(*problem.manifold)),
      step_(step),
      lines_(*problem.manifold) {
  if (box_ != nullptr || find_ability<HasBounds>(*problem.manifold) == nullptr)
    decides_ = find_ability<DecidesMoves>(*problem.manifold);
}

/// Among quick obstacles a place is not pushed out of them: there will be others.
std::optional<Place> ClearLines::nearest(const Place& x) {
  if (!quick()) return lines_.nearest(x);
  return box_ != nullptr ? Place(x.cwiseMax(box_->box_lower()).cwiseMin(box_->box_upper())) : x;
}

/// The domain is flat, and convex: a box.
bool ClearLines::goes_straight(const Place& a, const Place& b) {
  if (!decides_->clears(a, b)) return false;
  const int pieces = pieces_of(a, b);
  for (int k = 0; k < pieces; ++k)
    if (!std::isfinite(move_cost(*problem_.cost, part_way(a, b, k, pieces), part_way(a, b, k + 1, pieces))))
      return false;
  return true;
}

int ClearLines::pieces_of(const Place& a, const Place& b) const {
  return std::max(1, static_cast<int>(std::ceil(kPiecesOfStep * (b - a).norm() / step_)));
}

bool ClearLines::append(const Place& a, const Place& b, std::vector<Place>& out) {
  const int pieces = pieces_of(a, b);
  if (quick()) {
    for (int k = 1; k <= pieces; ++k) out.push_back(part_way(a, b, k, pieces));
    return goes_straight(a, b);
  }
  if (!lines_.append(a, b, pieces, kLongestPiece * step_ / kPiecesOfStep, out)) return false;
  const Place* from = &a;
  for (const Place& to : out) {
    if (!std::isfinite(move_cost(*problem_.cost, *from, to))) return false;
    if (obstacles_ != nullptr && !goes_clear(*obstacles_, *from, to)) return false;
    from = &to;
  }
  return true;
}

bool ClearLines::is_clear(const Place& a, const Place& b) {
  if (quick()) return goes_straight(a, b);
  line_.clear();
  return append(a, b, line_);
}

Places ClearLines::in_pieces(const Places& nodes) const {
  Places path = {nodes.front()};
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
    const int pieces = pieces_of(nodes[i], nodes[i + 1]);
    for (int k = 1; k <= pieces; ++k) path.push_back(part_way(nodes[i], nodes[i + 1], k, pieces));
  }
  return path;
}

/// Between any two places of it, and more often between two that are near to each other, where a long path bends: in
/// rounds, until one has gained little. A solver takes much longer for what shortcuts leave to it than they take to
/// find it.
Places ClearLines::straightened(Places path, const Rounds& rounds, double longest, std::mt19937_64& engine,
                                const Monitor& monitor) {
  constexpr int kOneAnywhere = 4;   // of so many tries
  constexpr double kBeside = 0.25;  // of the length: half of what the others may span
  constexpr double kWorth = 1e-3;   // of the length: a shortcut that is tried
  std::vector<double> ends;         // of the segments, from the first node on
  const auto measure = [&] {
    ends.clear();
    double sum = 0;
    for (std::size_t i = 0; i + 1 < path.size(); ++i) ends.push_back(sum += (path[i + 1] - path[i]).norm());
  };
  const auto pick = [&](int k) -> std::pair<double, double> {
    const double all = ends.back(), one = uniform_number(engine) * all, other = uniform_number(engine);
    if (k % kOneAnywhere == 0) return std::minmax(one, other * all);
    const double half = kBeside * other * other * all;
    return {std::max(0.0, one - half), std::min(all, one + half)};
  };
  measure();
  double before = ends.back();
  const auto goes_on = [&](int round) {
    return before - ends.back() >= rounds.worth * before && (round < rounds.fewest || ends.back() <= longest);
  };
  for (int k = 0; k < rounds.most * rounds.tries && path.size() > 2 && !monitor.interrupted(); ++k) {
    if (k > 0 && k % rounds.tries == 0) {
      if (!goes_on(k / rounds.tries)) break;
      before = ends.back();
    }
    const auto [from, to] = pick(k);
    const auto segment_at = [&](double s) { return std::upper_bound(ends.begin(), ends.end() - 1, s) - ends.begin(); };
    const std::ptrdiff_t i = segment_at(from), j = segment_at(to);
    if (i == j) continue;
    const auto place = [&](std::ptrdiff_t segment, double s) -> Place {
      const auto n = static_cast<std::size_t>(segment);
      const double begin = n == 0 ? 0 : ends[n - 1], length = ends[n] - begin;
      return length > 0 ? Place(path[n] + (s - begin) / length * (path[n + 1] - path[n])) : path[n];
    };
    const Place a = place(i, from), b = place(j, to);
    if (!(to - from - (b - a).norm() > kWorth * ends.back()) || !goes_straight(a, b)) continue;
    path.insert(path.erase(path.begin() + i + 1, path.begin() + j + 1), {a, b});
    measure();
  }
  return path;
}

Places ClearLines::roughly_shortened(const Places& nodes, int tries, double longest, std::mt19937_64& engine,
                                     const Monitor& monitor) {
  constexpr int kShorter = 4, kMost = 8, kFewest = 2;  // rounds: times, at most, before a path may be given up
  constexpr double kWorth = 5e-3;
  if (!quick()) return shortened(nodes, tries, longest, engine, monitor);
  const Rounds rounds{std::max(1, tries / kShorter), kMost, kFewest, kWorth};
  return in_pieces(straightened(nodes, tries > 0 ? rounds : Rounds{}, longest, engine, monitor));
}

Places ClearLines::shortened(const Places& nodes, int tries, double longest, std::mt19937_64& engine,
                             const Monitor& monitor) {
  constexpr double kShorter = 1 - 1e-9, kWorth = 2.5e-3;
  if (quick()) return in_pieces(straightened(nodes, {tries, kMostIfQuick, 1, kWorth}, longest, engine, monitor));
  Places path = {nodes.front()};
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
    look_at_clock(monitor.deadline);
    line_.clear();
    append(nodes[i], nodes[i + 1], line_);
    path.insert(path.end(), line_.begin(), line_.end());
  }
  for (int k = 0; k < tries && path.size() > 2 && !monitor.interrupted(); ++k) {
    const auto pick = [&] {
      return static_cast<std::ptrdiff_t>(uniform_number(engine) * static_cast<double>(path.size()));
    };
    const auto [i, j] = std::minmax({pick(), pick()});
    if (j < i + 2) continue;
    const auto from = path.begin() + i, to = path.begin() + j;
    line_.clear();
    if (!append(*from, *to, line_)) continue;
    line_.insert(line_.begin(), *from);
    if (!(length(line_.begin(), line_.end() - 1) < kShorter * length(from, to))) continue;
    path.insert(path.erase(from, to + 1), line_.begin(), line_.end());
  }
  return path;
}

}  // namespace leastcost
