// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <leastcost/framework/errors.hpp>
#include <leastcost/framework/manifold.hpp>
#include <leastcost/framework/options.hpp>
#include <leastcost/problems/distance/build_progress.hpp>

namespace leastcost {

/// The options of a plug-in, of a type that only its registration line knows.
class AnyOptions {
 public:
  virtual ~AnyOptions() = default;
  virtual void fields(FieldVisitor& visit) = 0;
};

template <class T>
class OptionsOf final : public AnyOptions {
 public:
  void fields(FieldVisitor& visit) override { value.fields(visit); }
  T value;
};

/// What a factory may look at besides its own options.
struct BuildContext {
  std::filesystem::path folder;                ///< of the configuration; files are relative to it
  int dimension = 0;                           ///< of the ambient space; 0 while the manifold is made
  std::optional<Eigen::VectorXd> source = {};  ///< projected onto the manifold, ambient; none in a ring
  std::vector<std::string> coordinates = {};   ///< names of the coordinates in which points are given
  int seed = 0;                                ///< master seed of the run
  /// Null while it is made, or while options are only checked.
  std::shared_ptr<const ConstraintManifold> manifold = {};
  /// Told how far a long build is; may throw to stop. Who reads files or takes long calls it first when its options
  /// have been checked and nothing has been read yet: so options are checked alone.
  BuildProgress progress = {};
};

/// What is known about a plug-in of any kind. What one plug-in provides and another needs are the words of abilities
/// (framework/ability.hpp: "mesh", "constant metric", "ring"); what does not fit is refused before anything is read or
/// computed. An ability that depends on options (a level set may be a surface) is provided if it may be there.
struct PluginEntry {
  std::string type;     ///< its name in a configuration
  std::string summary;  ///< one sentence
  std::vector<std::string> provides, needs;
  std::string missing;  ///< why this build has it not, and how to get it; empty: it is there
  std::function<std::unique_ptr<AnyOptions>()> defaults;
};

/// A plug-in that makes objects of type Made.
template <class Made>
struct Plugin : PluginEntry {
  std::function<Made(const AnyOptions&, const BuildContext&)> make;

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

/// Makes the chosen object. Made must be what the kind of the choice makes. An OptionError of the plug-in gets the path
/// of the choice in front of its key.
template <class Made>
Made make(const PluginChoice& choice, const BuildContext& context) {
  try {
    return static_cast<const Plugin<Made>&>(*choice.plugin).make(*choice.options, context);
  } catch (const OptionError& e) {
    throw OptionError(choice.path + "." + e.key(), e.what());
  }
}

}  // namespace leastcost
