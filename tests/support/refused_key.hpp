// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <leastcost/framework/base/errors.hpp>

namespace leastcost::test {

/// The key of the OptionError that `make` throws; empty: it throws none.
template <class Make>
std::string refused_key(const Make& make) {
  try {
    make();
  } catch (const OptionError& error) {
    return error.key();
  }
  return "";
}

}  // namespace leastcost::test
