// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/raster/raster_function.hpp"

namespace leastcost {

BilinearFunction::BilinearFunction(const RasterGrid& raster)
    : RasterFunction(RasterPatches(raster, 0, 2)), columns_(raster.columns), values_(raster.values) {}

std::array<double, 4> BilinearFunction::values_at(const RasterPatch& patch) const {
  const double* low = &values_[static_cast<std::size_t>(patch.row) * static_cast<std::size_t>(columns_) +
                               static_cast<std::size_t>(patch.column)];
  const double* high = low + columns_;
  return {low[0], low[1], high[0], high[1]};
}

PlaneJet BilinearFunction::in_patch(const RasterPatch& patch, double column, double row) const {
  const std::array<double, 4> z = values_at(patch);
  const double u = column - patch.column, v = row - patch.row;
  const double east = z[1] - z[0], north = z[2] - z[0], twist = z[3] - z[2] - z[1] + z[0];
  const Eigen::Vector2d& cell = patches().cell();
  PlaneJet jet;
  jet.value = (1 - v) * ((1 - u) * z[0] + u * z[1]) + v * ((1 - u) * z[2] + u * z[3]);
  jet.gradient << (east + twist * v) / cell[0], (north + twist * u) / cell[1];
  jet.hessian(0, 1) = jet.hessian(1, 0) = twist / (cell[0] * cell[1]);
  return jet;
}

PatchBounds BilinearFunction::bounds(const RasterPatch& patch) const {
  const std::array<double, 4> z = values_at(patch);
  const auto slope = [&](std::size_t from, std::size_t to, int axis) {
    return (Interval(z[to]) - Interval(z[from])) / Interval(patches().cell()[axis]);
  };
  return {hull(hull(z[0], z[1]), hull(z[2], z[3])), hull(slope(0, 1, 0), slope(2, 3, 0)),
          hull(slope(0, 2, 1), slope(1, 3, 1))};
}

PatchBounds BilinearFunction::enclose(const RasterPatch& patch, const Interval& column, const Interval& row) const {
  const std::array<double, 4> z = values_at(patch);
  const Interval u = column - Interval(patch.column), v = row - Interval(patch.row), base(z[0]);
  const Interval east = Interval(z[1]) - base, north = Interval(z[2]) - base,
                 twist = Interval(z[3]) - Interval(z[2]) - east, hx(patches().cell()[0]), hy(patches().cell()[1]);
  return {base + east * u + (north + twist * u) * v, (east + twist * v) / hx, (north + twist * u) / hy};
}

PlaneBends BilinearFunction::bends(const RasterPatch& patch, const Interval&, const Interval&) const {
  return bends(patch, patch);
}

PlaneBends BilinearFunction::bends(const RasterPatch& first, const RasterPatch& last) const {
  const Interval area = Interval(patches().cell()[0]) * Interval(patches().cell()[1]);
  PlaneBends out;
  for (RasterPatch at = first; at.row <= last.row; ++at.row)
    for (at.column = first.column; at.column <= last.column; ++at.column) {
      const std::array<double, 4> z = values_at(at);
      const Interval here = ((Interval(z[3]) - Interval(z[2])) - (Interval(z[1]) - Interval(z[0]))) / area;
      out.xy = at.row == first.row && at.column == first.column ? here : hull(out.xy, here);
    }
  return out;
}

/// Simpson's rule: along a line the function is a quadratic polynomial.
PatchQuadrature BilinearFunction::quadrature() const {
  static constexpr std::array<double, 3> kNodes = {0, 0.5, 1}, kWeights = {1.0 / 6, 4.0 / 6, 1.0 / 6};
  return {kNodes, kWeights};
}

}  // namespace leastcost
