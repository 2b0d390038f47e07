// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include <Eigen/Geometry>
#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>
#include <fstream>
#include <ostream>
#include <span>
#include <sstream>
#include <string>
#include <vector>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/problems/exact/exact_search.hpp>
#include <leastcost/problems/readers/mesh_reader.hpp>
#include "app/cli/command_options.hpp"
#include "app/cli/commands.hpp"
#include "app/cli/interrupt.hpp"
#include "app/cli/progress.hpp"
#include "app/cli/written_places.hpp"
#include "app/distances/distance_files.hpp"

namespace leastcost::app {
namespace {

/// The vertices that --from names, each once by number or many in a file of numbers.
std::vector<int> numbers_of(const std::vector<std::string>& from) {
  std::vector<int> numbers;
  const auto none = [](const std::string&) { return false; };
  for (const WrittenPlace& place : written_places(from, "--from", is_whole_number, none, "12 (a vertex)")) {
    std::istringstream in(place.text);  // a line may have several
    for (std::string word; in >> word;) {
      int number = -1;
      const char* end = word.data() + word.size();
      const auto [rest, error] = std::from_chars(word.data(), end, number);
      if (error != std::errc() || rest != end || number < 0)
        throw InputError(fmt::format("{}: expected a vertex number, from 0 (found '{}')", place.where, word));
      numbers.push_back(number);
    }
  }
  return numbers;
}

std::vector<SurfacePoint> sources_of(const TriangleMesh& mesh, const DistancesArguments& arguments) {
  std::vector<SurfacePoint> sources;
  for (const int number : numbers_of(arguments.from)) {
    const std::int32_t v = mesh.vertex_of_file(number);
    if (v < 0)
      throw InputError(fmt::format("{}: no face uses vertex {}, so no path can leave it", arguments.mesh, number));
    sources.push_back(vertex_point(mesh, v));
  }
  return sources;
}

struct Count {
  std::int64_t reached = 0, not_reached = 0;
  double farthest = 0;
};

Count count(const ExactDistances& found) {
  Count all;
  for (std::size_t v = 0; v < found.at_most.size(); ++v) {
    if (state_at(found, static_cast<std::int32_t>(v)) == DistanceState::not_reached) ++all.not_reached;
    if (!std::isfinite(found.at_most[v])) continue;
    ++all.reached;
    all.farthest = std::max(all.farthest, found.at_most[v]);
  }
  return all;
}

/// Why the search ended before all was known, with the option that lets it go on; empty where it did not.
std::string end_of_search(const ExactDistances& found, const DistancesArguments& arguments, double max_memory) {
  if (interrupted()) return "interrupted";
  if (found.out_of_memory)
    return fmt::format("stopped: windows reached the memory limit of {:.4g} GB; to continue, use --max-memory {:.4g}",
                       max_memory, 2 * max_memory);
  if (found.out_of_windows)
    return fmt::format("stopped after {0} windows; to continue, use --max-windows {1}", *arguments.max_windows,
                       2 * *arguments.max_windows);
  if (found.stopped)
    return fmt::format("stopped after {0:.4g} s; to continue, use --max-seconds {1:.4g}", *arguments.max_seconds,
                       2 * *arguments.max_seconds);
  return "";
}

ExactDistances search(const TriangleMesh& mesh, std::span<const SurfacePoint> sources,
                      const DistancesArguments& arguments, double max_memory, const Streams& streams) {
  constexpr double kBytesPerGb = 1e9;
  ProgressPrinter progress(streams, arguments.quiet);
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& p : mesh.positions()) box.extend(p);
  const double whole = arguments.max_distance.value_or(box.diagonal().norm());
  const auto begin = std::chrono::steady_clock::now();
  ExactOptions options;
  options.max_memory = max_memory * kBytesPerGb;
  if (arguments.max_windows) options.max_windows = *arguments.max_windows;
  if (arguments.max_distance) options.max_distance = *arguments.max_distance;
  options.stop = [&] {
    const std::chrono::duration<double> since = std::chrono::steady_clock::now() - begin;
    return interrupted() || (arguments.max_seconds && since.count() > *arguments.max_seconds);
  };
  options.watch = [&](double seen_to, std::int64_t windows) {
    progress.show_part("distances", seen_to / whole, fmt::format("up to {:.4g}, {} windows", seen_to, windows));
  };
  const ExactSearch exact(mesh);
  ExactSearch::Workspace workspace(exact);
  return exact.distances(sources, workspace, options);
}

}  // namespace

Exit distances_command(const DistancesArguments& arguments, const Streams& streams) {
  constexpr double kMaxMemory = 1.8;  // GB: with the rest of 50,000 triangles below 2
  const DistanceFormat format =
      arguments.output.empty() ? DistanceFormat::csv : distance_format(arguments.output);  // before any work
  const TriangleMesh mesh(read_mesh(arguments.mesh), weld_of(arguments.weld));
  const std::vector<SurfacePoint> sources = sources_of(mesh, arguments);
  catch_interrupts();
  const double max_memory = arguments.max_memory.value_or(kMaxMemory);
  const ExactDistances found = search(mesh, sources, arguments, max_memory, streams);
  const Count all = count(found);
  const std::string end = end_of_search(found, arguments, max_memory);
  if (!end.empty())
    streams.err << fmt::format("{}: distances below {:.6g} are exact, {} of {} vertices were not reached\n", end,
                               found.seen_to, all.not_reached, mesh.vertex_count());
  if (found.blocked)
    streams.err << fmt::format(
        "note: shorter paths could cross a degenerate face, which cannot be unfolded: distances from {:.6g} on are "
        "only bounds (leastcost doctor lists the faces)\n",
        found.seen_to);
  const Exit exit = interrupted() ? Exit::interrupted : end.empty() ? Exit::certified : Exit::uncertified;
  const std::string text = distance_text(mesh, found, format);
  if (arguments.output.empty()) {
    streams.out << text;
    return exit;
  }
  std::ofstream out(arguments.output, std::ios::binary);
  out << text << std::flush;
  if (!out) {
    streams.err << fmt::format("error: cannot write {}\n", arguments.output);
    return Exit::output;
  }
  streams.out << fmt::format("{}: {} of {} vertices reached, the farthest at {:.10g}\n", arguments.output, all.reached,
                             mesh.vertex_count(), all.farthest);
  if (arguments.max_distance && end.empty() && all.not_reached > 0)
    streams.out << fmt::format("{} vertices are farther than --max-distance {:.10g} or cannot be reached\n",
                               all.not_reached, *arguments.max_distance);
  return exit;
}

void add_distances(const CommandLine& line) {
  OptionValues& v = line.values;
  CLI::App& distances = *line.app.add_subcommand(
      "distances", "Compute exact distances on a mesh to all vertices, from one vertex or from the nearest of several");
  distances.add_option("mesh", v.mesh, "OBJ, OFF, PLY or STL file")->required()->type_name("MESH");
  DistancesArguments& d = v.distances;
  distances
      .add_option("--from", d.from,
                  "Vertex number in the file, from 0, or a text file of vertex numbers; can be repeated")
      ->required()
      ->type_name("VERTEX");
  distances.add_flag(
      "--weld", v.weld,
      "First merge vertices at equal positions; --weld=1e-6: also those no farther apart than this, in length units");
  distances.add_option("--max-distance", d.max_distance, "Go no farther than this, in length units")
      ->check(CLI::PositiveNumber);
  distances.add_option("--max-seconds", d.max_seconds, "Stop after this time, in seconds; default: no limit")
      ->check(CLI::PositiveNumber);
  distances
      .add_option("--max-memory", d.max_memory, "Stop before windows take more memory than this, in GB; default: 1.8")
      ->check(CLI::PositiveNumber);
  distances.add_option("--max-windows", d.max_windows, "Stop after this many windows; default: no limit")
      ->check(CLI::PositiveNumber);
  distances.add_flag("-q,--quiet", v.quiet, "Print no progress");
  add_output(distances, v, "Write to this file: .csv, .vtp or .ply; default: CSV on standard output", "FILE");
  distances.callback([&] {
    line.chosen = [&] {
      v.distances.mesh = v.mesh;
      v.distances.output = v.output;
      v.distances.weld = v.weld;
      v.distances.quiet = v.quiet;
      return distances_command(v.distances, line.streams);
    };
  });
}

}  // namespace leastcost::app
