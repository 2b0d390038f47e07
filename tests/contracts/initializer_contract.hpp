// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <leastcost/framework/energy/path_energy.hpp>
#include <leastcost/framework/problem/initializer.hpp>
#include "tests/support/catch.hpp"

namespace leastcost::test {

/// A first path joins the ends of its problem by points of the domain, at a finite cost, the same one every time.
inline void check_initializer_contract(const Initializer& initializer, const Problem& problem) {
  constexpr double kRounding =
      1e-14;  // length units: an end goes through barycentric coordinates; examples have size 1
  CAPTURE(initializer.name(), problem.ring, problem.source.u.transpose(), problem.target.u.transpose());
  CHECK_FALSE(initializer.name().empty());
  const FirstPath first = initializer.first_path(problem, {});
  const CoordinatePath& path = first.path;
  REQUIRE(path.u.rows() == problem.manifold->dimensions().coordinate);
  REQUIRE(path.u.cols() >= 2);
  REQUIRE(path.u.allFinite());
  CHECK(path.ring == problem.ring);
  CHECK((path.sites.empty() || static_cast<Index>(path.sites.size()) == path.u.cols()));
  CHECK(problem.manifold->residual(path) <= kRounding);
  CHECK(PathEnergy(problem, 1).costs(path).allFinite());
  if (!problem.ring) {
    CHECK((path.u.col(0) - problem.source.u).norm() <= kRounding);
    CHECK((path.u.rightCols(1) - problem.target.u).norm() <= kRounding);
  }
  CHECK(initializer.first_path(problem, {}).path.u == path.u);
}

}  // namespace leastcost::test
