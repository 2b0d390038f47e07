// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "app/compose.hpp"

#include <chrono>

#include "app/ends.hpp"
#include "app/registry.hpp"
#include "framework/errors.hpp"
#include "problems/geometry/has_images.hpp"
#include "problems/geometry/has_mesh.hpp"
#include "solvers/newton.hpp"

namespace leastcost::app {
namespace {

/// Where several points stand for the same, the path ends at the one nearest to its source.
void take_nearest_image(Composition& out) {
  const auto* domain = dynamic_cast<const HasImages*>(out.problem.manifold.get());
  if (domain == nullptr) return;
  const Eigen::VectorXd image = domain->nearest_image(out.target.end.u, out.source.end.u);
  if (image == out.target.end.u) return;
  out.target.end.u = image;
  out.notes.emplace_back("the target was replaced by the image of it that is nearer to the source");
}

void place_ends(const RunConfig& config, Composition& out) {
  out.problem.ring = config.ring;
  if (config.ring) return;
  out.source = place_end(*out.problem.manifold, config.source, "ends.source");
  out.target = place_end(*out.problem.manifold, config.target, "ends.target");
  take_nearest_image(out);
  out.problem.source = out.source.end;
  out.problem.target = out.target.end;
  if (out.problem.source.u == out.problem.target.u)
    throw OptionError("ends.target", "is the same point as the source; a closed path is a ring (path.ring: true)");
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
  out.options.certificate = config.certificate;
  out.options.certifier = out.certifier.get();
  for (const auto& processor : out.post_processors) out.options.post_processors.push_back(processor.get());
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

/// The space a plug-in will see. Where the manifold itself is in a file, a stand-in: meshes lie in R^3.
std::optional<BuildContext> context_without_files(LoadedConfig& loaded) {
  const RunConfig& config = loaded.config;
  BuildContext context{loaded.folder, 3, Eigen::VectorXd::Zero(3)};
  if (config.ring) context.source.reset();
  if (config.manifold.provides(std::string(kMesh))) return context;
  Composition out;
  const bool placed = checked(loaded, [&] {
    out.problem.manifold = make<std::shared_ptr<const ConstraintManifold>>(config.manifold, {loaded.folder, 0, {}});
    place_ends(config, out);
  });
  if (!placed) return std::nullopt;
  context.dimension = out.problem.manifold->dimensions().ambient;
  if (!config.ring) context.source = out.problem.source.u;
  return context;
}

bool reads_files(const PluginChoice& choice) {
  bool any = false;
  OptionsWriter watching([&](const std::string& file) { return any = true, file; });
  choice.options->fields(watching);
  return any;
}

}  // namespace

Composition compose(const RunConfig& config, const std::filesystem::path& folder) {
  const auto start = std::chrono::steady_clock::now();
  Composition out;
  out.problem.manifold = make<std::shared_ptr<const ConstraintManifold>>(config.manifold, {folder, 0, {}});
  out.read_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (const auto* mesh = dynamic_cast<const HasMesh*>(out.problem.manifold.get())) out.notes = mesh->mesh().notes();
  place_ends(config, out);
  BuildContext context{folder, out.problem.manifold->dimensions().ambient, {}};
  if (!config.ring) context.source = out.problem.source.u;
  context.seed = config.seed;
  make_parts(config, context, out);
  fill_options(config, out);
  return out;
}

void check_constructors(LoadedConfig& loaded) {
  const RunConfig& config = loaded.config;
  const std::optional<BuildContext> context = context_without_files(loaded);
  if (!context) return;
  checked(loaded, [&] { make<std::shared_ptr<const SegmentCost>>(config.cost, *context); });
  checked(loaded, [&] { make<std::shared_ptr<const Kernel>>(config.kernel, *context); });
  if (!reads_files(config.initializer))
    checked(loaded, [&] { make<std::shared_ptr<const Initializer>>(config.initializer, *context); });
  checked(loaded, [&] { make<std::shared_ptr<const Solver>>(config.solver, *context); });
  for (const PluginChoice& choice : config.post_process.choices)
    checked(loaded, [&] { make<std::shared_ptr<const PostProcessor>>(choice, *context); });
}

}  // namespace leastcost::app
