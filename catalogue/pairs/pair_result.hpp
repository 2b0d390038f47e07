// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <leastcost/catalogue/plugins/end_options.hpp>
#include <leastcost/framework/result/result.hpp>

namespace leastcost {

/// Two ends of a path.
struct EndPair {
  EndOptions source, target;  ///< where the path begins and ends
};

/// What became of one pair. Numbers that were not measured are NaN.
struct PairResult {
  static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();  ///< a number that there is none of

  long number = 0;     ///< of the pair, from 0 in their order
  long file_line = 0;  ///< of the file of pairs, from 1; 0: it came from memory
  EndPair ends;        ///< as they were given
  std::string
      outcome;  ///< certified, uncertified, collapsed or interrupted; no_path, bad_pair, error: there is no path
  std::string message;                        ///< why there is no path
  double cost = kNone;                        ///< of the path, in the unit of the cost
  double error = kNone;                       ///< its error bar
  std::optional<Scope> scope = {};            ///< of the certificate, where it was measured
  std::optional<ProofOutcome> proof = {};     ///< of a proof over all paths, where one was tried
  double lower_bound = kNone;                 ///< of the cost of all paths, where a proof was tried
  std::vector<std::string> failures = {};     ///< names of what the certificate does not fulfil
  double source_moved = 0, target_moved = 0;  ///< distances by which the ends were put onto the domain, length units
  std::vector<std::string> notes = {};        ///< what the run says about this pair alone
  Points points = {};                         ///< of the path, ambient, one per column; where they were asked for
  double seconds = 0;                         ///< wall time of this pair
  std::string line;                           ///< a line of paths.jsonl without its line break, where it was asked for

  bool found() const { return message.empty(); }             ///< whether there is a path
  bool certified() const { return outcome == "certified"; }  ///< whether the path has a certificate
};

/// How pairs are solved, and what is kept of each.
struct PairsOptions {
  int threads = 1;     ///< paths that are sought at the same time
  bool points = true;  ///< results have the points of their paths
  bool lines = false;  ///< results have their line of paths.jsonl; it has the points, too, if `points`
  std::function<bool()> stop_requested = {};  ///< asked by all threads; then no pair is begun
};

/// Told the result of each pair, in their order, by one thread at a time. May throw, which ends all of it.
using PairDone = std::function<void(PairResult)>;

}  // namespace leastcost
