// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "tests/adversarial/adversaries.hpp"

namespace leastcost::test {

/// False: certified, and |printed - truth| > bar. Over-cautious: refused, though a local minimum and within 1e-4.
struct Tally {
  int problems = 0, known = 0, certified = 0, false_ones = 0, cautious = 0;
  std::map<std::string, int> reasons;  ///< failures of the over-cautious, each problem under all of its own

  std::string row(const std::string& family) const;
};

/// Seeds first, first + 2, ...: development on even ones, measurement on odd ones. With LEASTCOST_ADVERSARIES_CSV every
/// problem is a line of that file.
Tally measure(const AdversaryFamily& family, std::uint64_t first, int count, const CertificateOptions& options);

/// What `family` does for pairs of points on an oblate ellipsoid: `longer`, it delivers a path that is certified, and
/// longer than another one in its list by more than the bars (in truth, by shooting).
struct FamilyTally {
  int pairs = 0, certified = 0, longer = 0, false_ones = 0;
  double worst = 0;  ///< by what part longer
};
FamilyTally measure_families(std::uint64_t first, int count, int points);

}  // namespace leastcost::test
