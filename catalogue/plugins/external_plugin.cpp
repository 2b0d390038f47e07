// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "catalogue/plugins/external_plugin.hpp"

#include <array>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include <leastcost/catalogue/plugins/abilities.hpp>
#include "catalogue/plugins/check_dimension.hpp"
#include "catalogue/plugins/kinds.hpp"
#include "catalogue/plugins/run_visitor.hpp"

namespace leastcost {
namespace {

/// In the order of ExternalObject.
constexpr std::array<std::string_view, std::variant_size_v<ExternalObject>> kKinds = {
    "manifold", "obstacle", "robot", "cost", "kernel", "initializer", "solver", "post_processor"};

/// What the factories of the kind make: the object itself, or a list with it.
template <class Object>
using MadeOf = std::conditional_t<std::is_same_v<Object, Obstacle>, std::vector<std::shared_ptr<const Object>>,
                                  std::shared_ptr<const Object>>;

/// The words of the abilities that this object has, where its kind has any.
template <class Object>
std::vector<std::string> words_of(const Object& object) {
  std::vector<std::string> words;
  if constexpr (std::is_base_of_v<HasAbilities<Object>, Object>)
    for_each_ability([&]<class Ability>() {
      if (find_ability<Ability>(object) != nullptr) words.emplace_back(Ability::kAbility);
    });
  return words;
}

template <class Object>
std::shared_ptr<const PluginEntry> plugin_for(const Object& object) {
  auto entry = std::make_shared<Plugin<MadeOf<Object>>>();
  entry->type = kExternal;
  entry->summary = "An object of the caller.";
  entry->provides = words_of(object);
  if constexpr (std::is_same_v<Object, ConstraintManifold>) entry->ambient = object.dimensions().ambient;
  entry->make = [](const AnyOptions& options, const BuildContext& context) -> MadeOf<Object> {
    const auto& made = std::get<std::shared_ptr<const Object>>(static_cast<const External&>(options).object());
    if constexpr (std::is_same_v<Object, SegmentCost>) check_dimension(*made, context, "name");
    static_cast<void>(context);
    return MadeOf<Object>{made};
  };
  return entry;
}

}  // namespace

void ExternalName::fields(FieldVisitor& visit) {
  visit.field("name", name, {.help = "Name under which the calling program hands over the object.", .required = true});
}

External::External(std::string name, ExternalObject object, std::shared_ptr<const PluginEntry> plugin)
    : name_{std::move(name)}, object_(std::move(object)), plugin_(std::move(plugin)) {}

void External::fields(RunVisitor& visit) { name_.fields(visit); }

std::string_view kind_of(const ExternalObject& object) { return kKinds.at(object.index()); }

const PluginEntry& external_plugin() {
  static const PluginEntry entry = [] {
    PluginEntry named;
    named.type = kExternal;
    named.summary = "An object of the program that reads the configuration, by its name.";
    named.defaults = [] { return std::make_unique<OptionsOf<ExternalName>>(); };
    return named;
  }();
  return entry;
}

PluginChoice choose_external(const ExternalObject& object, std::string name, std::string path) {
  const std::shared_ptr<const PluginEntry> plugin =
      std::visit([](const auto& given) { return plugin_for(*given); }, object);
  return {plugin.get(), std::make_shared<External>(std::move(name), object, plugin), std::move(path)};
}

}  // namespace leastcost
