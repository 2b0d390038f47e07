// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace leastcost {

/// Why a path is not certified. docs/failures.md says of each what to do.
enum class Failure {
  stationarity,
  exception,
  inconsistent,
  interrupted,
  post_process,
  saddle,
  degenerate,
  undecidable,
  index_not_applicable,
  residual,
  touches,
  class_lost,
  active_set_cycling,
  dearer_than_first,
  straightness,
  infinite_cost,
  costs_nothing,
  collapsed,
  interfaces,
  spacing,
  longest_segment,
  doubling,
  refinement,
  not_asymptotic,
  bracket,
  error_bar,
  unresolved,
  geometry_error,
  not_global,
  below_bound
};

/// Whether solving the path again with more points may mend a failure.
enum class PointsHelp {
  no,             ///< not by themselves
  maybe,          ///< too few points may explain it
  beside_others,  ///< it may go away beside a failure that they help: the chain sees another cost than there is
  never           ///< no number of points mends it
};

/// What follows from a failure: the one table of it.
struct Consequences {
  Failure failure;        ///< what failed
  std::string_view word;  ///< its name in files and messages
  bool voids_bar;         ///< the value has no error bar
  PointsHelp points;      ///< whether more points would help
};
/// What follows from a failure: its row of the table.
const Consequences& consequences(Failure failure);

/// The word of a failure in results and messages.
inline std::string_view word(Failure failure) { return consequences(failure).word; }

/// One reason not to trust a path: `kind` for programs, `message` for people.
struct CertificateFailure {
  Failure kind;         ///< what failed
  std::string message;  ///< in words, with the figures

  std::string name() const { return std::string(word(kind)); }  ///< its word
};

}  // namespace leastcost
