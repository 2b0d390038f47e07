// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/robots/least_on_move.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <queue>
#include <utility>

namespace leastcost {
namespace {

constexpr int kMostMovePieces = 8000;

/// One of the values on a piece.
struct OnPiece {
  int which;
  double first, last;  ///< distances at the ends
};

struct MovePiece {
  double from, to, lower;
  std::vector<OnPiece> open;                                                    ///< what may have its least value here
  bool operator<(const MovePiece& other) const { return lower > other.lower; }  // the least first
};

}  // namespace

double least_distance_on_piece(const MovingDistance& known, double length, double d0, double d1) {
  const double cone = (d0 + d1 - known.speed * length) / 2;
  if (!(cone > 0)) return cone;
  const double bend = (known.speed * known.speed / cone + known.acceleration) * length * length;
  const double rise = std::abs(d1 - d0);
  if (rise >= bend / 2) return std::min(d0, d1);  // the lowest point of the parabola is beyond an end
  return std::max(cone, (d0 + d1) / 2 - bend / 8 - rise * rise / (2 * bend));
}

LeastOnMove least_on_move(const std::vector<MovingDistance>& all, DistancesOnMove& distances,
                          const MovePrecision& precision) {
  LeastOnMove least;
  if (all.empty()) return least;
  const auto known = [&](int i) -> const MovingDistance& { return all[static_cast<std::size_t>(i)]; };
  const auto take = [&](double t, const std::vector<int>& which, const std::vector<double>& values) {
    for (std::size_t k = 0; k < which.size(); ++k) {
      const double value = known(which[k]).value(values[k]);
      if (value < least.upper) least.upper = value, least.at = t, least.which = which[k];
    }
  };
  const auto settled = [&](double lower) {
    return lower >= precision.enough ||
           lower >= least.upper - std::max(precision.accuracy, precision.share * std::abs(least.upper));
  };
  const auto bound = [&](const OnPiece& one, double length) {
    return known(one.which).value(least_distance_on_piece(known(one.which), length, one.first, one.last));
  };
  double passed = std::numeric_limits<double>::infinity();  // the least bound of what needs no closer look
  const auto keep_open = [&](MovePiece& piece) {
    piece.lower = std::numeric_limits<double>::infinity();
    std::erase_if(piece.open, [&](const OnPiece& one) {
      const double lower = bound(one, piece.to - piece.from);
      const bool closed = settled(lower);
      if (closed)
        passed = std::min(passed, lower);
      else
        piece.lower = std::isnan(lower) ? -std::numeric_limits<double>::infinity() : std::min(piece.lower, lower);
      return closed;
    });
  };

  std::vector<int> which(all.size());
  std::iota(which.begin(), which.end(), 0);
  std::vector<double> first, last;
  distances.at(0, which, first);
  distances.at(1, which, last);
  take(0, which, first);
  take(1, which, last);
  MovePiece whole{0, 1, 0, {}};
  for (std::size_t k = 0; k < all.size(); ++k) whole.open.push_back({which[k], first[k], last[k]});
  keep_open(whole);
  std::priority_queue<MovePiece> open;
  if (!whole.open.empty()) open.push(std::move(whole));
  std::vector<double> middle;
  for (int pieces = 1; !open.empty() && pieces < kMostMovePieces && !(least.upper < precision.too_low); pieces += 2) {
    if (settled(open.top().lower) || open.top().lower == -std::numeric_limits<double>::infinity()) break;
    const MovePiece piece = open.top();
    open.pop();
    const double t = (piece.from + piece.to) / 2;
    which.clear();
    for (const OnPiece& one : piece.open) which.push_back(one.which);
    distances.at(t, which, middle);
    take(t, which, middle);
    const double half = (piece.to - piece.from) / 2;
    MovePiece left{piece.from, t, 0, {}}, right{t, piece.to, 0, {}};
    for (std::size_t k = 0; k < middle.size(); ++k) {
      const double around = known(which[k]).value(distances.least_around(t, half, which[k], middle[k]));
      if (settled(around)) {
        passed = std::min(passed, around);
        continue;
      }
      left.open.push_back({which[k], piece.open[k].first, middle[k]});
      right.open.push_back({which[k], middle[k], piece.open[k].last});
    }
    for (MovePiece* part : {&left, &right}) {
      keep_open(*part);
      if (!part->open.empty()) open.push(std::move(*part));
    }
  }
  least.lower = std::min(passed, least.upper);
  if (!open.empty()) least.lower = std::min(least.lower, open.top().lower);
  return least;
}

}  // namespace leastcost
