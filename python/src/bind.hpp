// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

namespace leastcost::python {

/// C++ exceptions become those of leastcost/_errors.py.
void translate_errors();

void bind_externals(pybind11::module_& module);
void bind_field(pybind11::module_& module);
void bind_mesh(pybind11::module_& module);
void bind_robot(pybind11::module_& module);
void bind_run(pybind11::module_& module);
void bind_pairs(pybind11::module_& module);
void bind_reference(pybind11::module_& module);
void bind_register(pybind11::module_& module);
void bind_report(pybind11::module_& module);
void bind_study(pybind11::module_& module);

}  // namespace leastcost::python
