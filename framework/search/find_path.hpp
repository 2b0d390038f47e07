// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <leastcost/framework/base/monitor.hpp>
#include <leastcost/framework/energy/solver.hpp>
#include <leastcost/framework/problem/initializer.hpp>
#include <leastcost/framework/problem/problem.hpp>
#include <leastcost/framework/result/complete_interrupted.hpp>
#include <leastcost/framework/result/result.hpp>
#include <leastcost/framework/search/prepare.hpp>

namespace leastcost {

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

}  // namespace leastcost
