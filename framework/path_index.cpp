// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "framework/path_index.hpp"

#include "framework/chain_model.hpp"

namespace leastcost {

std::string_view name(IndexVerdict verdict) {
  switch (verdict) {
    case IndexVerdict::not_applicable: return "not_applicable";
    case IndexVerdict::minimum: return "minimum";
    case IndexVerdict::saddle: return "saddle";
    case IndexVerdict::degenerate: return "degenerate";
  }
  return "unknown";
}

PathIndex path_index(PathEnergy& energy, const CoordinatePath& path, double shift) {
  PathIndex index;
  ChainModel model;
  if (!energy.has_exact_hessian() || !model.evaluate(energy, path)) return index;
  ChainSystem exact, gauss_newton;
  energy.chain_hessian(path, model.gradient, model.frames, HessianKind::exact, exact);
  energy.chain_hessian(path, model.gradient, model.frames, HessianKind::gauss_newton, gauss_newton);
  ChainSystem up = exact, down = exact;
  up.add(shift, gauss_newton);
  down.add(-shift, gauss_newton);
  index.negatives = exact.negative_eigenvalues();
  index.saddle_order = up.negative_eigenvalues();
  index.nullity = down.negative_eigenvalues() - index.saddle_order;
  index.verdict = index.saddle_order > 0 ? IndexVerdict::saddle
                  : index.nullity > 0    ? IndexVerdict::degenerate
                                         : IndexVerdict::minimum;
  return index;
}

}  // namespace leastcost
