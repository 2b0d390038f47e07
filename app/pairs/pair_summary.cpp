// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "app/pairs/pair_summary.hpp"

#include <algorithm>
#include <cmath>

namespace leastcost::app {
namespace {

constexpr double kBinsPerE = 100;  // bins whose values are within 1 % of each other

}  // namespace

void Spectrum::add(double value, long number) {
  if (std::isnan(value)) return;
  ++count_;
  if (!(greatest_ >= value)) {
    greatest_ = value;
    greatest_of_ = number;
  }
  if (value <= 0)
    ++zeros_;
  else if (std::isfinite(value))  // an infinite one is beyond all bins
    ++bins_[static_cast<int>(std::floor(std::log(value) * kBinsPerE))];
}

double Spectrum::median() const {
  if (count_ == 0) return std::numeric_limits<double>::quiet_NaN();
  long below = zeros_;
  const long middle = (count_ - 1) / 2;
  if (below > middle) return 0;
  for (const auto& [bin, count] : bins_) {
    below += count;
    if (below > middle) return std::min(greatest_, std::exp((bin + 0.5) / kBinsPerE));
  }
  return std::numeric_limits<double>::infinity();
}

void PairSummary::add(const PairFacts& facts) {
  ++count;
  ++outcomes[facts.outcome];
  if (!facts.proof.empty()) ++proofs[facts.proof];
  errors.add(facts.error, facts.number);
  if (facts.outcome != "bad_pair") seconds.add(facts.seconds, facts.number);
}

long PairSummary::with(const std::string& outcome) const {
  const auto at = outcomes.find(outcome);
  return at == outcomes.end() ? 0 : at->second;
}

}  // namespace leastcost::app
