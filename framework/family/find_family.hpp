// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <leastcost/framework/base/monitor.hpp>
#include <leastcost/framework/energy/solver.hpp>
#include <leastcost/framework/family/family.hpp>

namespace leastcost {

/// find_path() from every start, without more points than are asked for. What is cheaper than every certified path
/// without being certified itself goes on with twice the points, `certificate.refine` times at most, until it is
/// certified, or is left where it is a saddle; what is then delivered are the points that were asked for, of the finer
/// chain, as find_path() does. Where that decides nothing it stays first,
/// uncertified, and a note says so. Not done with the certificate switched off. A proof is always
/// tried of the first member only, of others where it is needed.
/// A start without a first path, or one that throws otherwise, is a note and loses no other; where none has a path the
/// exception of the first one is thrown. Throws InputError where an initializer is null. Stops
/// early, with what it has, when the monitor says so; interrupted before there was any path the family is one member
/// without a path.
Family find_family(const std::vector<FamilyStart>& starts, const Solver& solver, const FindOptions& options,
                   const Monitor& monitor = {});

}  // namespace leastcost
