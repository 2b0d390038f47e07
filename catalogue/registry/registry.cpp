// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "catalogue/registry/registry.hpp"

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "catalogue/registry/built_in.hpp"

namespace leastcost {
namespace {

template <class P>
PluginKind kind_of(std::string name, std::string plural, std::string summary, const std::vector<P>& plugins) {
  PluginKind out{std::move(name), std::move(plural), std::move(summary), {}};
  for (const P& p : plugins) out.entries.push_back(&p);
  return out;
}

}  // namespace

std::vector<PluginKind> built_in_kinds() {
  return {
      kind_of("manifold", "manifolds", "where points lie", built_in::manifolds()),
      kind_of("obstacle", "obstacles", "regions that paths avoid", built_in::obstacles()),
      kind_of("robot", "robots", "bodies that move among obstacles", built_in::robots()),
      kind_of("cost", "costs", "the cost of a move from a to b", built_in::costs()),
      kind_of("kernel", "kernels", "the convex H of the energy sum H(c / s0)", built_in::kernels()),
      kind_of("initializer", "initializers", "how the first path is found", built_in::initializers()),
      kind_of("solver", "solvers", "how the path is improved", built_in::solvers()),
      kind_of("post_processor", "post_processors", "steps after the solve", built_in::post_processors()),
  };
}

const PluginKind* find_kind(std::string_view name) {
  const auto& all = plugin_kinds();
  const auto it =
      std::find_if(all.begin(), all.end(), [&](const PluginKind& k) { return k.name == name || k.plural == name; });
  return it == all.end() ? nullptr : &*it;
}

const PluginKind& kind(std::string_view name) {
  const PluginKind* found = find_kind(name);
  if (found == nullptr) std::abort();  // a name in our own sources
  return *found;
}

const PluginEntry* find_plugin(const PluginKind& kind, std::string_view type) {
  const auto it =
      std::find_if(kind.entries.begin(), kind.entries.end(), [&](const PluginEntry* e) { return e->type == type; });
  return it == kind.entries.end() ? nullptr : *it;
}

std::vector<std::string> types_of(const PluginKind& kind) {
  std::vector<std::string> types;
  for (const PluginEntry* e : kind.entries) types.push_back(e->type);
  return types;
}

}  // namespace leastcost
