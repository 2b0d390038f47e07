// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <leastcost/framework/base/options.hpp>

namespace leastcost {

/// Throws OptionError, whose message names the option, for the first one outside the range that its fields() state.
/// `key`: what stands before it, as in "certificate".
void check_ranges(const std::function<void(FieldVisitor&)>& fields, const std::string& key = "");

/// The options, after that check: for constructors, so that C++ refuses what a configuration would.
template <class Options>
Options checked(Options options, const std::string& key = "") {
  check_ranges([&](FieldVisitor& visit) { options.fields(visit); }, key);
  return options;
}

}  // namespace leastcost
