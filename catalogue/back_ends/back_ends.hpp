// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include "catalogue/plugins/kinds.hpp"

namespace leastcost {

/// Solvers of third-party libraries. CMake compiles `<name>.cpp` where the library was found and `<name>_absent.cpp`
/// where not: the entry then says how to get it.
SolverPlugin nlopt_plugin();
SolverPlugin ceres_plugin();

inline constexpr const char* kNloptSummary = "NLopt's local optimisers, in the chain's own variables or as they are.";
inline constexpr const char* kCeresSummary = "Ceres: trust region on the residual form, or line search.";

/// What this build has not. `package`: that of Debian.
inline SolverPlugin absent(const char* type, const char* summary, const char* package) {
  SolverPlugin entry;
  entry.type = type;
  entry.summary = summary;
  entry.missing = std::string("install ") + package + " (Debian) and build again";
  entry.defaults = [] { return std::make_unique<OptionsOf<NoOptions>>(); };
  return entry;
}

}  // namespace leastcost
