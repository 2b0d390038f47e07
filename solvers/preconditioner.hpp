// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <leastcost/framework/base/options.hpp>

namespace leastcost {

/// What a quasi-Newton method starts from: the Gauss-Newton Hessian of the chain, or a multiple of the identity.
enum class Preconditioner { chain, none };
Words<Preconditioner> words(Preconditioner);

}  // namespace leastcost
