// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/obstacles/origin_walls.hpp"

#include <utility>

namespace leastcost {

OriginWalls::OriginWalls(Eigen::Index dimension, std::shared_ptr<const Walls> walls)
    : dimension_(dimension), walls_(std::move(walls)) {}

void OriginWalls::near(const Vector& x, double reach, std::vector<Wall>& found) const {
  walls_->near(origin(x), reach, found);
  extend_slopes(found);
}

/// Coordinates beyond those of the origin change no gap.
void OriginWalls::extend_slopes(std::vector<Wall>& found) const {
  for (Wall& wall : found) {
    const Eigen::Index own = wall.slope.size();
    if (own == 0) continue;
    wall.slope.conservativeResize(dimension_);
    wall.slope.tail(dimension_ - own).setZero();
  }
}

MoveClearance OriginWalls::clearance(const Vector& a, const Vector& b) const {
  return walls_->clearance(origin(a), origin(b));
}

void OriginWalls::along(const Vector& a, const Vector& b, double reach, std::vector<Wall>& found) const {
  walls_->along(origin(a), origin(b), reach, found);
  extend_slopes(found);
}

double OriginWalls::room(const Vector& a, const Vector& b, double reach) const {
  return walls_->room(origin(a), origin(b), reach);
}

std::string OriginWalls::obstacle_name(int obstacle) const { return walls_->obstacle_name(obstacle); }

void OriginWalls::draw(const DrawnPaths& paths, Drawing& out) const {
  constexpr Eigen::Index kSpace = 3;
  Drawing plane;
  if (dimension_ == kSpace && walls_->dimension() == 2) walls_->draw(paths, plane);
  const auto add = [](std::vector<Points>& outlines, std::vector<Points>& all) {
    for (Points& outline : outlines) {  // for the map, which looks from above
      outline.conservativeResize(kSpace, Eigen::NoChange);
      outline.bottomRows(1).setZero();
      all.push_back(std::move(outline));
    }
  };
  add(plane.obstacles, out.obstacles);
  add(plane.margins, out.margins);
  out.notes.emplace_back("obstacles depend on position only, not on height or angle, and are not drawn here");
}

}  // namespace leastcost
