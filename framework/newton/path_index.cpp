// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/framework/newton/path_index.hpp>

#include <cmath>
#include <limits>

#include <leastcost/framework/cost/has_constant_metric.hpp>

namespace leastcost {
namespace {

/// Rounding of a chain Hessian, as a part of the size of its blocks.
constexpr double kHessianRounding = 16 * std::numeric_limits<double>::epsilon();

/// Adds `factor` times the size of each diagonal block to its diagonal: what rounding may have taken from it.
void add_rounding(double factor, const Eigen::VectorXd& sizes, ChainSystem& system) {
  for (Index i = 0; i < system.count(); ++i) system.diagonal(i).diagonal().array() += factor * sizes[i];
}

Eigen::VectorXd block_sizes(const ChainSystem& system) {
  Eigen::VectorXd sizes(system.count());
  for (Index i = 0; i < system.count(); ++i) sizes[i] = system.diagonal(i).cwiseAbs().maxCoeff();
  return sizes;
}

/// The least eigenvalue lambda of H x = lambda P x between -tau and tau, by counting. `h` is H - tau P.
double softest(const ChainSystem& p, double tau, ChainSystem& h, const Deadline& deadline) {
  double shifted = -tau;  // h = H + shifted P
  const auto all_above = [&](double lambda) {
    h.add(-lambda - shifted, p);
    shifted = -lambda;
    return h.negative_eigenvalues(deadline) == 0;
  };
  // By decades from 0, on the side on which it lies, then within one.
  const double sign = all_above(0) ? 1 : -1;
  double low = 0, high = tau;  // of the modulus
  for (double modulus = tau / 10; modulus > 1e-12 * tau; modulus /= 10) {
    if (all_above(sign * modulus) == (sign > 0)) {
      low = modulus;
      break;
    }
    high = modulus;
  }
  while (high > 1.1 * low && low > 0) {
    const double middle = std::sqrt(low * high);
    (all_above(sign * middle) == (sign > 0) ? low : high) = middle;
  }
  return sign * low;
}

}  // namespace

Words<IndexVerdict> words(IndexVerdict) {
  using enum IndexVerdict;
  static constexpr Word<IndexVerdict> kWords[] = {{not_applicable, "not_applicable"},
                                                  {minimum, "minimum"},
                                                  {saddle, "saddle"},
                                                  {degenerate, "degenerate"},
                                                  {undecidable, "undecidable"}};
  return kWords;
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

bool is_convex(const Problem& problem) {
  const bool flat = problem.manifold->shape() == Shape::flat && find_ability<HasChart>(*problem.manifold) == nullptr;
  return flat && !problem.ring && find_ability<HasConstantMetric>(*problem.cost) != nullptr;
}

PathIndex path_index(PathEnergy& energy, const CoordinatePath& path, double shift) {
  PathIndex index;
  if (energy.has_exact_hessian() && is_convex(energy.problem())) {
    if (std::isfinite(energy.value(path))) index.verdict = IndexVerdict::minimum;
    return index;
  }
  std::optional<ChainHessians> h = chain_hessians(energy, path);
  if (!h) return index;
  const Deadline& deadline = energy.deadline();
  const Eigen::VectorXd sizes = block_sizes(h->gauss_newton);
  index.negatives = h->exact.negative_eigenvalues(deadline);
  h->exact.add(shift, h->gauss_newton);  // in place: copies of a long chain are dear, and nobody looks at the clock
  index.saddle_order = h->exact.negative_eigenvalues(deadline);
  if (index.saddle_order > 0) {
    add_rounding(kHessianRounding, sizes, h->exact);
    const bool decided = h->exact.negative_eigenvalues(deadline) > 0;
    add_rounding(-kHessianRounding, sizes, h->exact);
    index.verdict = decided ? IndexVerdict::saddle : IndexVerdict::undecidable;
  }
  h->exact.add(-2 * shift, h->gauss_newton);
  index.nullity = h->exact.negative_eigenvalues(deadline) - index.saddle_order;
  if (index.saddle_order > 0) return index;
  index.verdict = index.nullity > 0 ? IndexVerdict::degenerate : IndexVerdict::minimum;
  if (index.nullity > 0) index.softest = softest(h->gauss_newton, shift, h->exact, deadline);
  return index;
}

}  // namespace leastcost
