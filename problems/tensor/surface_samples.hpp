// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

#include <leastcost/problems/cloud/has_point_cloud.hpp>
#include <leastcost/problems/mesh/has_mesh.hpp>

namespace leastcost {

/// Points of a surface on which data is given, as its file numbers them.
struct SurfaceSamples {
  std::vector<Eigen::Vector3d> positions;  ///< of the samples
  std::vector<Eigen::Vector3d> normals;    ///< unit; zero where there is none
  std::vector<double> spacing;             ///< side of the square that a sample has to itself, about
  std::vector<double> support;             ///< radius around a sample in which its data counts
  std::vector<std::int32_t> in_file;       ///< number of the sample in the file
  std::int32_t count_in_file = 0;          ///< those that are left out included
  bool oriented = false;                   ///< the normals tell the two sides of a thin sheet apart
  std::string what;                        ///< "vertices", "faces", "points", for messages
};

/// The vertices of the file that faces use. Where vertices were welded each of them is a sample. Subdivision changes
/// nothing.
SurfaceSamples vertex_samples(const TriangleMesh& mesh);

/// The centroids of the faces of the file; polygons are faces. Subdivision changes nothing.
SurfaceSamples face_samples(const TriangleMesh& mesh);

/// The points of a cloud; supports grow with its noise, as those of its surface do.
SurfaceSamples point_samples(const PointCloud& cloud);

}  // namespace leastcost
