// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>
#include <string>

#include "app/report/space/space_image.hpp"
#include "app/report/space/space_view.hpp"

namespace leastcost::app {

/// What is left free around a drawing, px.
struct Margins {
  double left = 8, right = 8, top = 8, bottom = 8;
};

/// Where points of space lie in a drawing.
class Projector {
 public:
  /// `area`: of the view, which fits into width and height (px) with the margins.
  Projector(const Eigen::AlignedBox2d& area, const SpaceView& view, double width, double height,
            const Margins& margins = {});
  double width() const { return margins_.left + 2 * half_[0] + margins_.right; }
  double height() const { return margins_.top + 2 * half_[1] + margins_.bottom; }
  /// Px per length unit.
  double scale() const { return scale_; }
  /// x and y in px, y downwards; z the depth, larger for what is nearer.
  Eigen::Vector3d place(const Eigen::Vector3d& x) const { return place_seen(view_.axes * x); }
  /// The same of a place of the view.
  Eigen::Vector3d place_seen(const Eigen::Vector3d& p) const;

 private:
  SpaceView view_;
  Margins margins_;
  Eigen::Vector2d middle_, half_;
  double scale_ = 1;
};

/// A polyline in two parts: what is seen, and what is hidden. `name`: class.
std::string line_in_space(const Points& x, const char* name, const Projector& projector, const DepthMap& depths);

/// Circles at points; hidden ones only with `hidden_too`.
std::string circles_in_space(const Points& x, const char* name, double radius, bool hidden_too,
                             const Projector& projector, const DepthMap& depths);

/// An image in its place.
std::string image_element(const ShadedImage& image, const Projector& projector);

/// A round length about a quarter as wide as the drawing, with what it is.
std::string length_bar(const Projector& projector, double top, const std::string& unit);

}  // namespace leastcost::app
