// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "problems/geometry/box.hpp"
#include "problems/geometry/build_progress.hpp"
#include "problems/geometry/has_distance_grid.hpp"
#include "problems/manifolds/implicit.hpp"
#include "problems/manifolds/level_set.hpp"
#include "problems/manifolds/point_cloud.hpp"

namespace leastcost {

struct SignedDistanceOptions {
  std::string source;  ///< mesh, point_cloud, implicit, file
  std::string file;    ///< of a mesh or a grid
  bool weld = false;
  std::string sign = "signed";  ///< signed, unsigned
  double offset = 0;
  PointCloudManifoldOptions cloud;
  ImplicitManifoldOptions implicit;
  BoxOptions box;
  double cell = 0, accuracy = 0;
  int margin = 8;
  double memory_limit = 1;  ///< GiB
  void fields(FieldVisitor& visit);
};

/// The zeros of a signed distance that is sampled on a regular grid, with a twice differentiable tricubic interpolant (VFCS 4.4.3). The domain
/// is the surface that was sampled; what the grid makes of it is the geometry error, of order 4 in the cell where the surface is smooth. At the
/// edges of a polyhedron it is rounded on the scale of a cell (order 1 there); sheets nearer than about two cells merge. Paths cannot leave the
/// grid.
class SignedDistanceManifold final : public LevelSet, public HasCoarserVersion, public HasDistanceGrid {
 public:
  explicit SignedDistanceManifold(std::shared_ptr<const DistanceGrid> grid, std::vector<std::string> notes = {});

  const DistanceGrid& grid() const override { return *grid_; }
  const std::vector<std::string>& notes() const override { return notes_; }
  /// Every second node: the same source sampled with cells twice as large.
  std::shared_ptr<const ConstraintManifold> coarser() const override;

 private:
  std::shared_ptr<const DistanceGrid> grid_;
  std::vector<std::string> notes_;
};

/// Reads (relative to `folder`), samples, builds. `progress` is first called when all options have been checked, and nothing read yet. Throws
/// OptionError, InputError.
std::shared_ptr<const SignedDistanceManifold> make_signed_distance_manifold(const SignedDistanceOptions& options,
                                                                            const std::filesystem::path& folder,
                                                                            const BuildProgress& progress = {});

}  // namespace leastcost
