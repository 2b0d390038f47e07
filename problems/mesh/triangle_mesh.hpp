// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <leastcost/eigen_alignment.hpp>
#include <leastcost/framework/base/deadline.hpp>

namespace leastcost {

/// What a file said, before any interpretation: polygons over vertices, both in file order, numbered from 0.
struct PolygonSoup {
  std::vector<Eigen::Vector3d> positions;   ///< of the vertices of the file
  std::vector<std::int32_t> corners;        ///< vertex numbers, polygon after polygon
  std::vector<std::int32_t> polygon_begin;  ///< polygon p owns corners [polygon_begin[p], polygon_begin[p + 1])
  std::string source;                       ///< where it came from, for messages
};

struct MeshOptions {
  bool weld = false;  ///< merge vertices with equal positions
  int subdivide = 0;  ///< midpoint subdivision, so many times: same geometry, 4^k as many faces
  /// Merge vertices that are no farther apart than this too, length units; each into the lowest near it, so that none
  /// moves farther. 0: as `weld` says.
  double weld_within = 0;
  Deadline deadline = {};  ///< when the making is given up: it throws Interrupted
};

/// A point of the surface: face and barycentric coordinates (sum 1, corner order of the face).
struct SurfacePoint {
  std::int32_t face = -1;                                 ///< its number; -1: none
  Eigen::Vector3d barycentric = Eigen::Vector3d::Zero();  ///< weights of the corners, with sum 1
};

/// An immutable triangle mesh with adjacency, in double precision. Boundaries, several components and any genus are
/// normal; so are flipped faces and non-orientable surfaces, because no query depends on the order of corners.
///
/// Halfedge h = 3 f + k is the side of face f from its corner k to its corner (k + 1) mod 3. `across(h)` is the
/// halfedge of the neighbouring face that shares this edge (which may run in the same direction when that face is
/// flipped), kBorder where there is none, kNonManifold where three or more faces share the edge.
///
/// Identity: vertex v of the file is vertex_of_file(v) here (welding may merge two), and a point given by file face
/// and barycentric coordinates is found again by locate(), whatever triangulation and subdivision did. Vertices that
/// no face uses are left out; the others keep the order of the file and come before those made by subdivision.
class TriangleMesh {
 public:
  static constexpr std::int32_t kBorder = -1;       ///< across an edge with one face
  static constexpr std::int32_t kNonManifold = -2;  ///< across an edge with more than two faces

  /// Triangulates polygons (notes() says so), welds, subdivides, drops degenerate polygons (fewer than three different
  /// corners; noted). Throws InputError when indices are out of range, positions are not finite or beyond 1e75, all lie
  /// within 1e-75, or no face remains; OptionError when `subdivide` is negative or makes more faces than 32-bit numbers
  /// can name.
  explicit TriangleMesh(const PolygonSoup& soup, const MeshOptions& options = {});

  /// Vertices that a face uses.
  std::int32_t vertex_count() const { return static_cast<std::int32_t>(positions_.size()); }
  std::int32_t face_count() const { return static_cast<std::int32_t>(faces_.size()); }  ///< triangles
  /// Place of a vertex.
  const Eigen::Vector3d& position(std::int32_t v) const { return positions_[static_cast<std::size_t>(v)]; }
  /// The vertices of a face, in the order of its corners.
  const std::array<std::int32_t, 3>& face(std::int32_t f) const { return faces_[static_cast<std::size_t>(f)]; }
  const std::vector<Eigen::Vector3d>& positions() const { return positions_; }      ///< of all vertices
  const std::vector<std::array<std::int32_t, 3>>& faces() const { return faces_; }  ///< of all triangles
  Eigen::Vector3d point(const SurfacePoint& p) const;                               ///< place of a point

  /// The halfedge of the neighbour across h, or kBorder or kNonManifold.
  std::int32_t across(std::int32_t h) const { return across_[static_cast<std::size_t>(h)]; }
  /// Vertex that h leaves.
  std::int32_t tail(std::int32_t h) const { return face(h / 3)[static_cast<std::size_t>(h % 3)]; }
  /// Vertex that h enters.
  std::int32_t head(std::int32_t h) const { return face(h / 3)[static_cast<std::size_t>((h + 1) % 3)]; }
  static std::int32_t next(std::int32_t h) { return h % 3 == 2 ? h - 2 : h + 1; }  ///< halfedge after h in its face
  /// Halfedge before h in its face.
  static std::int32_t previous(std::int32_t h) { return h % 3 == 0 ? h + 2 : h - 1; }

  /// Faces around a vertex, ascending (not in the order of a walk around it).
  std::span<const std::int32_t> faces_of_vertex(std::int32_t v) const;
  /// Neighbours of a vertex along edges, ascending.
  std::span<const std::int32_t> neighbours(std::int32_t v) const;
  /// Sum of the corner angles at v (the cone angle where v is interior).
  double vertex_angle(std::int32_t v) const { return vertex_angle_[static_cast<std::size_t>(v)]; }
  /// Whether v is the end of an edge that has one face only.
  bool on_border(std::int32_t v) const { return on_border_[static_cast<std::size_t>(v)] != 0; }

  /// Unit normal of a face, in the order of its corners; zero for a face whose corners are collinear to rounding.
  Eigen::Vector3d face_normal(std::int32_t f) const;
  /// Unit normal at a point, interpolated from angle-weighted vertex normals; the side is that of the face's own
  /// orientation, so flipped neighbours do no harm. A vertex where several sheets meet has one normal per sheet. Zero
  /// only where all faces around are degenerate.
  Eigen::Vector3d smooth_normal(const SurfacePoint& p) const;

  /// Connected component (through shared edges or vertices) of a vertex, and the vertex count of each component.
  std::int32_t component(std::int32_t v) const { return component_[static_cast<std::size_t>(v)]; }
  /// Vertices of each connected part.
  const std::vector<std::int32_t>& component_sizes() const { return component_sizes_; }

  /// Diagonal of the bounding box.
  double diameter() const { return diameter_; }

  /// The vertex here that is vertex v of the file, or -1 when no face uses it. Throws InputError when out of range.
  std::int32_t vertex_of_file(std::int32_t v) const;
  /// Vertices of the file, those without faces included.
  std::int32_t file_vertex_count() const { return static_cast<std::int32_t>(vertex_of_file_.size()); }
  /// Faces of the file, before they were cut into triangles.
  std::int32_t file_face_count() const { return static_cast<std::int32_t>(base_begin_.size()) - 1; }
  /// The file's number of the polygon that face f came from, and of vertex v (-1: made by subdivision; the lowest
  /// number where welding merged several).
  std::int32_t file_face(std::int32_t f) const { return base_file_face_[static_cast<std::size_t>(base_of(f))]; }
  /// Number in the file of vertex v.
  std::int32_t file_vertex(std::int32_t v) const { return file_vertex_[static_cast<std::size_t>(v)]; }

  /// A point in terms of the file: the polygon, which of the triangles it was cut into (0 when it is a triangle), that
  /// triangle's corners as vertex numbers of the file, and barycentric coordinates with respect to these.
  struct FilePoint {
    std::int32_t face = -1;                                 ///< its number in the file; -1: none
    std::int32_t fan = 0;                                   ///< which triangle of the fan that the face was cut into
    std::array<std::int32_t, 3> vertices = {-1, -1, -1};    ///< of that triangle, by their numbers in the file
    Eigen::Vector3d barycentric = Eigen::Vector3d::Zero();  ///< weights of these vertices
  };
  /// Where a point of a triangular face of the file went. Coordinates may be off by 1e-6 (they are clamped and scaled
  /// to sum 1). Throws InputError when out of range, on a polygon, on a face that was dropped.
  SurfacePoint locate(std::int32_t file_face, const Eigen::Vector3d& barycentric) const;
  /// The same for any face, by `face`, `fan` and `barycentric`; the inverse of in_file().
  SurfacePoint locate(const FilePoint& p) const;
  /// The same point by numbers of the file.
  FilePoint in_file(const SurfacePoint& p) const;

  /// Edges with three or more faces, as pairs of vertices (of this mesh; file_vertex() names them), ascending.
  const std::vector<std::pair<std::int32_t, std::int32_t>>& non_manifold_edges() const { return non_manifold_edges_; }
  /// Halfedges whose neighbour runs in the same direction, ascending; both sides of such an edge are listed.
  const std::vector<std::int32_t>& flipped_halfedges() const { return flipped_halfedges_; }
  /// What construction did that a user should know: "12 polygons cut into 24 triangles", "403 vertices merged", ...
  const std::vector<std::string>& notes() const { return notes_; }
  /// Where the mesh came from, for messages.
  const std::string& source() const { return source_; }

 private:
  void import_polygons(const PolygonSoup& soup, const std::vector<std::int32_t>& same_as, const Deadline& deadline);
  void number_vertices(const PolygonSoup& soup, const std::vector<std::int32_t>& same_as);
  void subdivide_once();
  void measure_diameter();
  void build_adjacency(const Deadline& deadline);
  void build_vertex_tables(std::span<const double> angles, const Deadline& deadline);
  void build_normals(std::span<const double> angles, const Deadline& deadline);
  void build_components();
  std::vector<double> corner_angles(const Deadline& deadline) const;
  Eigen::Vector3d fan_normal(std::int32_t corner, std::int32_t fan, std::span<const double> angles,
                             std::span<const Eigen::Vector3d> normals);
  SurfacePoint locate_in_base(std::int32_t base, Eigen::Vector3d barycentric) const;
  std::int32_t base_of(std::int32_t f) const { return f >> (2 * subdivisions_); }

  std::vector<Eigen::Vector3d> positions_;
  std::vector<std::array<std::int32_t, 3>> faces_;
  std::vector<std::int32_t> across_;
  std::vector<std::int32_t> vertex_face_begin_, vertex_faces_, neighbour_begin_, neighbours_;
  std::vector<double> vertex_angle_;
  std::vector<char> on_border_;
  std::vector<Eigen::Vector3d> fan_normals_;  // one per sheet of faces around a vertex
  std::vector<std::int32_t> corner_fan_;      // per halfedge: 2 x fan of its tail + (1: the face is flipped against it)
  std::vector<std::int32_t> component_, component_sizes_;
  std::vector<std::int32_t> vertex_of_file_, file_vertex_;
  // A base face is a triangle before subdivision; face f descends from base face f / 4^k.
  std::vector<std::array<std::int32_t, 3>> base_file_vertices_;
  std::vector<std::int32_t> base_file_face_;
  std::vector<std::int32_t> base_begin_;  // base faces of polygon p: [base_begin_[p], base_begin_[p + 1])
  int subdivisions_ = 0;
  double diameter_ = 0;
  std::vector<std::pair<std::int32_t, std::int32_t>> non_manifold_edges_;
  std::vector<std::int32_t> flipped_halfedges_;
  std::vector<std::string> notes_;
  std::string source_;
};

}  // namespace leastcost
