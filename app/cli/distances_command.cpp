// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <ostream>

#include <leastcost/framework/errors.hpp>
#include <leastcost/problems/exact/exact_search.hpp>
#include <leastcost/problems/readers/mesh_reader.hpp>
#include "app/cli/commands.hpp"
#include "app/cli/interrupt.hpp"
#include "app/distances/distance_files.hpp"

namespace leastcost::app {

Exit distances_command(const DistancesArguments& arguments, const Streams& streams) {
  const DistanceFormat format =
      arguments.output.empty() ? DistanceFormat::csv : distance_format(arguments.output);  // before any work
  MeshOptions options;
  options.weld = arguments.weld;
  const TriangleMesh mesh(read_mesh(arguments.mesh), options);
  const std::int32_t source = mesh.vertex_of_file(arguments.vertex);
  if (source < 0)
    throw InputError(
        fmt::format("{}: no face uses vertex {}, so that no path leaves it", arguments.mesh, arguments.vertex));
  catch_interrupts();
  const ExactSearch search(mesh);
  ExactSearch::Workspace workspace(search);
  const ExactDistances found = search.distances(vertex_point(mesh, source), workspace, {.stop = interrupted});
  if (interrupted()) {
    streams.err << "interrupted; nothing was written\n";
    return Exit::interrupted;
  }
  if (!found.complete)
    streams.err
        << "note: shorter paths could cross an edge with three or more faces or a face without height, where "
           "nothing can be unfolded: the errors are those of a bound of 0 (leastcost doctor names the places)\n";
  const std::string text = distance_text(mesh, found, format);
  if (arguments.output.empty()) {
    streams.out << text;
    return Exit::certified;
  }
  std::ofstream out(arguments.output, std::ios::binary);
  out << text << std::flush;
  if (!out) {
    streams.err << fmt::format("error: {} cannot be written\n", arguments.output);
    return Exit::output;
  }
  double farthest = 0;
  std::int64_t reached = 0;
  for (const double d : found.at_most) {
    if (!std::isfinite(d)) continue;
    ++reached;
    farthest = std::max(farthest, d);
  }
  streams.out << fmt::format("{}: {} of {} vertices reached, the farthest at {:.10g}\n", arguments.output, reached,
                             mesh.vertex_count(), farthest);
  return Exit::certified;
}

}  // namespace leastcost::app
