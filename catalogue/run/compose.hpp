// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <memory>

#include <leastcost/catalogue/run/run_parts.hpp>
#include "catalogue/config/loaded_config.hpp"
#include "catalogue/plugins/plugin.hpp"
#include "catalogue/run/voids.hpp"
#include "catalogue/run/walls.hpp"

namespace leastcost {

class PairComposer;

/// Makes the objects that a configuration describes, each of them once, in two steps: first what its options alone
/// allow, then what needs the files. Whoever only wants to know the errors stops after the first.
///
/// `refused` hears every OptionError, with the full path of the option as its key ("ends.source.point"); the parts
/// that do not depend on the refused one are made or checked all the same. It may throw instead.
class Composer {
 public:
  using Refused = std::function<void(const OptionError&)>;

  /// `config` must outlive the composer.
  Composer(const RunConfig& config, std::filesystem::path folder, Refused refused);

  /// Reads no file and computes nothing that takes a while.
  void make_from_options();
  /// The rest. `progress` hears of domains that take a while to make. Throws InputError.
  void make_from_files(const BuildProgress& progress = {});
  /// Complete after both steps, unless something was refused.
  RunParts take();
  /// What makes the parts for other ends out of these `parts`; null of a ring.
  std::shared_ptr<const PairComposer> pairs(const RunParts& parts) const;
  /// What files said while they were read, so far.
  const std::vector<std::string>& told() const { return told_; }
  /// Of the files and the domains made from them.
  double read_seconds() const { return read_seconds_; }

 private:
  template <class Step>
  bool attempt(Step step);
  template <class Made>
  bool waits(const PluginChoice& choice) const;
  template <class Made>
  void make_or_check(const PluginChoice& choice, Made& made);
  void make_robot();
  void place_goals();
  bool domain_waits() const;
  void assume_domain();
  void check_all_needs();
  void check_memory(const Dimensions& dimensions);
  void take_trajectory();
  void take_domain();
  void place_obstacles();
  bool obstacles_wait(bool voids_wait) const;
  bool make_obstacles(ListedObstacles& out);
  bool robot_fits();
  void put_among(ListedObstacles obstacles);
  void find_voids();
  void go_round_voids();
  void make_parts();

  const RunConfig& config_;
  Refused refused_;
  BuildContext context_;
  RunParts out_;
  std::shared_ptr<const ConstraintManifold> open_domain_;   // without its obstacles
  std::vector<std::shared_ptr<const Initializer>> others_;  // of the family
  std::vector<std::string> told_;                           // by what was made
  bool files_ = false;                                      // may be read
  bool obstacles_placed_ = false;
  Voids voids_;  // which became obstacles
  double read_seconds_ = 0;
};

/// The first step for its errors: adds them to `loaded.errors`.
void check_parts(LoadedConfig& loaded);

}  // namespace leastcost
