// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/taut/tight_chain.hpp"

#include <cstdio>
#include <cstdlib>
#include <ctime>

#include "problems/taut/pulled_chain.hpp"

namespace leastcost {

Points tight_chain(const ConstraintManifold& domain, const Walls& walls, const Eigen::MatrixXd& metric,
                   const Points& start, double excess, const std::function<bool(const Points&)>& is_clear,
                   const Monitor& monitor) {
  constexpr int kMostRefinements = 5;
  PulledChain chain(domain, walls, metric, start, monitor);
  Points proven = start;
  const bool verbose = std::getenv("VERBOSE_CHAIN") != nullptr;
  for (int k = 0; k <= kMostRefinements; ++k) {
    if (k > 0 && !chain.refine(excess)) break;
    const double before = chain.length();
    chain.pull_tight(excess * 10);
    const bool ok = is_clear(chain.polyline());
    if (verbose) std::printf("   %.0f ms round %d: %d vertices, %.6f -> %.6f %d\n", 1e3 * static_cast<double>(clock()) / CLOCKS_PER_SEC, k, (int)chain.polyline().cols(), before, chain.length(), ok);
    if (!ok) break;
    proven = chain.polyline();
    if (k > 1 && before - chain.length() < excess * before) break;
  }
  return proven;
}

}  // namespace leastcost
