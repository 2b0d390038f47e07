// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "catalogue/run/compose.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>
#include <variant>

#include <leastcost/catalogue/plugins/abilities.hpp>
#include <leastcost/framework/base/errors.hpp>
#include <leastcost/problems/chart/is_geographic.hpp>
#include <leastcost/problems/manifolds/made_from_data.hpp>
#include <leastcost/problems/obstacles/free_space.hpp>
#include <leastcost/problems/obstacles/has_walls.hpp>
#include <leastcost/problems/post_processors/bracket.hpp>
#include <leastcost/problems/post_processors/choose_global_proof.hpp>
#include <leastcost/problems/raster/has_voids.hpp>
#include <leastcost/problems/robots/robot_trajectory.hpp>
#include "catalogue/config/choice_options.hpp"
#include "catalogue/config/config_facts.hpp"
#include "catalogue/inputs/joint_limits.hpp"
#include "catalogue/plugins/kinds.hpp"
#include "catalogue/registry/registry.hpp"
#include "catalogue/run/cheapest_image.hpp"
#include "catalogue/run/ends.hpp"
#include "catalogue/run/family_ways.hpp"
#include "catalogue/run/goals.hpp"
#include "catalogue/run/memory.hpp"
#include "catalogue/run/pair_composer.hpp"
#include "catalogue/run/plane_on_earth.hpp"
#include "problems/formula/coordinate_names.hpp"

namespace leastcost {
namespace {

void fill_options(const RunConfig& config, RunParts& out) {
  out.options.points = config.points;
  out.options.target_as_given = true;  // take_cheapest_image() has named it
  out.options.reference_cost = config.reference_cost;
  out.options.cascade = config.cascade;
  out.options.escape_saddle = config.escape_saddle;
  out.options.certificate = config.certificate;
  out.options.certificate.global = GlobalOff{};  // add_proof() has seen to it
  out.waypoints = config.waypoints;
}

/// Its limits; where none are given those of a file of joint limits, then of that of the robot. Before the path is
/// sought: throws OptionError for limits that do not fit the domain.
TrajectoryOptions trajectory_of(const RunConfig& config, const Problem& problem, const BuildContext& context) {
  TrajectoryOptions wanted = config.trajectory;
  if (!config.wants_trajectory()) return wanted;
  try {
    const Robot* robot = context.robot.get();
    if (!config.joint_limits.empty()) {
      if (robot == nullptr) throw OptionError("limits", "has limits of joints, but there is no robot: give 'robot'");
      wanted = with_joint_limits(context.folder / config.joint_limits, *robot, std::move(wanted), context.note);
    }
    if (robot != nullptr) wanted = with_limits_of(*robot, std::move(wanted));
    check_trajectory(problem, wanted);
    return wanted;
  } catch (const OptionError& error) {
    throw error.under("output.trajectory");
  } catch (const InputError& error) {
    throw OptionError("output.trajectory", error.what());
  }
}

/// A proof over all paths, after the step that makes the curve it speaks of. Not for families: their members are paths
/// of other classes.
void add_proof(const RunConfig& config, const std::filesystem::path& folder, RunParts& out) {
  const bool bracket = brackets(config), search = proves_shortest(config);
  if ((!bracket && !search) || !out.problem.manifold || !out.problem.cost) return;
  GlobalProof proof = config.certificate.global;
  if (auto* budget = std::get_if<GlobalBudget>(&proof); budget != nullptr && !budget->index.empty())
    budget->index = (folder / budget->index).string();
  auto& steps = out.options.post_processors;
  if (bracket) {
    steps.push_back(std::make_shared<const BracketPostProcessor>(std::get<GlobalBudget>(proof)));
    return;
  }
  GlobalProofStep found = global_proof(out.problem, proof);
  if (found.step && found.before && !steps.empty() && steps.back()->name() == found.before->name())
    steps.push_back(std::move(found.step));
}

/// Whether an object lacks an ability that a plug-in needs and its type only may have: the zeros of a function of the
/// plane are no surface. Throws OptionError for it.
void check_needs(const PluginChoice& choice, const PluginChoice& giver, const ConstraintManifold& manifold) {
  if (!choice) return;
  const std::vector<std::string>& needs = choice.plugin->needs;
  for_each_ability([&]<class Ability>() {
    const bool wanted = std::count(needs.begin(), needs.end(), Ability::kAbility) > 0;
    if (!wanted || !giver.provides<Ability>() || find_ability<Ability>(manifold) != nullptr) return;
    throw OptionError(choice.path, fmt::format("'{}' needs a manifold with a {}, but this '{}' has none",
                                               choice.plugin->type, Ability::kAbility, giver.plugin->type));
  });
}

/// Whether ends are in longitude and latitude on a cost map in the plane.
bool wants_place_of_cost(const RunConfig& config, int dimension) {
  const bool lonlat = (config.source && config.source->lonlat) || (config.target && config.target->lonlat);
  return lonlat && dimension == 2 && may_be_map(config.cost);
}

using ManifoldPtr = std::shared_ptr<const ConstraintManifold>;
using RobotPtr = std::shared_ptr<const Robot>;

/// Of what the dimension of the space has to be known first.
template <class Made>
constexpr bool kOfSpace = std::is_same_v<Made, std::shared_ptr<const SegmentCost>> ||
                          std::is_same_v<Made, std::shared_ptr<const Initializer>>;

}  // namespace

Composer::Composer(const RunConfig& config, std::filesystem::path folder, Refused refused)
    : config_(config), refused_(std::move(refused)) {
  context_.folder = std::move(folder);
  context_.note = [this](std::string note) {
    if (std::find(told_.begin(), told_.end(), note) == told_.end()) told_.push_back(std::move(note));
  };
  others_.resize(config.family.initializers.size());
}

/// Runs one step; its OptionError is passed on, so that the next steps can add theirs.
template <class Step>
bool Composer::attempt(Step step) {
  try {
    step();
    return true;
  } catch (const OptionError& e) {
    refused_(e);
    return false;
  }
}

template <class Made>
bool Composer::waits(const PluginChoice& choice) const {
  if (files_) return false;
  const WaitsFor what = waits_for<Made>(choice);
  if (what == WaitsFor::robot) return config_.robot && !context_.robot;
  if (kOfSpace<Made> && context_.dimension == 0) return true;
  return what == WaitsFor::files || (what == WaitsFor::domain && !context_.manifold);
}

template <class Made>
void Composer::make_or_check(const PluginChoice& choice, Made& made) {
  if (made) return;
  attempt([&] {
    if (waits<Made>(choice))
      check_options<Made>(choice, context_);
    else
      made = make<Made>(choice, context_);
  });
}

void Composer::make_robot() {
  if (config_.robot) make_or_check(config_.robot, context_.robot);
}

/// Ends that are states of a robot wait for it, and the domain with them.
bool Composer::domain_waits() const {
  const auto is_state = [](const std::optional<EndOptions>& end) { return end && end->state; };
  const bool states = is_state(config_.source) || is_state(config_.target);
  return waits<ManifoldPtr>(config_.manifold) ||
         (states && config_.robot && !context_.robot && waits<RobotPtr>(config_.robot));
}

/// What is known of a domain that waits for its files: a surface in R^3, or a part of the plane. Of the configurations
/// of a robot nothing is.
void Composer::assume_domain() {
  const int ambient = config_.manifold.plugin->ambient;
  if (ambient == 0 || !waits<ManifoldPtr>(config_.manifold)) return;
  check_memory({ambient, ambient, 2});
  context_.dimension = ambient;
  context_.coordinates = coordinate_names(ambient);
  if (!config_.ring || config_.source) context_.source = Eigen::VectorXd::Zero(ambient);
}

/// Of the domain as it was made; what its type cannot have is refused before.
void Composer::check_all_needs() {
  const auto check = [&](const PluginChoice& choice) {
    attempt([&] { check_needs(choice, config_.manifold, *out_.problem.manifold); });
  };
  check(config_.initializer);
  for (const PluginChoice& choice : config_.family.initializers) check(choice);
  for (const PluginChoice& choice : config_.post_process.value_or(PluginList{})) check(choice);
}

/// Before the memory is taken: a machine that swaps, or kills, says less.
void Composer::check_memory(const Dimensions& dimensions) {
  if (!config_.points) return;
  const double need = bytes_of_path(*config_.points, dimensions), have = memory_of_host();
  if (need <= have) return;
  attempt([&] {
    throw OptionError("path.points", fmt::format("{} points take about {} of memory, and there are {}", *config_.points,
                                                 size_in_words(need), size_in_words(have)));
  });
}

void Composer::take_trajectory() {
  attempt([&] { out_.trajectory = trajectory_of(config_, out_.problem, context_); });
}

void Composer::take_domain() {
  const ConstraintManifold& manifold = *out_.problem.manifold;
  open_domain_ = out_.problem.manifold;
  check_memory(manifold.dimensions());
  const int dimension = manifold.dimensions().ambient;
  if (context_.dimension != dimension) out_.problem.cost.reset();  // made for another space
  context_.manifold = out_.problem.manifold;
  context_.dimension = dimension;
  context_.coordinates = point_coordinates(manifold);
  if (const auto* data = find_ability<MadeFromData>(manifold)) out_.notes = data->notes();
  check_all_needs();
  out_.problem.ring = config_.ring;
  out_.problem.based = config_.ring && config_.source.has_value();
  out_.robot = context_.robot;
  if (!config_.robot || context_.robot) take_trajectory();
  if (config_.ends_come_later()) context_.source = Eigen::VectorXd::Zero(dimension);  // every pair has its own
  if (config_.ends_come_later() || (config_.ring && !out_.problem.based)) return;
  if (wants_place_of_cost(config_, dimension) && !out_.problem.cost)  // the raster says where on the Earth ends are
    attempt([&] { out_.problem.cost = make<std::shared_ptr<const SegmentCost>>(config_.cost, context_); });
  const auto end = [&](const std::optional<EndOptions>& given, const char* path) {
    return in_coordinates(with_state(given.value_or(EndOptions{}), context_.robot.get(), path), manifold,
                          out_.problem.cost.get(), path);
  };
  const bool placed = attempt([&] {
    out_.source = place_end(manifold, end(config_.source, "ends.source"), "ends.source");
    out_.problem.source = out_.source.end;
    note_far_end("the source", out_.source, out_);
    context_.source = source_position(out_.problem);
  });
  if (!placed) context_.source = Eigen::VectorXd::Zero(dimension);  // the other parts are checked all the same
  if (!config_.ring && placed && !(config_.target && config_.target->is_several()))  // else place_goals()
    attempt([&] {
      place_target(end(config_.target, "ends.target"), "ends.target", out_);
      refuse_one_place(out_.problem, "ends.target");
      context_.target = positions(manifold, {out_.problem.target.u, {}, true});
    });
}

/// Of the domain and of a cost in the plane, which is made for them.
void Composer::find_voids() {
  voids_ = {};
  if (!takes_voids(config_, *out_.problem.manifold)) return;
  voids_.add(find_ability<HasVoids>(*out_.problem.manifold));
  if (context_.dimension != 2 || !may_be_map(config_.cost)) return;
  make_or_check(config_.cost, out_.problem.cost);
  if (out_.problem.cost) voids_.add(find_ability<HasVoids>(*out_.problem.cost));
}

/// A straight first path through places without data is none: the field of least arrival costs leads round them.
void Composer::go_round_voids() {
  if (!voids_.any() || !out_.initializer || out_.initializer->name() != "straight") return;
  if (!straight_is_blocked(out_.problem)) return;
  attempt([&] {
    const PluginEntry* eikonal = find_plugin(kind("initializer"), "eikonal");
    out_.initializer = make<std::shared_ptr<const Initializer>>(choose(*eikonal, "initializer"), context_);
    out_.notes.emplace_back("the straight line crosses places without data: the first path comes from eikonal");
  });
}

/// Whether obstacles, or the robot that they are obstacles to, come from files that may not be read yet.
bool Composer::obstacles_wait(bool voids_wait) const {
  return voids_wait || (config_.robot && !context_.robot && waits<RobotPtr>(config_.robot)) ||
         std::any_of(config_.obstacles.begin(), config_.obstacles.end(),
                     [&](const PluginChoice& choice) { return waits<FreeSpace::Obstacles>(choice); });
}

/// False where one of them was refused; the others are made all the same, for their errors.
bool Composer::make_obstacles(ListedObstacles& out) {
  bool made = true;
  for (std::size_t i = 0; i < config_.obstacles.size(); ++i)
    made = attempt([&] {
             for (auto& one : make<FreeSpace::Obstacles>(config_.obstacles[i], context_)) {
               if (!context_.robot)
                 refuse_plane_on_earth(*one, *out_.problem.manifold, "obstacles." + std::to_string(i));
               out.add(std::move(one), i);
             }
           }) &&
           made;
  return made;
}

/// Whether the robot is there and fits the domain and the obstacles; true of a run without one.
bool Composer::robot_fits() {
  if (!config_.robot) return true;
  return context_.robot != nullptr && attempt([&] {
           check_robot_limits(*context_.robot, *out_.problem.manifold);
           if (config_.obstacles.empty() && context_.robot->self.empty())
             throw OptionError("robot", "has nothing to collide with: give 'obstacles'");
         });
}

/// After the ends have found their places: an end that is given within an obstacle is an error, not to be moved.
void Composer::place_obstacles() {
  const bool voids_wait =
      !files_ && takes_voids(config_, *out_.problem.manifold) && may_be_map(config_.cost) && context_.dimension == 2;
  if (voids_wait)
    voids_ = {};
  else
    find_voids();
  if (config_.obstacles.empty() && !voids_wait && !voids_.any()) {
    if (config_.clearance > 0)
      attempt([] {
        throw OptionError("clearance", "needs obstacles, but there are none: give 'obstacles', or remove it");
      });
    if (!config_.robot) {
      obstacles_placed_ = true;
      context_.manifold = out_.problem.manifold;  // a cost map may have been waited for
      return;
    }
  }
  if (obstacles_wait(voids_wait)) {
    for (const PluginChoice& choice : config_.obstacles)
      attempt([&] { check_options<FreeSpace::Obstacles>(choice, context_); });
    context_.manifold.reset();  // what asks for the domain asks for the one among obstacles
    return;
  }
  obstacles_placed_ = true;
  ListedObstacles obstacles;
  for (auto& one : voids_.obstacles) obstacles.add(std::move(one), 0);
  const bool fits = robot_fits(), made = make_obstacles(obstacles);
  if (!fits || !made || !attempt([&] { put_among(std::move(obstacles)); })) return;
  for (const auto& [end, key] :
       {std::pair{&out_.problem.source, "ends.source"}, std::pair{&out_.problem.target, "ends.target"}})
    if (end->u.size() > 0) attempt([&, end = end, key = key] { refuse_end_in_clearance(out_.problem, *end, key); });
}

void Composer::put_among(ListedObstacles obstacles) {
  const RobotPtr& robot = context_.robot;
  const double clearance = voids_.clearance(config_.clearance);
  out_.problem.manifold = context_.manifold = among(std::move(obstacles), clearance, robot, out_.problem.manifold);
  if (robot != nullptr && !robot->whose.empty()) out_.notes.push_back("clearances refer to " + robot->whose);
  if (voids_.any() && !(config_.clearance > 0))
    out_.notes.push_back(kVoidsNote +
                         fmt::format("the path keeps {:.6g} away from them, a tenth of a cell (to change this, set "
                                     "'clearance')",
                                     clearance));
}

/// Goals that obstacles or the domain do not let be ends are left out; what is left of them is tried.
void Composer::place_goals() {
  const bool several = !config_.ring && config_.target && config_.target->is_several();
  if (!several || !obstacles_placed_ || !out_.problem.manifold || out_.problem.target.u.size() > 0) return;
  if (out_.problem.source.u.size() == 0) return;  // it was refused, and goals are compared with it
  attempt([&] {
    std::vector<PlacedEnd> all = goals_of(*config_.target, context_.robot.get(), *open_domain_, out_);
    out_.target = all.front();
    out_.problem.target = out_.target.end;
    out_.goals.assign(all.begin() + 1, all.end());
    refuse_one_place(out_.problem, "ends.target");
    context_.target = positions(*out_.problem.manifold, {out_.problem.target.u, {}, true});
  });
}

void Composer::make_parts() {
  make_or_check(config_.cost, out_.problem.cost);
  make_or_check(config_.kernel, out_.problem.kernel);
  // Obstacles that were refused are the fault; a first path among them would be another one.
  const bool without_obstacles = obstacles_placed_ && (config_.robot || !config_.obstacles.empty()) &&
                                 find_ability<HasWalls>(*out_.problem.manifold) == nullptr;
  if (!without_obstacles) {
    make_or_check(config_.initializer, out_.initializer);
    for (std::size_t i = 0; i < others_.size(); ++i) make_or_check(config_.family.initializers[i], others_[i]);
  }
  make_or_check(config_.solver, out_.solver);
  const PluginList steps = config_.post_process.value_or(PluginList{});
  out_.options.post_processors.resize(steps.size());
  for (std::size_t i = 0; i < steps.size(); ++i) make_or_check(steps[i], out_.options.post_processors[i]);
}

void Composer::make_from_options() {
  context_.seed = config_.seed;
  make_robot();
  if (domain_waits()) {
    attempt([&] { check_options<ManifoldPtr>(config_.manifold, context_); });
    assume_domain();
  } else {
    if (!attempt([&] { out_.problem.manifold = make<ManifoldPtr>(config_.manifold, context_); })) return;
    take_domain();
    place_obstacles();
    place_goals();
  }
  make_parts();
}

void Composer::make_from_files(const BuildProgress& progress) {
  files_ = true;
  const bool robot_waited = config_.robot && !context_.robot && out_.problem.manifold != nullptr;
  make_robot();
  if (config_.robot && !context_.robot && waits_for<ManifoldPtr>(config_.manifold) == WaitsFor::robot)
    return;  // what was wrong with the robot has been said
  if (!out_.problem.manifold) {
    const auto start = std::chrono::steady_clock::now();
    BuildContext reading{context_.folder};
    reading.robot = context_.robot;
    reading.progress = progress;
    reading.note = context_.note;
    if (!attempt([&] { out_.problem.manifold = make<ManifoldPtr>(config_.manifold, reading); })) return;
    read_seconds_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    take_domain();
  } else if (robot_waited && context_.robot) {
    out_.robot = context_.robot;
    take_trajectory();
  }
  if (!obstacles_placed_) place_obstacles();
  place_goals();
  make_parts();
  go_round_voids();
  if (out_.problem.cost && find_ability<IsGeographic>(*out_.problem.manifold) == nullptr)
    if (const auto* earth = find_ability<IsGeographic>(*out_.problem.cost); earth && !earth->place_note().empty())
      out_.notes.push_back(earth->place_note());
  if (out_.problem.cost && out_.initializer && out_.problem.target.u.size() > 0)
    attempt([&] { take_cheapest_image(config_, open_domain_, out_); });
}

RunParts Composer::take() {
  add_family_ways(config_, others_, out_);
  fill_options(config_, out_);
  add_proof(config_, context_.folder, out_);
  out_.notes.insert(out_.notes.begin(), told_.begin(), told_.end());
  return std::move(out_);
}

void check_parts(LoadedConfig& loaded) {
  Composer(loaded.config, loaded.folder, [&](const OptionError& e) {
    loaded.add_error(e.key(), e.reason());
  }).make_from_options();
}

std::shared_ptr<const PairComposer> Composer::pairs(const RunParts& parts) const {
  if (config_.ring) return nullptr;
  BuildContext context = context_;
  context.note = {};  // the composer will be gone
  return std::make_shared<const PairComposer>(config_, std::move(context), open_domain_, parts);
}

}  // namespace leastcost
