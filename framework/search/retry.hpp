// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "framework/search/search.hpp"

namespace leastcost {

/// Why a stage of a search is tried again, and what is kept of it. An attempt is carried up to the stage whose answer
/// was wrong and is judged there; then the stage is run again on what is kept.
struct Retry {
  /// `tries`: attempts that were made at this stage.
  bool (*has_reason)(const Search&, const Outcome&, int tries);
  /// The next attempt, not yet solved; nothing: there are too many points, or no such chain.
  std::optional<Outcome> (*attempt)(const Search&, const Outcome&);
  bool (*keeps)(const Search&, const Outcome& before, Outcome& attempt);
  /// The stage has left work open for the sake of the attempt: it is run again where nothing came of that, too.
  bool repeats = false;
};

/// An attempt from `points` free points along another path, on the domain as it was given: margins that fit one chain
/// say nothing of another. Nothing where there is no such chain.
std::optional<Outcome> resampled(const Search& search, const Outcome& before, const CoordinatePath& path, Index points);

/// No other attempt.
extern const Retry kNone;

/// After a solve: twice as many points where the moves between them would not go between the obstacles of the domain.
extern const Retry kDenserBetweenObstacles;
/// A note of the points that it came to.
void note_denser_points(const Search& search, Outcome& out);

/// After the post-processors, once: from a cheaper path of another class that one of them has found.
extern const Retry kFromCheaperWay;

}  // namespace leastcost
