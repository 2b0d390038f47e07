// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <leastcost/framework/certificate/certificate.hpp>
#include <leastcost/framework/replan/waypoints.hpp>
#include <leastcost/framework/trajectory/trajectory.hpp>
#include "catalogue/options/options_writer.hpp"
#include "catalogue/plugins/run_visitor.hpp"

namespace leastcost {

/// More first paths, for other locally least-cost paths.
struct FamilyOptions {
  int windings = 0;
  int bows = 0;
  int routes = 1;
  bool mirrored = false;
  double bow_height = 0.5;
  PluginList initializers = {};
  void fields(RunVisitor& visit);
  bool wanted() const { return windings > 0 || bows > 0 || routes > 1 || mirrored || !initializers.empty(); }
};

/// Which of the coordinates of one point the path ends at: those to which a path is cheapest, where the given ones
/// state no winding, or those that were given.
enum class TargetImageChoice { cheapest, given };
Words<TargetImageChoice> words(TargetImageChoice);

/// What `output.files` can name: parts of what a run of one path leaves in its folder, beside manifest.json.
inline constexpr std::array<std::string_view, 16> kRunFiles = {
    "result",    "path",       "curve",   "vtp",        "obj",   "geojson", "gpkg",   "residuals",
    "waypoints", "trajectory", "history", "first_path", "scene", "clicks",  "config", "report"};

/// One run as its configuration describes it. Everything typed, checked and with its default in place; nothing read
/// from the disk and nothing computed yet.
struct RunConfig {
  std::string name;  ///< default: the name of the configuration file
  int seed = 0;
  std::optional<double> max_seconds;  ///< time budget of the search
  PluginChoice manifold, cost, kernel;
  PluginList obstacles;
  PluginChoice robot;                            ///< none: points are places among the obstacles
  double clearance = 0;                          ///< from the obstacles, length units
  std::optional<EndOptions> source, target;      ///< none in a ring, or the source alone: its fixed point
  EndsFrom ends_from = EndsFrom::configuration;  ///< of whoever reads it, not of the file
  std::string pairs;                             ///< file of many pairs of ends, in the place of these two; empty: none
  std::optional<double> pair_tolerance;          ///< of their points, as of an end
  std::optional<int> points = 64;                ///< free points n; none: as many as the first edge path has
  bool ring = false;
  bool cascade = false;
  bool escape_saddle = false;
  TargetImageChoice target_image = TargetImageChoice::cheapest;
  std::optional<double> reference_cost;  ///< s0; else the mean segment cost of the first path
  PluginChoice initializer, solver;
  FamilyOptions family;
  CertificateOptions certificate;
  std::optional<PluginList> post_process;    ///< none: those of the manifold
  std::optional<std::string> output_folder;  ///< relative to the current folder; else results/<name>
  std::vector<std::string> output_files;     ///< which of kRunFiles a run of one path writes; empty: all of them
  bool pair_points = false;                  ///< the lines of a run of pairs have the points of the paths
  WaypointOptions waypoints;                 ///< of the output
  TrajectoryOptions trajectory;              ///< of the output
  std::string joint_limits;                  ///< file of limits for it; empty: none

  void fields(RunVisitor& visit);
  bool has_pairs() const { return !pairs.empty(); }
  /// Whether the parts are made without ends, which are put in later.
  bool ends_come_later() const {
    return has_pairs() || (ends_from == EndsFrom::caller && !ring && !(source && target));
  }
  bool wants_trajectory() const { return trajectory.wanted() || !joint_limits.empty(); }
  /// Whether a run writes what one of kRunFiles stands for.
  bool writes(std::string_view file) const;
};

/// The configuration with every default, as YAML that reads back as the same one.
std::string resolved_yaml(const RunConfig& config, const RenameFile& rename = {});

/// Files that the configuration names, as they are written there.
std::vector<std::string> files_of(const RunConfig& config);

}  // namespace leastcost
