// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <map>
#include <string>

#include "app/pairs/pair_facts.hpp"

namespace leastcost::app {

/// Median and greatest of any number of values >= 0 in little memory: they are counted in bins that are 1 % wide.
class Spectrum {
 public:
  /// NaN is not counted. `number`: what the value belongs to.
  void add(double value, long number);
  bool empty() const { return count_ == 0; }
  /// Within 0.5 % of the value in the middle, the lower one of two; NaN where there is none.
  double median() const;
  double greatest() const { return greatest_; }
  /// To which the greatest belongs; the first of several.
  long greatest_of() const { return greatest_of_; }

 private:
  std::map<int, long> bins_;  // of the logarithm
  long count_ = 0, zeros_ = 0;
  double greatest_ = std::numeric_limits<double>::quiet_NaN();
  long greatest_of_ = -1;
};

/// What became of many pairs, added up line by line.
struct PairSummary {
  long count = 0;
  std::map<std::string, long> outcomes, proofs;
  Spectrum errors;   ///< relative, of the paths that have one
  Spectrum seconds;  ///< of the pairs that a path was sought for

  void add(const PairFacts& facts);
  long with(const std::string& outcome) const;
  bool all_certified() const { return with("certified") == count; }
  /// Pairs without a path.
  long failed() const { return with("no_path") + with("bad_pair") + with("error"); }
};

}  // namespace leastcost::app
