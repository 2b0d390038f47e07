// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <leastcost/catalogue/run/load_run.hpp>
#include "catalogue/config/run_config.hpp"
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
  Run read(const BuildProgress& progress, const std::shared_ptr<CallErrors>& errors,
           EndsFrom ends = EndsFrom::configuration) const;
  /// Throws every error of the configuration, without making its domain. Without the GIL.
  void validate() const;

 private:
  std::vector<Override> overrides() const;
  Externals objects(const std::shared_ptr<CallErrors>& errors) const;
};

/// Where nothing says how many coordinates points have.
inline constexpr int kAnyDimension = 2;

/// Of the space in which the points of a configuration are. What is wrong with its manifold is said when it is read.
int dimension_of(const RunConfig& config, const std::filesystem::path& folder);

/// The objects, with costs that are functions made for points of as many coordinates as `dimension` finds: it reads the
/// configuration with all of them made for any. Without the GIL.
Externals objects_of(const std::map<std::string, External>& externals, const std::shared_ptr<CallErrors>& errors,
                     const std::function<int(const Externals& all)>& dimension);

/// A dict with keys that are texts and values that are None, bool, int, float, str, lists and dicts.
ConfigValue::Block block_of(const pybind11::dict& plain);

}  // namespace leastcost::python
