// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/distance/orient_faces.hpp"

#include <algorithm>

namespace leastcost {

FaceOrientation orient_faces(const TriangleMesh& mesh) {
  FaceOrientation result;
  constexpr char kUnseen = 2;
  std::vector<char>& turned = result.turned;
  turned.assign(static_cast<std::size_t>(mesh.face_count()), kUnseen);
  std::vector<std::int32_t> part;
  for (std::int32_t seed = 0; seed < mesh.face_count(); ++seed) {
    if (turned[static_cast<std::size_t>(seed)] != kUnseen) continue;
    turned[static_cast<std::size_t>(seed)] = 0;
    part.assign(1, seed);
    std::size_t turned_here = 0;
    for (std::size_t i = 0; i < part.size(); ++i) {
      const char mine = turned[static_cast<std::size_t>(part[i])];
      turned_here += mine != 0 ? 1 : 0;
      for (std::int32_t h = 3 * part[i]; h < 3 * part[i] + 3; ++h) {
        const std::int32_t other = mesh.across(h);
        if (other < 0) continue;
        const bool against = mesh.tail(h) == mesh.tail(other);
        const char wanted = against ? static_cast<char>(1 - mine) : mine;
        char& theirs = turned[static_cast<std::size_t>(other / 3)];
        if (theirs == kUnseen) {
          theirs = wanted;
          part.push_back(other / 3);
        } else if (theirs != wanted && !result.one_sided) {
          result.one_sided = other / 3;
        }
      }
    }
    if (2 * turned_here > part.size())
      for (const std::int32_t f : part)
        turned[static_cast<std::size_t>(f)] = static_cast<char>(1 - turned[static_cast<std::size_t>(f)]);
  }
  result.turned_count = static_cast<std::int32_t>(std::count(turned.begin(), turned.end(), 1));
  return result;
}

}  // namespace leastcost
