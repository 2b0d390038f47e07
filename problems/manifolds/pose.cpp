// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/manifolds/pose.hpp>

#include <leastcost/problems/manifolds/angle.hpp>
#include <leastcost/problems/manifolds/constraint.hpp>
#include <leastcost/problems/manifolds/euclidean.hpp>

namespace leastcost {
namespace {

ProductManifold::Factors place_and_turn(int place_size, const PoseOptions& options) {
  auto place = std::make_shared<const EuclideanManifold>(EuclideanManifoldOptions{place_size, options.box});
  if (place_size == 2) return {std::move(place), std::make_shared<const AngleManifold>()};
  ConstraintManifoldOptions rotations;
  rotations.set = constraint::Rotations{};
  return {std::move(place), make_constraint_manifold(rotations)};
}

std::vector<std::string> names_of_pose(int place_size) {
  if (place_size == 2) return {"x", "y", "angle"};
  return {"x", "y", "z", "qw", "qx", "qy", "qz"};
}

}  // namespace

void PoseOptions::fields(FieldVisitor& visit) {
  visit.field("lower", box.lower,
              {.help = "Lower corner of a box for the position; default: unbounded.", .unit = "length"});
  visit.field("upper", box.upper,
              {.help = "Upper corner of a box for the position; default: unbounded.", .unit = "length"});
}

PoseManifold::PoseManifold(int place_size, const PoseOptions& options)
    : ProductManifold(place_and_turn(place_size, options), names_of_pose(place_size)), origin_size_(place_size) {}

void PoseManifold::draw(const DrawnPaths&, Drawing& out) const {
  if (box_lower().array().isInf().all() && box_upper().array().isInf().all()) return;
  out.lower = box_lower();
  out.upper = box_upper();
}

std::shared_ptr<const PoseManifold> make_planar_poses(const PoseOptions& options) {
  return std::make_shared<const PoseManifold>(2, options);
}

std::shared_ptr<const PoseManifold> make_spatial_poses(const PoseOptions& options) {
  return std::make_shared<const PoseManifold>(3, options);
}

}  // namespace leastcost
