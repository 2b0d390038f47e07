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

/// A run of many pairs of ends: the domain and everything else is made once, and this puts one pair after the other
/// into it. May be used by several threads at once.
class PairComposer {
 public:
  /// `context`: with the domain as it is made, among its obstacles; `open_domain`: without them; `parts`: all but the
  /// ends.
  PairComposer(RunConfig config, BuildContext context, std::shared_ptr<const ConstraintManifold> open_domain,
               RunParts parts);

  /// The parts for one pair, with notes about it alone. Its ends may be one place (are_one_place): there is nothing to
  /// search. Throws OptionError with a key that begins with "source" or
  /// "target", or with that of the cost, which may refuse a source.
  RunParts compose(EndOptions source, EndOptions target) const;

  const RunConfig& config() const { return config_; }
  /// All but the ends.
  const RunParts& parts() const { return parts_; }
  /// The names of the coordinates in which points are given.
  const std::vector<std::string>& coordinates() const { return context_.coordinates; }

 private:
  RunConfig config_;
  BuildContext context_;
  std::shared_ptr<const ConstraintManifold> open_domain_;
  RunParts parts_;
  mutable std::once_flag prepared_;  // coarser versions of the domain are no pair's work
};

}  // namespace leastcost
