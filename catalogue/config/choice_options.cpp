// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "catalogue/config/choice_options.hpp"

#include <algorithm>

#include <leastcost/framework/domain/manifold.hpp>
#include <leastcost/recipes/facts.hpp>
#include "catalogue/options/options_writer.hpp"
#include "catalogue/plugins/external_plugin.hpp"
#include "catalogue/yaml/scalars.hpp"

namespace leastcost {

bool is_type(const PluginChoice& choice, std::initializer_list<std::string_view> types) {
  return choice && std::count(types.begin(), types.end(), choice.plugin->type) > 0;
}

bool is_flat(const PluginChoice& manifold) {
  ProblemFacts facts;
  if (const auto* domain = external_object<ConstraintManifold>(manifold)) add_facts(*domain, facts);
  return facts.euclidean || is_type(manifold, {"euclidean"});
}

ConfigNode options_as_tree(const PluginChoice& choice) {
  OptionsWriter writer;
  if (choice.options) choice.options->fields(writer);
  return writer.take();
}

int whole_option(const PluginChoice& choice, std::string_view name) {
  const ConfigNode options = options_as_tree(choice);
  const ConfigEntry* entry = options.find(name);
  return entry == nullptr ? 0 : parse_int(entry->value).value.value_or(0);
}

}  // namespace leastcost
