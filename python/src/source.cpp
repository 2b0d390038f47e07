// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "python/src/source.hpp"

#include <cstdint>
#include <utility>
#include <variant>

#include <leastcost/framework/base/errors.hpp>
#include "catalogue/config/load_config.hpp"
#include "catalogue/plugins/kinds.hpp"
#include "catalogue/run/compose.hpp"

namespace leastcost::python {
namespace {

namespace py = pybind11;

constexpr const char* kName = "config";  // of what has no file

LoadedConfig load(const Source& source, const std::vector<Override>& overrides, const Externals& externals) {
  if (source.file) return load_config(*source.file, overrides, externals);
  if (source.tree) return parse_config(*source.tree, kName, source.folder, overrides, externals);
  return parse_config(source.text, kName, source.folder, overrides, externals);
}

ConfigValue value_of(const py::handle& plain) {
  if (plain.is_none()) return {};
  if (py::isinstance<py::bool_>(plain)) return plain.cast<bool>();
  if (py::isinstance<py::int_>(plain)) return plain.cast<std::int64_t>();
  if (py::isinstance<py::float_>(plain)) return plain.cast<double>();
  if (py::isinstance<py::str>(plain)) return plain.cast<std::string>();
  if (py::isinstance<py::dict>(plain)) return block_of(py::reinterpret_borrow<py::dict>(plain));
  ConfigValue::List list;
  for (const py::handle item : py::reinterpret_borrow<py::list>(plain)) list.push_back(value_of(item));
  return list;
}

}  // namespace

std::vector<Override> Source::overrides() const {
  std::vector<Override> list;
  for (const std::string& assignment : assignments) list.push_back({assignment, "set: " + assignment});
  return list;
}

int dimension_of(const RunConfig& config, const std::filesystem::path& folder) {
  using Made = std::shared_ptr<const ConstraintManifold>;
  const PluginChoice& manifold = config.manifold;
  if (!manifold) return kAnyDimension;
  try {
    BuildContext context;
    context.folder = folder;
    const WaitsFor what = waits_for<Made>(manifold);
    if (what == WaitsFor::robot && config.robot)
      return static_cast<int>(make<std::shared_ptr<const Robot>>(config.robot, context)->kinematics->dimension());
    if (what != WaitsFor::nothing) return manifold.plugin->ambient > 0 ? manifold.plugin->ambient : kAnyDimension;
    return make<Made>(manifold, context)->dimensions().ambient;
  } catch (const Error&) {
    return kAnyDimension;
  }
}

Externals objects_of(const std::map<std::string, External>& externals, const std::shared_ptr<CallErrors>& errors,
                     const std::function<int(const Externals&)>& dimension) {
  Externals all;
  bool functions = false;
  const auto make = [&](int coordinates) {
    for (const auto& [name, external] : externals)
      if (const auto* maker = std::get_if<CostMaker>(&external.made)) {
        functions = true;
        all.insert_or_assign(name, (*maker)(coordinates, errors));
      }
  };
  for (const auto& [name, external] : externals)
    if (const auto* object = std::get_if<ExternalObject>(&external.made)) all.emplace(name, *object);
  make(kAnyDimension);
  if (!functions) return all;
  if (const int found = dimension(all); found != kAnyDimension) make(found);
  return all;
}

Externals Source::objects(const std::shared_ptr<CallErrors>& errors) const {
  return objects_of(externals, errors, [&](const Externals& all) {
    const LoadedConfig loaded = load(*this, overrides(), all);
    return dimension_of(loaded.config, loaded.folder);
  });
}

Run Source::read(const BuildProgress& progress, const std::shared_ptr<CallErrors>& errors, EndsFrom ends) const {
  const ErrorsOfThread reading(errors);
  const Externals made = objects(errors);
  if (file) return load_run(*file, overrides(), progress, made, ends);
  if (tree) return parse_run(*tree, kName, folder, overrides(), progress, made, ends);
  return parse_run(text, kName, folder, overrides(), progress, made, ends);
}

void Source::validate() const {
  LoadedConfig loaded = load(*this, overrides(), objects(std::make_shared<CallErrors>()));
  if (loaded.errors.empty()) check_parts(loaded);
  if (!loaded.errors.empty()) throw ConfigError(loaded.errors);
}

ConfigValue::Block block_of(const py::dict& plain) {
  ConfigValue::Block block;
  for (const auto& [key, value] : plain) block.push_back({key.cast<std::string>(), value_of(value)});
  return block;
}

}  // namespace leastcost::python
