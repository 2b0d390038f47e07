// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <leastcost/framework/base/deadline.hpp>
#include <leastcost/framework/energy/chain_system.hpp>
#include <leastcost/framework/energy/frames.hpp>
#include <leastcost/framework/energy/solve_report.hpp>
#include <leastcost/framework/problem/problem.hpp>

namespace leastcost {

/// The energy E = sum_i H(c_i / s0) of a path, VFCS Eq. (9), with what a chain solver needs: gradient, tangent frames,
/// block-tridiagonal chain Hessian, retraction. Everything a solver may do to a path goes through here, so the counters
/// are the same for all solvers. What it computed for the last path is kept (see Evaluated) and not computed again;
/// the counters count what was asked for. Holds workspaces: one object per solve, one thread at a time; no allocation
/// after the first call.
class PathEnergy {
 public:
  /// `problem` must outlive it. reference_cost: s0 > 0, units of the cost; else InputError. After `deadline` every
  /// function that works through a whole path throws Interrupted, at the latest a few dozen points later.
  PathEnergy(const Problem& problem, double reference_cost, Deadline deadline = {});

  const Problem& problem() const { return *problem_; }    ///< what is minimised
  double reference_cost() const { return s0_; }           ///< cost of a segment that the kernel is scaled by
  const Counters& counters() const { return counters_; }  ///< evaluations so far
  const Deadline& deadline() const { return deadline_; }  ///< none: no limit
  /// Evaluations beyond it throw Interrupted.
  void set_deadline(Deadline deadline) { deadline_ = deadline; }

  /// E, or +infinity where the path leaves the domain of the cost.
  double value(const CoordinatePath& path);
  /// E and its gradient at the free points in coordinates, coordinate x n (not projected).
  double value_and_gradient(const CoordinatePath& path, Points& gradient);

  /// Frames at a path. With bounds, the gradient decides which of them hold (a bound is kept while its
  /// multiplier pushes against it).
  void frames(const CoordinatePath& path, const Points& gradient, Frames& frames);
  /// T'v per free point; blocked coordinates are 0. Length tangent * n.
  void to_tangent(const Frames& frames, const Points& vectors, Eigen::VectorXd& tangent) const;
  /// T t per free point, coordinate x n.
  void from_tangent(const Frames& frames, const Eigen::VectorXd& tangent, Points& vectors) const;

  /// Chain Hessian in the frames. `exact` includes the curvature of the domain; on a polyhedron, which has none that
  /// could be used, both kinds are the Gauss-Newton one. The gradient is that of value_and_gradient() at `path`.
  void chain_hessian(const CoordinatePath& path, const Points& gradient, const Frames& frames, HessianKind kind,
                     ChainSystem& system);
  /// Whether `exact` exists: the kernel is strictly convex and the domain is not a polyhedron.
  bool has_exact_hessian() const;

  /// False where it is not positive definite.
  bool factor(ChainSystem& system);
  /// Solves with a factored system.
  void solve(const ChainSystem& system, Eigen::VectorXd& x);
  /// R(from, step), see ConstraintManifold::retract. `to` may not alias `from`.
  void retract(const CoordinatePath& from, const Points& step, CoordinatePath& to);

  /// The residual form: r_i with |r_i|^2 = c_i^2, rows x N, and unless null the Jacobians over the coordinates of both
  /// ends of each segment, side by side: rows x (2 coordinate N), zero for the ends of an open path. Counts as an
  /// energy, or as a gradient.
  void residuals(const CoordinatePath& path, Points& r, Points* jacobians);

  /// The metric G of the cost at every column of a path, q(x, x + v) = v' G v + o(|v|^2), side by side: coordinate x
  /// (coordinate * columns). For methods that work with a metric instead of moves. Counts as an energy. Where q is not
  /// twice differentiable at a = b (a Finsler cost: `quadratic_at_rest` is false) it is the metric in the direction of
  /// the path, half the Hessian of F^2 in v, from moves of a ten-thousandth of a segment.
  void metrics(const CoordinatePath& path, Points& g);

  /// Work that a back end did by means of its own.
  void count(const Counters& work);

  /// sum_i c_i.
  double cost(const CoordinatePath& path);
  Eigen::VectorXd costs(const CoordinatePath& path);  ///< cost of every segment
  /// sum_i H'(s_i) s_i: an energy excess divided by it is a relative cost excess (docs/numerics.md Sec. 3.1).
  double scale(const CoordinatePath& path);

  /// The path as the cost sees it. Valid until it is asked for another path, or until `path` changes.
  AmbientPath ambient(const CoordinatePath& path);

 private:
  /// A path, and what the workspaces hold of it: a search asks for values, gradient, Hessian and scale of the same path
  /// one after the other.
  struct Evaluated {
    CoordinatePath path;
    bool ambient = false;    ///< embedded_, and of a ring ambient_ and ring_sites_
    bool jacobians = false;  ///< jacobians_
    bool costs = false;      ///< q_
    bool kernel = false;     ///< phi_
    bool gradient = false;   ///< ambient_gradient_, and `energy`
    double energy = 0;
  };

  /// That of this path, empty where it is another one than before.
  Evaluated& evaluated(const CoordinatePath& path);
  /// The kernel at q_i / s0^2 of every segment, into phi_.
  void apply_kernel(const CoordinatePath& path);
  /// q_i of every segment into q_.
  void squared_costs(const CoordinatePath& path);
  void lift(const CoordinatePath& path, Frames& frames);
  /// dx/du at all columns, side by side; of a chart.
  const Points& chart_jacobians(const CoordinatePath& path);
  void add_curvature(const CoordinatePath& path, const Points& gradient, const Frames& frames, ChainSystem& system);
  void add_chart_curvature(const CoordinatePath& path, const Frames& frames, ChainSystem& system);
  /// dE/dx into ambient_gradient_, the closing column of a ring added to its first; E.
  double ambient_gradient(const CoordinatePath& path);
  void block_directions(const Frames& frames, ChainSystem& system) const;

  const Problem* problem_;
  const HasChart* chart_;
  double s0_;
  Deadline deadline_;
  Dimensions dims_;
  Counters counters_;
  Evaluated evaluated_;
  bool wants_slopes_ = false;  ///< of a chart: somebody has asked for a gradient, and will again
  Points ambient_, ambient_gradient_, part_gradient_, step_, embedded_, jacobians_;
  std::vector<Site> ring_sites_;
  std::vector<double> q_, scaled_;
  std::vector<Jet2> phi_;
  ChainBlocks blocks_;
  CoordinatePath plus_, minus_;
};

}  // namespace leastcost
