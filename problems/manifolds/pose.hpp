// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include <leastcost/framework/base/options.hpp>
#include <leastcost/framework/domain/has_origin.hpp>
#include <leastcost/problems/drawing/draws_itself.hpp>
#include <leastcost/problems/manifolds/box.hpp>
#include <leastcost/problems/manifolds/product.hpp>

namespace leastcost {

/// A box that the origin of a body stays in.
struct PoseOptions {
  BoxOptions box = {};
  void fields(FieldVisitor& visit);
};

/// The poses of a rigid body: where its origin is and how it is turned. Points are (x, y, angle) in the plane, with the
/// angle in radians, which all its turns name, and (x, y, z, qw, qx, qy, qz) in space, with a unit quaternion, which
/// its opposite names as well. Obstacles of the plane or of space keep the origin of the body out.
class PoseManifold final : public ProductManifold, public HasOrigin, public DrawsItself {
 public:
  /// SE(2) for place_size = 2, SE(3) for 3. Throws OptionError for a box that does not fit or is empty.
  PoseManifold(int place_size, const PoseOptions& options);
  int origin_size() const override { return origin_size_; }
  /// The box, where there is one.
  void draw(const DrawnPaths& paths, Drawing& out) const override;

 private:
  int origin_size_;
};

/// Poses in the plane, SE(2).
std::shared_ptr<const PoseManifold> make_planar_poses(const PoseOptions& options = {});
/// Poses in space, SE(3).
std::shared_ptr<const PoseManifold> make_spatial_poses(const PoseOptions& options = {});

}  // namespace leastcost
