// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

namespace leastcost {

/// Version of the layout of result.json and manifest.json; grows when a key changes its meaning or goes away.
inline constexpr int kSchemaVersion = 1;

/// JSON knows finite numbers only. NaN (not measured) is null; infinities are the texts "Infinity" and "-Infinity".
nlohmann::ordered_json number(double value);
nlohmann::ordered_json number(const std::optional<double>& value);
nlohmann::ordered_json numbers(const Eigen::VectorXd& values);

/// Indented, with a final line break. Bytes that are not UTF-8 (in file names) are replaced, never an exception.
std::string to_text(const nlohmann::ordered_json& json);

}  // namespace leastcost
