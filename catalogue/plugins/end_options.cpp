// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/catalogue/plugins/end_options.hpp>

namespace leastcost {

void ToolPose::fields(FieldVisitor& visit) {
  visit.field("link", link, {.help = "The link that carries the tool; default: the last one."});
  visit.field("offset", offset,
              {.help = "The tool, in the frame of the link; default: the origin of the frame.", .unit = "length"});
  pose.fields(visit);
}

void EndOptions::fields(FieldVisitor& visit) {
  visit.field(
      "vertex", vertex,
      {.help = "Vertex of the mesh, or point of the cloud, numbered from 0 in the order of the file.", .minimum = 0});
  visit.field("face", face, {.help = "Face of the mesh, numbered from 0 in the order of the file.", .minimum = 0});
  visit.field("barycentric", barycentric,
              {.help = "Position on the face: weights of its three corners, with sum 1.", .minimum = 0});
  visit.field("point", point, {.help = "Coordinates; moved to the nearest point of the manifold.", .unit = "length"});
  visit.field("lonlat", lonlat,
              {.help = "On the Earth, and on rasters with a CRS or in degrees: [longitude, latitude] on WGS84, in this "
                       "order.",
               .unit = "degrees"});
  visit.field("state", state, {.help = "Name of a state of the robot: a group_state of its SRDF."});
  visit.field("points", points,
              {.help = "Of a target: several goals, one a row. The path ends at the one that is cheapest to reach.",
               .unit = "length"});
  visit.group(
      "tool",
      {.help = "Of a target: a pose of the robot's tool. The path ends at the configuration that is cheapest to "
               "reach, of those that inverse kinematics finds."},
      [&](FieldVisitor& inner) { tool.fields(inner); });
  visit.field("tolerance", tolerance,
              {.help = "Largest distance by which `point` is moved; default: 1 % of the diameter of a mesh, a cloud or "
                       "the box of a grid, elsewhere rounding only.",
               .unit = "length",
               .minimum = 0});
}

int EndOptions::ways() const {
  return (vertex ? 1 : 0) + (face || barycentric ? 1 : 0) + (point ? 1 : 0) + (lonlat ? 1 : 0) + (state ? 1 : 0) +
         (points ? 1 : 0) + (tool.given() ? 1 : 0);
}

}  // namespace leastcost
