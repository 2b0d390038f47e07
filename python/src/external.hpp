// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>
#include <variant>

#include <leastcost/catalogue/plugins/externals.hpp>
#include "python/src/call_errors.hpp"

namespace leastcost::python {

/// Makes a cost for one run: of points with so many coordinates, where what functions raise goes to `errors`. Takes the
/// GIL itself. Throws InputError.
using CostMaker =
    std::function<std::shared_ptr<const SegmentCost>(int dimension, const std::shared_ptr<CallErrors>& errors)>;

/// An object of Python as the library takes it.
struct External {
  std::variant<ExternalObject, CostMaker> made;
};

}  // namespace leastcost::python
