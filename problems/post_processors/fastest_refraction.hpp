// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <utility>

#include <leastcost/framework/problem/global_bound.hpp>
#include <leastcost/framework/problem/post_processor.hpp>

namespace leastcost {

/// Proves that no path through the layers costs less than the refracted one, whatever layers it passes, or delivers the
/// one that does (docs/numerics.md Sec. 4.2). Comes after `refract`, and needs what that needs.
class FastestRefractionPostProcessor final : public PostProcessor {
 public:
  explicit FastestRefractionPostProcessor(GlobalProof proof = GlobalAuto{}) : proof_(std::move(proof)) {}
  std::string_view name() const override { return "fastest_refraction"; }
  bool bounds_all_paths() const override { return true; }
  PostProcessed apply(const Problem& problem, const FirstPath& first, PostProcessed current,
                      const Monitor& monitor) const override;

 private:
  GlobalProof proof_;
};

}  // namespace leastcost
