// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <leastcost/framework/base/options.hpp>

namespace leastcost {

/// The option of everything that reads a mesh: `weld: true`, or the distance of MeshOptions::weld_within.
inline void visit_weld(FieldVisitor& visit, bool& weld, double& within) {
  visit.switch_or_number("weld", weld, within,
                         {.help = "true: merges vertices with exactly equal positions (always done for STL). A number: "
                                  "merges vertices no farther apart than this, in length units of the file.",
                          .minimum = 0,
                          .exclusive_minimum = true});
}

}  // namespace leastcost
