// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <utility>

#include <leastcost/framework/problem/global_bound.hpp>
#include <leastcost/framework/problem/post_processor.hpp>

namespace leastcost {

/// A bound below the cost of all paths over the cells of a cost map, by a potential on their sides (docs/numerics.md
/// Sec. 4.3). Comes after `refract_cells`, and needs what that needs; the path stays as it is.
class CellBoundPostProcessor final : public PostProcessor {
 public:
  explicit CellBoundPostProcessor(GlobalProof proof = GlobalAuto{}) : proof_(std::move(proof)) {}
  std::string_view name() const override { return "cell_bound"; }
  bool bounds_all_paths() const override { return true; }
  PostProcessed apply(const Problem& problem, const FirstPath& first, PostProcessed current,
                      const Monitor& monitor) const override;

 private:
  GlobalProof proof_;
};

}  // namespace leastcost
