// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <Eigen/Core>
#include <string>
#include <vector>

#include <leastcost/catalogue/plugins/end_options.hpp>

namespace leastcost::python {

/// A vertex, a face with barycentric coordinates, or a point; end_tuple() of _places.py checks them.
inline EndOptions end_of(const pybind11::tuple& end) {
  const auto vector_of = [](const std::vector<double>& numbers) -> Eigen::VectorXd {
    return Eigen::Map<const Eigen::VectorXd>(numbers.data(), static_cast<Eigen::Index>(numbers.size()));
  };
  const std::string form = end[0].cast<std::string>();
  EndOptions options;
  if (form == "vertex") {
    options.vertex = end[1].cast<int>();
  } else if (form == "face") {
    options.face = end[1].cast<int>();
    options.barycentric = vector_of(end[2].cast<std::vector<double>>());
  } else {
    options.point = vector_of(end[1].cast<std::vector<double>>());
  }
  return options;
}

}  // namespace leastcost::python
