// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <leastcost/catalogue/pairs/pair_result.hpp>

namespace leastcost::app {

/// What a line says that is counted. Relative errors; NaN is what was not measured.
struct PairFacts {
  long number = 0;
  std::string outcome;  ///< certified, uncertified, collapsed, interrupted; no_path, bad_pair, error: there is no path
  std::string proof;    ///< the word of a proof over all paths; empty: none was tried
  double error = 0;
  double seconds = 0;
};

PairFacts facts_of(const PairResult& result);

/// What an earlier program wrote. Throws InputError where it is no such line.
PairFacts read_pair_line(const std::string& text);

}  // namespace leastcost::app
