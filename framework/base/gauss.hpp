// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>

namespace leastcost {

/// Gauss-Legendre nodes and weights on [0, 1], Abramowitz and Stegun 25.4.30.
inline constexpr std::array<double, 5> kGaussNodes = {0.04691007703066800, 0.23076534494715845, 0.5,
                                                      0.76923465505284155, 0.95308992296933200};
inline constexpr std::array<double, 5> kGaussWeights = {0.11846344252809454, 0.23931433524968324, 0.28444444444444444,
                                                        0.23931433524968324, 0.11846344252809454};

}  // namespace leastcost
