// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <exception>
#include <string>

#include <leastcost/catalogue/output/write_run.hpp>
#include <leastcost/catalogue/run/run.hpp>
#include <leastcost/catalogue/yaml/diagnostics.hpp>
#include <leastcost/framework/base/errors.hpp>
#include "python/src/bind.hpp"

namespace leastcost::python {
namespace {

namespace py = pybind11;
using namespace py::literals;

void raise(const char* name, const std::string& message) {
  const py::object type = py::module_::import("leastcost._errors").attr(name);
  PyErr_SetString(type.ptr(), message.c_str());
}

/// With the places, for editors and notebooks.
void raise(const ConfigError& error) {
  py::list places;
  for (const Diagnostic& d : error.diagnostics().sorted())
    places.append(py::dict("where"_a = error.diagnostics().where(d.place), "line"_a = d.place.line,
                           "column"_a = d.place.column, "length"_a = d.place.length, "message"_a = d.message));
  const py::object type = py::module_::import("leastcost._errors").attr("ConfigError");
  const py::object instance = type(error.what(), places);
  PyErr_SetObject(type.ptr(), instance.ptr());
}

void translate(std::exception_ptr thrown) {
  try {
    if (thrown) std::rethrow_exception(thrown);
  } catch (const ConfigError& e) {
    raise(e);
  } catch (const OptionError& e) {
    raise("ConfigError", said_of(in_quotes(e.key()), e.reason()));
  } catch (const InputError& e) {
    raise("InputError", e.what());
  } catch (const InitializationError& e) {
    raise("NoPathError", e.what());
  } catch (const StoppedEarly& e) {  // of a request: Signals::raise() came first
    raise("TimeLimitError", e.what());
  } catch (const Interrupted& e) {
    raise("TimeLimitError", e.what());
  } catch (const HostError& e) {
    raise("OutputError", e.what());
  } catch (const Error& e) {
    raise("Error", e.what());
  }
}

}  // namespace

void translate_errors() { py::register_local_exception_translator(translate); }

}  // namespace leastcost::python
