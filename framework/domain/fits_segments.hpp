// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <memory>
#include <vector>

#include <leastcost/framework/domain/manifold.hpp>

namespace leastcost {

/// What it costs that points keep a margin from an obstacle.
struct MarginCost {
  int obstacle = -1;  ///< its number; -1: none
  double cost = 0;    ///< at first order: the margin times what a unit of it less would save
};

/// What a domain was found to need for the moves of a path.
struct SegmentFit {
  std::shared_ptr<const ConstraintManifold> domain;  ///< fitted anew; null where that would change nothing
  std::map<int, double> gaps;                        ///< least of the moves, by number of the obstacle, length units
};

/// Ability of a domain whose points keep away from something by as much as the moves between them need, which depends
/// on the chain that they belong to.
class FitsSegments {
 public:
  static constexpr double kCloseFit = 1e-9;  ///< relative: a closer fit changes nothing that is measured
  virtual ~FitsSegments() = default;
  /// The same domain for chains with moves as long as those of a path, fitted to nothing else yet. `agreement`, of the
  /// extent of the path: by so much a move may keep away for nothing.
  virtual std::shared_ptr<const ConstraintManifold> unfitted(const CoordinatePath& path,
                                                             double agreement = kCloseFit) const = 0;
  /// Fitted anew to a path on this one: by more where its moves come too near, by less where points keep away for
  /// nothing.
  virtual SegmentFit fitted(const CoordinatePath& path) const = 0;
  /// Of a chain at rest on this one, ascending by obstacle. gradient: of its cost at the free points, coordinate x n.
  virtual std::vector<MarginCost> margin_costs(const CoordinatePath& path, const Points& gradient) const = 0;
};

}  // namespace leastcost
