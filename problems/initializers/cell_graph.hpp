// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include <leastcost/framework/base/checked.hpp>
#include <leastcost/framework/base/options.hpp>
#include <leastcost/framework/problem/initializer.hpp>

namespace leastcost {

struct CellGraphOptions {
  /// On each side of a cell, beside its corners. None: 3, and 1 where the raster has more than 300,000 cells.
  std::optional<int> side_points = {};
  void fields(FieldVisitor& visit);
};

/// The least-cost path by straight moves within cells of a raster, between their corners and places on their sides, for
/// a cost that is constant in each cell. With three places it costs no more than any grid path to 8 or 16 neighbours.
class CellGraphInitializer final : public Initializer {
 public:
  explicit CellGraphInitializer(const CellGraphOptions& options = {}) : options_(checked(options)) {}
  std::string_view name() const override { return "cell_graph"; }
  /// Throws InputError for another cost or domain, InitializationError where cells without data part the ends.
  FirstPath first_path(const Problem& problem, const Monitor& monitor) const override;

 private:
  CellGraphOptions options_;
};

}  // namespace leastcost
