// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/obstacles/grid_obstacle.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include "framework/base/point_text.hpp"
#include "problems/distance/grid_bounds.hpp"
#include "problems/obstacles/least_along.hpp"
#include "problems/readers/sdf_reader.hpp"

namespace leastcost {
namespace {

using Eigen::Vector3d;

constexpr double kBytesOfGiB = 0x1p30;
constexpr double kCellsDeep = 0.5;     ///< so far within the obstacle slopes and bends are bounded
constexpr double kLeastFound = 1e-10;  ///< sizes: how nearly the least distance of a segment is found
constexpr double kOfBounds = 1 + 1e-9;

class GridObstacle final : public Obstacle {
 public:
  GridObstacle(DistanceGrid grid, double radius, std::string name)
      : grid_(std::move(grid)),
        radius_(radius),
        name_(std::move(name)),
        lower_(grid_.shape().origin),
        upper_(grid_.shape().upper()),
        size_(std::max(lower_.cwiseAbs().maxCoeff(), upper_.cwiseAbs().maxCoeff())),
        deepest_(-kCellsDeep * grid_.shape().cell) {
    for (Eigen::Index i = 0; i < 3; ++i)  // by rounding the last node may lie beyond the grid, where there is no value
      while (!((upper_[i] - lower_[i]) / grid_.shape().cell <= grid_.shape().count[static_cast<std::size_t>(i)] - 1))
        upper_[i] = std::nextafter(upper_[i], lower_[i]);
    const GridBounds known = bounds_above(grid_, deepest_);
    const double border = least_on_border(grid_);
    if (!(known.slope > 0)) throw InputError(name_ + ": all its values are more than half a cell inside the obstacle");
    if (!(border > 0))
      throw InputError(name_ + ": on the border of the grid its values can be as low as " + short_number(border) +
                       ", so the obstacle would extend beyond it; make a grid with a wider margin");
    slope_ = kOfBounds * known.slope;
    bend_ = kOfBounds * known.bend / slope_;
    bend_beyond_ = bend_ + slope_ / border;
  }

  std::string name() const override { return name_; }
  /// Of the whole grid: what counts as the distance may be less than the distance from the obstacle.
  Box core_bounds() const override { return {Vector(lower_), Vector(upper_)}; }
  double radius() const override { return radius_; }
  Eigen::MatrixXd corners() const override { return {}; }  // asked for in the plane

  double distance(const Vector& x, Eigen::Ref<Vector> away) const override {
    Vector3d slope;
    const double value = this->value(Vector3d(x), slope);
    away = slope;
    return value;
  }

  /// Between the planes of the box it is smooth, with bounded bends.
  double distance_of_segment(const Vector& from, const Vector& to, double& t) const override {
    const Vector3d a = from, b = to, way = b - a;
    const double length = way.norm();
    std::array<double, 8> bends;  // those that there are not stand at the end
    bends.fill(1);
    bends[0] = 0;
    std::size_t count = 1;
    for (Eigen::Index i = 0; i < 3; ++i)
      for (const double side : {lower_[i], upper_[i]}) {
        const double at = (side - a[i]) / way[i];
        if (at > 0 && at < 1) bends[count++] = at;
      }
    std::sort(bends.begin(), bends.end());
    double least = std::numeric_limits<double>::infinity();
    Vector3d slope;
    for (std::size_t k = 0; k + 1 < bends.size(); ++k) {
      if (k > 0 && !(bends[k] < bends[k + 1])) continue;
      const Vector3d first = a + bends[k] * way;
      const double piece = (bends[k + 1] - bends[k]) * length;
      const Vector3d middle = a + (bends[k] + bends[k + 1]) / 2 * way;
      const bool within = (middle.array() >= lower_.array()).all() && (middle.array() <= upper_.array()).all();
      const auto along = [&](double s) {
        return value(length > 0 ? Vector3d(first + s / length * way) : first, slope);
      };
      const LineBounds known{1, within ? bend_ : bend_beyond_, deepest_ / slope_};
      const LeastValue found =
          least_along(along, piece, known, {kLeastFound * size_, 0, std::numeric_limits<double>::infinity(), false});
      if (found.lower < least) {
        least = found.lower;
        t = length > 0 ? bends[k] + found.at / length : 0;
      }
      if (!(least > 0)) break;
    }
    return std::max(0.0, least);
  }

 private:
  /// Nowhere changing by more than the place does.
  double value(const Vector3d& x, Vector3d& slope) const {
    const Vector3d nearest = x.cwiseMax(lower_).cwiseMin(upper_), off = x - nearest;
    const double value = std::max(deepest_, grid_.evaluate(nearest, slope)) / slope_;
    slope /= slope_;
    const double beyond = off.norm();
    if (!(beyond > 0)) return value;
    for (Eigen::Index i = 0; i < 3; ++i)
      if (off[i] != 0) slope[i] = 0;  // the nearest place does not move along it
    const double distance = std::hypot(value, beyond);
    slope = (value * slope + off) / distance;
    return distance;
  }

  DistanceGrid grid_;
  double radius_;
  std::string name_;
  Vector3d lower_, upper_;
  double size_, deepest_;
  double slope_ = 1, bend_ = 0, bend_beyond_ = 0;
};

}  // namespace

void GridObstacleOptions::fields(FieldVisitor& visit) {
  visit.file(
      "file", file,
      {.help = "Signed distances, negative inside the obstacle, in the text format of SDFGen.", .required = true});
  visit.field("radius", radius, {.help = "Thickness around the obstacle.", .unit = "length", .minimum = 0});
  visit.field("memory_limit", memory_limit,
              {.help = "Limit on the memory for the grid; a grid that needs more is refused.",
               .unit = "GiB",
               .minimum = 0,
               .exclusive_minimum = true});
}

std::shared_ptr<const Obstacle> make_grid_obstacle(DistanceGrid grid, double radius, const std::string& name) {
  if (!(radius >= 0) || !std::isfinite(radius)) throw OptionError("radius", "must be a number, at least 0");
  return std::make_shared<GridObstacle>(std::move(grid), radius, name);
}

std::shared_ptr<const Obstacle> make_grid_obstacle(const GridObstacleOptions& options,
                                                   const std::filesystem::path& folder) {
  GridSamples samples = read_sdf(folder / options.file, options.memory_limit * kBytesOfGiB);
  return make_grid_obstacle(DistanceGrid(samples.shape, std::move(samples.values)), options.radius,
                            "the grid " + std::filesystem::path(options.file).filename().string());
}

}  // namespace leastcost
