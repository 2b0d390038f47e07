// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <typeinfo>

namespace leastcost {

/// Base of what may have abilities: a T is a domain, a cost or an initializer. An ability is what only some of them
/// have, a small interface A that they inherit; whoever needs it asks find_ability<A>(object) and says in words what is
/// missing. Where an ability has a name for people it says it once, `static constexpr std::string_view kAbility`; the
/// words of the registry are made from these. One that depends on how an object was made adds a non-virtual
/// `bool present() const`, which asks a virtual function of its own.
template <class T>
class HasAbilities {
 public:
  virtual ~HasAbilities() = default;

  /// The object that answers for this one about an ability (typeid of its interface) that it does not inherit itself. A
  /// decorator returns what it decorates, so that nothing is lost that nobody thought of, and null only for what its
  /// decoration makes untrue. Must outlive this object.
  virtual const T* decorated(const std::type_info& ability) const {
    static_cast<void>(ability);
    return nullptr;
  }
};

/// The ability A of an object, or of what it decorates; null where there is none, and for no object. The one place that
/// asks objects for their type.
template <class A, class T>
const A* find_ability(const HasAbilities<T>* object) {
  for (; object != nullptr; object = object->decorated(typeid(A))) {
    const A* found = dynamic_cast<const A*>(object);
    if (found == nullptr) continue;
    if constexpr (requires { found->present(); }) return found->present() ? found : nullptr;
    return found;
  }
  return nullptr;
}

template <class A, class T>
const A* find_ability(const HasAbilities<T>& object) {
  return find_ability<A>(&object);
}

}  // namespace leastcost
