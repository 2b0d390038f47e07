// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/version.hpp>
#include "python/src/bind.hpp"
#include "python/src/signals.hpp"

PYBIND11_MODULE(_leastcost, module) {
  module.doc() =
      "What leastcost is made of. Use the package leastcost, which checks arguments and says what they mean.";
  module.attr("version") = LEASTCOST_VERSION;
  leastcost::python::translate_errors();
  leastcost::python::bind_externals(module);
  leastcost::python::bind_field(module);
  leastcost::python::bind_mesh(module);
  leastcost::python::bind_robot(module);
  leastcost::python::bind_run(module);
  leastcost::python::bind_pairs(module);
  leastcost::python::bind_reference(module);
  leastcost::python::bind_register(module);
  leastcost::python::bind_report(module);
  leastcost::python::bind_study(module);
  pybind11::module_::import("atexit").attr("register")(pybind11::cpp_function(&leastcost::python::Signals::end_all));
}
