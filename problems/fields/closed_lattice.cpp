// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/fields/closed_lattice.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/domain/has_images.hpp>
#include <leastcost/framework/domain/manifold.hpp>

namespace leastcost {
namespace {

using Eigen::Vector2d;

constexpr double kOpen = std::numeric_limits<double>::infinity();
constexpr std::int64_t kNoNode = -1;

/// A side at which a coordinate has no length, as at the apex of a cone, is moved inward by a rounding error: the cost
/// of moves there is then small, and not 0.
void leave_singular_sides(const HasChart& chart, ChartBox& box) {
  constexpr double kRounding = 1e-9;
  if (!box.complete()) return;
  const Vector2d size = box.upper - box.lower, middle = box.lower + size / 2;
  for (int c = 0; c < 2; ++c)
    for (const bool high : {false, true}) {
      Vector2d u = middle;
      u[c] = high ? box.upper[c] : box.lower[c];
      Points jacobian;
      chart.jacobians({u, {}, true}, jacobian);
      if ((jacobian.colwise().squaredNorm().array() == 0).any())
        (high ? box.upper : box.lower)[c] += (high ? -kRounding : kRounding) * size[c];
    }
}

/// Between two poles, or on from one.
void end_at_poles(const HasChart& chart, ChartBox& box) {
  const std::vector<SeamMap>& poles = chart.poles();
  box.poles = poles;
  for (int c = 0; c < 2; ++c) {
    double least = kOpen, most = -kOpen;
    for (const SeamMap& pole : poles)
      if (!pole.identity() && pole.sign[c] < 0) {
        least = std::min(least, pole.shift[c] / 2);
        most = std::max(most, pole.shift[c] / 2);
      }
    if (least < kOpen) box.lower[c] = std::max(box.lower[c], least);
    if (most > least) box.upper[c] = std::min(box.upper[c], most);
  }
}

}  // namespace

ChartBox chart_box(const Problem& problem) {
  ChartBox box;
  const ConstraintManifold& domain = *problem.manifold;
  const auto* chart = find_ability<HasChart>(domain);
  const auto* closing = find_ability<HasSeams>(domain);
  if (chart == nullptr || closing == nullptr) {
    const auto* images = find_ability<HasImages>(domain);
    if (images != nullptr && !images->images(problem.source.u, problem.source.u, 1).empty())
      throw InputError(
          "field: joints, headings and other angles that are no coordinates of a surface have none; leastcost run "
          "gives the least cost between two places, with --pairs between many");
    return box;
  }
  const Eigen::Matrix2d edges = closing->edges();
  box.lower = edges.col(0), box.upper = edges.col(1);
  end_at_poles(*chart, box);
  for (const Seam& seam : closing->seams()) {
    const int c = seam.coordinate;
    const bool cut = std::isfinite(box.lower[c]) || std::isfinite(box.upper[c]);
    if (cut) continue;
    box.lower[c] = -seam.period / 2, box.upper[c] = seam.period / 2;
    box.seams.push_back(seam);
  }
  leave_singular_sides(*chart, box);
  return box;
}

void close_lattice(const std::vector<Seam>& seams, bool equal_steps, IsotropicMarch::Lattice& lattice) {
  constexpr double kRounding = 1e-6;
  for (const Seam& seam : seams) {
    const auto d = static_cast<std::size_t>(seam.coordinate);
    double& step = lattice.step[seam.coordinate];
    auto cells = static_cast<std::int32_t>(std::lround(seam.period / step));
    const bool fits = std::abs(cells * step - seam.period) <= kRounding * seam.period && cells % 2 == 0;
    if (!fits && equal_steps)
      throw InputError(
          "field: an .asc file has equal steps along both sides, and these do not divide what closes on itself into an "
          "even number of steps: choose another --resolution, or write .csv or .npy");
    if (!fits) cells = 2 * std::max(2, static_cast<std::int32_t>(std::ceil(seam.period / step / 2 - kRounding)));
    step = seam.period / cells;
    lattice.count[d] = cells + 1;
  }
}

LaidOut::LaidOut(const IsotropicMarch::Lattice& closed, const std::vector<Seam>& seams)
    : closed_(closed), wide_(closed), seams_(seams) {
  // Those that turn another coordinate over come first: it may have a seam of its own.
  std::stable_partition(seams_.begin(), seams_.end(), [](const Seam& seam) { return seam.flipped.has_value(); });
  for (const Seam& seam : seams_) {
    const auto d = static_cast<std::size_t>(seam.coordinate);
    before_[d] = closed.count[d] / 2;
    wide_.count[d] += 2 * before_[d];
    wide_.lower[seam.coordinate] -= before_[d] * closed.step[seam.coordinate];
  }
}

std::int64_t LaidOut::closed_node(std::int32_t i, std::int32_t j) const {
  std::array<std::int32_t, 2> at = {i - before_[0], j - before_[1]};
  for (const Seam& seam : seams_) {
    const auto d = static_cast<std::size_t>(seam.coordinate);
    const std::int32_t cells = closed_.count[d] - 1;
    const std::int32_t turns = (at[d] >= 0 ? at[d] : at[d] - cells + 1) / cells;
    at[d] -= turns * cells;
    if (!seam.flipped || turns % 2 == 0) continue;
    const auto flipped = static_cast<std::size_t>(*seam.flipped);  // whose nodes lie evenly around 0
    at[flipped] = closed_.count[flipped] - 1 - at[flipped];
  }
  if (at[0] < 0 || at[1] < 0 || at[0] >= closed_.count[0] || at[1] >= closed_.count[1]) return kNoNode;
  return std::int64_t(at[1]) * closed_.count[0] + at[0];
}

std::vector<Eigen::VectorXd> LaidOut::images(const std::vector<Eigen::VectorXd>& places) const {
  constexpr double kRounding = 1e-9;
  const Vector2d upper = wide_.place(wide_.count[0] - 1, wide_.count[1] - 1);
  const double slack = kRounding * (upper - wide_.lower).maxCoeff();
  std::vector<Eigen::VectorXd> all = places;
  const auto count = static_cast<Index>(seams_.size());
  const int ways = count == 1 ? 3 : 9;
  for (const Eigen::VectorXd& place : places)
    for (int k = 0; k < ways; ++k) {
      Eigen::VectorXi turns(count);
      for (Index s = 0; s < count; ++s) turns[s] = (s == 0 ? k % 3 : k / 3) - 1;
      if (turns.isZero()) continue;
      const Vector2d image = seam_map(seams_, 2, turns).apply(place);
      if (((image - wide_.lower).array() >= -slack).all() && ((upper - image).array() >= -slack).all())
        all.emplace_back(image);
    }
  return all;
}

std::vector<double> LaidOut::folded(const std::vector<double>& values) const {
  std::vector<double> least(std::size_t(closed_.count[0]) * std::size_t(closed_.count[1]), kOpen), all;
  std::size_t next = 0;
  for (std::int32_t j = 0; j < wide_.count[1]; ++j)
    for (std::int32_t i = 0; i < wide_.count[0]; ++i) {
      const double value = values[next++];
      const std::int64_t node = closed_node(i, j);
      if (node != kNoNode && value < least[std::size_t(node)]) least[std::size_t(node)] = value;
    }
  all.reserve(least.size());
  for (std::int32_t j = 0; j < closed_.count[1]; ++j)
    for (std::int32_t i = 0; i < closed_.count[0]; ++i) {
      const std::int64_t node = closed_node(before_[0] + i, before_[1] + j);
      all.push_back(node != kNoNode ? least[std::size_t(node)] : kOpen);
    }
  return all;
}

std::vector<double> LaidOut::unfolded(const std::vector<double>& values) const {
  std::vector<double> all;
  all.reserve(std::size_t(wide_.count[0]) * std::size_t(wide_.count[1]));
  for (std::int32_t j = 0; j < wide_.count[1]; ++j)
    for (std::int32_t i = 0; i < wide_.count[0]; ++i) {
      const std::int64_t node = closed_node(i, j);
      all.push_back(node != kNoNode ? values[std::size_t(node)] : std::numeric_limits<double>::quiet_NaN());
    }
  return all;
}

Eigen::VectorXd in_period(const IsotropicMarch::Lattice& lattice, const std::vector<Seam>& seams,
                          const std::vector<SeamMap>& poles, const Eigen::VectorXd& place) {
  if (place.size() != 2 || !place.allFinite()) return place;
  const Vector2d upper = lattice.place(lattice.count[0] - 1, lattice.count[1] - 1);
  Eigen::VectorXd named = place;
  for (const SeamMap& pole : poles) {
    if (pole.identity()) continue;
    const Eigen::VectorXd image = pole.apply(named);
    const auto beyond = [&](const Eigen::VectorXd& u, int c) {
      return std::max({0.0, lattice.lower[c] - u[c], u[c] - upper[c]});
    };
    for (int c = 0; c < 2; ++c)
      if (pole.sign[c] < 0 && beyond(image, c) < beyond(named, c)) {
        named = image;
        break;
      }
  }
  if (seams.empty()) return named;
  const Eigen::VectorXd middle = (lattice.lower + upper) / 2;
  const Eigen::VectorXi turns = nearest_image(seams, named, middle);
  return turns.isZero() ? named : seam_map(seams, 2, turns).apply(named);
}

}  // namespace leastcost
