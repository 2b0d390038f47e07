// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <leastcost/framework/base/options.hpp>

namespace leastcost {

/// An option that is a length, positive.
inline void length_field(FieldVisitor& visit, const char* key, double& value, const char* help) {
  visit.field(key, value, {.help = help, .unit = "length", .minimum = 0, .exclusive_minimum = true});
}

}  // namespace leastcost
