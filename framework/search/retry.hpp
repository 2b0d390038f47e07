// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "framework/search/search.hpp"

namespace leastcost {

/// When a phase of a search is repeated. A new attempt runs the phases before it and is compared here; then the phase
/// runs on the one that is kept.
struct Retry {
  /// `tries`: attempts that this phase has made.
  bool (*has_reason)(const Search&, const Outcome&, int tries);
  /// The next attempt, not yet solved; nothing: there are too many points, or no such chain.
  std::optional<Outcome> (*attempt)(const Search&, const Outcome&);
  bool (*keeps)(const Search&, const Outcome& before, Outcome& attempt);
  /// The phase runs again even if there was no attempt, or it was not kept.
  bool repeats = false;
};

/// An attempt from `points` free points along another path, on the domain as it was given: margins that fit one chain
/// say nothing of another. Nothing where there is no such chain.
std::optional<Outcome> resampled(const Search& search, const Outcome& before, const CoordinatePath& path, Index points);

/// For a phase that is never repeated.
extern const Retry kNoRetry;

/// After a solve: twice as many points, up to 4,000, if the moves between them touch the obstacles of the domain. Ends
/// when a doubling makes them touch by no less than three quarters.
extern const Retry kDenserBetweenObstacles;
/// A note of the points that it came to.
void note_denser_points(const Search& search, Outcome& out);

/// After the post-processors, once: from a cheaper path of another class that one of them has found.
extern const Retry kFromCheaperWay;

}  // namespace leastcost
