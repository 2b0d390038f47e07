// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>
#include <vector>

#include <leastcost/framework/certificate.hpp>
#include <leastcost/framework/initializer.hpp>
#include <leastcost/framework/monitor.hpp>
#include <leastcost/framework/post_processor.hpp>
#include <leastcost/framework/problem.hpp>
#include <leastcost/framework/solver.hpp>

namespace leastcost {

struct FindOptions {
  int points = 64;             ///< free points n; 0: max(8, interior vertices of the first edge path), VFCS 5.1
  double reference_cost = 0;   ///< s0, units of the cost; 0: the mean segment cost of the first path
  bool cascade = false;        ///< solve coarse first, then double: see framework/cascade.hpp
  bool escape_saddle = false;  ///< leave saddles to the lower side: see framework/escape_saddle.hpp
  CertificateOptions certificate = {};
  const Solver* certifier = nullptr;                       ///< required when the certificate is enabled; not owned
  std::vector<const PostProcessor*> post_processors = {};  ///< not owned
};

enum class Status { certified, uncertified, collapsed, interrupted };
std::string_view name(Status status);

struct StageSeconds {
  double initialize = 0;
  double solve = 0;
  double post_process = 0;
  double certify = 0;
};

struct Result {
  Status status = Status::uncertified;
  FirstPath first;         ///< as the initializer made it
  CoordinatePath initial;  ///< its samples, equally spaced in cost: what the solver started from
  double initial_cost = 0;
  double reference_cost = 0;    ///< s0
  CoordinatePath path;          ///< the delivered points, equally spaced in cost
  Eigen::VectorXd costs;        ///< cost of each move between them
  Curve curve;                  ///< the path as a curve on the domain
  Eigen::VectorXd curve_costs;  ///< cost of that curve between the delivered points
  SolveReport solve;
  Certificate certificate;
  StageSeconds seconds;
  std::vector<std::string> notes;
};

/// The library's front door; the command line and an embedder call this same function. Never prints, never exits;
/// may run from several threads at once (one Monitor each). Throws InputError for a problem whose parts do not fit,
/// InitializationError when there is no first path.
Result find_path(const Problem& problem, const Initializer& initializer, const Solver& solver,
                 const FindOptions& options, const Monitor& monitor = {});

}  // namespace leastcost
