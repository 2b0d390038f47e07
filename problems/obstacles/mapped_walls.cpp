// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/obstacles/mapped_walls.hpp"

#include <utility>

namespace leastcost {

MappedWalls::MappedWalls(Eigen::Index dimension, std::vector<Eigen::Index> rows, std::shared_ptr<const Walls> walls)
    : dimension_(dimension), rows_(std::move(rows)), walls_(std::move(walls)) {}

/// Of a derivative or a direction: coordinates that are left out change nothing.
MappedWalls::Vector MappedWalls::back(const Vector& y) const {
  Vector x = Vector::Zero(dimension_);
  x(rows_) = y;
  return x;
}

void MappedWalls::map_slopes_back(std::vector<Wall>& found) const {
  for (Wall& wall : found)
    if (wall.slope.size() > 0) wall.slope = back(wall.slope);
}

void MappedWalls::near(const Vector& x, double reach, std::vector<Wall>& found) const {
  walls_->near(mapped(x), reach, found);
  map_slopes_back(found);
}

MoveClearance MappedWalls::clearance(const Vector& a, const Vector& b) const {
  MoveClearance least = walls_->clearance(mapped(a), mapped(b));
  if (all_rows() && least.place.size() > 0) least.place = back(least.place);
  return least;
}

void MappedWalls::along(const Vector& a, const Vector& b, double reach, std::vector<Wall>& found) const {
  walls_->along(mapped(a), mapped(b), reach, found);
  map_slopes_back(found);
}

double MappedWalls::room(const Vector& a, const Vector& b, double reach) const {
  return walls_->room(mapped(a), mapped(b), reach);
}

bool MappedWalls::planes(const Vector& a, const Vector& b, double reach, std::vector<SupportPlane>& found) const {
  const auto* has = find_ability<HasSupportPlanes>(*walls_);
  if (has == nullptr || !all_rows() || !has->planes(mapped(a), mapped(b), reach, found)) return false;
  for (SupportPlane& plane : found) {
    plane.normal = back(plane.normal);
    plane.place = back(plane.place);
  }
  return true;
}

bool MappedWalls::gaps_are_distances() const { return find_ability<GapsAreDistances>(*walls_) != nullptr; }

std::shared_ptr<const Walls> MappedWalls::remembering() const {
  std::shared_ptr<const Walls> inner = leastcost::remembering(*walls_);
  return inner != nullptr ? std::make_shared<const MappedWalls>(dimension_, rows_, std::move(inner)) : nullptr;
}

bool MappedWalls::clears(const Vector& a, const Vector& b) const {
  return leastcost::clears(*walls_, mapped(a), mapped(b));
}

void MappedWalls::draw(const DrawnPaths& paths, Drawing& out) const {
  constexpr Eigen::Index kSpace = 3;
  const auto* drawn = find_ability<DrawsItself>(*walls_);
  if (all_rows()) {
    if (drawn != nullptr) drawn->draw(paths, out);
    return;
  }
  Drawing plane;
  if (drawn != nullptr && dimension_ == kSpace && walls_->dimension() == 2) drawn->draw(paths, plane);
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

PoseStrip MappedWalls::pose_strip(const Points& configurations) const {
  return find_ability<DrawsPoses>(*walls_)->pose_strip(configurations(rows_, Eigen::all));
}

bool MappedWalls::has_poses() const { return find_ability<DrawsPoses>(*walls_) != nullptr; }

}  // namespace leastcost
