// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// Part of the library leastcost::bounds: what is proved of all paths in a box where no other library has a proof.
#include <string>
#include <utility>
#include <variant>

#include <leastcost/problems/post_processors/bracket.hpp>
#include "problems/methods/offered_methods.hpp"

namespace leastcost {
namespace {

std::optional<GlobalProofStep> proof_in_box(const Problem& problem, const GlobalProof& proof) {
  if (std::string why = why_no_bracket(problem); !why.empty()) return GlobalProofStep{nullptr, nullptr, std::move(why)};
  const auto* budget = std::get_if<GlobalBudget>(&proof);
  return GlobalProofStep{std::make_shared<const BracketPostProcessor>(budget != nullptr ? *budget : GlobalBudget{}),
                         nullptr, ""};
}

constexpr BoundsMethods kBoundsMethods{proof_in_box};

}  // namespace
}  // namespace leastcost

// Who links the library asks the linker for this name (cmake/leastcost_library.cmake, OFFERS).
extern "C" const bool leastcost_bounds_methods;
const bool leastcost_bounds_methods = leastcost::offer(leastcost::kBoundsMethods);
