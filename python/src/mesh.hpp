// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/numpy.h>

#include <Eigen/Core>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include <leastcost/problems/exact/exact_search.hpp>
#include <leastcost/problems/manifolds/data/mesh.hpp>
#include <leastcost/problems/mesh/triangle_mesh.hpp>
#include <leastcost/problems/straighten/geodesic.hpp>

namespace leastcost::python {

/// A mesh with what searches on it need; shared by threads, each of which borrows a workspace.
class Mesh {
 public:
  using Vertices = pybind11::array_t<double, pybind11::array::c_style>;
  using Faces = pybind11::array_t<std::int32_t, pybind11::array::c_style>;
  using Stop = std::function<bool()>;

  /// V: (n, 3); F: (m, k), rows of vertex numbers. Shapes and numbers are checked by _mesh.py. All throw Interrupted.
  Mesh(const Vertices& vertices, const Faces& faces, bool weld, const Deadline& deadline);
  Mesh(const std::filesystem::path& file, bool weld, const Deadline& deadline);
  Mesh(PolygonSoup soup, bool weld, const Deadline& deadline = {});

  const TriangleMesh& mesh() const { return manifold_->mesh(); }
  /// The same as a domain.
  const std::shared_ptr<const MeshManifold>& manifold() const { return manifold_; }
  /// What it was made of.
  const PolygonSoup& soup() const { return soup_; }
  bool weld() const { return weld_; }
  /// As they were given, 3 x n.
  Eigen::Matrix3Xd vertices() const;
  /// The triangles, in vertex numbers of V, 3 x m.
  Eigen::Matrix<std::int32_t, 3, Eigen::Dynamic> faces() const;

  /// Vertex v of V. Throws InputError.
  SurfacePoint vertex(std::int64_t v) const;
  /// A point of a triangle in row `face` of F. Throws InputError.
  SurfacePoint on_face(std::int64_t face, const Eigen::Vector3d& barycentric) const;
  /// The point of the surface nearest to `point`. Throws InputError where it is not finite; Interrupted, for the first
  /// such question makes a search tree.
  SurfacePoint nearest(const Eigen::Vector3d& point, const Deadline& deadline) const;

  /// Throws InitializationError where there is no path.
  ExactResult geodesic(const SurfacePoint& source, const SurfacePoint& target, const Stop& stop) const;
  ExactDistances distances(std::span<const SurfacePoint> sources, double max_distance, const Stop& stop) const;

 private:
  struct Workspace {
    ExactSearch::Workspace exact;
    GeodesicSearch routes;
  };

  Workspace borrow() const;
  void give_back(Workspace workspace) const;

  PolygonSoup soup_;
  bool weld_;
  std::shared_ptr<const MeshManifold> manifold_;
  ExactSearch exact_;
  mutable std::mutex mutex_;
  mutable std::vector<Workspace> idle_;  // guarded by mutex_
};

}  // namespace leastcost::python
