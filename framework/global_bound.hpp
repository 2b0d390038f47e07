// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include <leastcost/framework/options.hpp>

namespace leastcost {

/// What a proof over all paths of the domain between two ends says, whatever class they are of.
struct GlobalBound {
  bool proved = false;       ///< no path costs less than the delivered one by more than the gap
  std::string outcome = {};  ///< "proved", "improved" (proved, of a path cheaper than before), "bounded", "blocked"
  double lower_bound = 0;    ///< no path costs less
  double gap = 0;            ///< (cost of the delivered path - lower_bound) / cost
  std::int64_t steps = 0;    ///< windows that were looked at
  std::string bound = {};    ///< what the search aimed by: "euclid"
  std::string reason = {};   ///< why it is blocked, in words
};

/// How far a proof over all paths may go.
struct GlobalBudget {
  static constexpr std::string_view kType = "budget", kHelp = "Within a budget that is given here.";
  double tolerance = 1e-9;
  std::optional<double> max_seconds = {};
  std::optional<int> max_windows = {};
  void fields(FieldVisitor& visit);
};
struct GlobalAuto {
  static constexpr std::string_view kType = "auto",
                                    kHelp = "To the end on meshes of up to 20000 vertices, within a budget above.";
};
struct GlobalOff {
  static constexpr std::string_view kType = "off", kHelp = "Not tried: the certificate is a local one.";
};
using GlobalProof = std::variant<GlobalAuto, GlobalOff, GlobalBudget>;

}  // namespace leastcost
