// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/catalogue/output/results.hpp>

#include <span>

#include "catalogue/output/path_table.hpp"
#include "catalogue/scene/scene.hpp"

namespace leastcost {
namespace {

namespace fs = std::filesystem;

/// The configuration with every default.
std::string resolved_config(const RunConfig& config, const fs::path& folder_of_config, const fs::path& output) {
  return "# Every option of this run, defaults included. `leastcost run` on this file repeats it.\n" +
         resolved_yaml(config, from_output(folder_of_config, output));
}

}  // namespace

RenameFile from_output(const fs::path& folder_of_config, const fs::path& output) {
  return [folder_of_config, output](const std::string& file) {
    if (fs::path(file).is_absolute()) return file;
    const fs::path absolute = fs::weakly_canonical(fs::absolute(folder_of_config / file));
    return absolute.lexically_relative(output).string();
  };
}

void write_results(const RunOutcome& outcome, const fs::path& folder_of_config, const ManifestFacts& facts,
                   OutputFolder& folder) {
  const PathTable points = delivered_points(outcome.parts.problem, outcome.result);
  const PathTable curve = delivered_curve(outcome.parts.problem, outcome.result);
  const bool curve_differs = curve.x.cols() != points.x.cols() || curve.x != points.x;
  folder.write("config.resolved.yaml", resolved_config(outcome.config, folder_of_config, folder.target()));
  folder.write("manifest.json", manifest_json(facts));
  folder.write("result.json", result_json(outcome));
  folder.write("path.csv", csv_text(points));
  folder.write("curve.csv", csv_text(curve));
  std::vector<PathTable> lines = {points};
  if (curve_differs) lines.push_back(curve);
  for (std::size_t k = 1; k < outcome.family.size(); ++k)
    lines.push_back(delivered_curve(outcome.family[k].problem, outcome.family[k].result));
  folder.write("path.vtp", vtp_text(lines));
  folder.write("path.obj", obj_text(curve));
  folder.write("history.csv", history_csv(outcome.result.solve.history));
  folder.write("first_path.csv", first_path_csv(outcome.parts.problem, outcome.result.first));
  const std::string residuals = residuals_csv(outcome.parts.problem, curve);
  if (!residuals.empty()) folder.write("residuals.csv", residuals);
  const std::span<const FamilyMember> family = outcome.family;
  folder.write("scene.json",
               scene_json(make_scene(outcome.parts.problem, outcome.result, family.subspan(family.empty() ? 0 : 1))));
}

}  // namespace leastcost
