// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/framework/search/prepare.hpp>

#include <memory>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/domain/makes_on_demand.hpp>
#include <leastcost/framework/domain/manifold.hpp>
#include "framework/certificate/geometry_error.hpp"

namespace leastcost {

void prepare(const Problem& problem) {
  check(problem);
  std::shared_ptr<const ConstraintManifold> manifold = problem.manifold;
  if (const auto* parts = find_ability<MakesOnDemand>(*manifold)) parts->make({});
  for (int level = 0; manifold && level < kGeometryLevels; ++level) {
    const auto* domain = find_ability<HasCoarserVersion>(*manifold);
    try {
      manifold = domain != nullptr ? domain->coarser() : nullptr;
    } catch (const InputError&) {
      return;  // too little is left; the certificate says so
    }
  }
}

}  // namespace leastcost
