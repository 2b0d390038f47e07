// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <leastcost/problems/mesh/triangle_mesh.hpp>
#include "app/cli/streams.hpp"
#include "app/figure/figure.hpp"
#include "app/run/run.hpp"
#include "app/study/merge.hpp"
#include "app/study/study.hpp"

namespace leastcost::app {

enum class Verbosity { quiet, normal, verbose };

struct RunArguments {
  RunRequest request;
  bool dry_run = false;
  bool json = false;
  Verbosity verbosity = Verbosity::normal;
  // Of a run of many pairs:
  bool json_lines = false;  ///< every line of paths.jsonl on standard output
  bool resume = false;
  int threads = 1;
};

struct StudyArguments {
  StudyRequest request;
  bool dry_run = false;
  bool json = false;
  bool quiet = false;
};

struct MergeArguments {
  MergeRequest request;
  bool json = false;
};

struct DistancesArguments {
  std::string mesh;
  std::vector<std::string> from;  ///< each a vertex of the file, or a text file of such numbers
  std::string output;             ///< empty: CSV on stdout
  std::string weld;               ///< empty: no; "true", or a distance in length units
  bool quiet = false;
  std::optional<double> max_distance = {};  ///< length units
  std::optional<double> max_seconds = {};
  std::optional<double> max_memory = {};  ///< GB, of windows
  std::optional<std::int64_t> max_windows = {};
};

struct FieldArguments {
  std::filesystem::path config;  ///< "-": standard input
  std::vector<Override> overrides;
  std::vector<std::string> from;  ///< each "x,y" (on a mesh "x,y,z", or a vertex), or a text file of such
                                  ///< lines; empty: the source of the configuration
  std::vector<std::string> to;    ///< the same, of places whose way back is wanted
  std::string output;             ///< empty: none, but a figure
  std::string ways;               ///< file of these ways; empty: none
  std::string figure = {};        ///< file of a picture; empty: none
  FigureRequest picture = {};     ///< its size, parts and unit
  std::optional<double> resolution = {};
  bool to_here = false;
  bool corridor = false;
  bool json = false;
};

struct FigureArguments {
  FigureRequest request;
  std::string output;
};

/// What --weld says: "true", or a distance. Throws InputError for anything else.
MeshOptions weld_of(const std::string& text);

/// What run_command() does where the configuration has many pairs of ends.
Exit pairs_command(const Run& run, const RunArguments& arguments, const Streams& streams);
/// Each command returns the exit code of the program. They throw what they do not handle; see exit_of_exception().
Exit run_command(const RunArguments& arguments, const Streams& streams);
Exit study_command(const StudyArguments& arguments, const Streams& streams);
Exit merge_command(const MergeArguments& arguments, const Streams& streams);
/// Makes the report of each folder again.
Exit report_command(const std::vector<std::string>& folders, const Streams& streams);
/// The picture of a run as a file for a paper, or its surface and path for 3D programs.
Exit figure_command(const FigureArguments& arguments, const Streams& streams);
Exit validate_command(const std::vector<std::string>& files, const std::vector<Override>& overrides, bool json,
                      const Streams& streams);
/// `kind`: empty for all kinds.
Exit list_command(const std::string& kind, bool json, const Streams& streams);
/// `type`: empty for the overview of a kind; the kinds `run` and `study` stand for the keys of a configuration.
Exit describe_command(const std::string& kind, const std::string& type, const Streams& streams);
/// Writes pages (name of the file, text) into a folder.
Exit pages_command(const std::map<std::string, std::string>& pages, const std::string& folder, const Streams& streams);
/// Writes a starting configuration with its schema and sample data. `name`: empty for the list of templates; `path`: a
/// folder or a .yaml file, empty for a folder with that name, - for the configuration alone on stdout. Files that exist
/// are kept, and nothing is written then, unless `force`.
Exit init_command(const std::string& name, const std::string& path, bool force, const Streams& streams);
/// `weld`: as for distances.
Exit doctor_command(const std::string& file, const std::string& weld, bool json, const Streams& streams);
/// Exact distances from the nearest of some vertices of a mesh to all others.
Exit distances_command(const DistancesArguments& arguments, const Streams& streams);
/// Least costs from the nearest of some places to every node of a lattice, or how much dearer detours are.
Exit field_command(const FieldArguments& arguments, const Streams& streams);

/// Prints what the exception in flight says and returns its exit code. Call it in a catch block only.
Exit exit_of_exception(const Streams& streams, bool json);

}  // namespace leastcost::app
