// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "app/field/run_field.hpp"
#include "app/figure/figure.hpp"

namespace leastcost::app {

/// Throws InputError for a field on a mesh or in space, which has no picture.
void check_drawable(FieldNodes nodes);

/// A field over a lattice on paper: bands and lines of equal cost, the places, the ways, obstacles, axes, a bar with
/// the unit and a legend. Of the request its size, parts and unit. Throws InputError as check_drawable().
Figure field_figure(const RunField& field, const std::vector<FieldWay>& ways, const FigureRequest& request);

}  // namespace leastcost::app
