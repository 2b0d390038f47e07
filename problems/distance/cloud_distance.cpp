// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/distance/cloud_distance.hpp"

#include <sstream>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/problems/cloud/cloud_surface.hpp>
#include "problems/cloud/unresolved.hpp"
#include "problems/distance/distance_signs.hpp"
#include "problems/distance/foot_points.hpp"

namespace leastcost {
namespace {

using Eigen::Vector3d;

constexpr double kSidesFrom =
    2;  ///< cells from the surface up to which nodes take their side from it; the others take it from them

constexpr double kAmong =
    0.4;  ///< supports between a foot and the nearest sample; 0.2 in the widest gap of an even cloud

class CloudDistance final : public DistanceSource {
 public:
  CloudDistance(PointCloud cloud, bool sides) : cloud_(std::move(cloud)), surface_(cloud_), sides_(sides) {
    for (const CloudSample& sample : cloud_.samples()) {
      if (!(sample.trust > 0)) continue;
      samples_.emplace_back(sample.position + cloud_.centre());
      box_.extend(samples_.back());
    }
  }
  CloudDistance(const CloudDistance&) = delete;  // the surface refers to the cloud beside it
  CloudDistance& operator=(const CloudDistance&) = delete;

  Eigen::AlignedBox3d box() const override { return box_; }
  std::vector<std::string> notes() const override { return cloud_.notes(); }
  bool is_sample() const override { return true; }
  double exact_cells() const override { return 4; }  // they take long, and a cloud is no exact surface
  std::shared_ptr<const DistanceSource> coarser() const override {
    return std::make_shared<CloudDistance>(cloud_.thinned(), sides_);
  }
  std::string why_unresolved(const Vector3d& x) const override {
    const std::optional<Foot> found = nearest(x);
    return found ? why_unresolved_at(surface_, found->position) : "";
  }
  std::optional<Vector3d> foot(const Vector3d& x) const override {
    const std::optional<Foot> found = nearest(x);
    return found ? std::optional<Vector3d>(found->position) : std::nullopt;
  }

  std::vector<double> sample(const GridShape& shape, double exact, const BuildProgress& progress) const override {
    FootPointGrid field(shape);
    fill_band(
        field, samples_, exact, [this](const Vector3d& x, std::int32_t) { return nearest(x); }, progress);
    spread_feet(field, progress);
    std::vector<double> values = std::move(field.distance);
    if (!sides_) return values;
    std::vector<std::int8_t> signs = std::move(field.side);
    for (std::size_t i = 0; i < signs.size(); ++i)
      if (values[i] > kSidesFrom * shape.cell) signs[i] = 0;
    if (const auto both = spread_signs(shape, values, std::move(signs))) throw InputError(no_sides(*both));
    return values;
  }

 private:
  /// Down the gradients of the moving least squares first; that foot then moves along its tangent plane until x lies
  /// above it.
  std::optional<Foot> nearest(const Vector3d& x) const {
    constexpr int kMostMoves = 4;
    constexpr double kConverged = 1e-3;  // of the distance: it then errs by 5e-7 of itself
    Foot result{x};
    if (!surface_.project(result.position) || !among_samples(result.position)) return std::nullopt;
    for (int i = 0;; ++i) {
      const std::optional<Vector3d> normal = surface_.normal(result.position);
      if (!normal) return std::nullopt;
      const Vector3d way = x - result.position;
      const double height = normal->dot(way);
      const Vector3d along = way - height * *normal;
      result.side = height < 0 ? std::int8_t{-1} : std::int8_t{1};
      if (i == kMostMoves || along.squaredNorm() <= kConverged * kConverged * way.squaredNorm()) return result;
      Vector3d moved = result.position + along;
      if (!surface_.project(moved) || !((x - moved).squaredNorm() < way.squaredNorm())) return result;
      result.position = moved;
    }
  }

  /// Whether samples lie around a point: far from all of them, by noise or outliers, moving least squares have zeros of
  /// no meaning.
  bool among_samples(const Vector3d& x) const {
    const Neighbour sample = cloud_.search().nearest(x - cloud_.centre());
    const double reach = kAmong * cloud_.radius(sample.index);
    return sample.squared_distance <= reach * reach && cloud_.sample(sample.index).trust > 0;
  }

  std::string no_sides(const Vector3d& x) const {
    std::ostringstream out;
    out.precision(6);
    out << "the surface of the cloud has no inside: both its sides are connected to (" << x[0] << ", " << x[1] << ", "
        << x[2]
        << ") without crossing it. Causes are a partial scan, holes wider than the radius, or normals that disagree. "
           "Use the surface at a distance from it (sign: unsigned, offset)";
    return out.str();
  }

  PointCloud cloud_;
  CloudSurface surface_;
  bool sides_;
  std::vector<Vector3d> samples_;
  Eigen::AlignedBox3d box_;
};

}  // namespace

std::shared_ptr<const DistanceSource> make_cloud_distance(PointCloud cloud, bool sides) {
  return std::make_shared<CloudDistance>(std::move(cloud), sides);
}

}  // namespace leastcost
