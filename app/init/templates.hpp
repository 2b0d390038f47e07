// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace leastcost::app {

/// A file that a configuration reads.
struct SampleFile {
  std::string name;
  std::string (*text)();
};

/// A commented starting configuration or study. Every one runs beside its files.
struct Template {
  std::string name, summary, text;
  std::vector<SampleFile> files = {};
  std::string command = "run";  ///< or "study"
};

const std::vector<Template>& templates();

}  // namespace leastcost::app
