// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/framework/path_index.hpp>

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

std::optional<ChainHessians> chain_hessians(PathEnergy& energy, const CoordinatePath& path) {
  ChainHessians h;
  if (!energy.has_exact_hessian() || !h.model.evaluate(energy, path)) return std::nullopt;
  energy.chain_hessian(path, h.model.gradient, h.model.frames, HessianKind::exact, h.exact);
  energy.chain_hessian(path, h.model.gradient, h.model.frames, HessianKind::gauss_newton, h.gauss_newton);
  // A drift that costs nothing, around a cylinder say, has no share in either: rounding alone would decide about its
  // sign.
  if (path.ring) lift_drift(h.gauss_newton);
  return h;
}

PathIndex path_index(PathEnergy& energy, const CoordinatePath& path, double shift) {
  PathIndex index;
  std::optional<ChainHessians> h = chain_hessians(energy, path);
  if (!h) return index;
  const Deadline& deadline = energy.deadline();
  index.negatives = h->exact.negative_eigenvalues(deadline);
  h->exact.add(shift, h->gauss_newton);  // in place: copies of a long chain are dear, and nobody looks at the clock
  index.saddle_order = h->exact.negative_eigenvalues(deadline);
  h->exact.add(-2 * shift, h->gauss_newton);
  index.nullity = h->exact.negative_eigenvalues(deadline) - index.saddle_order;
  index.verdict = index.saddle_order > 0 ? IndexVerdict::saddle
                  : index.nullity > 0    ? IndexVerdict::degenerate
                                         : IndexVerdict::minimum;
  return index;
}

}  // namespace leastcost
