// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace leastcost::app {

/// A commented starter configuration or study. Every one passes `leastcost validate`, and runs where its files are.
struct Template {
  std::string name, summary, text;
};

const std::vector<Template>& templates();

}  // namespace leastcost::app
