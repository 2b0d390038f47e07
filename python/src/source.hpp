// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <leastcost/catalogue/run/load_run.hpp>
#include "python/src/external.hpp"

namespace leastcost::python {

/// A configuration as _config.py hands it over.
struct Source {
  std::optional<std::filesystem::path> file;  ///< read from here
  std::optional<ConfigValue::Block> tree;     ///< else this
  std::string text;                           ///< else this
  std::filesystem::path folder;               ///< of a tree or a text: its files are relative to it
  std::vector<std::string> assignments;       ///< to its options
  std::map<std::string, External> externals;

  /// The run, as load_run() makes it. Without the GIL. What functions raise goes to `errors`.
  Run read(const BuildProgress& progress, const std::shared_ptr<CallErrors>& errors) const;
  /// Throws every error of the configuration, without making its domain. Without the GIL.
  void validate() const;

 private:
  std::vector<Override> overrides() const;
  Externals objects(const std::shared_ptr<CallErrors>& errors) const;
};

/// A dict with keys that are texts and values that are None, bool, int, float, str, lists and dicts.
ConfigValue::Block block_of(const pybind11::dict& plain);

}  // namespace leastcost::python
