// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "app/report/space/space_image.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>

#include "catalogue/inputs/png_image.hpp"
#include "problems/drawing/solids.hpp"

namespace leastcost::app {
namespace {

using Eigen::Vector3d;

constexpr int kSamples = 2;  ///< of a pixel, in each direction
constexpr int kBand = 64;    ///< rows of pixels that are made at once, so that memory does not grow with the image

/// Where the lamp is, in the view; of length 1.
Vector3d towards_lamp() { return {-0.34975, 0.54961, 0.75946}; }

/// Whether b, beside a, lies clearly behind it, or across a crease.
bool edge_between(const SeenSample& a, const SeenSample& b, double pixel) {
  constexpr double kSteep = 0.15, kJump = 4;  // of a normal, pixels
  if (!b.there()) return true;
  if (a.normal.dot(b.normal) < kCrease && a.depth >= b.depth - kJump * pixel) return true;
  return a.depth - b.depth > kJump * pixel / std::max(kSteep, std::min(a.normal[2], b.normal[2]));
}

/// All layers in one band of samples, with a row below and one above for edges.
class Band {
 public:
  Band(const std::vector<LayerOfImage>& layers, const PixelGrid& grid, const SpaceView& view, const DepthMap* lamp)
      : grid_(grid), view_(view), lamp_(lamp) {
    for (const LayerOfImage& layer : layers) {
      layers_.push_back(&layer.layer());
      seen_.push_back(layer.look(grid));
    }
    front_.assign(static_cast<std::size_t>(grid.columns) * static_cast<std::size_t>(grid.rows), -1);
    for (int row = 0; row < grid.rows; ++row)
      for (int column = 0; column < grid.columns; ++column) {
        double depth = -std::numeric_limits<double>::infinity();
        for (std::size_t k = 0; k < layers_.size(); ++k) {
          const SeenSample& seen = seen_[k].at(column, row);
          if (layers_[k]->opacity < 1 || !(seen.depth > depth)) continue;
          depth = seen.depth;
          front_[index(column, row)] = static_cast<int>(k);
        }
      }
  }

  Vector3d colour(int column, int row) const {
    constexpr double kWhite = 255;
    const std::size_t i = index(column, row);
    Vector3d out = Vector3d::Constant(kWhite);
    double depth = -std::numeric_limits<double>::infinity();
    if (front_[i] >= 0) {
      const auto k = static_cast<std::size_t>(front_[i]);
      depth = seen_[k].at(column, row).depth;
      out = shade(k, column, row);
      if (layers_[k]->has_outline && outlined(column, row)) out *= kInk;
    }
    std::vector<std::pair<double, std::size_t>> before;  // what shines through, the farthest first
    for (std::size_t k = 0; k < layers_.size(); ++k)
      if (const double at = seen_[k].at(column, row).depth; layers_[k]->opacity < 1 && at > depth)
        before.emplace_back(at, k);
    std::sort(before.begin(), before.end());
    for (const auto& [at, k] : before) {
      const bool ink = layers_[k]->has_outline && outlined_alone(k, column, row);
      const double opacity = ink ? (1 + layers_[k]->opacity) / 2 : layers_[k]->opacity;
      out += opacity * (shade(k, column, row) * (ink ? kInk : 1) - out);
    }
    return out;
  }

 private:
  static constexpr double kInk = 0.45;  ///< how dark a line is on what it is drawn on
  static constexpr std::array<std::array<int, 2>, 4> kBeside = {{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};

  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(grid_.columns) + static_cast<std::size_t>(column);
  }
  bool has(int column, int row) const { return column >= 0 && row >= 0 && column < grid_.columns && row < grid_.rows; }

  Vector3d shade(std::size_t k, int column, int row) const {
    constexpr double kShadow = 0.2, kOfShadow = 0.6;
    const SeenSample& seen = seen_[k].at(column, row);
    double light = lightness(seen.normal);
    if (lamp_ != nullptr && layers_[k]->opacity == 1 && light > kShadow) {
      const Eigen::Vector2d at = grid_.origin + grid_.pixel * Eigen::Vector2d(column, row);
      const Vector3d place = view_.axes.transpose() * Vector3d(at[0], at[1], seen.depth);
      if (!lamp_->sees(place)) light += kOfShadow * (kShadow - light);
    }
    const Rgb colour = colour_of_light(light, layers_[k]->colour);
    return {static_cast<double>(colour[0]), static_cast<double>(colour[1]), static_cast<double>(colour[2])};
  }

  /// Whether an opaque layer ends beside this sample, or goes round a corner.
  bool outlined(int column, int row) const {
    const auto k = static_cast<std::size_t>(front_[index(column, row)]);
    const SeenSample& here = seen_[k].at(column, row);
    for (const auto& [right, up] : kBeside) {
      if (!has(column + right, row + up)) continue;
      const std::size_t beside = index(column + right, row + up);
      if (front_[beside] < 0) return true;
      if (edge_between(here, seen_[static_cast<std::size_t>(front_[beside])].at(column + right, row + up), grid_.pixel))
        return true;
    }
    return false;
  }
  bool outlined_alone(std::size_t k, int column, int row) const {
    for (const auto& [right, up] : kBeside)
      if (has(column + right, row + up) &&
          edge_between(seen_[k].at(column, row), seen_[k].at(column + right, row + up), grid_.pixel))
        return true;
    return false;
  }

  PixelGrid grid_;
  SpaceView view_;
  const DepthMap* lamp_;
  std::vector<const ImageLayer*> layers_;
  std::vector<LayerInBand> seen_;
  std::vector<int> front_;  ///< the opaque layer that is seen; -1: none
};

/// What the lamp sees; nothing where no layer casts a shadow.
std::optional<DepthMap> lamp_of(const std::vector<ImageLayer>& layers, const SpaceView& view, int pixels) {
  constexpr int kMost = 1400;
  TriangleSoup all;
  for (const ImageLayer& layer : layers)
    if (layer.casts) append(all, layer.surface);
  if (all.triangles.empty()) return std::nullopt;
  SpaceView lamp;
  lamp.axes.row(2) = (view.axes.transpose() * towards_lamp()).transpose();
  lamp.axes.row(0) = lamp.direction().unitOrthogonal().transpose();
  lamp.axes.row(1) = lamp.axes.row(2).cross(lamp.axes.row(0));
  return DepthMap(all, lamp, std::min(pixels, kMost));
}

}  // namespace

double lightness(const Vector3d& normal) {
  constexpr double kAmbient = 0.4;  // what is turned away from the lamp still has some light
  return std::clamp((normal.dot(towards_lamp()) + kAmbient) / (1 + kAmbient), 0.0, 1.0);
}

Rgb colour_of_light(double lightness, const Rgb& full) {
  constexpr double kDark = 0.51;
  Rgb out = full;
  for (int& value : out) value = static_cast<int>(value * (kDark + (1 - kDark) * lightness));
  return out;
}

ShadedImage shaded_image(const std::vector<ImageLayer>& layers, const SpaceView& view, const Eigen::AlignedBox2d& area,
                         int pixels) {
  const double side = std::max(area.sizes().maxCoeff() / std::max(1, pixels), 1e-300);
  const int width = std::max(1, static_cast<int>(std::ceil(area.sizes()[0] / side - 1e-6))),
            height = std::max(1, static_cast<int>(std::ceil(area.sizes()[1] / side - 1e-6)));
  PixelGrid grid;
  grid.pixel = side / kSamples;
  grid.columns = kSamples * width;
  std::vector<LayerOfImage> ready;
  ready.reserve(layers.size());
  for (const ImageLayer& layer : layers) ready.emplace_back(layer, view);
  const std::optional<DepthMap> lamp = lamp_of(layers, view, kSamples * pixels);
  std::vector<std::uint8_t> rgb;
  rgb.reserve(std::size_t{3} * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (int top = height; top > 0; top -= kBand) {
    const int rows = std::min(kBand, top), bottom = top - rows;  // rows of pixels, from below
    grid.rows = kSamples * rows + 2;
    grid.origin = area.min() + grid.pixel * Eigen::Vector2d(0.5, kSamples * bottom - 0.5);
    const Band band(ready, grid, view, lamp ? &*lamp : nullptr);
    for (int row = rows - 1; row >= 0; --row)
      for (int column = 0; column < width; ++column) {
        Vector3d sum = Vector3d::Zero();
        for (int k = 0; k < kSamples * kSamples; ++k)
          sum += band.colour(kSamples * column + k % kSamples, 1 + kSamples * row + k / kSamples);
        for (const double value : sum) rgb.push_back(static_cast<std::uint8_t>(value / (kSamples * kSamples)));
      }
  }
  return {png_of_rgb(rgb, width, height), {area.min(), area.min() + side * Eigen::Vector2d(width, height)}};
}

ShadedImage shaded_image(const TriangleSoup& surface, const SpaceView& view, int pixels) {
  Eigen::AlignedBox2d area;
  for (const Vector3d& x : surface.vertices) area.extend(Eigen::Vector2d((view.axes * x).head<2>()));
  std::vector<ImageLayer> layers(1);
  layers[0].surface = surface;
  return shaded_image(layers, view, area, pixels);
}

}  // namespace leastcost::app
