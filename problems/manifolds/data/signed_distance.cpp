// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/manifolds/data/signed_distance.hpp>

#include <Eigen/Geometry>
#include <array>
#include <sstream>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/problems/distance/build_distance_grid.hpp>
#include <leastcost/problems/readers/mesh_reader.hpp>
#include <leastcost/problems/readers/point_cloud_reader.hpp>
#include "problems/distance/cloud_distance.hpp"
#include "problems/distance/implicit_distance.hpp"
#include "problems/distance/mesh_distance.hpp"
#include "problems/drawing/domain_shapes.hpp"
#include "problems/mesh/weld_option.hpp"
#include "problems/readers/sdf_reader.hpp"

namespace leastcost {
namespace {

using Eigen::Vector3d;
constexpr double kGiB = 0x1p30;

using SourcePtr = std::shared_ptr<const DistanceSource>;

/// Half the sides of the box of a bounded surface with a name, around the origin.
std::optional<Vector3d> half_sides(const implicit::Sphere& s) { return Vector3d::Constant(s.radius); }
std::optional<Vector3d> half_sides(const implicit::Ellipsoid& s) { return Vector3d(s.axes); }
std::optional<Vector3d> half_sides(const implicit::Torus& s) {
  return Vector3d(s.major_radius + s.minor_radius, s.major_radius + s.minor_radius, s.minor_radius);
}
std::optional<Vector3d> half_sides(const implicit::Genus2&) {
  return Vector3d(2.5, 2.5, 1.2);  // other sheets of this polynomial lie beyond |z| = 1.5
}
std::optional<Vector3d> half_sides(const implicit::Gyroid&) { return std::nullopt; }
std::optional<Vector3d> half_sides(const implicit::PaperCurve&) { return std::nullopt; }
std::optional<Vector3d> half_sides(const implicit::Formula&) { return std::nullopt; }

/// The bounds that were given, or those of the surface.
Eigen::AlignedBox3d box_of(const distance_source::Implicit& o) {
  const Box given(3, o.box);
  if (given.lower().allFinite() && given.upper().allFinite()) return {Vector3d(given.lower()), Vector3d(given.upper())};
  if (given.bounded()) throw OptionError("box.lower", "the box needs both corners, with three numbers each");
  const auto half = std::visit([](const auto& surface) { return half_sides(surface); }, o.surface.surface);
  if (half) return {Vector3d(-*half), *half};
  const std::string type = std::visit([](const auto& s) { return std::string(s.kType); }, o.surface.surface);
  throw OptionError("box", "the surface '" + type + "' has no bounds of its own: give box: {lower: [..], upper: [..]}");
}

/// Keeps the function of a level set together with its owner.
std::shared_ptr<const ConstraintFunction> surface_function(const ImplicitManifoldOptions& options) {
  const std::shared_ptr<const LevelSet> set = make_implicit_manifold(options);
  if (set->function().inputs() != 3)
    throw OptionError("surface", "is a curve in the plane, but a grid needs a surface in space");
  return {set, &set->function()};
}

/// Whether the distances have a sign.
bool has_sides(const distance_source::Sides& o) { return o.sign == DistanceSign::with_sides; }

void check(const distance_source::Sides& o) {
  if (has_sides(o) && o.offset != 0) throw OptionError("offset", "is only for sign: unsigned");
  if (!has_sides(o) && !(o.offset > 0))
    throw OptionError("offset",
                      "must be greater than 0 with sign: unsigned: give the distance of the domain from the surface");
}

// What can be known about a source before anything is read or computed.
void check(const distance_source::Mesh& o) { check(o.sides); }
void check(const distance_source::PointCloud& o) { check(o.sides); }
void check(const distance_source::Implicit& o) {
  if (o.surface.box.given())
    throw OptionError(
        "lower", "a grid samples the whole surface: bounds are for 'type: implicit'; to limit the sampling, use 'box'");
  static_cast<void>(surface_function(o.surface));
  static_cast<void>(box_of(o));
}
void check(const distance_source::GridFile&) {}

SourcePtr open(const distance_source::Mesh& o, const std::filesystem::path& folder, const BuildProgress& progress) {
  report(progress, 0, "reading");
  return make_mesh_distance(TriangleMesh(read_mesh(folder / o.file), {o.weld, 0, o.weld_within}), has_sides(o.sides));
}

SourcePtr open(const distance_source::PointCloud& o, const std::filesystem::path& folder,
               const BuildProgress& progress) {
  report(progress, 0, "reading");
  return make_cloud_distance(PointCloud(read_point_cloud(folder / o.cloud.file), o.cloud.settings), has_sides(o.sides));
}

SourcePtr open(const distance_source::Implicit& o, const std::filesystem::path&, const BuildProgress& progress) {
  report(progress, 0, "distances");
  return make_implicit_distance(surface_function(o.surface), box_of(o));
}

double offset_of(const distance_source::Mesh& o) { return o.sides.offset; }
double offset_of(const distance_source::PointCloud& o) { return o.sides.offset; }
double offset_of(const distance_source::Implicit&) { return 0; }

using Made = std::shared_ptr<const SignedDistanceManifold>;

/// Samples a source on a grid.
template <class Source>
Made make(const Source& source, const SignedDistanceOptions& o, const std::filesystem::path& folder,
          const BuildProgress& progress) {
  SourcePtr opened;
  try {
    opened = open(source, folder, progress);
  } catch (const OptionError& error) {
    throw error.under("source");
  }
  try {
    const DistanceGridSettings settings{o.cell, o.accuracy, offset_of(source), o.margin, o.memory_limit * kGiB};
    return std::make_shared<SignedDistanceManifold>(build_distance_grid(*opened, settings, progress), opened);
  } catch (const OptionError& error) {
    throw error.key() == "offset" ? error.under("source") : error;
  }
}

/// Takes a grid as it is.
Made make(const distance_source::GridFile& source, const SignedDistanceOptions& o, const std::filesystem::path& folder,
          const BuildProgress& progress) {
  report(progress, 0, "reading");
  GridSamples samples = read_sdf(folder / source.file, o.memory_limit * kGiB);
  std::vector<std::string> notes = {"distance grid: " + text(samples.shape)};
  return std::make_shared<SignedDistanceManifold>(DistanceGrid(samples.shape, std::move(samples.values)),
                                                  std::move(notes));
}

}  // namespace

Words<DistanceSign> words(DistanceSign) {
  static constexpr std::array<Word<DistanceSign>, 2> kWords = {
      {{DistanceSign::with_sides, "signed"}, {DistanceSign::without_sides, "unsigned"}}};
  return kWords;
}

namespace distance_source {

void Sides::fields(FieldVisitor& visit, const char* help) {
  visit.choice("sign", sign, {.help = help});
  visit.field("offset", offset,
              {.help = "With sign: unsigned, the domain is the surface at this distance; at least 3 cells.",
               .unit = "length",
               .minimum = 0});
}

void Mesh::fields(FieldVisitor& visit) {
  visit.file("file", file, {.help = "Mesh file: OBJ, OFF, PLY or STL.", .required = true});
  visit_weld(visit, weld, weld_within);
  sides.fields(visit,
               "signed: for a closed mesh; inside is where its winding number is not 0. unsigned: for any mesh.");
}

void PointCloud::fields(FieldVisitor& visit) {
  cloud.fields(visit);
  sides.fields(
      visit, "signed: for a cloud that covers a closed surface; its normals point outwards. unsigned: for any cloud.");
}

void Implicit::fields(FieldVisitor& visit) {
  surface.fields(visit);
  visit.group("box", {.help = "Box around the surface; needed if the surface has no bounds of its own."},
              [this](FieldVisitor& inner) { box.fields(inner); });
}

void GridFile::fields(FieldVisitor& visit) { visit.file("file", file, {.help = "The .sdf file.", .required = true}); }

}  // namespace distance_source

void SignedDistanceOptions::fields(FieldVisitor& visit) {
  visit.variant("source", source, {.help = "Source of the distances.", .required = true});
  visit.field_or_zero(
      "cell", cell,
      {.help = "Side of a cell of the grid; 0: from `accuracy`, or 1/64 of the longest side of the surface.",
       .unit = "length",
       .minimum = 0});
  visit.field_or_zero("accuracy", accuracy,
                      {.help = "Instead of `cell`: largest distance between the surface of the grid and its source. "
                               "The cell is reduced until a measurement confirms it.",
                       .unit = "length",
                       .minimum = 0});
  visit.field("margin", margin,
              {.help = "Number of cells around the surface; paths cannot leave the grid.",
               .unit = "cells",
               .minimum = 1,
               .maximum = 1000});
  visit.field("memory_limit", memory_limit,
              {.help = "Limit on the memory to compute the grid; a grid that needs more is refused beforehand.",
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
  std::call_once(made_coarser_, [this] {
    coarser_ = make_coarser();
    has_coarser_ = true;
  });
  return coarser_;
}

std::string SignedDistanceManifold::why_unresolved(const CoordinatePath& path) const {
  if (!source_) return "";
  for (Index i = 0; i < path.u.cols(); ++i)
    if (std::string why = source_->why_unresolved(path.u.col(i)); !why.empty()) return why;
  return "";
}

std::string SignedDistanceManifold::why_not_projected(const Eigen::VectorXd& x) const {
  const Vector3d lower = grid_->shape().origin, upper = grid_->shape().upper();
  if ((x.array() >= lower.array()).all() && (x.array() <= upper.array()).all()) return LevelSet::why_not_projected(x);
  std::ostringstream out;
  out.precision(4);
  out << "the point is outside the grid, which extends from (" << lower[0] << ", " << lower[1] << ", " << lower[2]
      << ") to (" << upper[0] << ", " << upper[1] << ", " << upper[2] << "); for a larger grid, increase the margin";
  return out.str();
}

std::shared_ptr<const ConstraintManifold> SignedDistanceManifold::make_coarser() const {
  constexpr double kMisses = 4;
  const bool first = level_ == 0;
  if (level_ == 2 || (!first && !source_ && mean_miss_ == 0)) return nullptr;
  const auto grid_of = [&](const DistanceSource& coarse) {
    const GridShape shape = first ? every_second(grid_->shape()) : grid_->shape();
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

void check_signed_distance(const SignedDistanceOptions& options) {
  if (std::holds_alternative<distance_source::GridFile>(options.source) && (options.cell || options.accuracy))
    throw OptionError(options.cell ? "cell" : "accuracy", "the file gives the cell; remove this");
  if (options.cell && options.accuracy) throw OptionError("accuracy", "give either cell or accuracy, not both");
  try {
    std::visit([](const auto& source) { check(source); }, options.source);
  } catch (const OptionError& error) {
    throw error.under("source");
  }
}

std::shared_ptr<const SignedDistanceManifold> make_signed_distance_manifold(const SignedDistanceOptions& options,
                                                                            const std::filesystem::path& folder,
                                                                            const BuildProgress& progress) {
  check_signed_distance(options);
  return std::visit([&](const auto& source) { return make(source, options, folder, progress); }, options.source);
}

}  // namespace leastcost
