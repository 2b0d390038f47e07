// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/initializers/plane_cut.hpp>

#include <algorithm>
#include <limits>
#include <string>

#include <leastcost/framework/base/errors.hpp>
#include "framework/base/point_text.hpp"
#include "problems/mesh/mesh_curve.hpp"
#include "problems/section/plane_section.hpp"
#include "problems/section/smooth_section.hpp"

namespace leastcost {
namespace {

Eigen::Vector3d three_numbers(const Eigen::VectorXd& v, const char* key) {
  if (v.size() != 3) throw OptionError(key, "must have three coordinates");
  if (!v.allFinite()) throw OptionError(key, "coordinates must be finite");
  return v;
}

double distance(const SurfacePath& curve, const Eigen::Vector3d& p) {
  double best = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 1 < curve.points.size(); ++i) {
    const Eigen::Vector3d d = curve.points[i + 1] - curve.points[i], to = p - curve.points[i];
    const double t = d.squaredNorm() > 0 ? std::clamp(to.dot(d) / d.squaredNorm(), 0.0, 1.0) : 0.0;
    best = std::min(best, (to - t * d).norm());
  }
  return best;
}

std::string number_of_curves(int count) {
  return std::to_string(count) + (count == 1 ? " curve that ends" : " curves that end");
}

/// Why there is no closed curve.
std::string failure(const TriangleMesh& mesh, const SectionCurves& curves, const Eigen::Vector3d& point,
                    const Eigen::Vector3d& normal) {
  if (curves.at_border + curves.at_edge > 0) {
    std::string text = "the plane does not cut the mesh in a closed curve: ";
    if (curves.at_border > 0) text += number_of_curves(curves.at_border) + " at the border of the mesh";
    if (curves.at_border > 0 && curves.at_edge > 0) text += " and ";
    if (curves.at_edge > 0) text += number_of_curves(curves.at_edge) + " at an edge with three or more faces";
    return text;
  }
  double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
  for (const Eigen::Vector3d& p : mesh.positions()) {
    const double height = (p - point).dot(normal);
    lowest = std::min(lowest, height);
    highest = std::max(highest, height);
  }
  if (lowest < 0 && highest > 0) return "the plane passes between the parts of the mesh without cutting any";
  const double gap = std::max(lowest, -highest);
  if (gap > 0) return "the plane misses the mesh by " + short_number(gap) + " (length units)";
  return "the plane touches the mesh and does not cut it";
}

}  // namespace

void PlaneCutOptions::fields(FieldVisitor& visit) {
  visit.field("point", point,
              {.help = "A point of the plane. Of several closed curves, the nearest to it is taken (on a smooth "
                       "surface: one nearby).",
               .unit = "length",
               .required = true});
  visit.field("normal", normal, {.help = "Normal of the plane, of any length.", .required = true});
}

PlaneCutInitializer::PlaneCutInitializer(const PlaneCutOptions& options)
    : point_(three_numbers(options.point, "point")), normal_(three_numbers(options.normal, "normal")) {
  if (!(normal_.stableNorm() > 0)) throw OptionError("normal", "must not be zero");
  normal_.stableNormalize();
}

FirstPath PlaneCutInitializer::first_path(const Problem& problem, const Monitor& monitor) const {
  const ConstraintManifold& domain = *problem.manifold;
  const bool surface = domain.dimensions().ambient == 3 && domain.dimensions().tangent == 2;
  if (!surface || domain.shape() == Shape::flat)
    throw InputError("initializer plane_cut needs a surface in R^3: a mesh, a chart, a level set or a point cloud");
  if (!problem.ring)
    throw InitializationError("a plane cut is a closed curve, but this path has two ends: use path.ring: true");
  if (domain.shape() == Shape::smooth) {
    FirstPath first;
    first.path = smooth_section(domain, point_, normal_, monitor.limit());
    return first;
  }
  const TriangleMesh& mesh = mesh_of(problem, "initializer plane_cut").mesh();
  const SectionCurves curves = section_curves(mesh, point_, normal_, monitor.limit());
  if (curves.closed.empty()) throw InitializationError(failure(mesh, curves, point_, normal_));
  const auto nearer = [this](const SurfacePath& a, const SurfacePath& b) {
    return distance(a, point_) < distance(b, point_);
  };
  const SurfacePath& curve = *std::min_element(curves.closed.begin(), curves.closed.end(), nearer);
  FirstPath first;
  first.path = as_coordinates(problem, curve);
  first.path.ring = true;
  first.path.u.conservativeResize(Eigen::NoChange, first.path.u.cols() - 1);  // the closing point
  first.path.sites.pop_back();
  first.graph_vertices = static_cast<int>(first.path.u.cols());
  if (curves.closed.size() > 1)
    first.notes.push_back("plane_cut: the nearest of " + std::to_string(curves.closed.size()) + " closed curves");
  return first;
}

}  // namespace leastcost
