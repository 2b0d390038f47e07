// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "app/report/space/look.hpp"
#include "catalogue/scene/scene.hpp"

namespace leastcost::app {

/// From where a scene is looked at, without perspective: rows are right, up and towards the eye.
struct SpaceView {
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  Eigen::Vector3d direction() const { return axes.row(2).transpose(); }
};

/// A grid of pixels in the view: the middle of the lowest left one, the side of one.
struct PixelGrid {
  Eigen::Vector2d origin = Eigen::Vector2d::Zero();
  double pixel = 1;
  int columns = 0, rows = 0;
};

/// What hides what, seen from one side: the depths of a surface on a grid of pixels.
class DepthMap {
 public:
  /// `pixels`: of the longer side, at least 2.
  DepthMap(const TriangleSoup& surface, const SpaceView& view, int pixels);
  /// The part on a grid. `one_sided`: without triangles that are seen clockwise.
  DepthMap(const TriangleSoup& surface, const SpaceView& view, const PixelGrid& grid, bool one_sided = false);
  /// Whether a point is seen, or hidden by no more than the depth of some pixels.
  bool sees(const Eigen::Vector3d& x) const;

  const PixelGrid& grid() const { return grid_; }
  /// What is seen in a pixel, rows from below; -1: nothing.
  int triangle(int column, int row) const { return front_[index(column, row)]; }
  /// How near that is to the eye, length units; -infinity: nothing.
  double depth(int column, int row) const { return depth_[index(column, row)]; }

 private:
  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(grid_.columns) + static_cast<std::size_t>(column);
  }
  void draw_all(const TriangleSoup& surface, const std::vector<Eigen::Vector3d>& seen, bool one_sided);
  void draw(int number, const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c);

  SpaceView view_;
  PixelGrid grid_;
  std::vector<double> depth_;
  std::vector<int> front_;
};

/// A cloud as small squares, each a part of the spacing from its middle to its sides.
TriangleSoup squares(const Surfels& surfels, double half_side = 0.6);

/// From so many degrees around the vertical of the scene, from the x axis on (from y, if x is the vertical), and above
/// its horizon.
SpaceView view_from(const Angles& angles, const Eigen::Vector3d& up);
/// The inverse, in whole degrees.
Angles angles_of(const SpaceView& view, const Eigen::Vector3d& up);

/// Of a few dozen sides, the one from which most of the path is seen, and at its largest.
SpaceView choose_view(const Scene& scene);

}  // namespace leastcost::app
