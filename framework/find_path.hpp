// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <leastcost/framework/certificate.hpp>
#include <leastcost/framework/initializer.hpp>
#include <leastcost/framework/monitor.hpp>
#include <leastcost/framework/post_processor.hpp>
#include <leastcost/framework/problem.hpp>
#include <leastcost/framework/solver.hpp>

namespace leastcost {

/// Complete as it is: {} solves 64 points and certifies them, or goes on with more of them where that is what the
/// certificate lacks (`certificate.refine`; a path that stays refused costs up to `certificate.refine_work` times the
/// first search; 0 where there is no time for them).
struct FindOptions {
  /// Free points n >= 1; nothing: max(8, interior vertices of the first edge path), VFCS 5.1. Doubled, which a note
  /// says, as long as the moves between them cannot go between the obstacles of the domain.
  std::optional<int> points = 64;
  /// s0 > 0, units of the cost; nothing: the mean segment cost of the first path.
  std::optional<double> reference_cost = {};
  bool cascade = false;  ///< solve coarse first, then double: see framework/cascade.hpp
  /// Keeps the coordinates of the target where they are a name only (the longitude of a sphere), and with them a turn
  /// round the axis. Else the target is called by the name nearest to the source, or to the last waypoint.
  bool target_as_given = false;
  bool escape_saddle = false;  ///< leave saddles to the lower side: see framework/escape_saddle.hpp
  CertificateOptions certificate = {};
  std::vector<std::shared_ptr<const PostProcessor>> post_processors = {};  ///< in the order of their application
};

enum class Status { certified, uncertified, collapsed, interrupted };
std::string_view name(Status status);

struct StageSeconds {
  double initialize = 0;
  double solve = 0;
  double post_process = 0;
  double prepare = 0;  ///< the coarser versions of the domain, by the search that asks for them first; see prepare()
  double certify = 0;  ///< without them
};

/// NaN is what was not measured. An interrupted result has the best feasible path so far, or none yet (`path` is empty,
/// a note says so); what there was no time for is missing, see complete_interrupted().
struct Result {
  Status status = Status::uncertified;
  FirstPath first;         ///< as the initializer made it
  CoordinatePath initial;  ///< its samples, equally spaced in cost: what the solver started from
  double initial_cost = std::numeric_limits<double>::quiet_NaN();
  double reference_cost = std::numeric_limits<double>::quiet_NaN();  ///< s0
  CoordinatePath path;                                               ///< the delivered points, equally spaced in cost
  Eigen::VectorXd costs;                                             ///< cost of each move between them
  Curve curve;                                                       ///< the path as a curve on the domain
  bool post_processed = false;  ///< whether `curve` is what the post-processors made; only an interrupted one is not
  Eigen::VectorXd curve_costs;  ///< cost of that curve between the delivered points
  SolveReport solve;
  Certificate certificate;
  StageSeconds seconds;
  std::vector<std::string> notes;
};

/// The library's front door; the command line and an embedder call this same function. Never prints, never exits;
/// may run from several threads at once (one Monitor each), and leaves signals, locale and streams alone. Throws
/// InputError for a problem or options whose parts do not fit, InitializationError when there is no first path. What a
/// user's own part throws ends a solve (Termination::exception, the best path is kept) or a certificate (failure
/// `exception`); thrown by a first path, a post-processor or the monitor it passes through as it is.
///
/// **More points.** A path that was refused for want of points, and for no other reason, is solved again with twice as
/// many, from the chain that was found (from the first path, with four times as many, where that was not solved or is a
/// saddle), `options.certificate.refine` times at most, within `refine_work`, and as long as the cost comes closer.
/// Certified, the points that were asked for are delivered: every 2^k-th
/// of the finer chain, with its curve and its certificate, and a note (all of them where moves between fewer
/// might touch an obstacle). Else the path stays as it came, uncertified, with a note; so it does where the deadline or
/// a stop request comes in between. Not under a solver that moves no points.
///
/// **Time.** After the monitor's deadline it comes back within max(1 ms, a tenth of the budget) of thread time, with
/// NLopt and Ceres within 5 ms, plus one call of a user's function (chains of up to 10,000 points; beyond, in
/// proportion to their memory): the work in hand is abandoned, nothing new is begun, and the status is `interrupted`. A
/// domain builds in its constructor what it needs; what is made only when it is asked for is made by prepare(), which
/// the certificate of a sampled domain calls unless you did.
Result find_path(const Problem& problem, const Initializer& initializer, const Solver& solver,
                 const FindOptions& options = {}, const Monitor& monitor = {});

/// Warm start: as find_path() from the points of a chain as they are, neither sampled again nor evened out, between the
/// ends of the problem (they may have moved since the chain was made). `options.points` is not used. A chain of a
/// result is improved at once to itself, to the last digits where `options.reference_cost` is that of the result.
/// `chain`: coordinate x (n + 2), a ring coordinate x n; sites for every column, or none (they are then found). A point
/// off the domain is projected. Throws InputError when sizes or numbers do not fit or a point has no nearest one on the
/// domain, InitializationError when the chain costs infinitely much, or nothing.
Result improve_path(const Problem& problem, const CoordinatePath& chain, const Solver& solver,
                    const FindOptions& options = {}, const Monitor& monitor = {});

/// What an interrupted result lacks for want of time: its costs and its curve, by the post-processors of `options`
/// where they can be applied without improving the path. Takes as long as it takes; other results stay as they are.
void complete_interrupted(const Problem& problem, const FindOptions& options, Result& result);

/// Makes now what parts of a problem make only when they are asked for (HasCoarserVersion::coarser), so that it does
/// not count against a deadline. They are kept by the domain, whatever problem asks next, and take no longer than the
/// domain itself.
void prepare(const Problem& problem);

}  // namespace leastcost
