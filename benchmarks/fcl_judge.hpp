// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/math/bv/OBBRSS.h>
#include <fcl/narrowphase/collision.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <vector>

#include <leastcost/framework/path/path.hpp>
#include "tests/support/app_scene.hpp"

namespace leastcost {

/// Whether a body meets the mesh somewhere on a path, by the collision library FCL and the meshes as they are: at
/// places between which no point of the body goes farther than `resolution` (length units).
class FclJudge {
 public:
  explicit FclJudge(const test::AppScene& scene)
      : planar_(scene.planar), world_(model(scene.world)), body_(model(scene.body)) {
    for (const auto& corners : scene.body)
      for (const Eigen::Vector3d& p : corners) farthest_ = std::max(farthest_, p.norm());
    if (planar_)
      for (const auto& corners : scene.body)
        lowest_ = std::min({lowest_, corners[0].z(), corners[1].z(), corners[2].z()});
  }

  /// A pose: x, y, angle, or x, y, z, w, x, y, z.
  bool meets(const Eigen::VectorXd& pose) const {
    fcl::Transform3d place = fcl::Transform3d::Identity();
    if (planar_) {
      place.translation() << pose[0], pose[1], kLift - lowest_;  // it stands on the ground
      place.linear() = Eigen::AngleAxisd(pose[2], Eigen::Vector3d::UnitZ()).toRotationMatrix();
    } else {
      place.translation() = pose.head<3>();
      place.linear() = Eigen::Quaterniond(pose[3], pose[4], pose[5], pose[6]).normalized().toRotationMatrix();
    }
    fcl::CollisionResultd result;
    return fcl::collide(world_.get(), fcl::Transform3d::Identity(), body_.get(), place, fcl::CollisionRequestd(),
                        result) > 0;
  }

  /// How many of the places that were looked at on the moves of a path meet the mesh.
  int meetings(const Points& poses, double resolution) const {
    int count = 0;
    for (Index i = 0; i + 1 < poses.cols(); ++i) {
      const Eigen::VectorXd a = poses.col(i), b = poses.col(i + 1);
      const Eigen::Index space = planar_ ? 2 : 3;
      const double turned = planar_ ? std::abs(b[2] - a[2]) : 4 * (b - a).tail<4>().norm();  // generously
      const double goes = (b - a).head(space).norm() + turned * farthest_;
      const double pieces = std::max(1.0, std::ceil(goes / resolution));
      for (double k = i == 0 ? 0 : 1; k <= pieces; ++k) count += meets(a + k / pieces * (b - a)) ? 1 : 0;
    }
    return count;
  }

 private:
  using Model = fcl::BVHModel<fcl::OBBRSSd>;
  static constexpr double kLift = 1e-3;

  static std::shared_ptr<Model> model(const std::vector<std::array<Eigen::Vector3d, 3>>& triangles) {
    auto out = std::make_shared<Model>();
    out->beginModel();
    for (const auto& [a, b, c] : triangles) out->addTriangle(a, b, c);
    out->endModel();
    return out;
  }

  bool planar_;
  double farthest_ = 0, lowest_ = 0;
  std::shared_ptr<Model> world_, body_;
};

}  // namespace leastcost
