// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <utility>

#include <leastcost/framework/problem/global_bound.hpp>
#include <leastcost/framework/problem/post_processor.hpp>

namespace leastcost {

/// Proves that no path among obstacles in the plane is shorter than the one pulled tight, or delivers the one that is
/// (tangents, docs/numerics.md Sec. 4.1). Comes after `taut`, and leaves what that made where it finds nothing better.
/// Needs what `taut` needs in the plane; elsewhere, and for rings, apply() throws InputError that says so.
class ShortestPlanPostProcessor final : public PostProcessor {
 public:
  explicit ShortestPlanPostProcessor(GlobalProof proof = GlobalAuto{}) : proof_(std::move(proof)) {}
  std::string_view name() const override { return "shortest_plan"; }
  bool bounds_all_paths() const override { return true; }
  PostProcessed apply(const Problem& problem, const FirstPath& first, PostProcessed current,
                      const Monitor& monitor) const override;

 private:
  GlobalProof proof_;
};

}  // namespace leastcost
