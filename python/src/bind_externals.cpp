// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// Objects of Python as the library takes them. Shapes, types and values are checked by the Python files.
#include <pybind11/stl.h>

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/problems/costs/cost_map.hpp>
#include <leastcost/problems/costs/zermelo.hpp>
#include <leastcost/problems/initializers/waypoints.hpp>
#include <leastcost/problems/manifolds/data/point_cloud.hpp>
#include <leastcost/problems/manifolds/data/terrain.hpp>
#include "python/src/arrays.hpp"
#include "python/src/bind.hpp"
#include "python/src/external.hpp"
#include "python/src/python_cost.hpp"
#include "python/src/signals.hpp"

namespace leastcost::python {
namespace {

namespace py = pybind11;
using namespace py::literals;

using Errors = std::shared_ptr<CallErrors>;
using Plane = std::array<double, 2>;

/// What `make` makes. An argument is no option of a configuration.
template <class Make>
auto made(const Make& make) {
  try {
    return make();
  } catch (const OptionError& e) {
    throw InputError(e.what());
  }
}

/// Row 0 of the array is the northernmost one.
RasterGrid raster_of(const Numbers& values, const Plane& origin, const Plane& cell, std::string source) {
  RasterGrid raster;
  raster.rows = static_cast<int>(values.shape(0));
  raster.columns = static_cast<int>(values.shape(1));
  raster.cell = Eigen::Vector2d(cell.data());
  raster.corner = Eigen::Vector2d(origin.data());
  raster.source = std::move(source);
  const auto at = values.unchecked<2>();
  raster.values.reserve(static_cast<std::size_t>(values.size()));
  for (int row = raster.rows - 1; row >= 0; --row)
    for (int column = 0; column < raster.columns; ++column) raster.values.push_back(at(row, column));
  return raster;
}

External domain(std::shared_ptr<const ConstraintManifold> manifold) { return {std::move(manifold)}; }

/// `normals`: of unit length, or of shape (0, 3); `numbers`: of the points among `count`.
External cloud(const Numbers& points, const Numbers& normals, std::vector<std::int32_t> numbers, std::int32_t count,
               int neighbours, std::optional<double> radius, double max_edge) {
  PointSamples samples{vectors_of(points), vectors_of(normals), std::move(numbers), count, {}, "points"};
  if (count > static_cast<std::int32_t>(samples.positions.size()))
    samples.notes.push_back(std::to_string(count - static_cast<std::int32_t>(samples.positions.size())) + " of " +
                            std::to_string(count) + " points removed: exact duplicates of earlier points");
  return interruptible([&](const std::function<bool()>& stop) {
    return made([&] {
      const Deadline deadline({}, stop);
      const PointCloudSettings settings{.neighbours = neighbours, .radius = radius, .max_edge = max_edge};
      return domain(surface_of(PointCloud(std::move(samples), settings, deadline), deadline));
    });
  });
}

External terrain(const Numbers& heights, const Plane& origin, const Plane& cell) {
  RasterGrid raster = raster_of(heights, origin, cell, "heights");
  const py::gil_scoped_release released;
  return domain(std::make_shared<const TerrainManifold>(std::move(raster)));
}

External cost_map(const Numbers& costs, const Plane& origin, const Plane& cell, bool cells) {
  const auto raster = std::make_shared<const RasterGrid>(raster_of(costs, origin, cell, "costs"));
  const auto reading = cells ? CostMapInterpolation::cells : CostMapInterpolation::smooth;
  return {CostMaker([raster, reading](int dimension, const Errors&) {
    return made([&] { return make_cost_map(*raster, reading, dimension); });
  })};
}

/// `nodes`: x, y, u, v in each row.
External wind(const Numbers& nodes, std::string speed, std::string unit) {
  return {CostMaker([table = Eigen::MatrixXd(columns_of(nodes).transpose()), speed = std::move(speed),
                     unit = std::move(unit)](int dimension, const Errors&) {
    if (dimension != 2)
      throw InputError("a wind from arrays is in the plane, but these points have " + std::to_string(dimension) +
                       " coordinates");
    return made([&] { return make_zermelo_cost({.speed = speed, .unit = unit}, table, dimension); });
  })};
}

External waypoints(const Numbers& points) {
  const std::shared_ptr<const Initializer> through =
      made([&] { return std::make_shared<const WaypointsInitializer>(columns_of(points)); });
  return {through};
}

/// `dimension`: 0 where the manifold tells it.
External cost(py::function q, py::function check, std::string unit, bool symmetric, bool additive, bool differences,
              int dimension) {
  // A cost with two directions has no metric at rest, but for rare ones.
  const PythonCostOptions options{
      std::move(q), std::move(check),
      CostTraits{.unit = std::move(unit), .symmetric = symmetric, .additive = additive, .quadratic_at_rest = symmetric},
      differences ? Derivatives::differences : Derivatives::complex_steps};
  const auto shared = std::make_shared<const PythonCostOptions>(options);
  return {CostMaker([shared, dimension](int of_manifold, const Errors& errors) {
    const py::gil_scoped_acquire gil;  // functions are copied
    auto made = std::make_shared<const PythonCost>(*shared, dimension > 0 ? dimension : of_manifold, errors);
    errors->add(made);
    return made;
  })};
}

}  // namespace

void bind_externals(py::module_& module) {
  py::class_<External>(module, "External");
  module.def("cloud", &cloud, "points"_a, "normals"_a, "numbers"_a, "count"_a, "neighbours"_a, "radius"_a,
             "max_edge"_a);
  module.def("terrain", &terrain, "heights"_a, "origin"_a, "cell"_a);
  module.def("cost_map", &cost_map, "costs"_a, "origin"_a, "cell"_a, "cells"_a);
  module.def("wind", &wind, "nodes"_a, "speed"_a, "unit"_a);
  module.def("waypoints", &waypoints, "points"_a);
  module.def("cost", &cost, "q"_a, "check"_a, "unit"_a, "symmetric"_a, "additive"_a, "differences"_a, "dimension"_a);
}

}  // namespace leastcost::python
