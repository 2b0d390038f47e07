// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>
#include <vector>

namespace leastcost::app {

/// A commented starter configuration. Every one passes `leastcost validate`.
struct Template {
  std::string_view name, summary, text;
};

const std::vector<Template>& templates();

}  // namespace leastcost::app
