// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/manifolds/angle.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace leastcost {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;
constexpr double kWholeTurn = 1 - 1e-9;  ///< of a turn: so much less is rounding
constexpr double kMostTurns = 1e6;       ///< beyond it an angle has lost too many digits to be another's image

Box limits_of(const AngleOptions& options) {
  BoxOptions box;
  if (options.lower) box.lower = Eigen::VectorXd::Constant(1, *options.lower);
  if (options.upper) box.upper = Eigen::VectorXd::Constant(1, *options.upper);
  return Box(1, box);
}

}  // namespace

AngleManifold::AngleManifold(const AngleOptions& options) : box_(limits_of(options)) {}

Projection AngleManifold::project(CoordinatePath& path) const {
  Projection result;
  if (!box_.bounded()) return result;
  const Points before = path.u;
  box_.clamp(path.u);
  result.moved = (path.u - before).cwiseAbs().maxCoeff();
  return result;
}

void AngleManifold::tangent_bases(const CoordinatePath& path, Points& bases) const { bases.setOnes(1, path.u.cols()); }

void AngleManifold::retract(const CoordinatePath& from, const Points& step, CoordinatePath& to) const {
  prepare_like(from, to);
  auto moved = to.u.middleCols(from.free_begin(), from.free_count());
  moved = from.u.middleCols(from.free_begin(), from.free_count()) + step;
  box_.clamp(moved);
}

double AngleManifold::residual(const CoordinatePath& path) const {
  CoordinatePath inside = path;
  return project(inside).moved;
}

int AngleManifold::active_bounds(const CoordinatePath& path, Index column, Eigen::Ref<Points> normals) const {
  return box_.active(path.u.col(column), normals);
}

std::vector<PointImage> AngleManifold::images(const Eigen::VectorXd& x, const Eigen::VectorXd& reference,
                                              std::size_t most) const {
  const double nearest = std::round((reference[0] - x[0]) / kTurn);
  std::vector<PointImage> all;
  if (!(std::abs(nearest) < kMostTurns)) return all;
  for (const double winding : {nearest - 1, nearest, nearest + 1}) {
    const double u = x[0] + winding * kTurn;
    if (winding == 0 || u < box_.lower()[0] || u > box_.upper()[0]) continue;
    all.push_back({Eigen::VectorXd::Constant(1, u), "winding (" + std::to_string(std::lround(winding)) + ")"});
  }
  std::stable_sort(all.begin(), all.end(), [&](const PointImage& a, const PointImage& b) {
    return std::abs(a.u[0] - reference[0]) < std::abs(b.u[0] - reference[0]);
  });
  if (all.size() > most) all.resize(most);
  return all;
}

SampleBox AngleManifold::sample_box(const Eigen::VectorXd& source, const Eigen::VectorXd& target) const {
  const Eigen::VectorXd lower = source.cwiseMin(target).array() - kTurn / 2;
  const Eigen::VectorXd upper = source.cwiseMax(target).array() + kTurn / 2;
  return {lower.cwiseMax(box_.lower()), upper.cwiseMin(box_.upper())};
}

bool AngleManifold::states_way(const Eigen::VectorXd& target, const Eigen::VectorXd& source) const {
  return std::abs(target[0] - source[0]) >= kWholeTurn * kTurn;
}

}  // namespace leastcost
