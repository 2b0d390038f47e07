// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>

#include <leastcost/framework/problem/global_bound.hpp>
#include <leastcost/framework/problem/post_processor.hpp>

namespace leastcost {

struct KeptBracket;

/// Why there is no bracket of the least cost for a problem, as far as the domain and the cost say; empty: there is.
std::string why_no_bracket(const Problem& problem);

/// After a solve in a box of the plane or of space: a proved lower bound of the cost of all paths in the box between
/// the two ends (problems/bracket), beside the proved cost of the smooth curve through the points. Where the way down
/// its own field costs less than that, the search begins anew from it (PostProcessed::cheaper). Without a cost that is
/// a metric or a wind by formula (in space one that is the same in all directions), a box with finite sides or a flat
/// domain, the bound is `blocked`, with the reason. The last bound is kept: what begins anew does not prove it again.
/// Shared by threads.
class BracketPostProcessor final : public PostProcessor {
 public:
  explicit BracketPostProcessor(GlobalBudget budget = {});
  std::string_view name() const override { return "bracket"; }
  bool bounds_all_paths() const override { return true; }
  PostProcessed apply(const Problem& problem, const FirstPath& first, PostProcessed current,
                      const Monitor& monitor) const override;

 private:
  GlobalBudget budget_;
  std::shared_ptr<KeptBracket> kept_;
};

}  // namespace leastcost
