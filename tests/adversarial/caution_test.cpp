// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// How often the certificate is wrong, and how often it refuses what is right, on random problems whose answers are
// known. LEASTCOST_ADVERSARIES sets how many of each family, LEASTCOST_ADVERSARIES_SEED the first seed (in steps of
// two): what was tuned on even seeds is measured on odd ones. LEASTCOST_ADVERSARIES_FAMILY: only those whose names hold
// this text; LEASTCOST_ADVERSARIES_CSV: a file to which each problem adds a line; LEASTCOST_ADVERSARIES_BLACK_BOXES:
// the costs are asked as if they were no formulas, which is counted and not judged; LEASTCOST_ADVERSARIES_REFINE: how
// often the points may be doubled.
#include <cstdio>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include "tests/adversarial/measure.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/trials.hpp"

namespace leastcost::test {
namespace {

int number_from(const char* variable, int otherwise) {
  const char* text = std::getenv(variable);  // NOLINT(concurrency-mt-unsafe)
  return text == nullptr ? otherwise : std::atoi(text);
}

}  // namespace

TEST_CASE("adversaries: false and over-cautious certificates by family", "[adversarial]") {
  const int count = number_from("LEASTCOST_ADVERSARIES", nightly() ? 6 : 1);
  const auto first = static_cast<std::uint64_t>(number_from("LEASTCOST_ADVERSARIES_SEED", 2));
  std::printf("  %-28s %5s %5s %9s %5s %8s  reasons\n", "family", "asked", "known", "certified", "false", "cautious");
  const bool black_boxes =
      std::getenv("LEASTCOST_ADVERSARIES_BLACK_BOXES") != nullptr;  // NOLINT(concurrency-mt-unsafe)
  CertificateOptions options;
  if (black_boxes) options.proof = ProofRule::never;
  options.refine = number_from("LEASTCOST_ADVERSARIES_REFINE", options.refine);
  const char* only = std::getenv("LEASTCOST_ADVERSARIES_FAMILY");  // NOLINT(concurrency-mt-unsafe)
  for (const AdversaryFamily& family : adversary_families()) {
    if (only != nullptr && family.name.find(only) == std::string::npos) continue;
    const Tally tally = measure(family, first, count, options);
    std::printf("%s\n", tally.row(family.name).c_str());
    CAPTURE(family.name, count, first);
    CHECK(tally.known > 0);
    if (black_boxes) continue;
    CHECK(tally.false_ones == 0);
    if (family.resolved) CHECK(tally.cautious <= (count + 49) / 50);
  }
}

TEST_CASE("adversaries: what was false once", "[adversarial]") {
  const std::vector<std::pair<std::string, std::uint64_t>> found = {
      {"corrugated sheets", 3061},                // levels that fall at order 2 from one that sees the waves badly
      {"ellipsoid f = 0.8, few points", 740113},  // a coarsest chain of five segments, a bar by chance too narrow
      {"ellipsoid f = 0.8, few points", 267791},  // the least chain in a valley of its own, and its bound with it
      {"ellipsoids in charts", 740883}};          // a bar narrower than the error of the true length was
  for (const auto& [name, seed] : found)
    for (const AdversaryFamily& family : adversary_families()) {
      if (family.name != name) continue;
      for (const ProofRule proof : {ProofRule::always, ProofRule::never}) {
        CAPTURE(name, seed);
        const Tally tally = measure(family, seed, 1, {.proof = proof});
        CHECK(tally.known == 1);
        CHECK(tally.false_ones == 0);
      }
    }
}

TEST_CASE("adversaries: a family never delivers a longer certified path", "[adversarial]") {
  const int count = number_from("LEASTCOST_ADVERSARIES", nightly() ? 6 : 3);
  const auto first = static_cast<std::uint64_t>(number_from("LEASTCOST_ADVERSARIES_SEED", 2));
  for (const int points : {50, 100}) {
    const FamilyTally tally = measure_families(first, count, points);
    std::printf("  family, n = %d: %d pairs, %d certified, %d longer than another (at most by %.2g %%), %d false\n",
                points, tally.pairs, tally.certified, tally.longer, 100 * tally.worst, tally.false_ones);
    CHECK(tally.longer == 0);
    CHECK(tally.false_ones == 0);
  }
}

}  // namespace leastcost::test
