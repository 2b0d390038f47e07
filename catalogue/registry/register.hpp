// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <leastcost/catalogue/plugins/abilities.hpp>
#include <leastcost/catalogue/plugins/build_context.hpp>
#include <leastcost/framework/base/options.hpp>
#include <leastcost/framework/cost/segment_cost.hpp>
#include <leastcost/framework/domain/manifold.hpp>
#include <leastcost/framework/energy/solver.hpp>
#include <leastcost/framework/path/kernel.hpp>
#include <leastcost/framework/problem/initializer.hpp>
#include <leastcost/framework/problem/post_processor.hpp>
#include <leastcost/problems/obstacles/obstacle.hpp>

/// \file
/// Plug-ins of a program's own. What is registered here a configuration can name, as any plug-in of the library: runs,
/// studies, `describe`, the JSON schema, completion and the checks of configurations know it, without a change of the
/// library. Options are a struct with the list `fields()`, as everywhere (framework/base/options.hpp):
///
///     struct RayTimeOptions {
///       double gain = 0.5;
///       void fields(leastcost::FieldVisitor& visit) {
///         visit.field("gain", gain, {.help = "Growth of the speed with depth.", .unit = "1/length", .minimum = 0});
///       }
///     };
///
///     leastcost::register_cost<RayTimeOptions>(
///         "ray_time", "Time of a ray through a medium whose speed grows with depth.",
///         [](const RayTimeOptions& o, const leastcost::BuildContext&) {
///           return leastcost::make_segment_cost(RayTime{o.gain});
///         });
///     leastcost::register_solver<GaussNewton>("gauss_newton", "Gauss-Newton steps on the chain.");
///
/// All of these functions may be called at any time and from any thread. What is registered stays until the process
/// ends. A configuration that is being read meanwhile sees either all of a registration or nothing of it; runs that
/// were read before are not touched. A factory is called by every thread that composes a run, also at the same time.
/// They throw InputError for a name that is no word, a name that this kind has already, and a plug-in without a
/// sentence about it.

namespace leastcost {

/// What a registration may say beside its name, its sentence and its factory.
struct PluginFacts {
  std::vector<std::string> needs = {};     ///< words of abilities of the manifold or the cost ({"mesh"}); what has them
                                           ///< not is refused before anything is read or computed
  WaitsFor waits_for = WaitsFor::nothing;  ///< what has to be there before the factory is called
  bool follows_source = false;             ///< a cost that is another one for another source
  int ambient = 3;  ///< of a manifold that waits for its files: the dimension of the space that it lies in
};

/// Options of a plug-in that was registered, of a type that only the registration knows.
class OwnOptions {
 public:
  virtual ~OwnOptions() = default;
  virtual void fields(FieldVisitor& visit) = 0;
};

/// Those of the type Options.
template <class Options>
class OwnOptionsOf final : public OwnOptions {
 public:
  void fields(FieldVisitor& visit) override { value.fields(visit); }
  Options value;  ///< the options themselves
};

/// A registration, with a factory of objects of type Made.
template <class Made>
struct OwnPlugin {
  std::string type, summary;          ///< name in configurations; one sentence for list and describe
  std::vector<std::string> provides;  ///< words of abilities
  PluginFacts facts;                  ///< what checks and defaults have to know
  std::function<std::unique_ptr<OwnOptions>()> defaults;  ///< the options as a configuration leaves them
  /// Makes the object of its options; throws OptionError.
  std::function<Made(const OwnOptions&, const BuildContext&)> make;
  /// Takes the place of one that the program has registered under this name. Runs that were read keep that one.
  bool replaces = false;
};

/// Adds it to the lists; what the templates below do in the end.
void add_plugin(OwnPlugin<std::shared_ptr<const ConstraintManifold>> plugin);
void add_plugin(OwnPlugin<std::shared_ptr<const SegmentCost>> plugin);
void add_plugin(OwnPlugin<std::shared_ptr<const Kernel>> plugin);
void add_plugin(OwnPlugin<std::shared_ptr<const Initializer>> plugin);
void add_plugin(OwnPlugin<std::shared_ptr<const Solver>> plugin);
void add_plugin(OwnPlugin<std::shared_ptr<const PostProcessor>> plugin);
void add_plugin(OwnPlugin<std::vector<std::shared_ptr<const Obstacle>>> plugin);

/// What the registry keeps of an interface: a pointer; of obstacles several, as one entry may be many.
template <class Interface>
struct MadeFor {
  using Type = std::shared_ptr<const Interface>;
};
/// Of obstacles.
template <>
struct MadeFor<Obstacle> {
  using Type = std::vector<std::shared_ptr<const Obstacle>>;
};

/// Registers `build(options, context)`, which returns a std::shared_ptr to an Interface (SegmentCost, Solver, ...) or
/// to a class that is one, whose abilities the plug-in then provides; for obstacles a vector of them is right, too. It
/// may throw OptionError with the key of an option.
template <class Interface, class Options = NoOptions, class Build>
requires std::is_invocable_v<const Build&, const Options&, const BuildContext&>
void register_plugin(std::string type, std::string summary, Build build, PluginFacts facts = {}) {
  using Made = typename MadeFor<Interface>::Type;
  using Built = std::invoke_result_t<const Build&, const Options&, const BuildContext&>;
  OwnPlugin<Made> plugin;
  plugin.type = std::move(type);
  plugin.summary = std::move(summary);
  plugin.provides = abilities_of<Built>();
  plugin.facts = std::move(facts);
  plugin.defaults = [] { return std::make_unique<OwnOptionsOf<Options>>(); };
  plugin.make = [build = std::move(build)](const OwnOptions& options, const BuildContext& context) -> Made {
    Built made = build(static_cast<const OwnOptionsOf<Options>&>(options).value, context);
    if constexpr (std::is_convertible_v<Built, Made>)
      return made;
    else
      return {std::move(made)};
  };
  add_plugin(std::move(plugin));
}

/// Registers a class that is made from its options alone, or from nothing. A kernel may be a function H alone, as
/// make_kernel() takes it.
template <class Interface, class Class, class Options = NoOptions>
void register_plugin(std::string type, std::string summary, PluginFacts facts = {}) {
  const auto build = [](const Options& options, const BuildContext&) {
    if constexpr (std::is_base_of_v<Interface, Class> && std::is_same_v<Options, NoOptions>)
      return std::make_shared<const Class>();
    else if constexpr (std::is_base_of_v<Interface, Class>)
      return std::make_shared<const Class>(options);
    else if constexpr (std::is_same_v<Options, NoOptions>)
      return make_kernel<Class>();
    else
      return make_kernel(Class(options));
  };
  register_plugin<Interface, Options>(std::move(type), std::move(summary), build, std::move(facts));
}

/// A cost: register_cost<Options>(type, summary, build, facts), or register_cost<Class, Options>(type, summary, facts).
/// Options may be left out. The functions for the other kinds take the same.
template <class... Types, class... Arguments>
void register_cost(std::string type, std::string summary, Arguments&&... arguments) {
  register_plugin<SegmentCost, Types...>(std::move(type), std::move(summary), std::forward<Arguments>(arguments)...);
}
/// A solver, as by register_cost().
template <class... Types, class... Arguments>
void register_solver(std::string type, std::string summary, Arguments&&... arguments) {
  register_plugin<Solver, Types...>(std::move(type), std::move(summary), std::forward<Arguments>(arguments)...);
}
/// A manifold: a domain of paths, as by register_cost().
template <class... Types, class... Arguments>
void register_manifold(std::string type, std::string summary, Arguments&&... arguments) {
  register_plugin<ConstraintManifold, Types...>(std::move(type), std::move(summary),
                                                std::forward<Arguments>(arguments)...);
}
/// An obstacle, or several by one entry, as by register_cost().
template <class... Types, class... Arguments>
void register_obstacle(std::string type, std::string summary, Arguments&&... arguments) {
  register_plugin<Obstacle, Types...>(std::move(type), std::move(summary), std::forward<Arguments>(arguments)...);
}
/// A kernel, also as a function H alone, as by register_cost().
template <class... Types, class... Arguments>
void register_kernel(std::string type, std::string summary, Arguments&&... arguments) {
  register_plugin<Kernel, Types...>(std::move(type), std::move(summary), std::forward<Arguments>(arguments)...);
}
/// An initializer: how the first path is found, as by register_cost().
template <class... Types, class... Arguments>
void register_initializer(std::string type, std::string summary, Arguments&&... arguments) {
  register_plugin<Initializer, Types...>(std::move(type), std::move(summary), std::forward<Arguments>(arguments)...);
}
/// A post-processor: a step after the solve, as by register_cost().
template <class... Types, class... Arguments>
void register_post_processor(std::string type, std::string summary, Arguments&&... arguments) {
  register_plugin<PostProcessor, Types...>(std::move(type), std::move(summary), std::forward<Arguments>(arguments)...);
}

}  // namespace leastcost
