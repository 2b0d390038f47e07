// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <tuple>
#include <type_traits>
#include <vector>

#include <leastcost/framework/cost/has_constant_metric.hpp>
#include <leastcost/framework/cost/mixes_moves.hpp>
#include <leastcost/framework/problem/has_graph.hpp>
#include <leastcost/framework/problem/initializer.hpp>
#include <leastcost/problems/chart/seams.hpp>
#include <leastcost/problems/distance/has_distance_grid.hpp>
#include <leastcost/problems/layers/has_layers.hpp>
#include <leastcost/problems/level_set/has_level_set.hpp>
#include <leastcost/problems/manifolds/file_places.hpp>
#include <leastcost/problems/mesh/has_mesh.hpp>
#include <leastcost/problems/section/is_surface.hpp>

namespace leastcost {

/// The abilities that have a word, in the order in which people read them. A plug-in gets its words from the type of
/// what its factory returns.
using NamedAbilities = std::tuple<HasMesh, IsSurface, HasSeams, HasGraph, HasLevelSet, HasDistanceGrid, HasVertices,
                                  HasFaces, HasConstantMetric, HasLayers, MixesMoves, MakesRings>;

/// Calls the templated operator() of `visit` for each of them.
template <class Visit>
void for_each_ability(Visit visit) {
  [&]<class... A>(std::tuple<A...>*) { (visit.template operator()<A>(), ...); }(static_cast<NamedAbilities*>(nullptr));
}

/// The words for the abilities of a class.
template <class Class>
std::vector<std::string> ability_words() {
  std::vector<std::string> words;
  for_each_ability([&]<class Ability>() {
    if constexpr (std::is_base_of_v<Ability, Class>) words.emplace_back(Ability::kAbility);
  });
  return words;
}

/// What the pointer that a factory makes points to, or each of those that it makes.
template <class Pointer>
struct MadeBy {
  using Class = std::remove_const_t<typename Pointer::element_type>;
};
template <class Pointer>
struct MadeBy<std::vector<Pointer>> : MadeBy<Pointer> {};

/// The words for the abilities of what a factory makes.
template <class Made>
std::vector<std::string> abilities_of() {
  return ability_words<typename MadeBy<Made>::Class>();
}

}  // namespace leastcost
