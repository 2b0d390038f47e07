// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <leastcost/problems/robots/covering.hpp>
#include "urdf/urdf_model.hpp"

namespace leastcost {

/// Where meshes are looked for: beside the URDF, as a path and below the folder of packages; then by their names alone
/// in the folders below that of the URDF.
class MeshFinder {
 public:
  MeshFinder(std::filesystem::path beside, std::filesystem::path packages)
      : beside_(std::move(beside)), packages_(std::move(packages)) {}

  /// Throws InputError(place: ...) that says where was looked.
  std::filesystem::path find(const std::string& name, const std::string& place) const;

 private:
  const std::map<std::string, std::vector<std::filesystem::path>>& below() const;

  std::filesystem::path beside_, packages_;
  mutable std::map<std::string, std::vector<std::filesystem::path>> below_;  ///< files by their names; made once
  mutable bool looked_ = false;
};

/// Capsules of a collision shape in the frame of its link, and how far they reach out of it.
Covering cover(const UrdfCollision& collision, const MeshFinder& meshes);

}  // namespace leastcost
