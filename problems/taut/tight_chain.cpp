// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/taut/tight_chain.hpp"

#include <leastcost/framework/base/errors.hpp>
#include "problems/taut/polyline_length.hpp"
#include "problems/taut/pulled_chain.hpp"

namespace leastcost {

Points tight_chain(const ConstraintManifold& domain, const Walls& walls, const Eigen::MatrixXd& metric,
                   const Points& start, const std::function<bool(const Points&)>& is_clear,
                   const TightChainOptions& options, const Monitor& monitor) {
  constexpr int kMostRefinements = 5;
  constexpr double kWorthAVertex = 0.1;  // of what a refinement has to bring
  if (start.cols() < 2 || !(polyline_length(start) > 0)) return start;
  PulledChain chain(domain, walls, metric, start, options.kept, monitor);
  Points tight = start;
  try {
    for (int k = 0; k <= kMostRefinements; ++k) {
      if (k > 0 && !chain.refine(kWorthAVertex * options.gain)) break;
      const double before = chain.length();
      chain.pull_tight(options.gain);
      if (!is_clear(chain.polyline())) break;
      tight = chain.polyline();
      if (k > 1 && before - chain.length() < options.gain * before) break;
    }
  } catch (const Interrupted&) {  // as far as it came
    if (is_clear(chain.polyline())) tight = chain.polyline();
  }
  return tight;
}

}  // namespace leastcost
