// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <limits>
#include <utility>
#include <vector>

#include "app/report/space/space_view.hpp"

namespace leastcost::app {

/// Red, green and blue, 0 to 255.
using Rgb = std::array<int, 3>;

inline constexpr Rgb kSurfaceColour = {230, 224, 210};  ///< of domains, in full light

/// A surface among others.
struct ImageLayer {
  TriangleSoup surface;
  Rgb colour = kSurfaceColour;
  double opacity = 1;        ///< below 1 what lies behind its nearest part shines through that part
  bool one_sided = false;    ///< not seen where its triangles run clockwise
  bool has_outline = false;  ///< dark lines at its creases, and around what stands before something else
  bool casts = false;        ///< a shadow
};

inline constexpr double kCrease = 0.5;  ///< cosine between normals: a sharper edge stays one

/// What a layer shows in one sample.
struct SeenSample {
  double depth = -std::numeric_limits<double>::infinity();
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< in the view, towards the eye
  bool there() const { return depth > -std::numeric_limits<double>::infinity(); }
};

/// What a layer shows in a part of a grid of samples, and nothing beside it.
class LayerInBand {
 public:
  LayerInBand(int left, int bottom, int columns, std::vector<SeenSample> seen)
      : left_(left), bottom_(bottom), columns_(columns), seen_(std::move(seen)) {}
  const SeenSample& at(int column, int row) const {
    static const SeenSample nothing;
    const int i = column - left_, j = row - bottom_;
    if (i < 0 || j < 0 || i >= columns_) return nothing;
    const std::size_t k =
        static_cast<std::size_t>(j) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(i);
    return k < seen_.size() ? seen_[k] : nothing;
  }

 private:
  int left_, bottom_, columns_;
  std::vector<SeenSample> seen_;  ///< row by row from below
};

/// A layer, ready to be looked at band by band.
class LayerOfImage {
 public:
  /// `layer` must outlive it.
  LayerOfImage(const ImageLayer& layer, const SpaceView& view);
  const ImageLayer& layer() const { return *layer_; }
  LayerInBand look(const PixelGrid& grid) const;

 private:
  const ImageLayer* layer_;
  SpaceView view_;
  std::vector<std::array<Eigen::Vector3d, 3>> normals_;  ///< at the corners of every triangle
  TriangleSoup turned_;                                  ///< as it lies in the view
  Eigen::AlignedBox2d box_;
};

}  // namespace leastcost::app
