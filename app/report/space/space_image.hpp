// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "app/report/space/image_layer.hpp"
#include "app/report/space/space_view.hpp"

namespace leastcost::app {

inline constexpr double kMostPixels = 3000;  ///< of an image, along its longer side

/// How light a surface is, 0 to 1, under a lamp above the left shoulder. `normal`: in the view, of length 1, on the
/// side that is seen.
double lightness(const Eigen::Vector3d& normal);
/// Its colour there. `full`: in full light.
Rgb colour_of_light(double lightness, const Rgb& full = kSurfaceColour);

/// Surfaces as an image.
struct ShadedImage {
  std::string png;           ///< bytes, on white
  Eigen::AlignedBox2d area;  ///< what it covers in the view
};
/// Of a part of the view. `pixels`: of its longer side.
ShadedImage shaded_image(const std::vector<ImageLayer>& layers, const SpaceView& view, const Eigen::AlignedBox2d& area,
                         int pixels);
/// Of all of one surface.
ShadedImage shaded_image(const TriangleSoup& surface, const SpaceView& view, int pixels);

}  // namespace leastcost::app
