// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "catalogue/registry/built_in.hpp"

#include <leastcost/problems/post_processors/on_surface.hpp>
#include <leastcost/problems/post_processors/refract.hpp>
#include <leastcost/problems/post_processors/refract_cells.hpp>
#include <leastcost/problems/post_processors/straighten.hpp>
#include <leastcost/problems/post_processors/switchbacks.hpp>
#include <leastcost/problems/post_processors/taut.hpp>
#include <leastcost/problems/post_processors/trace.hpp>
#include "catalogue/plugins/registration.hpp"

namespace leastcost {

const std::vector<PostProcessorPlugin>& built_in::post_processors() {
  static const std::vector<PostProcessorPlugin> all = {
      made_of<PostProcessorPlugin, TracePostProcessor>("trace", "The solved path as a polyline on the mesh.")
          .needing<HasMesh>(),
      made_of<PostProcessorPlugin, StraightenPostProcessor>(
          "straighten", "The exact locally shortest path on the mesh, in the same class as the solved one.")
          .needing<HasMesh>()
          .needing<HasConstantMetric>(),
      made_of<PostProcessorPlugin, OnSurfacePostProcessor, OnSurfaceOptions>(
          "on_surface", "The solved path as a polyline that lies on a smooth domain within a tolerance.")
          .needing<HasLevelSet>(),
      made_of<PostProcessorPlugin, TautPostProcessor, TautOptions>(
          "taut", "The shortest path in its class among obstacles in the plane, or among convex ones in space.")
          .needing<HasConstantMetric>(),
      made_of<PostProcessorPlugin, RefractPostProcessor>(
          "refract", "The least-cost path through the same layers, with Snell's law at every interface.")
          .needing<HasLayers>(),
      made_of<PostProcessorPlugin, RefractCellsPostProcessor>(
          "refract_cells",
          "The locally least-cost path over the cells of a cost map, with Snell's law at every cell side."),
      made_of<PostProcessorPlugin, SwitchbackPostProcessor, SwitchbackOptions>(
          "switchbacks", "The zigzag of given width that a walking path represents on steep slopes.")
          .needing<MixesMoves>(),
  };
  return all;
}

}  // namespace leastcost
