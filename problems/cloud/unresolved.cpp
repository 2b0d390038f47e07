// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/cloud/unresolved.hpp"

#include "framework/point_text.hpp"

namespace leastcost {

std::string why_unresolved_at(const CloudSurface& surface, const Eigen::Vector3d& x) {
  const auto sheet = surface.other_sheet(x);
  if (!sheet) return "";
  return "at " + point_text(x) + " the samples within one support lie on two sheets, " + short_number(sheet->apart) +
         " spacings apart: the surface runs between them, or is drawn from one to the other; more samples, a "
         "smaller radius or normals that point to opposite sides keep them apart";
}

}  // namespace leastcost
