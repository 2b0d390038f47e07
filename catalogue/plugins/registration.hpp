// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <type_traits>

#include <leastcost/catalogue/plugins/abilities.hpp>
#include "catalogue/plugins/plugin.hpp"
#include "catalogue/plugins/run_visitor.hpp"

namespace leastcost {

/// Registers `build(options, context)`, whose options are of type Options. It provides the abilities of the class that
/// `build` returns a pointer to.
template <class P, class Options, class Build>
P plugin(const char* type, const char* summary, Build build) {
  P entry;
  entry.type = type;
  entry.summary = summary;
  entry.provides = abilities_of<std::invoke_result_t<Build, const Options&, const BuildContext&>>();
  entry.defaults = [] { return std::make_unique<OptionsOf<Options>>(); };
  entry.make = [build](const AnyOptions& options, const BuildContext& context) {
    return build(static_cast<const OptionsOf<Options>&>(options).value, context);
  };
  return entry;
}

/// A class made from its options alone, or from nothing.
template <class P, class Class, class Options = NoOptions>
P made_of(const char* type, const char* summary) {
  return plugin<P, Options>(type, summary, [](const Options& options, const BuildContext&) {
    if constexpr (std::is_same_v<Options, NoOptions>)
      return std::make_shared<const Class>();
    else
      return std::make_shared<const Class>(options);
  });
}

}  // namespace leastcost
