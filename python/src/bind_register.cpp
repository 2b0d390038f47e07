// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// Costs, solvers and initializers written in Python as plug-ins. A name is registered in the library once; what it
// stands for is looked up here, so that a name that is registered again keeps nothing of before alive.
#include <pybind11/stl.h>

#include <cstddef>
#include <exception>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/problems/initializers/waypoints.hpp>
#include "python/src/arrays.hpp"
#include "python/src/bind.hpp"
#include "python/src/chain.hpp"
#include "python/src/definition.hpp"
#include "python/src/external.hpp"
#include "python/src/python_solver.hpp"

namespace leastcost::python {
namespace {

namespace py = pybind11;
using namespace py::literals;

/// What a name stands for now.
class Slot {
 public:
  std::shared_ptr<const Definition> now() const {
    const std::lock_guard lock(mutex_);
    return now_;
  }
  void set(std::shared_ptr<const Definition> definition) {
    const std::lock_guard lock(mutex_);
    now_.swap(definition);
  }
  std::string summary;  ///< guarded by the GIL

 private:
  mutable std::mutex mutex_;
  std::shared_ptr<const Definition> now_;
};

/// By kind and name. Never destroyed: the library keeps what refers to them, and functions must not outlive Python.
Slot*& slot_of(const std::string& kind, const std::string& type) {
  static auto& all = *new std::map<std::pair<std::string, std::string>, Slot*>();
  return all[{kind, type}];
}

/// What `call` returns, with the GIL; what it raises is kept.
template <class Call>
auto guarded(CallErrors& errors, const Call& call) {
  const py::gil_scoped_acquire gil;
  try {
    return call();
  } catch (...) {
    errors.keep(std::current_exception());
    throw;
  }
}

std::shared_ptr<const SegmentCost> made_cost(const PythonOptions& options, const BuildContext& context) {
  const External made = guarded(
      *options.errors(), [&] { return options.definition().call(options.dict(context.folder)).cast<External>(); });
  if (const auto* maker = std::get_if<CostMaker>(&made.made)) return (*maker)(context.dimension, options.errors());
  throw InputError("the cost '" + options.definition().type + "' made something else");
}

std::shared_ptr<const Solver> made_solver(const PythonOptions& options, const BuildContext& context) {
  return std::make_shared<const PythonSolver>(options, context.folder);
}

/// A first path written in Python.
class PythonInitializer final : public Initializer, public MakesRings {
 public:
  PythonInitializer(const PythonOptions& options, std::filesystem::path folder)
      : options_(options), folder_(std::move(folder)) {}
  std::string_view name() const override { return options_.definition().type; }

  FirstPath first_path(const Problem& problem, const Monitor& monitor) const override {
    const auto place_of = [&](const PathEnd& end) -> py::object {
      if (problem.ring) return py::none();
      const CoordinatePath one{end.u, end.site == kNoSite ? std::vector<Site>() : std::vector<Site>{end.site}};
      const Points x = positions(*problem.manifold, one);
      return py::array_t<double>(x.rows(), x.data());
    };
    const Points points = guarded(*options_.errors(), [&]() -> Points {
      const Numbers rows = options_.definition().call(place_of(problem.source), place_of(problem.target),
                                                      problem.manifold->dimensions().ambient, options_.dict(folder_));
      return columns_of(rows);
    });
    FirstPath first = WaypointsInitializer(points).first_path(problem, monitor);
    return first;
  }

 private:
  PythonOptions options_;
  std::filesystem::path folder_;
};

std::shared_ptr<const Initializer> made_initializer(const PythonOptions& options, const BuildContext& context) {
  return std::make_shared<const PythonInitializer>(options, context.folder);
}

OptionValue value_of(const std::string& kind, const py::object& value) {
  if (kind == "bool") return value.cast<bool>();
  if (kind == "int") return value.cast<int>();
  if (kind == "float") return value.cast<double>();
  if (kind == "text") return value.cast<std::string>();
  if (kind == "file") return FileName{value.cast<std::string>()};
  if (kind == "choice") {
    const py::tuple said = value;
    return ChosenWord{said[0].cast<std::size_t>(), said[1].cast<std::vector<std::string>>()};
  }
  if (kind == "vector") {
    const auto numbers = value.cast<Numbers>();
    return Eigen::VectorXd(Eigen::Map<const Eigen::VectorXd>(numbers.data(), numbers.size()));
  }
  if (kind == "matrix") return Eigen::MatrixXd(columns_of(value.cast<Numbers>()).transpose());
  if (kind == "numbers") return value.cast<std::map<std::string, double>>();
  return value.cast<std::vector<std::string>>();
}

OwnOption option_of(const py::tuple& said) {
  return {said[0].cast<std::string>(), value_of(said[1].cast<std::string>(), said[2]),
          said[3].cast<std::string>(), said[4].cast<std::string>(),
          said[5].cast<double>(),      said[6].cast<double>(),
          said[7].cast<bool>(),        said[8].cast<bool>()};
}

/// `make`: of a PythonOptions and a BuildContext. Throws InputError for a name that the library or C++ has.
template <class Interface, class Make>
void add(const char* kind, const std::string& type, const std::string& summary, const py::list& options,
         const py::function& call, WaitsFor waits_for, std::vector<std::string> provides, Make make) {
  auto definition = std::make_shared<Definition>();
  definition->type = type;
  definition->call = call;
  for (const py::handle& said : options)
    definition->options.push_back(option_of(py::reinterpret_borrow<py::tuple>(said)));
  Slot*& known = slot_of(kind, type);
  const bool is_new = known == nullptr;
  if (is_new || known->summary != summary) {
    std::unique_ptr<Slot> made = is_new ? std::make_unique<Slot>() : nullptr;
    Slot* slot = is_new ? made.get() : known;
    if (is_new) slot->set(definition);
    OwnPlugin<std::shared_ptr<const Interface>> plugin;
    plugin.type = type;
    plugin.summary = summary;
    plugin.provides = std::move(provides);
    plugin.facts.waits_for = waits_for;
    plugin.replaces = !is_new;
    plugin.defaults = [slot] { return std::make_unique<PythonOptions>(slot->now()); };
    plugin.make = [make](const OwnOptions& chosen, const BuildContext& context) {
      return make(static_cast<const PythonOptions&>(chosen), context);
    };
    add_plugin(std::move(plugin));
    slot->summary = summary;
    if (is_new) known = made.release();
  }
  known->set(std::move(definition));
}

}  // namespace

void bind_register(py::module_& module) {
  py::class_<Chain, std::shared_ptr<Chain>>(module, "Chain")
      .def_property_readonly("points", &Chain::points)
      .def_property_readonly("ring", &Chain::ring)
      .def("value", &Chain::value, "points"_a)
      .def("value_and_gradient", &Chain::value_and_gradient, "points"_a)
      .def("retract", &Chain::retract, "points"_a, "steps"_a);
  const auto define = [&](const char* name, auto added) {
    module.def(name, added, "name"_a, "summary"_a, "options"_a, "call"_a);
  };
  define("register_cost",
         [](const std::string& name, const std::string& summary, const py::list& options, const py::function& call) {
           add<SegmentCost>("cost", name, summary, options, call, WaitsFor::domain, {}, made_cost);
         });
  define("register_solver",
         [](const std::string& name, const std::string& summary, const py::list& options, const py::function& call) {
           add<Solver>("solver", name, summary, options, call, WaitsFor::nothing, {}, made_solver);
         });
  define("register_initializer",
         [](const std::string& name, const std::string& summary, const py::list& options, const py::function& call) {
           add<Initializer>("initializer", name, summary, options, call, WaitsFor::nothing,
                            abilities_of<std::shared_ptr<const PythonInitializer>>(), made_initializer);
         });
}

}  // namespace leastcost::python
