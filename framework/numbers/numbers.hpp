// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

// Numbers that carry more than a value: derivatives, enclosures, both. They know no path.
#include <leastcost/framework/numbers/dual.hpp>
#include <leastcost/framework/numbers/interval.hpp>
#include <leastcost/framework/numbers/interval_jet.hpp>
