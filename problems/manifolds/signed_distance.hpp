// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include <leastcost/problems/distance/build_distance_grid.hpp>
#include <leastcost/problems/distance/has_distance_grid.hpp>
#include <leastcost/problems/manifolds/box.hpp>
#include <leastcost/problems/manifolds/implicit.hpp>
#include <leastcost/problems/manifolds/level_set.hpp>
#include <leastcost/problems/manifolds/point_cloud.hpp>

namespace leastcost {

struct SignedDistanceOptions {
  std::string source = {};  ///< mesh, point_cloud, implicit, file
  std::string file = {};    ///< of a mesh or a grid
  bool weld = false;
  std::string sign = "signed";  ///< signed, unsigned
  double offset = 0;
  PointCloudManifoldOptions cloud = {};
  ImplicitManifoldOptions implicit = {};
  BoxOptions box = {};
  double cell = 0, accuracy = 0;
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
class SignedDistanceManifold final : public LevelSet, public HasCoarserVersion, public HasDistanceGrid {
 public:
  /// A grid with nothing behind it.
  explicit SignedDistanceManifold(DistanceGrid grid, std::vector<std::string> notes = {});
  /// `source` is kept where it has a coarser version (a cloud).
  SignedDistanceManifold(SampledDistance sampled, const std::shared_ptr<const DistanceSource>& source);

  const DistanceGrid& grid() const override { return *grid_; }
  const std::vector<std::string>& notes() const override { return notes_; }
  /// First every second node, which is the same source sampled with cells twice as large; the version after it is the
  /// same moved by four times the mean miss of the grid, for details of the source between its nodes, which neither of
  /// the two grids sees. Where the source is a cloud: half of it, and a quarter of it, with cells twice as large. Then
  /// none (null).
  std::shared_ptr<const ConstraintManifold> coarser() const override;
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
};

/// Reads (relative to `folder`), samples, builds. `progress` is first called when all options have been checked, and
/// nothing read yet. Throws OptionError, InputError.
std::shared_ptr<const SignedDistanceManifold> make_signed_distance_manifold(const SignedDistanceOptions& options,
                                                                            const std::filesystem::path& folder,
                                                                            const BuildProgress& progress = {});

}  // namespace leastcost
