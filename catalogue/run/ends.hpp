// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "catalogue/options/run_visitor.hpp"
#include "catalogue/run/compose.hpp"

namespace leastcost {

/// Puts an end of the configuration onto the manifold. `path` ("ends.source") is for messages. Throws OptionError where
/// the domain has no such vertex or face, or the point is farther away than its tolerance.
PlacedEnd place_end(const ConstraintManifold& manifold, const EndOptions& options, const std::string& path);

}  // namespace leastcost
