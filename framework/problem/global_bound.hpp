// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <leastcost/eigen_alignment.hpp>

#include <leastcost/framework/base/options.hpp>

namespace leastcost {

/// What a lower bound of the least cost rests on.
enum class BoundCategory {
  proved,               ///< on nothing but the arithmetic of the machine and the C library
  proved_given_bounds,  ///< on bounds of derivatives that the user states
  sampled               ///< on values at points: no proof
};
Words<BoundCategory> words(BoundCategory);

/// What a certificate speaks of.
enum class Scope {
  none,  ///< nothing was measured
  local,
  local_value,  ///< the value alone, not the path
  local_on_polyhedron,
  chain_on_polyhedron,
  least_of_class,
  global_on_polyhedron,
  global
};
Words<Scope> words(Scope);

/// What a proof over all paths came to.
enum class ProofOutcome {
  proved,    ///< no path is cheaper by more than the gap
  improved,  ///< proved, of a path that is cheaper than the one before
  sampled,   ///< the gap is small enough, but nothing is proved
  bounded,   ///< the budget was spent: only the lower bound holds
  blocked    ///< a cheaper path could run where nothing can be told, or below what rounding leaves; `reason`
};
Words<ProofOutcome> words(ProofOutcome);

/// Values of a potential on a regular grid over a box, the corners included, for pictures. +infinity where no path that
/// may be cheaper goes.
struct PotentialSamples {
  Eigen::AlignedBox2d box;     ///< what the samples cover
  int columns = 0, rows = 0;   ///< samples along x and along y
  std::vector<double> values;  ///< x runs fastest, from below
};

/// The box and the grid of a lower bound by a potential on cells.
struct BoundGrid {
  Eigen::AlignedBoxXd box;          ///< in two or three dimensions: the paths that the bound speaks of stay in it
  std::vector<int> cells = {};      ///< of the finest grid over the whole box, along each axis
  double upper = 0;                 ///< of the cost of the delivered curve: the gap is between both
  PotentialSamples potential = {};  ///< around all places that were searched; empty: none, as in space
};

/// What a proof over all paths of the domain between two ends says, whatever class they are of.
struct GlobalBound {
  bool proved = false;                             ///< no path costs less than the delivered one by more than the gap
  ProofOutcome outcome = ProofOutcome::bounded;    ///< what it came to
  double lower_bound = 0;                          ///< no path costs less
  double gap = 0;                                  ///< (cost of the delivered path - lower_bound) / cost
  Scope scope = Scope::global_on_polyhedron;       ///< of a certificate, when it is proved
  std::int64_t steps = 0;                          ///< of the search
  std::string counts = "windows";                  ///< what the steps are
  std::string bound = {};                          ///< what the search aimed by: "euclid"
  std::string reason = {};                         ///< why it is blocked, in words
  BoundCategory category = BoundCategory::proved;  ///< what kind of bound it is
  std::optional<BoundGrid> grid = {};              ///< of a bound by a potential
  double seconds = 0;                              ///< that it took
};

/// How far a proof over all paths may go.
struct GlobalBudget {
  static constexpr std::string_view kType = "budget", kHelp = "Within the budget given here.";
  double tolerance = 1e-9;
  std::optional<double> max_seconds = {};
  std::optional<int> max_windows = {};
  std::optional<int> landmarks = {};  ///< that lower bounds come from
  std::string index = {};             ///< file of landmarks; empty: none
  void fields(FieldVisitor& visit);
};
struct GlobalAuto {
  static constexpr std::string_view kType = "auto",
                                    kHelp = "Without a limit on meshes of up to 20000 vertices, else within a budget.";
};
struct GlobalOff {
  static constexpr std::string_view kType = "off", kHelp = "No proof: the certificate is local.";
};
using GlobalProof = std::variant<GlobalAuto, GlobalOff, GlobalBudget>;

}  // namespace leastcost
