// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

#include <leastcost/framework/path/path.hpp>

namespace leastcost {

/// Triangles in space, for drawing only.
struct TriangleSoup {
  std::vector<Eigen::Vector3d> vertices;      ///< places of corners
  std::vector<std::array<int, 3>> triangles;  ///< numbers of three corners each
};

/// Points of a surface in space that are drawn as small discs.
struct Surfels {
  std::vector<Eigen::Vector3d> positions, normals;  ///< a small disc for each
  double spacing = 0;                               ///< typical distance of neighbours, length units
};

/// What there is to see of a domain in two or three dimensions.
struct Drawing {
  Eigen::Vector3d up = Eigen::Vector3d::UnitZ();  ///< upwards in pictures
  TriangleSoup surface;                           ///< of a two-dimensional domain in space
  Surfels surfels;                                ///< of a point cloud
  std::vector<Points> curves;                     ///< of a domain that is a curve in the plane: polylines, 2 x m
  std::vector<Points> obstacles;   ///< in the plane, or on the map of a surface: closed polylines, ambient
  std::vector<Points> margins;     ///< the same, as far off the obstacles as a clearance asks for
  std::vector<Points> free;        ///< closed outlines of the free part of the plane, holes included; empty: all of it
  Eigen::VectorXd lower, upper;    ///< of a box in the ambient space, entries may be infinite; empty: none
  std::vector<std::string> notes;  ///< what is not shown as it is
};

/// The paths that a drawing is made for.
struct DrawnPaths {
  Points x;  ///< all their points as they are drawn, ambient, d x m; some finite ones that are not all the same
  Points u;  ///< points of the chain and of the first path, in coordinates
};

/// Ability of a domain: it can be drawn. Asked in a space of two or three dimensions only.
class DrawsItself {
 public:
  virtual ~DrawsItself() = default;
  /// Adds the domain around the paths to `out`. A matter of milliseconds: what is large is thinned, which is noted.
  virtual void draw(const DrawnPaths& paths, Drawing& out) const = 0;
};

}  // namespace leastcost
