// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "catalogue/plugins/kinds.hpp"
#include "catalogue/plugins/registration.hpp"

namespace leastcost {

/// Solvers of third-party libraries, each registered by the CMakeLists.txt of its folder in solvers/. Those whose
/// library was not found are there too, and say how to get it. Its definition is written by CMake.
std::vector<SolverPlugin> back_ends();

/// What this build has. `library`: with its version.
inline SolverPlugin present(SolverPlugin entry, std::string library) {
  entry.library = std::move(library);
  return entry;
}

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
