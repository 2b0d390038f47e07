// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include <leastcost/catalogue/run/run_parts.hpp>
#include "catalogue/config/run_config.hpp"
#include "catalogue/plugins/plugin.hpp"

namespace leastcost {

/// The domain and everything else of a run is made once, and this puts one pair of ends after the other into it. May be
/// used by several threads at once.
class PairComposer {
 public:
  /// `context`: with the domain as it is made, among its obstacles; `open_domain`: without them; `parts`: all but the
  /// ends.
  PairComposer(RunConfig config, BuildContext context, std::shared_ptr<const ConstraintManifold> open_domain,
               RunParts parts);

  /// The parts for one pair, with notes about it alone. Its ends may be one place (are_one_place): there is nothing to
  /// search. `all`: everything but the ends: parts(), or what became of them in memory; the domain must be the same.
  /// Throws OptionError with a key that begins with "source" or "target", or with that of the cost, which may refuse a
  /// source.
  RunParts compose(EndOptions source, EndOptions target, const RunParts& all) const;

  const RunConfig& config() const { return config_; }
  /// As they were composed; of a configuration with many pairs of ends all but the ends.
  const RunParts& parts() const { return parts_; }
  /// The names of the coordinates in which points are given.
  const std::vector<std::string>& coordinates() const { return context_.coordinates; }

 private:
  std::shared_ptr<const SegmentCost> cost_between(const Problem& problem) const;

  RunConfig config_;
  BuildContext context_;
  std::shared_ptr<const ConstraintManifold> open_domain_;
  RunParts parts_;
  mutable std::once_flag prepared_;  // coarser versions of the domain are no pair's work
  mutable std::once_flag made_;
  mutable std::shared_ptr<const SegmentCost> cost_of_all_;  // where that of parts_ was made for their ends
};

}  // namespace leastcost
