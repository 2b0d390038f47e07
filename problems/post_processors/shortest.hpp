// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include <leastcost/framework/problem/global_bound.hpp>
#include <leastcost/framework/problem/post_processor.hpp>

namespace leastcost {

class SearchKeeper;

/// Proves that no path on the mesh is shorter than the straightened one, or delivers the one that is (exact windows,
/// docs/numerics.md Sec. 5.4). Comes after `straighten`, and leaves what that made where it finds nothing better. Needs
/// a mesh and a cost that is a length in one metric; elsewhere, and for rings, apply() throws InputError that says so.
/// One object answers many queries quickly, from any number of threads: the search of the last domain, its landmarks
/// and its workspaces are kept. Copies share them.
class ShortestPostProcessor final : public PostProcessor {
 public:
  explicit ShortestPostProcessor(GlobalProof proof = GlobalAuto{});
  std::string_view name() const override { return "shortest"; }
  bool bounds_all_paths() const override { return true; }
  PostProcessed apply(const Problem& problem, const FirstPath& first, PostProcessed current,
                      const Monitor& monitor) const override;

 private:
  GlobalProof proof_;
  std::shared_ptr<SearchKeeper> keeper_;
};

}  // namespace leastcost
