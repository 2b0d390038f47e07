// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <leastcost/framework/base/options.hpp>
#include <leastcost/framework/certificate/certificate_failure.hpp>
#include <leastcost/framework/certificate/cost_estimate.hpp>
#include <leastcost/framework/certificate/resolution.hpp>
#include <leastcost/framework/cost/regularized.hpp>
#include <leastcost/framework/newton/path_index.hpp>
#include <leastcost/framework/newton/refinement.hpp>
#include <leastcost/framework/problem/clearance.hpp>
#include <leastcost/framework/problem/global_bound.hpp>

namespace leastcost {

/// When a proof of the local minimum is tried, where cost and domain are formulas.
enum class ProofRule {
  always,
  needed,  ///< only where the path would be refused without it
  never
};
Words<ProofRule> words(ProofRule);

/// Thresholds of the certificate; the defaults are those of the table in docs/numerics.md.
struct CertificateOptions {
  bool enabled = true;
  ProofRule proof = ProofRule::always;
  GlobalProof global = {};  ///< on a mesh, among obstacles in the plane, or by a potential in a box of the plane
  int refine = 6;           ///< doublings of the points at most, where more of them may mend what is refused
  double refine_work = 30;  ///< that they may take at most, in units of the work of the search before them
  double stationarity = 1e-10;
  double residual = 1e-10;
  double spacing = 1e-6;
  double doubling = 0.05;
  double longest_segment = 3;
  double index_shift = 1e-3;
  double clearance = 1e-9;
  void fields(FieldVisitor& visit);
};

/// What was measured about a path, independently of the solver that made it; NaN: not measured. An empty list of
/// failures means certified. It says "global" only where a proof over all paths was made (`global`): a local method
/// cannot know.
struct Certificate {
  bool measured = false;                     ///< false: nothing was asked of the path
  Scope scope = Scope::none;                 ///< among which paths this one is least
  std::optional<GlobalBound> global;         ///< null: no proof over all paths was tried
  std::vector<CertificateFailure> failures;  ///< empty: certified
  CostEstimate estimate;                     ///< the cost of the curve that the path stands for
  std::optional<double> stationarity;        ///< relative cost error
  std::optional<double> residual;            ///< diameters
  /// max c / min c - 1; of a straightened path by arc length.
  double spacing = std::numeric_limits<double>::quiet_NaN();
  std::optional<double> doubling;           ///< E_2M / E_4M
  std::optional<double> doubling_expected;  ///< H(s_2M) / (2 H(s_4M))
  /// max / mean cost of the curve between two points.
  double longest_segment = std::numeric_limits<double>::quiet_NaN();
  PathIndex index;                       ///< of the path as a critical point: minimum or saddle
  std::optional<Resolution> resolution;  ///< of chains; null beside another failure, and on a bound
  std::optional<Clearance> clearance;    ///< null: the domain has no obstacles
  std::optional<double> straightness;    ///< smallest side angle minus pi, radians
  std::optional<double> asymmetry;       ///< backward cost / forward cost - 1
  std::optional<double> geometry_error;  ///< what the representation of the domain costs; null: exact or unknown
  std::optional<Regularization> regularization;  ///< null: the cost is the one that is meant
  std::vector<RefinementLevel> levels;           ///< the path with more and more points

  bool certified() const { return measured && failures.empty(); }  ///< whether it was measured and nothing failed
};

}  // namespace leastcost
