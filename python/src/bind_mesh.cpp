// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <limits>
#include <string>
#include <vector>

#include "python/src/arrays.hpp"
#include "python/src/bind.hpp"
#include "python/src/mesh.hpp"
#include "python/src/signals.hpp"

namespace leastcost::python {
namespace {

namespace py = pybind11;
using namespace py::literals;

/// The answer of `search(stop)`, which runs without the GIL. Ctrl-C is raised: half a search proves nothing.
template <class Search>
auto interruptible(Search search) {
  Signals signals;
  auto found = [&] {
    try {
      const py::gil_scoped_release released;
      return search([&signals] { return signals.stop(); });
    } catch (const std::exception&) {
      signals.raise();
      throw;
    }
  }();
  signals.raise();
  return found;
}

/// Points, faces (numbers of F), length, lower bound, word.
py::tuple tuple_of(const Mesh& mesh, const ExactResult& found) {
  const std::vector<Eigen::Vector3d>& points = found.path.points;
  py::array_t<double> at({static_cast<py::ssize_t>(points.size()), py::ssize_t{3}});
  for (std::size_t i = 0; i < points.size(); ++i)
    Eigen::Map<Eigen::Vector3d>(at.mutable_data(static_cast<py::ssize_t>(i), 0)) = points[i];
  py::array_t<std::int32_t> faces(static_cast<py::ssize_t>(found.path.faces.size()));
  for (std::size_t i = 0; i < found.path.faces.size(); ++i)
    faces.mutable_at(static_cast<py::ssize_t>(i)) = mesh.mesh().file_face(found.path.faces[i]);
  return py::make_tuple(at, faces, found.length, found.lower_bound, std::string(word_of(found.outcome)), found.reason);
}

py::tuple geodesic(const Mesh& mesh, const SurfacePoint& source, const SurfacePoint& target) {
  return tuple_of(mesh, interruptible([&](const Mesh::Stop& stop) { return mesh.geodesic(source, target, stop); }));
}

/// One value per row of V; infinite for vertices that no face uses.
py::array_t<double> in_order_of_v(const TriangleMesh& mesh, const std::vector<double>& values) {
  py::array_t<double> out(mesh.file_vertex_count());
  for (std::int32_t v = 0; v < mesh.file_vertex_count(); ++v) {
    const std::int32_t own = mesh.vertex_of_file(v);
    out.mutable_at(v) = own < 0 ? std::numeric_limits<double>::infinity() : values[static_cast<std::size_t>(own)];
  }
  return out;
}

/// Distances, lower and upper bounds, whether all are known.
py::tuple distances(const Mesh& mesh, const std::vector<SurfacePoint>& sources, double max_distance) {
  ExactDistances found =
      interruptible([&](const Mesh::Stop& stop) { return mesh.distances(sources, max_distance, stop); });
  for (std::size_t i = 0; i < found.distance.size(); ++i)  // what was not seen to its end is known from above alone
    if (!(found.at_least[i] < found.seen_to)) found.distance[i] = found.at_most[i];
  const auto array = [&](const std::vector<double>& values) { return in_order_of_v(mesh.mesh(), values); };
  return py::make_tuple(array(found.distance), array(found.at_least), array(found.at_most), found.blocked,
                        found.out_of_memory);
}

}  // namespace

void bind_mesh(py::module_& module) {
  py::class_<SurfacePoint>(module, "SurfacePoint")
      .def_readonly("face", &SurfacePoint::face)
      .def_property_readonly("barycentric", [](const SurfacePoint& p) {
        return py::make_tuple(p.barycentric[0], p.barycentric[1], p.barycentric[2]);
      });
  using Released = py::call_guard<py::gil_scoped_release>;
  py::class_<Mesh>(module, "Mesh")
      .def(py::init<const Mesh::Vertices&, const Mesh::Faces&, bool>(), "V"_a, "F"_a, "weld"_a, Released())
      .def(py::init<const std::filesystem::path&, bool>(), "file"_a, "weld"_a, Released())
      .def("V", [](const Mesh& mesh) { return rows_of(mesh.vertices()); })
      .def("F", [](const Mesh& mesh) { return rows_of(mesh.faces()); })
      .def("notes", [](const Mesh& mesh) { return mesh.mesh().notes(); })
      .def("vertex", &Mesh::vertex, "v"_a)
      .def(
          "nearest",
          [](const Mesh& mesh, double x, double y, double z) {
            return mesh.nearest({x, y, z});
          },
          "x"_a, "y"_a, "z"_a, Released())
      .def("geodesic", &geodesic, "source"_a, "target"_a)
      .def("distances", &distances, "sources"_a, "max_distance"_a);
}

}  // namespace leastcost::python
