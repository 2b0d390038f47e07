// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "app/pairs/pair_reader.hpp"
#include "catalogue/run/pair_composer.hpp"

namespace leastcost::app {

/// What a line says that is counted. Relative errors; NaN is what was not measured.
struct PairFacts {
  long number = 0;
  std::string outcome;  ///< certified, uncertified, collapsed, interrupted; no_path, bad_pair, error: there is no path
  std::string proof;    ///< the word of a proof over all paths; empty: none was tried
  double error = 0;
  double seconds = 0;
};

/// A line of paths.jsonl, with its line break.
struct PairLine {
  std::string text;
  PairFacts facts;
};

/// Finds the path of one pair and says what became of it: one JSON object, the same at every run but for `seconds`.
/// Whatever is wrong with the pair is a line too. `points`: those of the path are in it, ambient.
PairLine solve_pair(const PairComposer& composer, const PairRow& row, bool points, const Monitor& monitor);

/// What an earlier program wrote. Throws InputError where it is no such line.
PairFacts read_pair_line(const std::string& text);

}  // namespace leastcost::app
