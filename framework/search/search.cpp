// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "framework/search/search.hpp"

#include <algorithm>

namespace leastcost {

bool Search::finds_its_own() const {
  const auto& steps = options.post_processors;
  return std::any_of(steps.begin(), steps.end(), [](const auto& step) { return step->finds_its_own(); });
}

bool Outcome::failed() const {
  const Termination end = result.solve.termination;
  return end == Termination::exception || end == Termination::inconsistent;
}

}  // namespace leastcost
