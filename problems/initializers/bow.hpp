// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <leastcost/framework/base/checked.hpp>
#include <leastcost/framework/base/options.hpp>
#include <leastcost/framework/problem/initializer.hpp>

namespace leastcost {

struct BowOptions {
  double height = 0.5;  ///< sag over the distance of the ends
  double angle = 0;     ///< degrees about the straight line
  void fields(FieldVisitor& visit);
};

/// An arc from source to target beside the straight line, projected onto the domain: a start for another class of
/// paths. In the plane and in charts angle 0 bows to the left, 180 to the right.
class BowInitializer final : public Initializer {
 public:
  explicit BowInitializer(BowOptions options = {}) : options_(checked(options)) {}
  std::string_view name() const override { return "bow"; }
  FirstPath first_path(const Problem& problem, const Monitor& monitor) const override;

 private:
  BowOptions options_;
};

}  // namespace leastcost
