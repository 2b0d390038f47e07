// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/manifolds/signed_distance.hpp>

#include <Eigen/Geometry>
#include <sstream>
#include <utility>

#include <leastcost/framework/errors.hpp>
#include <leastcost/problems/distance/build_distance_grid.hpp>
#include <leastcost/problems/readers/mesh_reader.hpp>
#include <leastcost/problems/readers/point_cloud_reader.hpp>
#include "problems/distance/cloud_distance.hpp"
#include "problems/distance/implicit_distance.hpp"
#include "problems/distance/mesh_distance.hpp"
#include "problems/drawing/domain_shapes.hpp"
#include "problems/readers/sdf_reader.hpp"

namespace leastcost {
namespace {

using Eigen::Vector3d;
constexpr double kGiB = 0x1p30;

/// The bounds that were given, or those of a bounded surface with a name.
Eigen::AlignedBox3d box_of(const SignedDistanceOptions& o) {
  const Box given(3, o.box);
  if (given.lower().allFinite() && given.upper().allFinite()) return {Vector3d(given.lower()), Vector3d(given.upper())};
  if (given.bounded()) throw OptionError("box.lower", "the box needs both corners, three numbers each");
  const ImplicitManifoldOptions& s = o.implicit;
  Vector3d half;
  if (s.surface == "sphere")
    half.setConstant(s.radius);
  else if (s.surface == "ellipsoid")
    half = s.axes;
  else if (s.surface == "torus")
    half = Vector3d(s.major_radius + s.minor_radius, s.major_radius + s.minor_radius, s.minor_radius);
  else if (s.surface == "genus2")
    half = Vector3d(2.5, 2.5, 1.2);  // other sheets of this polynomial lie beyond |z| = 1.5
  else
    throw OptionError("box",
                      "the surface '" + s.surface + "' has no bounds of its own: give box: {lower: [..], upper: [..]}");
  return {Vector3d(-half), half};
}

/// Keeps the function of a level set together with its owner.
std::shared_ptr<const ConstraintFunction> surface_function(const ImplicitManifoldOptions& options) {
  const std::shared_ptr<const LevelSet> set = make_implicit_manifold(options);
  if (set->function().inputs() != 3)
    throw OptionError("surface", "a curve in the plane; a grid needs a surface in space");
  return {set, &set->function()};
}

std::shared_ptr<const DistanceSource> source_of(const SignedDistanceOptions& o, const std::filesystem::path& folder,
                                                const BuildProgress& progress) {
  try {
    if (o.source == "implicit") {
      if ((o.implicit.box.lower.size() > 0 || o.implicit.box.upper.size() > 0))
        throw OptionError("lower",
                          "a grid samples the whole surface: bounds are for 'type: implicit', 'box' says where "
                          "to sample");
      const auto function = surface_function(o.implicit);
      const Eigen::AlignedBox3d box = box_of(o);
      report(progress, 0, "distances");
      return make_implicit_distance(function, box);
    }
    const bool sides = o.sign == "signed";
    if (!sides && o.sign != "unsigned") throw OptionError("sign", "must be signed or unsigned");
    if (sides && o.offset != 0) throw OptionError("offset", "is for sign: unsigned");
    if (!sides && !(o.offset > 0))
      throw OptionError(
          "offset",
          "an unsigned distance has no gradient at 0: give the distance (> 0) at which the surface is wanted");
    if (o.source != "mesh" && o.source != "point_cloud") throw OptionError("type", "unknown source '" + o.source + "'");
    report(progress, 0, "reading");
    if (o.source == "mesh") return make_mesh_distance(TriangleMesh(read_mesh(folder / o.file), {o.weld, 0}), sides);
    return make_cloud_distance(PointCloud(read_point_cloud(folder / o.cloud.file), o.cloud.settings), sides);
  } catch (const OptionError& error) {
    throw OptionError("source." + error.key(), error.what());
  }
}

DistanceGridSettings settings_of(const SignedDistanceOptions& o) {
  if (o.cell > 0 && o.accuracy > 0) throw OptionError("accuracy", "give either the cell or the accuracy, not both");
  return {o.cell, o.accuracy, o.offset, o.margin, o.memory_limit * kGiB};
}

std::shared_ptr<const SignedDistanceManifold> from_file(const SignedDistanceOptions& o,
                                                        const std::filesystem::path& folder,
                                                        const BuildProgress& progress) {
  if (o.cell > 0 || o.accuracy > 0)
    throw OptionError(o.cell > 0 ? "cell" : "accuracy", "the file says what its cell is; leave this out");
  report(progress, 0, "reading");
  GridSamples samples = read_sdf(folder / o.file, o.memory_limit * kGiB);
  std::vector<std::string> notes = {"distance grid: " + text(samples.shape)};
  return std::make_shared<SignedDistanceManifold>(DistanceGrid(samples.shape, std::move(samples.values)),
                                                  std::move(notes));
}

}  // namespace

void SignedDistanceOptions::fields(FieldVisitor& visit) {
  const auto sides = [&](FieldVisitor& v, const char* help) {
    v.choice("sign", sign, {"signed", "unsigned"}, {.help = help});
    v.field("offset", offset,
            {.help = "With sign: unsigned, the domain is the surface at this distance; at least 3 cells.",
             .unit = "length",
             .minimum = 0});
  };
  visit.variant(
      "source", source,
      {{"mesh", "A triangle mesh.",
        [&](FieldVisitor& v) {
          v.file("file", file, {.help = "Mesh file: OBJ, OFF, PLY or STL.", .required = true});
          v.field("weld", weld, {.help = "Merges vertices with exactly equal positions (STL always is)."});
          sides(v, "signed: the mesh must be closed, inside is where its winding number is not 0. unsigned: any mesh.");
        }},
       {"point_cloud", "The smooth surface through a point cloud.",
        [&](FieldVisitor& v) {
          cloud.fields(v);
          sides(v, "signed: the cloud must go all around, inside is against its normals. unsigned: any cloud.");
        }},
       {"implicit", "A surface f(x, y, z) = 0, by name or as a formula.",
        [&](FieldVisitor& v) {
          implicit.fields(v);
          v.group("box", {.help = "Where the surface lies; needed where it has no bounds of its own."},
                  [&](FieldVisitor& b) { box.fields(b); });
        }},
       {"file", "A grid of distances in the text format of SDFGen, with its own cell.",
        [&](FieldVisitor& v) { v.file("file", file, {.help = "The .sdf file.", .required = true}); }}},
      {.help = "What distances are sampled from.", .required = true});
  visit.field("cell", cell,
              {.help = "Cell of the grid; 0: from the accuracy, or a 64th of the longest side of the surface.",
               .unit = "length",
               .minimum = 0});
  visit.field("accuracy", accuracy,
              {.help = "Instead of the cell: the largest distance that the surface of the grid may have from the one "
                       "it is made from; the cell "
                       "shrinks until a measurement says so.",
               .unit = "length",
               .minimum = 0});
  visit.field("margin", margin,
              {.help = "Cells around the surface; paths cannot leave the grid.",
               .unit = "cells",
               .minimum = 1,
               .maximum = 1000});
  visit.field("memory_limit", memory_limit,
              {.help = "Most memory that making the grid may take; a larger one is refused before it is made.",
               .unit = "GiB",
               .minimum = 0,
               .exclusive_minimum = true});
}

SignedDistanceManifold::SignedDistanceManifold(DistanceGrid grid, std::vector<std::string> notes)
    : SignedDistanceManifold(std::make_shared<const DistanceGrid>(std::move(grid)), std::move(notes)) {}

SignedDistanceManifold::SignedDistanceManifold(std::shared_ptr<const DistanceGrid> grid, std::vector<std::string> notes)
    : LevelSet(grid), grid_(std::move(grid)), notes_(std::move(notes)) {}

SignedDistanceManifold::SignedDistanceManifold(SampledDistance sampled,
                                               const std::shared_ptr<const DistanceSource>& source)
    : SignedDistanceManifold(std::move(sampled.grid), std::move(sampled.notes)) {
  offset_ = sampled.offset;
  mean_miss_ = sampled.mean;
  if (source->is_sample()) source_ = source;
}

void SignedDistanceManifold::draw(const DrawnPaths& paths, Drawing& out) const {
  const Surroundings whole{grid_->shape().origin, grid_->shape().upper()};
  out.surface = level_surface(*this, function(), around(paths.x), &whole, out.notes);
  out.up = up_of_data(out.surface.vertices);
}

std::shared_ptr<const ConstraintManifold> SignedDistanceManifold::coarser() const {
  std::call_once(made_coarser_, [this] { coarser_ = make_coarser(); });
  return coarser_;
}

std::string SignedDistanceManifold::why_not_projected(const Eigen::VectorXd& x) const {
  const Vector3d lower = grid_->shape().origin, upper = grid_->shape().upper();
  if ((x.array() >= lower.array()).all() && (x.array() <= upper.array()).all()) return LevelSet::why_not_projected(x);
  std::ostringstream out;
  out.precision(4);
  out << "it lies outside the grid, which goes from (" << lower[0] << ", " << lower[1] << ", " << lower[2] << ") to ("
      << upper[0] << ", " << upper[1] << ", " << upper[2] << "); a larger margin makes a larger grid";
  return out.str();
}

std::shared_ptr<const ConstraintManifold> SignedDistanceManifold::make_coarser() const {
  constexpr double kMisses = 4;
  const bool first = level_ == 0;
  if (level_ == 2 || (!first && !source_ && mean_miss_ == 0)) return nullptr;
  const auto grid_of = [&](const DistanceSource& coarse) {
    const GridShape shape = first ? grid_->every_second().shape() : grid_->shape();
    return DistanceGrid(shape, sample_distances(coarse, shape, offset_));
  };
  const std::shared_ptr<const DistanceSource> coarse = source_ ? source_->coarser() : nullptr;
  auto result = std::make_shared<SignedDistanceManifold>(coarse  ? grid_of(*coarse)
                                                         : first ? grid_->every_second()
                                                                 : grid_->raised(kMisses * mean_miss_));
  result->level_ = level_ + 1;
  result->offset_ = offset_;
  result->mean_miss_ = mean_miss_;
  result->source_ = coarse;
  return result;
}

std::shared_ptr<const SignedDistanceManifold> make_signed_distance_manifold(const SignedDistanceOptions& options,
                                                                            const std::filesystem::path& folder,
                                                                            const BuildProgress& progress) {
  if (options.source == "file") return from_file(options, folder, progress);
  const DistanceGridSettings settings = settings_of(options);
  const std::shared_ptr<const DistanceSource> source = source_of(options, folder, progress);
  try {
    return std::make_shared<SignedDistanceManifold>(build_distance_grid(*source, settings, progress), source);
  } catch (const OptionError& error) {
    throw error.key() == "offset" ? OptionError("source.offset", error.what()) : error;
  }
}

}  // namespace leastcost
