// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/catalogue/run/compose.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <utility>

#include <leastcost/catalogue/registry/registry.hpp>
#include <leastcost/framework/errors.hpp>
#include <leastcost/problems/chart/wound.hpp>
#include <leastcost/problems/initializers/bow.hpp>
#include <leastcost/problems/initializers/dijkstra.hpp>
#include <leastcost/problems/initializers/mirrored.hpp>
#include <leastcost/problems/manifolds/made_from_data.hpp>
#include <leastcost/solvers/newton.hpp>
#include "catalogue/plugins/abilities.hpp"
#include "catalogue/plugins/kinds.hpp"
#include "catalogue/run/ends.hpp"
#include "problems/chart/has_images.hpp"
#include "problems/formula/coordinate_names.hpp"

namespace leastcost {
namespace {

/// Where several points stand for the same, the path ends at the one nearest to its source.
void take_nearest_image(Composition& out) {
  const auto* domain = find_ability<HasImages>(*out.problem.manifold);
  if (domain == nullptr) return;
  const Eigen::VectorXd image = domain->nearest_image(out.target.end.u, out.source.end.u);
  if (image == out.target.end.u) return;
  out.target.end.u = image;
  out.notes.emplace_back("the target was replaced by the image of it that is nearer to the source");
}

void place_ends(const RunConfig& config, Composition& out) {
  out.problem.ring = config.ring;
  out.problem.based = config.ring && config.source.given;
  if (config.ring && !out.problem.based) return;
  out.source = place_end(*out.problem.manifold, config.source, "ends.source");
  out.problem.source = out.source.end;
  if (config.ring) return;
  out.target = place_end(*out.problem.manifold, config.target, "ends.target");
  take_nearest_image(out);
  out.problem.target = out.target.end;
  if (out.problem.source.u == out.problem.target.u)
    throw OptionError("ends.target", "is the same point as the source; a closed path is a ring (path.ring: true)");
}

Eigen::VectorXd source_position(const Problem& problem) {
  return positions(*problem.manifold, {problem.source.u, {}, true});
}

void make_parts(const RunConfig& config, const BuildContext& context, Composition& out) {
  out.problem.cost = make<std::shared_ptr<const SegmentCost>>(config.cost, context);
  out.problem.kernel = make<std::shared_ptr<const Kernel>>(config.kernel, context);
  out.initializer = make<std::shared_ptr<const Initializer>>(config.initializer, context);
  out.solver = make<std::shared_ptr<const Solver>>(config.solver, context);
  out.certifier = std::make_shared<const Newton>();
  for (const PluginChoice& choice : config.post_process.choices)
    out.post_processors.push_back(make<std::shared_ptr<const PostProcessor>>(choice, context));
}

void fill_options(const RunConfig& config, Composition& out) {
  out.options.points = config.points.automatic ? 0 : config.points.count;
  out.options.reference_cost = config.reference_cost;
  out.options.cascade = config.cascade;
  out.options.escape_saddle = config.escape_saddle;
  out.options.certificate = config.certificate;
  out.options.certifier = out.certifier.get();
  for (const auto& processor : out.post_processors) out.options.post_processors.push_back(processor.get());
}

/// The starts of a family: every image of the target, from the run's own initializer, from bows, and from what else was
/// given.
void add_family(const RunConfig& config, const BuildContext& context, Composition& out) {
  const FamilyOptions& family = config.family;
  if (!family.wanted()) return;
  std::vector<std::pair<std::string, std::shared_ptr<const Initializer>>> ways = {
      {std::string(out.initializer->name()), out.initializer}};
  for (int i = 0; i < family.bows; ++i) {
    const double angle = 360.0 * i / family.bows;
    ways.emplace_back(fmt::format("bow {:g} degrees", angle),
                      std::make_shared<const BowInitializer>(BowOptions{family.bow_height, angle}));
  }
  if (family.mirrored)
    ways.emplace_back(fmt::format("{}, mirrored", out.initializer->name()),
                      std::make_shared<const MirroredInitializer>(out.initializer));
  for (int rank = 2; rank <= family.routes; ++rank)
    ways.emplace_back(fmt::format("route {}", rank),
                      std::make_shared<const DijkstraInitializer>(DijkstraOptions{.routes = 1, .rank = rank}));
  for (const PluginChoice& choice : family.initializers.choices)
    ways.emplace_back(choice.path, make<std::shared_ptr<const Initializer>>(choice, context));
  std::vector<WoundProblem> problems = wound_problems(out.problem, family.windings);
  if (problems.empty()) problems.push_back({out.problem, ""});
  for (const WoundProblem& wound : problems)
    for (const auto& [name, initializer] : ways)
      out.family.push_back({wound.winding.empty() ? name : fmt::format("{}, winding {}", name, wound.winding),
                            wound.problem, initializer});
}

/// Runs one step of the check; its OptionError goes to the list, so that the next steps can add theirs.
template <class Step>
bool checked(LoadedConfig& loaded, Step step) {
  try {
    step();
    return true;
  } catch (const OptionError& e) {
    loaded.add_error(e.key(), e.what());
    return false;
  }
}

/// Makes the manifold of the configuration, unless it would read or compute: one that does checks its options and says
/// so first (BuildContext::progress), and is stopped there; then it is null. Throws OptionError.
std::shared_ptr<const ConstraintManifold> made_at_once(const LoadedConfig& loaded) {
  struct Checked {};
  BuildContext context{loaded.folder, 0, {}, {}};
  context.progress = [](double, std::string_view) { throw Checked(); };
  try {
    return make<std::shared_ptr<const ConstraintManifold>>(loaded.config.manifold, context);
  } catch (const Checked&) {
    return nullptr;
  }
}

/// The space a plug-in will see. Where the manifold itself is in a file, a stand-in: meshes, clouds and grids lie in
/// R^3.
std::optional<BuildContext> context_without_files(LoadedConfig& loaded) {
  const RunConfig& config = loaded.config;
  BuildContext context{loaded.folder, 3, Eigen::VectorXd::Zero(3), coordinate_names(3)};
  if (config.ring && !config.source.given) context.source.reset();
  Composition out;
  const bool placed = checked(loaded, [&] {
    out.problem.manifold = made_at_once(loaded);
    if (out.problem.manifold != nullptr) place_ends(config, out);
  });
  if (!placed) return std::nullopt;
  if (out.problem.manifold == nullptr) return context;
  context.manifold = out.problem.manifold;
  context.dimension = out.problem.manifold->dimensions().ambient;
  context.coordinates = point_coordinates(*out.problem.manifold);
  if (!config.ring || out.problem.based) context.source = source_position(out.problem);
  return context;
}

/// Asks the manifold itself for what its type only may have: the zeros of a function of the plane are no surface.
void check_needs(LoadedConfig& loaded, const PluginChoice& choice, const ConstraintManifold& manifold) {
  const std::vector<std::string>& needs = choice.plugin->needs;
  for_each_ability([&]<class Ability>() {
    const bool wanted = std::count(needs.begin(), needs.end(), Ability::kAbility) > 0;
    if (!wanted || !loaded.config.manifold.provides<Ability>() || find_ability<Ability>(manifold) != nullptr) return;
    loaded.add_error(choice.path,
                     fmt::format("'{}' needs a manifold with a {}, which this '{}' does not have", choice.plugin->type,
                                 Ability::kAbility, loaded.config.manifold.plugin->type));
  });
}

bool reads_files(const PluginChoice& choice) {
  bool any = false;
  OptionsWriter watching([&](const std::string& file) { return any = true, file; });
  choice.options->fields(watching);
  return any;
}

}  // namespace

Composition compose(const RunConfig& config, const std::filesystem::path& folder, const BuildProgress& progress) {
  const auto start = std::chrono::steady_clock::now();
  Composition out;
  BuildContext reading{folder, 0, {}, {}};
  reading.progress = progress;
  out.problem.manifold = make<std::shared_ptr<const ConstraintManifold>>(config.manifold, reading);
  out.read_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (const auto* data = find_ability<MadeFromData>(*out.problem.manifold)) out.notes = data->notes();
  place_ends(config, out);
  BuildContext context{
      folder, out.problem.manifold->dimensions().ambient, {}, point_coordinates(*out.problem.manifold)};
  if (!config.ring || out.problem.based) context.source = source_position(out.problem);
  context.seed = config.seed;
  context.manifold = out.problem.manifold;
  make_parts(config, context, out);
  add_family(config, context, out);
  fill_options(config, out);
  return out;
}

void check_constructors(LoadedConfig& loaded) {
  const RunConfig& config = loaded.config;
  const std::optional<BuildContext> context = context_without_files(loaded);
  if (!context) return;
  if (context->manifold != nullptr) {
    check_needs(loaded, config.initializer, *context->manifold);
    for (const PluginChoice& choice : config.family.initializers.choices)
      check_needs(loaded, choice, *context->manifold);
    for (const PluginChoice& choice : config.post_process.choices) check_needs(loaded, choice, *context->manifold);
  }
  checked(loaded, [&] { make<std::shared_ptr<const SegmentCost>>(config.cost, *context); });
  checked(loaded, [&] { make<std::shared_ptr<const Kernel>>(config.kernel, *context); });
  if (!reads_files(config.initializer))
    checked(loaded, [&] { make<std::shared_ptr<const Initializer>>(config.initializer, *context); });
  for (const PluginChoice& choice : config.family.initializers.choices)
    if (!reads_files(choice)) checked(loaded, [&] { make<std::shared_ptr<const Initializer>>(choice, *context); });
  checked(loaded, [&] { make<std::shared_ptr<const Solver>>(config.solver, *context); });
  for (const PluginChoice& choice : config.post_process.choices)
    checked(loaded, [&] { make<std::shared_ptr<const PostProcessor>>(choice, *context); });
}

}  // namespace leastcost
