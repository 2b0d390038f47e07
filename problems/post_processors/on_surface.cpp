// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/post_processors/on_surface.hpp>

#include <Eigen/Geometry>
#include <algorithm>
#include <optional>
#include <sstream>
#include <utility>
#include <vector>

#include <leastcost/framework/base/checked.hpp>
#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/cost/segment_cost.hpp>
#include "problems/section/plane_station.hpp"
#include "problems/section/projected_line.hpp"

namespace leastcost {
namespace {

constexpr double kOfExtent = 1e-6;
constexpr double kMargin = 0.8;  ///< of the tolerance: the deviation is measured in three places only
constexpr int kDeepest = 20;     ///< bisections of a segment

/// The curves on a surface in space in which the planes of VFCS Eq. (16) cut it: each holds a chord and the mean of the
/// normals at its ends.
class CuttingPlanes {
 public:
  CuttingPlanes(const ConstraintManifold& manifold, const CoordinatePath& chain) : manifold_(manifold), chain_(chain) {
    const Dimensions d = manifold.dimensions();
    if (d.ambient == 3 && d.tangent == 2) manifold.tangent_bases(chain, bases_);
  }

  /// The plane of segment i, where there is one: in space, unless chord and normals are parallel or the normals
  /// opposite.
  std::optional<StationFinder> of_segment(Index i) const {
    if (bases_.size() == 0) return std::nullopt;
    const Index next = (i + 1) % chain_.u.cols();
    const Eigen::Vector3d a = chain_.u.col(i), chord = Eigen::Vector3d(chain_.u.col(next)) - a;
    Eigen::Vector3d n = normal(i), m = normal(next);
    if (n.dot(m) < 0) m = -m;
    const Eigen::Vector3d across = (n + m).cross(chord);
    if (!(across.norm() > kParallel * chord.norm())) return std::nullopt;
    return StationFinder(manifold_, a, across.normalized());
  }

 private:
  static constexpr double kParallel = 1e-6;

  Eigen::Vector3d normal(Index i) const {
    return Eigen::Vector3d(bases_.col(2 * i)).cross(Eigen::Vector3d(bases_.col(2 * i + 1)));
  }

  const ConstraintManifold& manifold_;
  const CoordinatePath& chain_;
  Points bases_;
};

/// Refines the segments of a chain; counts those that could not be refined far enough.
class Refiner {
 public:
  Refiner(const ConstraintManifold& manifold, double tolerance) : lines_(manifold), tolerance_(kMargin * tolerance) {}

  /// The plane that the points of the segments that follow are to lie in; nothing: the nearest points will do.
  void cut_by(std::optional<StationFinder> plane) { plane_ = std::move(plane); }

  int given_up() const { return given_up_; }
  const std::vector<Eigen::VectorXd>& points() const { return points_; }
  void start(const Eigen::VectorXd& x) { points_.push_back(x); }

  /// Appends a -> b without a.
  void segment(const Eigen::VectorXd& a, const Eigen::VectorXd& b, int depth = 0) {
    const std::optional<Eigen::VectorXd> middle = on_domain((a + b) / 2);
    // A nearest point as far away as the ends is on another sheet.
    const bool usable = middle && std::max((*middle - a).norm(), (*middle - b).norm()) < (b - a).norm();
    if (usable && ((*middle - (a + b) / 2).norm() > tolerance_ || off(a, b, 0.25) || off(a, b, 0.75))) {
      if (depth < kDeepest) {
        segment(a, *middle, depth + 1);
        return segment(*middle, b, depth + 1);
      }
      ++given_up_;
    }
    given_up_ += usable ? 0 : 1;
    points_.push_back(b);
  }

 private:
  std::optional<Eigen::VectorXd> on_domain(const Eigen::VectorXd& x) {
    if (plane_)
      if (const std::optional<Station> station = plane_->reach(x)) return station->u;
    return lines_.nearest(x);
  }

  bool off(const Eigen::VectorXd& a, const Eigen::VectorXd& b, double t) {
    const Eigen::VectorXd x = (1 - t) * a + t * b;
    const std::optional<Eigen::VectorXd> on = lines_.nearest(x);
    return on && (*on - x).norm() > tolerance_;
  }

  LineProjector lines_;
  std::optional<StationFinder> plane_;
  double tolerance_;
  int given_up_ = 0;
  std::vector<Eigen::VectorXd> points_;
};

}  // namespace

void OnSurfaceOptions::fields(FieldVisitor& visit) {
  visit.field("tolerance", tolerance,
              {.help = "Largest distance of the delivered curve from the domain; default: 1e-6 of its extent.",
               .unit = "length",
               .minimum = 0,
               .exclusive_minimum = true});
}

OnSurfacePostProcessor::OnSurfacePostProcessor(const OnSurfaceOptions& options) : options_(checked(options)) {
  if (options.tolerance && !(*options.tolerance > 0)) throw OptionError("tolerance", "must be greater than 0");
}

PostProcessed OnSurfacePostProcessor::apply(const Problem& problem, const FirstPath& first, PostProcessed current,
                                            const Monitor& monitor) const {
  const ConstraintManifold& manifold = *problem.manifold;
  if (manifold.shape() != Shape::smooth || manifold.dimensions().coordinate != manifold.dimensions().ambient)
    throw InputError("on_surface needs a smooth domain in its ambient space (implicit, constraint)");
  const Points& u = current.chain.u;
  const Index segments = current.chain.segment_count();
  // A ring that has collapsed has no extent; that of the first path says what is small.
  const double size = std::max(extent_of(u), first.path.u.cols() > 0 ? extent_of(first.path.u) : 0);
  const double tolerance = options_.tolerance.value_or(kOfExtent * size);
  const CuttingPlanes planes(manifold, current.chain);
  Refiner refiner(manifold, tolerance);
  refiner.start(u.col(0));
  std::vector<Index> ends = {0};  // of the segments, in the curve
  for (Index i = 0; i < segments; ++i) {
    if (monitor.interrupted()) return current;
    refiner.cut_by(planes.of_segment(i));
    refiner.segment(u.col(i), u.col((i + 1) % u.cols()));
    ends.push_back(static_cast<Index>(refiner.points().size()) - 1);
  }
  current.curve.x = as_open_path(refiner.points()).u;
  const Points& x = current.curve.x;
  const Eigen::VectorXd costs = segment_costs(*problem.cost, {{x.data(), x.rows(), x.cols()}, {}, current.chain.ring});
  current.curve.cost = costs.sum();
  for (Index i = 0; i < segments; ++i) {
    const Index begin = ends[static_cast<std::size_t>(i)], end = ends[static_cast<std::size_t>(i) + 1];
    current.curve_costs[i] = costs.segment(begin, end - begin).sum();
  }
  if (refiner.given_up() > 0) {
    std::ostringstream note;
    note << "on_surface: " << refiner.given_up() << " segments remain farther from the domain than " << tolerance;
    current.notes.push_back(note.str());
  }
  return current;
}

}  // namespace leastcost
