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

constexpr int kPiecesOfStep = 2;       ///< before they are bisected
constexpr double kLongestPiece = 1.5;  ///< a projected piece may be so much longer than the piece

using Places = std::vector<Place>;

double length(Places::const_iterator from, Places::const_iterator to) {
  double sum = 0;
  for (; from != to; ++from) sum += (*(from + 1) - *from).norm();
  return sum;
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
bool ClearLines::append_straight(const Place& a, const Place& b, Places& out) {
  const int pieces = std::max(1, static_cast<int>(std::ceil(kPiecesOfStep * (b - a).norm() / step_)));
  for (int k = 1; k <= pieces; ++k) {
    const double t = static_cast<double>(k) / pieces;
    out.push_back(k < pieces ? Place((1 - t) * a + t * b) : b);
    if (!std::isfinite(move_cost(*problem_.cost, k > 1 ? out[out.size() - 2] : a, out.back()))) return false;
  }
  return decides_->clears(a, b);
}

bool ClearLines::append(const Place& a, const Place& b, std::vector<Place>& out) {
  if (quick()) return append_straight(a, b, out);
  const double distance = (b - a).norm();
  const int pieces = std::max(1, static_cast<int>(std::ceil(kPiecesOfStep * distance / step_)));
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
  line_.clear();
  return append(a, b, line_);
}

std::vector<Place> ClearLines::shortened(const std::vector<Place>& nodes, int tries, std::mt19937_64& engine,
                                         const Monitor& monitor) {
  constexpr double kShorter = 1 - 1e-9;
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
