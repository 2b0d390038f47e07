// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <array>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "python/src/arrays.hpp"
#include "python/src/bind.hpp"
#include "python/src/external.hpp"
#include "python/src/mesh.hpp"
#include "python/src/signals.hpp"

namespace leastcost::python {
namespace {

namespace py = pybind11;
using namespace py::literals;

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

using Whole = py::array_t<std::int32_t, py::array::c_style>;

/// All that a mesh was made of.
py::tuple state_of(const Mesh& mesh) {
  const PolygonSoup& soup = mesh.soup();
  const auto array = [](const std::vector<std::int32_t>& numbers) {
    return Whole(static_cast<py::ssize_t>(numbers.size()), numbers.data());
  };
  return py::make_tuple(rows_of(mesh.vertices()), array(soup.corners), array(soup.polygon_begin), soup.source,
                        mesh.weld());
}

std::unique_ptr<Mesh> mesh_of(const py::tuple& state) {
  const auto list = [&](std::size_t i) {
    const Whole numbers = state[i].cast<Whole>();
    return std::vector<std::int32_t>(numbers.data(), numbers.data() + numbers.size());
  };
  PolygonSoup soup{{}, list(1), list(2), state[3].cast<std::string>()};
  soup.positions = vectors_of(state[0].cast<Numbers>());
  return std::make_unique<Mesh>(std::move(soup), state[4].cast<bool>());
}

}  // namespace

void bind_mesh(py::module_& module) {
  py::class_<SurfacePoint>(module, "SurfacePoint");  // a place on the triangles that the library makes of F
  py::class_<Mesh>(module, "Mesh")
      .def(py::init([](const Mesh::Vertices& vertices, const Mesh::Faces& faces, bool weld) {
             return interruptible([&](const Mesh::Stop& stop) {
               return std::make_unique<Mesh>(vertices, faces, weld, Deadline({}, stop));
             });
           }),
           "V"_a, "F"_a, "weld"_a)
      .def(py::init([](const std::filesystem::path& file, bool weld) {
             return interruptible(
                 [&](const Mesh::Stop& stop) { return std::make_unique<Mesh>(file, weld, Deadline({}, stop)); });
           }),
           "file"_a, "weld"_a)
      .def("V", [](const Mesh& mesh) { return rows_of(mesh.vertices()); })
      .def("F", [](const Mesh& mesh) { return rows_of(mesh.faces()); })
      .def("notes", [](const Mesh& mesh) { return mesh.mesh().notes(); })
      .def("vertex", &Mesh::vertex, "v"_a)
      .def(
          "nearest",
          [](const Mesh& mesh, double x, double y, double z) {
            return interruptible([&](const Mesh::Stop& stop) { return mesh.nearest({x, y, z}, Deadline({}, stop)); });
          },
          "x"_a, "y"_a, "z"_a)
      .def(
          "on_face",
          [](const Mesh& mesh, std::int64_t face, const std::array<double, 3>& barycentric) {
            return mesh.on_face(face, Eigen::Vector3d(barycentric.data()));
          },
          "face"_a, "barycentric"_a)
      .def(
          "position",
          [](const Mesh& mesh, const SurfacePoint& place) {
            const Eigen::Vector3d x = mesh.mesh().point(place);
            return py::make_tuple(x[0], x[1], x[2]);
          },
          "place"_a)
      .def("geodesic", &geodesic, "source"_a, "target"_a)
      .def("distances", &distances, "sources"_a, "max_distance"_a)
      .def("external",
           [](const Mesh& mesh) {
             const std::shared_ptr<const ConstraintManifold> manifold = mesh.manifold();
             return External{manifold};
           })
      .def(py::pickle(&state_of, &mesh_of));
}

}  // namespace leastcost::python
