// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "urdf/link_shapes.hpp"

#include <algorithm>
#include <cstddef>
#include <system_error>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/problems/readers/mesh_reader.hpp>

namespace leastcost {
namespace {

using Eigen::Vector3d;
namespace fs = std::filesystem;

/// A name without what says that it is a file or in a package.
struct MeshName {
  std::string path;
  bool of_package = false;
};

MeshName parsed(const std::string& name) {
  for (const auto& [scheme, of_package] : {std::pair{"package://", true}, {"model://", true}, {"file://", false}})
    if (name.rfind(scheme, 0) == 0) return {name.substr(std::string(scheme).size()), of_package};
  return {name, false};
}

bool is_file(const fs::path& path) {
  std::error_code unknown;
  return fs::is_regular_file(path, unknown);
}

Covering cover(const urdf_shape::Sphere& sphere, const std::string&, const MeshFinder&) {
  return {{{0, Vector3d::Zero(), Vector3d::Zero(), sphere.radius}}, 0};
}

Covering cover(const urdf_shape::Cylinder& cylinder, const std::string&, const MeshFinder&) {
  if (!cylinder.round_ends) return cover_cylinder(cylinder.length, cylinder.radius);
  const Vector3d end(0, 0, cylinder.length / 2);
  return {{{0, -end, end, cylinder.radius}}, 0};
}

Covering cover(const urdf_shape::Box& box, const std::string&, const MeshFinder&) { return cover_box(box.size); }

Covering cover(const urdf_shape::Mesh& mesh, const std::string& place, const MeshFinder& meshes) {
  const fs::path file = meshes.find(mesh.name, place);
  std::vector<Vector3d> corners = read_mesh(file).positions;
  if (corners.empty()) throw InputError(place + ": the mesh " + file.string() + " has no vertices");
  for (Vector3d& corner : corners) corner = corner.cwiseProduct(mesh.scale).eval();
  return cover_points(corners);
}

}  // namespace

const std::map<std::string, std::vector<fs::path>>& MeshFinder::below() const {
  constexpr int kDeepest = 8;
  constexpr std::size_t kMost = 100000;  // of files: a URDF in the root of a disk should not walk all of it
  if (std::exchange(looked_, true)) return below_;
  std::error_code unknown;
  std::size_t seen = 0;
  const fs::path top = beside_.empty() ? fs::path(".") : beside_;
  for (auto at = fs::recursive_directory_iterator(top, fs::directory_options::skip_permission_denied, unknown);
       !unknown && at != fs::recursive_directory_iterator() && seen < kMost; at.increment(unknown), ++seen) {
    if (at.depth() >= kDeepest) at.disable_recursion_pending();
    if (at->is_regular_file(unknown)) below_[at->path().filename().string()].push_back(at->path());
  }
  return below_;
}

fs::path MeshFinder::find(const std::string& name, const std::string& place) const {
  const MeshName mesh = parsed(name);
  std::vector<fs::path> tried = {fs::path(mesh.path).is_absolute() ? fs::path(mesh.path) : beside_ / mesh.path};
  if (!packages_.empty()) {
    tried.push_back(packages_ / mesh.path);
    if (const auto slash = mesh.path.find('/'); mesh.of_package && slash != std::string::npos)
      tried.push_back(packages_ / mesh.path.substr(slash + 1));  // it is the folder of the package itself
  }
  for (const fs::path& path : tried)
    if (is_file(path)) return path;
  const std::string base = fs::path(mesh.path).filename().string();
  const auto found = below().find(base);
  if (found != below().end() && found->second.size() == 1) return found->second.front();
  std::string message = place + ": the mesh '" + name + "' was not found: looked for";
  for (const fs::path& path : tried) message += " " + path.string() + ",";
  const std::string folder = beside_.empty() ? "." : beside_.string();
  if (found != below().end())
    throw InputError(message + " and " + std::to_string(found->second.size()) + " files below " + folder +
                     " have this name: set 'packages' to the folder that the path begins in");
  throw InputError(message + " and for '" + base + "' below " + folder +
                   ": set 'packages' to the folder that the packages are in");
}

Covering cover(const UrdfCollision& collision, const MeshFinder& meshes) {
  Covering out = std::visit([&](const auto& shape) { return cover(shape, collision.place, meshes); }, collision.shape);
  for (Capsule& capsule : out.capsules) {
    capsule.from = collision.origin * capsule.from;
    capsule.to = collision.origin * capsule.to;
  }
  return out;
}

}  // namespace leastcost
