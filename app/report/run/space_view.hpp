// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "app/report/run/run_parts.hpp"
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
  /// `pixels`: of the longer side, at least 2.
  DepthMap(const TriangleSoup& surface, const SpaceView& view, int pixels);
  /// Whether a point is seen, or hidden by no more than the depth of some pixels.
  bool sees(const Eigen::Vector3d& x) const;

  int columns() const { return columns_; }
  int rows() const { return rows_; }
  /// What is seen in a pixel, rows from below; -1: nothing.
  int triangle(int column, int row) const { return front_[index(column, row)]; }
  /// The middle of a pixel in the view, and the side of one.
  Eigen::Vector2d middle(int column, int row) const {
    return origin_.head<2>() + pixel_ * Eigen::Vector2d(column, row);
  }
  double pixel() const { return pixel_; }

 private:
  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column);
  }
  void draw(int number, const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c);

  SpaceView view_;
  Eigen::Vector3d origin_ = Eigen::Vector3d::Zero();
  double pixel_ = 1;
  int columns_ = 0, rows_ = 0;
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

/// The scene without perspective: hidden parts of the path are thin.
Sketch space_sketch(const RunFiles& files, const SpaceView& view, const Look& look);

/// How light a surface is, 0 to 1, under a lamp above the left shoulder. `normal`: in the view, of length 1, on the
/// side that is seen.
double lightness(const Eigen::Vector3d& normal);
/// Its colour, red, green and blue.
std::array<int, 3> colour_of_light(double lightness);

/// A surface as an image.
struct ShadedImage {
  std::string png;           ///< bytes, on white
  Eigen::AlignedBox2d area;  ///< what it covers in the view
};
/// `pixels`: of its longer side.
ShadedImage shaded_image(const TriangleSoup& surface, const SpaceView& view, int pixels);

}  // namespace leastcost::app
