// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>

#include <leastcost/catalogue/run/externals.hpp>
#include "python/src/call_errors.hpp"

namespace leastcost::python {

/// An object of Python as the library takes it in one run.
struct External {
  /// `dimension`: of the space in which points are, which costs depend on; `errors`: what functions raise.
  std::function<ExternalObject(int dimension, const std::shared_ptr<CallErrors>& errors)> make;
};

}  // namespace leastcost::python
