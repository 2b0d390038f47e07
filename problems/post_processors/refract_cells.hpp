// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <leastcost/framework/problem/post_processor.hpp>

namespace leastcost {

/// Under a cost that is constant in each cell of a raster, the locally least-cost path beside the first one, or beside
/// the solved one where that is cheaper: straight in each cell, Snell's law at every side, corners on their cheaper
/// side, points equally spaced in cost on that polyline. Needs the plane or a box of it without obstacles; elsewhere,
/// and for rings, apply() throws InputError that says so.
class RefractCellsPostProcessor final : public PostProcessor {
 public:
  std::string_view name() const override { return "refract_cells"; }
  bool finds_its_own() const override { return true; }
  PostProcessed apply(const Problem& problem, const FirstPath& first, PostProcessed current,
                      const Monitor& monitor) const override;
};

}  // namespace leastcost
