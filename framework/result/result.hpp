// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <leastcost/framework/base/words.hpp>
#include <leastcost/framework/certificate/certificate.hpp>
#include <leastcost/framework/energy/solve_report.hpp>
#include <leastcost/framework/problem/initializer.hpp>
#include <leastcost/framework/problem/post_processor.hpp>

namespace leastcost {

/// Complete as it is: {} solves 64 points and certifies them, or goes on with more of them where that is what the
/// certificate lacks (`certificate.refine`; a path that stays refused costs up to `certificate.refine_work` times the
/// first search; 0 where there is no time for them).
struct FindOptions {
  /// Free points n >= 1; nothing: max(8, interior vertices of the first edge path), VFCS 5.1; of a robot LimitsMoves.
  /// Doubled, which a note says, as long as the moves between them cannot go between the obstacles of the domain.
  std::optional<int> points = 64;
  /// s0 > 0, units of the cost; nothing: the mean segment cost of the first path.
  std::optional<double> reference_cost = {};
  bool cascade = false;  ///< solve coarse first, then double: see framework/newton/cascade.hpp
  /// Keeps the coordinates of the target where they are a name only (the longitude of a sphere), and with them a turn
  /// round the axis. Else the target is called by the name nearest to the source, or to the last waypoint.
  bool target_as_given = false;
  bool escape_saddle = false;           ///< leave saddles to the lower side: see framework/newton/escape_saddle.hpp
  CertificateOptions certificate = {};  ///< what is asked of the path
  std::vector<std::shared_ptr<const PostProcessor>> post_processors = {};  ///< in the order of their application
};

/// What became of a search.
enum class Status { certified, uncertified, collapsed, interrupted };
Words<Status> words(Status);

/// Wall time of every stage, seconds.
struct StageSeconds {
  double initialize = 0;    ///< first path
  double solve = 0;         ///< minimisation
  double post_process = 0;  ///< steps after the minimisation
  double prepare = 0;  ///< the coarser versions of the domain, by the search that asks for them first; see prepare()
  double certify = 0;  ///< without them
};

/// NaN is what was not measured. An interrupted result has the best feasible path so far, or none yet (`path` is empty,
/// a note says so); what there was no time for is missing, see complete_interrupted().
struct Result {
  Status status = Status::uncertified;  ///< what became of the search
  FirstPath first;                      ///< as the initializer made it
  CoordinatePath initial;               ///< its samples, equally spaced in cost: what the solver started from
  double initial_cost = std::numeric_limits<double>::quiet_NaN();    ///< of the first path
  double reference_cost = std::numeric_limits<double>::quiet_NaN();  ///< s0
  CoordinatePath path;                                               ///< the delivered points, equally spaced in cost
  Eigen::VectorXd costs;                                             ///< cost of each move between them
  Curve curve;                                                       ///< the path as a curve on the domain
  bool post_processed = false;     ///< whether `curve` is what the post-processors made; only an interrupted one is not
  Eigen::VectorXd curve_costs;     ///< cost of that curve between the delivered points
  SolveReport solve;               ///< what the solver did
  Certificate certificate;         ///< what is known of the path
  StageSeconds seconds;            ///< of every stage
  std::vector<std::string> notes;  ///< what the user should know
};

/// A later result of the same search: where it began, and what it took, are those of the whole.
Result joined(const Result& before, Result later);

/// Adds notes that are not there yet.
void add_notes(const std::vector<std::string>& more, std::vector<std::string>& notes);

}  // namespace leastcost
