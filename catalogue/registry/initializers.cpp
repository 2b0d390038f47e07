// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "catalogue/registry/built_in.hpp"

#include <leastcost/problems/initializers/bow.hpp>
#include <leastcost/problems/initializers/cell_graph.hpp>
#include <leastcost/problems/initializers/coordinate_circle.hpp>
#include <leastcost/problems/initializers/dijkstra.hpp>
#include <leastcost/problems/initializers/eikonal.hpp>
#include <leastcost/problems/initializers/grid.hpp>
#include <leastcost/problems/initializers/plane_cut.hpp>
#include <leastcost/problems/initializers/rrt.hpp>
#include <leastcost/problems/initializers/straight.hpp>
#include <leastcost/problems/initializers/waypoints.hpp>
#include "catalogue/back_ends/back_ends.hpp"
#include "catalogue/plugins/registration.hpp"
#include "problems/readers/waypoint_reader.hpp"

namespace leastcost {

const std::vector<InitializerPlugin>& built_in::initializers() {
  static const std::vector<InitializerPlugin> own = {
      made_of<InitializerPlugin, StraightInitializer>(
          "straight", "The straight line between the ends, bent around places where its cost is infinite."),
      made_of<InitializerPlugin, BowInitializer, BowOptions>("bow", "An arc on a given side of the straight line."),
      made_of<InitializerPlugin, DijkstraInitializer, DijkstraOptions>(
          "dijkstra", "The least-cost path along the edges of the mesh, or the neighbour graph of the cloud.")
          .needing<HasGraph>(),
      made_of<InitializerPlugin, PlaneCutInitializer, PlaneCutOptions>(
          "plane_cut", "The closed curve in which a plane cuts the surface, for a ring.")
          .needing<IsSurface>(),
      made_of<InitializerPlugin, EikonalInitializer, EikonalOptions>(
          "eikonal", "Follows the arrival-cost field back to the source, over two coordinates, for any cost."),
      made_of<InitializerPlugin, CellGraphInitializer, CellGraphOptions>(
          "cell_graph", "The least-cost path between points on the cell sides of a cost map (interpolation: cells)."),
      made_of<InitializerPlugin, GridInitializer, GridOptions>(
          "grid", "A least-cost route over a regular grid in the plane or in space that keeps clear of obstacles."),
      plugin<InitializerPlugin, RrtOptions>(
          "rrt", "Random trees from both ends, for robots, among obstacles and near smooth domains; shortened.",
          [](const RrtOptions& o, const BuildContext& c) { return std::make_shared<const RrtInitializer>(o, c.seed); }),
      plugin<InitializerPlugin, WaypointsOptions>("waypoints", "A path through the given points, in order.",
                                                  [](const WaypointsOptions& o, const BuildContext&) {
                                                    return std::make_shared<const WaypointsInitializer>(
                                                        o.points.transpose());
                                                  }),
      made_of<InitializerPlugin, CoordinateCircleInitializer, CoordinateCircleOptions>(
          "coordinate_circle", "A ring along which one coordinate of a chart runs once or more through its period.")
          .needing<HasSeams>(),
      plugin<InitializerPlugin, FileInitializerOptions>(
          "file", "A path through the points of a text file, such as the path.csv of an earlier run.",
          [](const FileInitializerOptions& o, const BuildContext& c) {
            return std::make_shared<const WaypointsInitializer>(read_waypoints(c.folder / o.file, c.coordinates));
          })
          .waiting(),
  };
  static const std::vector<InitializerPlugin> all = built_in::with_those_of_libraries(own, planners());
  return all;
}

}  // namespace leastcost
