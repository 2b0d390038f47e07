// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <numbers>

namespace leastcost::test {

inline constexpr double kPi = std::numbers::pi, kDegree = kPi / 180;

}  // namespace leastcost::test
