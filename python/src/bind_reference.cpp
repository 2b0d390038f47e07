// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// What `leastcost describe` and `leastcost schema` print.
#include <pybind11/pybind11.h>

#include <string>
#include <vector>

#include <leastcost/framework/base/errors.hpp>
#include "app/reference/describe.hpp"
#include "catalogue/registry/registry.hpp"
#include "catalogue/yaml/suggest.hpp"
#include "python/src/bind.hpp"

namespace leastcost::python {
namespace {

namespace py = pybind11;
using namespace py::literals;

[[noreturn]] void unknown(const std::string& what, const std::string& word, const std::vector<std::string>& valid) {
  throw InputError("there is no " + what + " '" + word + "'" + did_you_mean(word, valid) +
                   "; there are: " + joined(valid));
}

/// Of a configuration, of a study, of a kind of plug-ins or of one of them.
std::string describe(const std::string& kind, const std::string& type) {
  if (type.empty() && kind == "run") return app::describe_run();
  if (type.empty() && kind == "study") return app::describe_study();
  const PluginKind* found = find_kind(kind == "post_process" ? "post_processor" : kind);
  if (found == nullptr) {
    std::vector<std::string> valid = {"run", "study"};
    for (const PluginKind& known : plugin_kinds()) valid.push_back(known.name);
    unknown("kind", kind, valid);
  }
  if (type.empty()) return app::describe_kind(*found);
  const PluginEntry* plugin = find_plugin(*found, type);
  if (plugin == nullptr) unknown(found->name, type, types_of(*found));
  return app::describe_plugin(*found, *plugin);
}

}  // namespace

void bind_reference(py::module_& module) {
  module.def("describe", &describe, "kind"_a, "type"_a, py::call_guard<py::gil_scoped_release>());
  module.def("schema", &app::json_schema, py::call_guard<py::gil_scoped_release>());
}

}  // namespace leastcost::python
