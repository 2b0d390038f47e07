// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <leastcost/problems/distance/build_distance_grid.hpp>
#include <leastcost/problems/distance/has_distance_grid.hpp>
#include <leastcost/problems/manifolds/box.hpp>
#include <leastcost/problems/manifolds/data/point_cloud.hpp>
#include <leastcost/problems/manifolds/implicit.hpp>
#include <leastcost/problems/manifolds/level_set.hpp>
#include <leastcost/problems/manifolds/made_from_data.hpp>

namespace leastcost {

/// Whether distances tell the sides of a surface.
enum class DistanceSign { with_sides, without_sides };
Words<DistanceSign> words(DistanceSign);

/// What SignedDistanceOptions samples distances from.
namespace distance_source {

/// How inside is told from outside.
struct Sides {
  DistanceSign sign = DistanceSign::with_sides;  ///< the rule
  double offset = 0;  ///< without sides: the domain is the surface at this distance, length units
  /// `help`: what either sign means for a source.
  void fields(FieldVisitor& visit, const char* help);
};

/// The distance to the surface of a mesh.
struct Mesh {
  static constexpr std::string_view kType = "mesh";
  static constexpr std::string_view kHelp = "A triangle mesh.";
  std::string file = {};
  bool weld = false;       ///< whether vertices at equal places become one
  Sides sides = {};        ///< how inside is told from outside
  double weld_within = 0;  ///< length units; 0: what `weld` says
  void fields(FieldVisitor& visit);
};

struct PointCloud {
  static constexpr std::string_view kType = "point_cloud";
  static constexpr std::string_view kHelp = "The smooth surface through a point cloud.";
  PointCloudManifoldOptions cloud = {};  ///< the points
  Sides sides = {};                      ///< how inside is told from outside
  void fields(FieldVisitor& visit);
};

struct Implicit {
  static constexpr std::string_view kType = "implicit";
  static constexpr std::string_view kHelp = "A surface f(x, y, z) = 0, by name or as a formula.";
  ImplicitManifoldOptions surface = {};  ///< without bounds
  BoxOptions box = {};                   ///< where the surface lies; needed where it has no bounds of its own
  void fields(FieldVisitor& visit);
};

struct GridFile {
  static constexpr std::string_view kType = "file";
  static constexpr std::string_view kHelp = "A grid of distances in the text format of SDFGen, which gives the cell.";
  std::string file = {};
  void fields(FieldVisitor& visit);
};

using Source = std::variant<Mesh, PointCloud, Implicit, GridFile>;

}  // namespace distance_source

struct SignedDistanceOptions {
  distance_source::Source source = {};
  std::optional<double> cell = {};      ///< length units
  std::optional<double> accuracy = {};  ///< instead of the cell, see DistanceGridSettings
  int margin = 8;
  double memory_limit = 1;  ///< GiB
  void fields(FieldVisitor& visit);
};

/// The zeros of a signed distance that is sampled on a regular grid, with a twice differentiable tricubic interpolant.
/// The domain is the surface that was sampled; what the grid makes of it is the geometry error, of order 4 in the cell
/// where the surface is smooth.
///
/// Limits. The edges of a polyhedron are rounded on the scale of a cell (order 1 to 2 there). With cells below the edge
/// length the rounded edges are what a chain has to resolve: with segments no longer than about a cell Newton needs 5
/// to 9 iterations and certifies, with longer ones it converges as well, but the certificate finds no second order.
/// Sheets nearer than about two cells merge; the making says where, and refuses when a twentieth of the surface is
/// lost. Paths cannot leave the grid.
class SignedDistanceManifold final : public LevelSet,
                                     public HasCoarserVersion,
                                     public HasUnresolvedPlaces,
                                     public HasDistanceGrid,
                                     public MadeFromData {
 public:
  /// A grid with nothing behind it.
  explicit SignedDistanceManifold(DistanceGrid grid, std::vector<std::string> notes = {});
  /// `source` is kept where it has a coarser version (a cloud).
  SignedDistanceManifold(SampledDistance sampled, const std::shared_ptr<const DistanceSource>& source);

  const DistanceGrid& grid() const override { return *grid_; }
  double diameter() const override { return (grid_->shape().upper() - grid_->shape().origin).norm(); }
  std::vector<std::string> notes() const override { return notes_; }
  std::vector<DataCount> counts() const override { return {}; }
  /// All of it.
  void draw(const DrawnPaths& paths, Drawing& out) const override;
  /// First every second node, which is the same source sampled with cells twice as large; the version after it is the
  /// same moved by four times the mean miss of the grid, for details of the source between its nodes, which neither of
  /// the two grids sees. Where the source is a cloud: half of it, and a quarter of it, with cells twice as large. Then
  /// none (null).
  std::shared_ptr<const ConstraintManifold> coarser() const override;
  bool has_made_coarser() const override { return has_coarser_; }
  /// Of the cloud behind it.
  std::string why_unresolved(const CoordinatePath& path) const override;
  std::string why_not_projected(const Eigen::VectorXd& x) const override;

 private:
  SignedDistanceManifold(std::shared_ptr<const DistanceGrid> grid, std::vector<std::string> notes);
  std::shared_ptr<const ConstraintManifold> make_coarser() const;

  std::shared_ptr<const DistanceGrid> grid_;
  std::vector<std::string> notes_;
  double offset_ = 0, mean_miss_ = 0;  // length units
  std::shared_ptr<const DistanceSource> source_;
  int level_ = 0;                        // 0: the domain itself; 1, 2: its coarser versions
  mutable std::once_flag made_coarser_;  // a family of paths asks more than once
  mutable std::shared_ptr<const ConstraintManifold> coarser_;
  mutable std::atomic<bool> has_coarser_ = false;
};

/// Throws OptionError for options that cannot work whatever is in the files. Reads and samples nothing.
void check_signed_distance(const SignedDistanceOptions& options);

/// Reads (relative to `folder`), samples, builds. Throws OptionError, InputError.
std::shared_ptr<const SignedDistanceManifold> make_signed_distance_manifold(const SignedDistanceOptions& options,
                                                                            const std::filesystem::path& folder,
                                                                            const BuildProgress& progress = {});

}  // namespace leastcost
