// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

#include <Eigen/Core>
#include <cstddef>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <leastcost/catalogue/registry/register.hpp>
#include "python/src/call_errors.hpp"

namespace leastcost::python {

/// A path to a file, as a configuration has it.
struct FileName {
  std::string name;
};

/// One of several words, by its position.
struct ChosenWord {
  std::size_t chosen;
  std::vector<std::string> words;
};

/// The value of an option, of one of the types that FieldVisitor has.
using OptionValue = std::variant<bool, int, double, std::string, Eigen::VectorXd, Eigen::MatrixXd,
                                 std::map<std::string, double>, std::vector<std::string>, FileName, ChosenWord>;

/// One option of a plug-in that is written in Python.
struct OwnOption {
  std::string key;
  OptionValue value;  ///< the default
  std::string help, unit;
  double minimum, maximum;  ///< infinite where there is no bound
  bool exclusive_minimum, required;
};

/// A plug-in that is written in Python, as it was registered.
struct Definition {
  std::string type;
  std::vector<OwnOption> options;
  pybind11::function call;  ///< of _register.py; what it takes depends on the kind

  Definition() = default;
  ~Definition() {
    const pybind11::gil_scoped_acquire gil;
    call = {};
  }
  Definition(const Definition&) = delete;
  Definition& operator=(const Definition&) = delete;
};

/// Its options in one configuration.
class PythonOptions final : public OwnOptions {
 public:
  explicit PythonOptions(std::shared_ptr<const Definition> definition);
  void fields(FieldVisitor& visit) override;

  const Definition& definition() const { return *definition_; }
  /// Of the run that it was read for.
  const std::shared_ptr<CallErrors>& errors() const { return errors_; }
  /// By their names; files are those in `folder`, vectors and matrices arrays. With the GIL.
  pybind11::dict dict(const std::filesystem::path& folder) const;

 private:
  std::shared_ptr<const Definition> definition_;
  std::vector<OptionValue> values_;
  std::shared_ptr<CallErrors> errors_;
};

}  // namespace leastcost::python
