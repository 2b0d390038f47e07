// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <leastcost/framework/base/errors.hpp>

namespace leastcost {

/// A field was asked for a way that is not there: the places are sound, but no path joins them, or leaves them.
class NoWay : public InputError {
 public:
  using InputError::InputError;
};

}  // namespace leastcost
