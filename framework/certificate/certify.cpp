// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/framework/certificate/certify.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/cost/has_interfaces.hpp>
#include <leastcost/framework/domain/fits_segments.hpp>
#include <leastcost/framework/energy/chain_model.hpp>
#include <leastcost/framework/energy/path_energy.hpp>
#include <leastcost/framework/problem/clearance.hpp>
#include "framework/base/point_text.hpp"
#include "framework/certificate/certify_polyhedral_chain.hpp"
#include "framework/certificate/certify_straightened.hpp"
#include "framework/certificate/geometry_error.hpp"
#include "framework/certificate/judge_spacing.hpp"
#include "framework/certificate/margin_bar.hpp"
#include "framework/certificate/shared_failures.hpp"
#include "framework/domain/in_parts.hpp"
#include "framework/energy/curve_value.hpp"
#include "framework/energy/spacing.hpp"
#include "framework/problem/place_rounding.hpp"

namespace leastcost {
namespace {

constexpr double kWidestBar = 0.1;         ///< relative error bar above which a path on a smooth domain says nothing
constexpr double kBetween = 1.25;          ///< room for the chords of the path between the points
constexpr double kSoftestRounding = 1e-6;  ///< of the softest eigenvalue: curvature from second differences

class Certifier {
 public:
  Certifier(const Problem& problem, double s0, const PostProcessed& path, const ToCurve& to_curve,
            const CertificateOptions& options, const Monitor& monitor)
      : problem_(problem),
        energy_(problem, s0, monitor.limit()),
        path_(path),
        to_curve_(to_curve),
        options_(options),
        monitor_(monitor) {}

  Certificate run() {
    c_.measured = true;
    c_.estimate.value = path_.curve.cost;
    bool interrupted = false;
    try {
      measure();
    } catch (const Interrupted&) {
      interrupted = true;
    }
    if (interrupted || monitor_.interrupted()) fail(Failure::interrupted, "the certificate was interrupted");
    if (voids_the_bar()) {
      c_.estimate = {};
      c_.estimate.value = path_.curve.cost;
    }
    return std::move(c_);
  }

 private:
  void measure() {
    if (!std::isfinite(path_.curve.cost) || !path_.curve_costs.allFinite())
      return fail(Failure::infinite_cost,
                  "the delivered path has infinite cost: the cost is not defined along all of it");
    measure_residual();
    measure_clearance();
    measure_segments();
    measure_asymmetry();
    if (path_.curve.straightness) {
      certify_straightened(problem_, path_, options_, c_);
    } else if (problem_.manifold->shape() == Shape::polyhedral) {
      measure_regularization();
      certify_polyhedral_chain(problem_, energy_, path_, to_curve_, monitor_, c_);
      add_regularization();
    } else {
      certify_chain();
    }
  }

  void fail(Failure kind, std::string message) { c_.failures.push_back({kind, std::move(message)}); }

  /// Whether a failure says that the levels and the delivered path are not of one kind, so that nothing is known about
  /// the cost but what the delivered path itself costs; or that nothing but differences of levels that do not fall
  /// speaks for the bar.
  bool voids_the_bar() const {
    if (differences_alone_) return true;
    return std::any_of(c_.failures.begin(), c_.failures.end(),
                       [](const CertificateFailure& failure) { return consequences(failure.kind).voids_bar; });
  }

  double extent() const {
    const Points& u = path_.chain.u;
    return extent_of(u);
  }

  /// Worst distance off the domain of a point of the chain, and on a polyhedron of the middle of a piece of the curve.
  void measure_residual() {
    double worst = residual(*problem_.manifold, path_.chain, monitor_.limit());
    if (problem_.manifold->shape() == Shape::polyhedral) {
      const Points& x = path_.curve.x;
      const Index m = x.cols() - 1;
      CoordinatePath middles{(x.leftCols(m) + x.rightCols(m)) / 2, path_.curve.segment_sites, true};
      worst = std::max(worst, residual(*problem_.manifold, middles, monitor_.limit()));
    }
    if (worst > options_.residual * extent())  // beyond the last digits of coordinates that are large
      worst = std::max(0.0, worst - contact_tolerance(path_.chain.u, 0));
    c_.residual = worst / extent();
    if (*c_.residual <= options_.residual) return;
    const TwoNumbers texts = told_apart(*c_.residual, options_.residual);
    fail(Failure::residual, "the largest distance of the path from the domain is " + texts.first +
                                " diameters, more than the allowed " + texts.second);
  }

  /// Of the curve that is delivered, segment by segment: no number of points sees a thin obstacle between two of them.
  void measure_clearance() {
    c_.clearance = leastcost::measure_clearance(*problem_.manifold, path_.curve.x, path_.chain.ring, monitor_.limit());
    if (!c_.clearance || c_.clearance->lower >= -contact_tolerance(path_.chain.u, options_.clearance)) return;
    const bool inside = c_.clearance->upper < 0;
    fail(Failure::touches, "the path comes " +
                               short_number(std::abs(inside ? c_.clearance->upper : c_.clearance->lower)) +
                               (inside ? "" : " (possibly)") + " too close to " + c_.clearance->obstacle +
                               " between points " + std::to_string(c_.clearance->segment) + " and " +
                               std::to_string(c_.clearance->segment + 1) + ", at " + point_text(c_.clearance->place));
  }

  void measure_segments() {
    c_.spacing = spread(path_.curve.straightness ? path_.curve_costs : energy_.costs(path_.chain));
    c_.longest_segment = path_.curve_costs.maxCoeff() / path_.curve_costs.mean();
    if (!(path_.curve.cost > 0))
      fail(Failure::costs_nothing, "the delivered path has cost 0");
    else if (!(c_.longest_segment <= options_.longest_segment))
      fail(Failure::longest_segment,
           "the longest segment costs " + short_number(c_.longest_segment) +
               " times the mean: the path jumps over part of the domain (a sinkhole, VFCS Fig. 2)");
  }

  void measure_asymmetry() {
    if (problem_.cost->traits().symmetric) return;
    CoordinatePath back = path_.chain;
    back.u = path_.chain.u.rowwise().reverse();
    std::reverse(back.sites.begin(), back.sites.end());
    c_.asymmetry = energy_.cost(back) / energy_.cost(path_.chain) - 1;
  }

  void certify_chain() {
    c_.global = path_.curve.global;
    c_.scope = c_.global && c_.global->proved ? c_.global->scope : Scope::local;
    if (find_ability<HasInterfaces>(*problem_.cost) != nullptr)
      fail(Failure::interfaces,
           "the cost jumps at interfaces, which a chain of points cannot resolve: use a post-processor for interfaces "
           "(refract, refract_cells)");
    measure_regularization();
    measure_stationarity();
    c_.index = path_index(energy_, path_.chain, options_.index_shift);
    measure_chart_jumps();
    // Where a bound holds the path no order is asked for, and half as many points may find no way between obstacles.
    const bool is_solved = *c_.stationarity <= options_.stationarity;
    const Refinement refinement =
        refine_levels(problem_, path_.chain, monitor_, {.by_order = !hugs_bound_, .is_solved = is_solved});
    c_.levels = refinement.levels;
    if (monitor_.interrupted()) return;  // run() says so; half a refinement says nothing
    if (!refinement.trouble.empty())
      fail(refinement.collapsed ? Failure::collapsed : Failure::refinement, refinement.trouble);
    measure_fine_index(refinement);
    judge_index();
    const std::optional<double> between = cost_between_points();
    judge_spacing(problem_, energy_, path_.chain, options_beyond_rounding(), hugs_bound_, c_);
    measure_doubling();
    EstimatedCost estimated = estimate_cost(problem_, energy_, path_.chain, refinement, c_.index, hugs_bound_);
    c_.estimate = estimated.estimate;
    for (CertificateFailure& failure : estimated.failures) c_.failures.push_back(std::move(failure));
    add_margin_bar(refinement);
    if (between) c_.estimate.error = std::max(c_.estimate.error, kBetween * std::abs(*between - c_.estimate.value));
    measure_resolution(refinement);
    add_regularization();
    if (!(c_.estimate.error <= kWidestBar * c_.estimate.value))
      fail(Failure::error_bar, "the error bar is " + short_number(c_.estimate.error / c_.estimate.value) +
                                   " of the cost, which is too large: use more points");
    compare_with_bound();
    measure_domain();
    measure_places();
  }

  /// A cost below what is proved of all paths would be a fault of one of the two.
  void compare_with_bound() {
    if (!c_.global || c_.global->category == BoundCategory::sampled) return;
    if (c_.estimate.value + c_.estimate.error >= c_.global->lower_bound) return;
    const TwoNumbers texts = told_apart(c_.estimate.value, c_.global->lower_bound);
    fail(Failure::below_bound,
         "the cost " + texts.first + " is below the proved lower bound " + texts.second + ": use more points");
  }

  void add_margin_bar(const Refinement& refinement) {
    const double bar = margin_bar(problem_, refinement, monitor_.limit());
    if (bar > c_.estimate.error && c_.estimate.method == ValueMethod::exact)
      c_.estimate.method = ValueMethod::differences;
    c_.estimate.error += bar;
  }

  void measure_regularization() {
    const auto* cost = find_ability<Regularized>(*problem_.cost);
    if (cost != nullptr) c_.regularization = cost->regularization(energy_.ambient(path_.chain));
    if (has_free_ways() && c_.scope == Scope::local) c_.scope = Scope::local_value;
  }

  /// Under the cost that is meant: nothing is said about the path but that it is one of them.
  bool has_free_ways() const { return c_.regularization && c_.regularization->free_share > 0; }

  /// What was minimised stands for another cost: the value and its bounds are those of that one.
  void add_regularization() {
    if (!c_.regularization) return;
    CostEstimate& e = c_.estimate;
    e.error += std::max(c_.regularization->below, c_.regularization->above);
    if (e.lower) *e.lower -= c_.regularization->below;
    if (e.upper) *e.upper += c_.regularization->above;
  }

  /// Only of a path that has no other failure: a proof about another one would say nothing. What is proved needs no
  /// extrapolation.
  void measure_resolution(const Refinement& refinement) {
    const auto extrapolates = [&](const CertificateFailure& failure) {
      return failure.kind == Failure::not_asymptotic;
    };
    const bool others = !std::all_of(c_.failures.begin(), c_.failures.end(), extrapolates);
    differences_alone_ = others && std::any_of(c_.failures.begin(), c_.failures.end(), extrapolates);
    if (hugs_bound_ || others) return;
    const bool needed = !c_.failures.empty();
    const bool asked = options_.proof == ProofRule::always || (options_.proof == ProofRule::needed && needed);
    const ProofEffort effort = !asked ? ProofEffort::none : needed ? ProofEffort::insist : ProofEffort::normal;
    ExaminedResolution examined = examine_resolution(problem_, path_.chain, refinement, effort, c_.estimate, monitor_);
    c_.resolution = examined.resolution;
    if (examined.resolution.minimum_proved) c_.failures.clear();
    for (CertificateFailure& failure : examined.failures) c_.failures.push_back(std::move(failure));
  }

  /// Where the domain itself says that it is not resolved.
  void measure_places() {
    const std::string why = why_unresolved(problem_, path_.chain, monitor_);
    if (why.empty()) return;
    fail(Failure::unresolved, why);
    c_.resolution.emplace().verdict = ResolutionVerdict::unresolved;
  }

  void measure_domain() {
    const GeometryError error = measure_geometry_error(problem_, path_.chain, monitor_);
    c_.geometry_error = error.value;
    if (!error.trouble.empty() && !monitor_.interrupted())
      fail(Failure::geometry_error,
           "the cost error from the representation of the domain is unknown: " + error.trouble);
  }

  void measure_stationarity() {
    ChainModel model;
    if (!model.evaluate(energy_, path_.chain)) {
      c_.stationarity = std::numeric_limits<double>::infinity();
    } else {
      model.solve(energy_, path_.chain, HessianKind::exact);
      c_.stationarity = model.cost_error;
      hugs_bound_ = held_by_bound(model.frames);
    }
    check_stationarity(c_, options_beyond_rounding().stationarity);
  }

  /// Nothing is asked of points that lie closer together than their places can tell.
  CertificateOptions options_beyond_rounding() const {
    constexpr double kRoom = 16;
    const double rounding = place_rounding(problem_, path_.chain);
    CertificateOptions options = options_;
    options.spacing = std::max(options.spacing, kRoom * rounding);
    options.stationarity = std::max(options.stationarity, kRoom * rounding * rounding);
    return options;
  }

  /// Whether a bound holds a point. The first point of a ring is pinned besides.
  bool held_by_bound(const Frames& frames) const {
    const int pinned = path_.chain.ring ? 1 : 0;
    const auto beyond_first = frames.blocked.begin() + pinned;
    return frames.blocked.front() > pinned ||
           std::any_of(beyond_first, frames.blocked.end(), [](int blocked) { return blocked > 0; });
  }

  /// With few points a path past its conjugate point may still look like a minimum: the finest chain has the last word.
  void measure_fine_index(const Refinement& refinement) {
    const bool soft = c_.index.verdict == IndexVerdict::degenerate;
    if ((c_.index.verdict != IndexVerdict::minimum && !soft) || refinement.paths.size() < 3) return;
    const PathIndex index = index_of_level(refinement, 2);
    if (index.verdict == IndexVerdict::not_applicable) return;
    c_.index = index;
    if (index.verdict == IndexVerdict::degenerate) judge_softest(index_of_level(refinement, 1));
  }

  PathIndex index_of_level(const Refinement& refinement, std::size_t k) {
    const double s0 = refinement.levels[k].cost / refinement.levels[k].segments;
    if (!(s0 > 0) || !std::isfinite(s0)) return {};
    Problem fitted = problem_;
    fitted.manifold = refinement.domains[k];
    PathEnergy energy(fitted, s0, monitor_.limit());
    return path_index(energy, refinement.paths[k], options_.index_shift);
  }

  /// A shallow minimum: the softest direction is stiffer than what it changes between two levels, and than rounding.
  void judge_softest(const PathIndex& coarse) {
    if (!c_.index.softest || !coarse.softest || c_.index.nullity != coarse.nullity) return;
    const double uncertain = kSoftestRounding + std::abs(*c_.index.softest - *coarse.softest);
    if (*c_.index.softest > uncertain) c_.index.verdict = IndexVerdict::minimum;
  }

  void measure_chart_jumps() {
    if (find_ability<HasChart>(*problem_.manifold) == nullptr) return;
    const ChartJump jump = worst_chart_jump(problem_, path_.chain, energy_.costs(path_.chain), monitor_.limit());
    if (jump.ratio > kChartJump)
      fail(Failure::longest_segment, "between points " + std::to_string(jump.segment) + " and " +
                                         std::to_string(jump.segment + 1) + " the straight move in the chart costs " +
                                         short_number(jump.ratio) +
                                         " times the chord: the path jumps over part of the domain; use more points");
  }

  /// On a curved domain with bounds that is not a chart: where the path between its points comes to rest on a bound
  /// that the points do not see, the cost of the path with eight times as many points, projected onto the domain.
  std::optional<double> cost_between_points() {
    constexpr Index kPieces = 8;
    const ConstraintManifold& manifold = *problem_.manifold;
    const auto* bounds = find_ability<HasBounds>(manifold);
    if (bounds == nullptr || manifold.shape() != Shape::smooth || find_ability<HasChart>(manifold) != nullptr ||
        find_ability<FitsSegments>(manifold) != nullptr)  // what lies between its points is not a matter of projection
      return std::nullopt;
    const CoordinatePath& chain = path_.chain;
    const Index segments = chain.segment_count();
    CoordinatePath dense{Points(chain.u.rows(), kPieces * segments + (chain.ring ? 0 : 1)), {}, chain.ring};
    for (Index i = 0; i < dense.u.cols(); ++i) {
      const double t = static_cast<double>(i % kPieces) / kPieces;
      dense.u.col(i) = (1 - t) * chain.column(i / kPieces);
      if (t > 0) dense.u.col(i) += t * chain.column(i / kPieces + 1);
    }
    if (!project(manifold, dense, monitor_.limit()).failed.empty()) return std::nullopt;
    Points normals(chain.u.rows(), chain.u.rows());
    bool rests = false;
    for (Index i = 1; i + 1 < dense.u.cols() && !rests; ++i) rests = bounds->active_bounds(dense, i, normals) > 0;
    if (!rests) return std::nullopt;
    hugs_bound_ = true;
    return energy_.cost(dense);
  }

  void judge_index() {
    switch (c_.index.verdict) {
      case IndexVerdict::minimum: return;
      case IndexVerdict::saddle:
        return fail(Failure::saddle,
                    "the path is a saddle of order " + std::to_string(c_.index.saddle_order) +
                        ": a neighbouring path costs less; to search for it, set `path: {escape_saddle: true}`");
      case IndexVerdict::degenerate:
        // Where ways are free they cost nearly the same, and the path is the least of them nevertheless.
        if (has_free_ways() && c_.index.negatives == 0) return;
        return fail(Failure::degenerate, "the path is degenerate with nullity " + std::to_string(c_.index.nullity) +
                                             ": neighbouring paths cost the same to second order");
      case IndexVerdict::undecidable:
        return fail(Failure::undecidable,
                    "rounding hides whether the path is a minimum or a saddle: the metric is too ill-conditioned");
      case IndexVerdict::not_applicable:
        if (problem_.kernel->strictly_convex())
          return fail(Failure::index_not_applicable, "the path has no index: its energy is not finite");
        return fail(Failure::index_not_applicable,
                    "the kernel is not strictly convex (H = s): points can slide along the path, so there is no index "
                    "and no spacing");
    }
  }

  void measure_doubling() {
    if (c_.levels.size() < 3 || problem_.kernel->kind() != KernelKind::quadratic_at_zero) return;
    const RefinementLevel &a = c_.levels[1], &b = c_.levels[2];
    const double s0 = a.cost / a.segments;
    if (!std::isfinite(a.energy) || !std::isfinite(b.energy) || !(b.energy > 0))
      return fail(Failure::doubling,
                  "the ratio E(2M) / E(4M) is undefined: the energies of the refined chains are zero or not finite");
    c_.doubling = a.energy / b.energy;
    c_.doubling_expected = kernel_value(*problem_.kernel, a.cost / (a.segments * s0)) /
                           (2 * kernel_value(*problem_.kernel, b.cost / (b.segments * s0)));
    if (std::abs(*c_.doubling / *c_.doubling_expected - 1) <= options_.doubling) return;
    const TwoNumbers texts = told_apart(*c_.doubling, *c_.doubling_expected);
    fail(Failure::doubling, "E(2M) / E(4M) is " + texts.first + ", but an evenly spaced path has " + texts.second +
                                ": the path jumps over part of the domain (VFCS Eq. 8)");
  }

  const Problem& problem_;
  PathEnergy energy_;
  const PostProcessed& path_;
  const ToCurve& to_curve_;
  const CertificateOptions& options_;
  const Monitor& monitor_;
  bool hugs_bound_ = false;         ///< a point rests on a bound: the segment that leaves it cannot follow the path
  bool differences_alone_ = false;  ///< levels without an order, and another failure, so that no other chain was asked
  Certificate c_;
};

}  // namespace

Certificate certify(const Problem& problem, double reference_cost, const PostProcessed& path, const ToCurve& to_curve,
                    const CertificateOptions& options, const Monitor& monitor) {
  return Certifier(problem, reference_cost, path, to_curve, options, monitor).run();
}

}  // namespace leastcost
