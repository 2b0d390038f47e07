// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/straighten/straighten.hpp>

#include "problems/straighten/string_flips.hpp"
#include "problems/straighten/string_moves.hpp"
#include "problems/straighten/taut_string.hpp"

namespace leastcost {

Straightened straighten(const TriangleMesh& mesh, const SurfacePath& path, const StraightenOptions& options) {
  Straightened result;
  result.initial_length = path_length(path, options.metric);
  if (path.faces.empty()) {  // both ends are one point
    result.path = path;
    return result;
  }
  StringPuller puller(mesh, options.metric);
  StringMover mover(puller, options.shortcuts);
  TautString string = puller.from_path(path);
  result.finished = mover.straighten(string, options.stop);
  if (options.flips && result.finished) {
    StringFlipper flipper(puller, mover);
    result.finished = flipper.improve(string, options.stop);
    result.flips = flipper.flips();
  }
  result.moves = mover.moves();
  result.path = puller.to_path(string);
  result.final_length = path_length(result.path, options.metric);
  return result;
}

}  // namespace leastcost
