// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <variant>

#include <leastcost/catalogue/plugins/externals.hpp>
#include "catalogue/plugins/plugin.hpp"

namespace leastcost {

/// The type under which a configuration names an object of its caller, in every kind of plug-ins. It is in no list of
/// types: only a program that hands over objects can read such a configuration.
inline constexpr std::string_view kExternal = "external";

/// The options of that type.
struct ExternalName {
  std::string name = {};
  void fields(FieldVisitor& visit);
};

/// The same with the object of this name: what a choice has in the place of its options once the object is found. Keeps
/// the plug-in of the choice, which knows the abilities of the object.
class External final : public AnyOptions {
 public:
  External(std::string name, ExternalObject object, std::shared_ptr<const PluginEntry> plugin);
  void fields(RunVisitor& visit) override;
  const ExternalObject& object() const { return object_; }

 private:
  ExternalName name_;
  ExternalObject object_;
  std::shared_ptr<const PluginEntry> plugin_;
};

/// The object that was chosen by its name; null for every other choice. Object: ConstraintManifold, SegmentCost, ...
template <class Object>
const Object* external_object(const PluginChoice& choice) {
  if (!choice || choice.plugin->type != kExternal) return nullptr;
  const ExternalObject& object = static_cast<const External&>(*choice.options).object();
  const auto* found = std::get_if<std::shared_ptr<const Object>>(&object);
  return found == nullptr ? nullptr : found->get();
}

/// The name of the kind that an object is of: "cost".
std::string_view kind_of(const ExternalObject& object);

/// What stands for every object until it is found by its name.
const PluginEntry& external_plugin();

/// The choice of an object; `path`: where in the configuration. The object is there.
PluginChoice choose_external(const ExternalObject& object, std::string name, std::string path);

}  // namespace leastcost
