// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <leastcost/catalogue/plugins/build_context.hpp>
#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/base/options.hpp>

namespace leastcost {

class RunVisitor;

/// The options of a plug-in, of a type that only its registration line knows. Those that hold other plug-ins need a
/// RunVisitor.
class AnyOptions {
 public:
  virtual ~AnyOptions() = default;
  virtual void fields(RunVisitor& visit) = 0;
};

template <class T>
class OptionsOf final : public AnyOptions {
 public:
  void fields(RunVisitor& visit) override { value.fields(visit); }
  T value;
};

/// What is known about a plug-in of any kind. What one plug-in provides and another needs are the words of abilities
/// (framework/base/ability.hpp: "mesh", "constant metric", "ring"); what does not fit is refused before anything is
/// read or computed. An ability that depends on options (a level set may be a surface) is provided if it may be there.
struct PluginEntry {
  std::string type;     ///< its name in a configuration
  std::string summary;  ///< one sentence
  std::vector<std::string> provides, needs;
  std::string missing;  ///< why this build has it not, and how to get it; empty: it is there
  std::string library;  ///< third party it stands on, with version: "NLopt 2.7.1", or that the program has registered
                        ///< it itself; empty: none
  std::function<std::unique_ptr<AnyOptions>()> defaults;
  bool follows_source = false;  ///< a cost that is another one for another source
  /// Of a manifold that waits for its files: the dimension of the space that it lies in; 0: the files say it.
  int ambient = 3;
};

/// A plug-in that makes objects of type Made.
template <class Made>
struct Plugin : PluginEntry {
  std::function<Made(const AnyOptions&, const BuildContext&)> make;
  std::function<WaitsFor(const AnyOptions&)> waits_for;  ///< empty: nothing
  /// While it waits: throws the OptionError that make() would throw, as far as that can be known. Empty: nothing can.
  std::function<void(const AnyOptions&, const BuildContext&)> check;

  /// It waits for its files, whatever its options are.
  Plugin&& waiting() && {
    waits_for = [](const AnyOptions&) { return WaitsFor::files; };
    return std::move(*this);
  }
  template <class Options>
  Plugin&& waiting(std::function<WaitsFor(const Options&)> what) && {
    waits_for = [what](const AnyOptions& o) { return what(static_cast<const OptionsOf<Options>&>(o).value); };
    return std::move(*this);
  }
  template <class Options>
  Plugin&& checked_by(std::function<void(const Options&, const BuildContext&)> test) && {
    check = [test](const AnyOptions& o, const BuildContext& c) {
      test(static_cast<const OptionsOf<Options>&>(o).value, c);
    };
    return std::move(*this);
  }
  Plugin&& of_dimension(int dimension) && {
    this->ambient = dimension;
    return std::move(*this);
  }
  Plugin&& following_source() && {
    this->follows_source = true;
    return std::move(*this);
  }
  template <class Ability>
  Plugin&& needing() && {
    needs.emplace_back(Ability::kAbility);
    return std::move(*this);
  }
};

/// An interface of the framework and everything registered for it.
struct PluginKind {
  std::string name, plural;  ///< "cost", "costs"; the key of a configuration is the name
  std::string summary;
  std::vector<const PluginEntry*> entries;
};

/// A plug-in and its options, as a configuration chose them.
struct PluginChoice {
  const PluginEntry* plugin = nullptr;  ///< null: not given
  std::shared_ptr<AnyOptions> options;
  std::string path;  ///< where in the configuration: "cost", "post_process.0"

  explicit operator bool() const { return plugin != nullptr; }
  bool provides(std::string_view ability) const;
  template <class Ability>
  bool provides() const {
    return provides(Ability::kAbility);
  }
};

PluginChoice choose(const PluginEntry& plugin, std::string path);

/// What step(plug-in) returns. Made must be what the kind of the choice makes. An OptionError of the plug-in gets the
/// path of the choice in front of its key.
template <class Made, class Step>
auto on_plugin(const PluginChoice& choice, Step step) {
  try {
    return step(static_cast<const Plugin<Made>&>(*choice.plugin));
  } catch (const OptionError& e) {
    throw e.under(choice.path);
  }
}

/// Makes the chosen object.
template <class Made>
Made make(const PluginChoice& choice, const BuildContext& context) {
  return on_plugin<Made>(choice, [&](const Plugin<Made>& plugin) { return plugin.make(*choice.options, context); });
}

/// Checks the options of an object that cannot be made yet.
template <class Made>
void check_options(const PluginChoice& choice, const BuildContext& context) {
  on_plugin<Made>(choice, [&](const Plugin<Made>& plugin) {
    if (plugin.check) plugin.check(*choice.options, context);
  });
}

template <class Made>
WaitsFor waits_for(const PluginChoice& choice) {
  const auto& plugin = static_cast<const Plugin<Made>&>(*choice.plugin);
  return plugin.waits_for ? plugin.waits_for(*choice.options) : WaitsFor::nothing;
}

}  // namespace leastcost
