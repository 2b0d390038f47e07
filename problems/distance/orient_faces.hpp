// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <leastcost/problems/mesh/triangle_mesh.hpp>

namespace leastcost {

/// Which faces have to be turned so that neighbours agree. In every part that hangs together through edges with two
/// faces the smaller share is turned.
struct FaceOrientation {
  std::vector<char> turned;  ///< per face: 1 where it has to be turned
  std::int32_t turned_count = 0;
  std::optional<std::int32_t> one_sided;  ///< a face of a part that cannot be oriented, if there is one
};
FaceOrientation orient_faces(const TriangleMesh& mesh);

}  // namespace leastcost
