// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "python/src/definition.hpp"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <type_traits>

namespace leastcost::python {

namespace py = pybind11;

namespace {

/// The words of a choice are those of an enum elsewhere; here they are known when the program runs.
class ChoiceOfWords : public FieldVisitor {
 public:
  using FieldVisitor::choice_of;
};

}  // namespace

PythonOptions::PythonOptions(std::shared_ptr<const Definition> definition)
    : definition_(std::move(definition)), errors_(ErrorsOfThread::now()) {
  for (const OwnOption& option : definition_->options) values_.push_back(option.value);
}

void PythonOptions::fields(FieldVisitor& visit) {
  for (std::size_t i = 0; i < values_.size(); ++i) {
    const OwnOption& option = definition_->options[i];
    const FieldDoc doc{.help = option.help,
                       .unit = option.unit,
                       .minimum = option.minimum,
                       .maximum = option.maximum,
                       .exclusive_minimum = option.exclusive_minimum,
                       .required = option.required};
    std::visit(
        [&](auto& value) {
          using Value = std::decay_t<decltype(value)>;
          if constexpr (std::is_same_v<Value, FileName>)
            visit.file(option.key, value.name, doc);
          else if constexpr (std::is_same_v<Value, ChosenWord>)
            (visit.*&ChoiceOfWords::choice_of)(option.key, value.chosen, value.words, doc);
          else
            visit.field(option.key, value, doc);
        },
        values_[i]);
  }
}

py::dict PythonOptions::dict(const std::filesystem::path& folder) const {
  const auto object_of = [&](const auto& value) -> py::object {
    using Value = std::decay_t<decltype(value)>;
    if constexpr (std::is_same_v<Value, FileName>) {
      return py::str(value.name.empty() ? "" : (folder / value.name).string());
    } else if constexpr (std::is_same_v<Value, ChosenWord>) {
      return py::str(value.words[value.chosen]);
    } else if constexpr (std::is_same_v<Value, Eigen::VectorXd>) {
      return py::array_t<double>(value.size(), value.data());
    } else if constexpr (std::is_same_v<Value, Eigen::MatrixXd>) {
      const Eigen::MatrixXd columns = value.transpose();
      return py::array_t<double>({value.rows(), value.cols()}, columns.data());
    } else {
      return py::cast(value);
    }
  };
  py::dict all;
  for (std::size_t i = 0; i < values_.size(); ++i)
    all[py::str(definition_->options[i].key)] = std::visit(object_of, values_[i]);
  return all;
}

}  // namespace leastcost::python
