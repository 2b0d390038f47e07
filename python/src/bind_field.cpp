// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <exception>
#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <leastcost/catalogue/catalogue.hpp>
#include <leastcost/catalogue/output/write_run.hpp>
#include "app/field/field_files.hpp"
#include "app/field/field_summary.hpp"
#include "app/field/run_field.hpp"
#include "catalogue/output/unit_of_cost.hpp"
#include "python/src/arrays.hpp"
#include "python/src/bind.hpp"
#include "python/src/ends.hpp"
#include "python/src/signals.hpp"
#include "python/src/source.hpp"

namespace leastcost::python {
namespace {

namespace py = pybind11;
using namespace py::literals;
using app::FieldPlace;
using app::RunField;

/// A field, and the functions of its cost.
struct Field {
  RunField field;
  std::shared_ptr<CallErrors> errors;
};

/// The answer of `work(monitor)`, without the GIL. What a handler or a function raises is raised here.
template <class Work>
auto listening(const std::shared_ptr<CallErrors>& errors, Work work) {
  return interruptible([&](const std::function<bool()>& stop) {
    Monitor monitor;
    monitor.stop_requested = [&] { return stop() || errors->any(); };
    try {
      return work(monitor);
    } catch (const std::exception&) {
      const py::gil_scoped_acquire held;
      errors->raise();
      throw;
    }
  });
}

/// A place with the words for errors about it.
FieldPlace place_of(const py::tuple& named) {
  return {end_of(named[1].cast<py::tuple>()), named[0].cast<std::string>()};
}

/// `places`: (words, end) each; none: the source of the configuration.
Field field(const Source& source, const std::vector<py::tuple>& places, bool to_here,
            std::optional<double> resolution) {
  app::FieldEnds ends;
  for (const py::tuple& place : places) ends.from.push_back(place_of(place));
  const auto errors = std::make_shared<CallErrors>();
  Field made{listening(errors,
                       [&](const Monitor& monitor) {
                         const BuildProgress progress = [&](double, std::string_view) {
                           if (monitor.interrupted()) throw StoppedEarly("interrupted before the field was found");
                         };
                         const Run run = source.read(progress, errors, EndsFrom::caller);
                         return RunField(run, ends, {.resolution = resolution, .to_places = to_here}, monitor);
                       }),
             errors};
  errors->raise();
  errors->end();
  return made;
}

Field corridor(const Field& from, const std::optional<py::tuple>& to) {
  std::optional<FieldPlace> place;
  if (to) place = place_of(*to);
  return {listening(from.errors,
                    [&](const Monitor& monitor) {
                      return from.field.corridor(place ? from.field.place(*place) : from.field.target(), monitor);
                    }),
          from.errors};
}

/// Points, cost.
py::tuple way(const Field& field, const py::tuple& to) {
  const FieldPlace place = place_of(to);
  const app::FieldWay way = listening(
      field.errors, [&](const Monitor& monitor) { return field.field.way(field.field.place(place), monitor); });
  Eigen::MatrixXd points(way.points.front().size(), static_cast<Eigen::Index>(way.points.size()));
  for (std::size_t i = 0; i < way.points.size(); ++i) points.col(static_cast<Eigen::Index>(i)) = way.points[i];
  return py::make_tuple(rows_of(points), way.cost);
}

/// As its axes say: rows x columns, the northernmost row first; or one per vertex of the file.
py::array values(const Field& made) {
  const RunField& field = made.field;
  if (field.on_mesh()) {
    const std::vector<double> all = in_order_of_file(field.mesh(), field.on_vertices());
    return py::array_t<double>(static_cast<py::ssize_t>(all.size()), all.data());
  }
  if (field.in_space()) {
    const SpaceField& space = field.space();
    py::array_t<double> out({space.count[0], space.count[1], space.count[2]});
    auto nodes = out.mutable_unchecked<3>();
    for (std::int32_t i = 0; i < space.count[0]; ++i)
      for (std::int32_t j = 0; j < space.count[1]; ++j)
        for (std::int32_t k = 0; k < space.count[2]; ++k) nodes(i, j, k) = space.value(i, j, k);
    return out;
  }
  const CostField lattice = app::as_map(field);
  py::array_t<double> out({lattice.count[1], lattice.count[0]});
  auto rows = out.mutable_unchecked<2>();
  for (std::int32_t j = 0; j < lattice.count[1]; ++j)
    for (std::int32_t i = 0; i < lattice.count[0]; ++i) rows(lattice.count[1] - 1 - j, i) = lattice.value(i, j);
  return out;
}

/// x of the columns and y of the rows; none on a mesh.
std::optional<py::tuple> axes(const Field& made) {
  if (made.field.on_mesh()) return std::nullopt;
  if (made.field.in_space()) {
    const SpaceField& space = made.field.space();
    py::tuple axes(3);
    for (std::size_t d = 0; d < 3; ++d) {
      const auto axis = static_cast<Eigen::Index>(d);
      Eigen::VectorXd x(space.count[d]);
      for (Eigen::Index i = 0; i < x.size(); ++i) x[i] = space.lower[axis] + double(i) * space.step[axis];
      axes[d] = py::array_t<double>(x.size(), x.data());
    }
    return axes;
  }
  const CostField lattice = app::as_map(made.field);
  Eigen::VectorXd x(lattice.count[0]), y(lattice.count[1]);
  for (std::int32_t i = 0; i < lattice.count[0]; ++i) x[i] = lattice.node(i, 0).x();
  for (std::int32_t j = 0; j < lattice.count[1]; ++j) y[j] = lattice.node(0, lattice.count[1] - 1 - j).y();
  return py::make_tuple(py::array_t<double>(x.size(), x.data()), py::array_t<double>(y.size(), y.data()));
}

/// The vertices of the file and the triangles, in their numbers; none over a lattice.
std::optional<py::tuple> mesh(const Field& made) {
  if (!made.field.on_mesh()) return std::nullopt;
  const TriangleMesh& mesh = made.field.mesh();
  Eigen::Matrix3Xd vertices = Eigen::Matrix3Xd::Constant(3, mesh.file_vertex_count(), std::nan(""));
  for (std::int32_t v = 0; v < mesh.file_vertex_count(); ++v)
    if (mesh.vertex_of_file(v) >= 0) vertices.col(v) = mesh.position(mesh.vertex_of_file(v));
  Eigen::Matrix<std::int32_t, 3, Eigen::Dynamic> faces(3, mesh.face_count());
  for (std::int32_t f = 0; f < mesh.face_count(); ++f)
    for (int k = 0; k < 3; ++k) faces(k, f) = mesh.file_vertex(mesh.face(f)[static_cast<std::size_t>(k)]);
  return py::make_tuple(rows_of(vertices), rows_of(faces));
}

/// The largest and the mean error; on a mesh the mean is NaN.
py::tuple errors(const Field& made) {
  const RunField& field = made.field;
  if (field.in_space()) return py::make_tuple(field.space().error, field.space().mean_error);
  if (!field.on_mesh()) return py::make_tuple(field.lattice().error, field.lattice().mean_error);
  double most = 0;
  for (const double error : field.on_vertices().errors) most = std::max(most, error);
  return py::make_tuple(most, std::nan(""));
}

void save(const Field& made, const std::filesystem::path& file) {
  const app::FieldFormat format = app::field_format(file.string());
  const std::string text = field_text(made.field, format);
  std::ofstream out(file, std::ios::binary);
  out << text << std::flush;
  if (!out) throw HostError("cannot write " + file.string());
}

}  // namespace

void bind_field(py::module_& module) {
  py::class_<Field>(module, "Field")
      .def("values", &values)
      .def("axes", &axes)
      .def("mesh", &mesh)
      .def("errors", &errors)
      .def("method", [](const Field& made) { return app::method_of(made.field); })
      .def("unit", [](const Field& made) { return unit_of_cost(made.field.problem()); })
      .def("directed", [](const Field& made) { return app::is_directed(made.field); })
      .def("is_corridor", [](const Field& made) { return made.field.is_corridor(); })
      .def("way", &way, "to"_a)
      .def("corridor", &corridor, "to"_a)
      .def("save", &save, "file"_a);
  module.def("field", &field, "source"_a, "places"_a, "to_here"_a, "resolution"_a);
}

}  // namespace leastcost::python
