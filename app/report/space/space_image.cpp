// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "app/report/space/space_image.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

#include "catalogue/inputs/png_image.hpp"
#include "problems/drawing/solids.hpp"

namespace leastcost::app {
namespace {

using Eigen::Vector3d;

constexpr int kSamples = 2;      ///< of a pixel, in each direction
constexpr int kBand = 64;        ///< rows of pixels that are made at once, so that memory does not grow with the image
constexpr double kCrease = 0.5;  ///< cosine: a sharper edge stays one

using Corners = std::array<Vector3d, 3>;

/// Where the lamp is, in the view; of length 1.
Vector3d towards_lamp() { return {-0.34975, 0.54961, 0.75946}; }

const Vector3d& corner(const TriangleSoup& surface, std::size_t triangle, std::size_t k) {
  return surface.vertices[static_cast<std::size_t>(surface.triangles[triangle][k])];
}

/// Normals at the corners of every triangle: the mean of those around its vertex, but for what lies beyond a crease.
std::vector<Corners> smooth_normals(const TriangleSoup& surface) {
  std::vector<Vector3d> flat, weighted;
  std::vector<std::size_t> first(surface.vertices.size() + 1, 0);  // of the triangles around each vertex
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const Vector3d& a = corner(surface, t, 0);
    weighted.emplace_back((corner(surface, t, 1) - a).cross(corner(surface, t, 2) - a));
    flat.emplace_back(weighted.back().normalized());
    for (const int v : surface.triangles[t]) ++first[static_cast<std::size_t>(v) + 1];
  }
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<std::size_t> around(3 * surface.triangles.size()), next(first.begin(), first.end() - 1);
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    for (const int v : surface.triangles[t]) around[next[static_cast<std::size_t>(v)]++] = t;
  std::vector<Corners> all(surface.triangles.size());
  for (std::size_t t = 0; t < all.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto v = static_cast<std::size_t>(surface.triangles[t][k]);
      Vector3d sum = Vector3d::Zero();
      for (std::size_t i = first[v]; i < first[v + 1]; ++i)
        if (flat[around[i]].dot(flat[t]) > kCrease) sum += weighted[around[i]];
      all[t][k] = sum.normalized();
    }
  return all;
}

/// The weights of the corners of a triangle at a place of the view.
Vector3d weights(const Corners& seen, const Eigen::Vector2d& at) {
  const Eigen::Vector2d u = (seen[1] - seen[0]).head<2>(), v = (seen[2] - seen[0]).head<2>(),
                        p = at - seen[0].head<2>();
  const double area = u[0] * v[1] - u[1] * v[0];
  if (area == 0) return {1, 0, 0};
  const double s = (p[0] * v[1] - p[1] * v[0]) / area, t = (u[0] * p[1] - u[1] * p[0]) / area;
  return {1 - s - t, s, t};
}

/// What a layer shows in one sample.
struct Seen {
  double depth = -std::numeric_limits<double>::infinity();
  Vector3d normal = Vector3d::UnitZ();  ///< in the view, towards the eye
  bool there() const { return depth > -std::numeric_limits<double>::infinity(); }
};

/// What a layer shows in a part of a grid of samples, and nothing beside it.
class LayerInBand {
 public:
  LayerInBand(int left, int bottom, int columns, std::vector<Seen> seen)
      : left_(left), bottom_(bottom), columns_(columns), seen_(std::move(seen)) {}
  const Seen& at(int column, int row) const {
    static const Seen nothing;
    const int i = column - left_, j = row - bottom_;
    if (i < 0 || j < 0 || i >= columns_) return nothing;
    const std::size_t k =
        static_cast<std::size_t>(j) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(i);
    return k < seen_.size() ? seen_[k] : nothing;
  }

 private:
  int left_, bottom_, columns_;
  std::vector<Seen> seen_;  ///< row by row from below
};

/// A layer, ready to be looked at band by band.
class LayerOfImage {
 public:
  LayerOfImage(const ImageLayer& layer, const SpaceView& view)
      : layer_(&layer), view_(view), normals_(smooth_normals(layer.surface)) {
    turned_.triangles = layer.surface.triangles;
    for (const Vector3d& x : layer.surface.vertices) {
      turned_.vertices.emplace_back(view.axes * x);
      box_.extend(Eigen::Vector2d(turned_.vertices.back().head<2>()));
    }
  }
  const ImageLayer& layer() const { return *layer_; }

  LayerInBand look(const PixelGrid& grid) const {
    PixelGrid part = grid;
    const auto pixel = [&](double x, Eigen::Index i, int most) {
      return static_cast<int>(std::clamp((x - grid.origin[i]) / grid.pixel, 0.0, static_cast<double>(most)));
    };
    if (box_.isEmpty()) return {0, 0, 0, {}};
    const int left = pixel(box_.min()[0], 0, grid.columns), bottom = pixel(box_.min()[1], 1, grid.rows);
    part.columns = std::min(grid.columns, pixel(box_.max()[0], 0, grid.columns) + 2) - left;
    part.rows = std::min(grid.rows, pixel(box_.max()[1], 1, grid.rows) + 2) - bottom;
    if (part.columns <= 0 || part.rows <= 0) return {0, 0, 0, {}};
    part.origin += grid.pixel * Eigen::Vector2d(left, bottom);
    const DepthMap map(turned_, SpaceView{}, part, layer_->one_sided);
    std::vector<Seen> out(static_cast<std::size_t>(part.columns) * static_cast<std::size_t>(part.rows));
    std::size_t next = 0;
    for (int row = 0; row < part.rows; ++row)
      for (int column = 0; column < part.columns; ++column, ++next) {
        const int number = map.triangle(column, row);
        if (number < 0) continue;
        const auto t = static_cast<std::size_t>(number);
        const Vector3d &a = corner(turned_, t, 0), &b = corner(turned_, t, 1), &c = corner(turned_, t, 2);
        const Vector3d w = weights({a, b, c}, part.origin + part.pixel * Eigen::Vector2d(column, row));
        const Vector3d normal = view_.axes * (w[0] * normals_[t][0] + w[1] * normals_[t][1] + w[2] * normals_[t][2]);
        const bool from_behind = (b - a).cross(c - a)[2] < 0;
        out[next] = {map.depth(column, row), (from_behind ? -normal : normal).normalized()};
      }
    return {left, bottom, part.columns, std::move(out)};
  }

 private:
  const ImageLayer* layer_;
  SpaceView view_;
  std::vector<Corners> normals_;
  TriangleSoup turned_;  ///< as it lies in the view
  Eigen::AlignedBox2d box_;
};

/// Whether b, beside a, lies clearly behind it, or across a crease.
bool edge_between(const Seen& a, const Seen& b, double pixel) {
  constexpr double kSteep = 0.15, kJump = 4;  // pixels
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
          const Seen& seen = seen_[k].at(column, row);
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
    const Seen& seen = seen_[k].at(column, row);
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
    const Seen& here = seen_[k].at(column, row);
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
