// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "catalogue/scene/scene.hpp"

namespace leastcost::app {

/// From where a scene is looked at, without perspective: rows are right, up and towards the eye.
struct SpaceView {
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  Eigen::Vector3d direction() const { return axes.row(2).transpose(); }
};

/// What hides what, seen from one side: the depths of a surface on a grid of pixels.
class DepthMap {
 public:
  DepthMap(const TriangleSoup& surface, const SpaceView& view, int pixels);
  /// Whether a point is seen, or hidden by no more than the depth of a pixel or two.
  bool sees(const Eigen::Vector3d& x) const;

 private:
  void draw(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c);

  SpaceView view_;
  Eigen::Vector3d origin_ = Eigen::Vector3d::Zero();
  double pixel_ = 1;
  int pixels_;
  std::vector<double> depth_;
};

/// A cloud as small squares, for what hides what.
TriangleSoup squares(const Surfels& surfels);

/// Of a few dozen sides, the one from which most of the path is seen, and at its largest. `surface`: best with a few
/// thousand triangles.
SpaceView choose_view(const TriangleSoup& surface, const Points& path, const Eigen::Vector3d& up);

/// The scene as a drawing, for where there is no 3D view: hidden parts of the path are thin. `markers`: points of the
/// path, `ends`: its ends, 3 x m.
std::string space_svg(const Scene& scene, const TriangleSoup& surface, const Points& markers, const Points& ends,
                      const SpaceView& view);

}  // namespace leastcost::app
