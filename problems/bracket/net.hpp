// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>

namespace leastcost::bracket {

/// Bernstein coefficients of a function on a cell, of degree two in x and in y: [row][column].
using Net = std::array<std::array<double, 3>, 3>;

}  // namespace leastcost::bracket
