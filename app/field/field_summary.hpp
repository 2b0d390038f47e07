// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "app/field/run_field.hpp"

namespace leastcost::app {

/// "isotropic march", "arrival field" or "exact windows".
std::string method_of(const RunField& field);
/// Whether a way may cost more or less than the way back.
bool is_directed(const RunField& field);

/// Why the values cannot be relied on: their error may be above all of them, or no path leads farther than the places.
/// Empty: they can.
std::vector<std::string> warnings_of(const RunField& field);

/// What was computed, how exact it is, and the ways: lines of text. `output`: the file it was written to.
std::string field_summary_text(const RunField& field, const std::string& output, const std::vector<FieldWay>& ways);
/// The same as JSON.
std::string field_summary_json(const RunField& field, const std::string& output, const std::vector<FieldWay>& ways);

}  // namespace leastcost::app
