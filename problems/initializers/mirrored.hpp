// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <utility>

#include <leastcost/framework/problem/initializer.hpp>

namespace leastcost {

/// The mirror image of another initializer's first path, projected onto the domain: a start on the other side of what
/// that path goes around. The mirror contains both ends: a line in the plane and in charts, a plane that also contains
/// the mean normal at the ends on surfaces in space; in other spaces the path is turned by 180 degrees about the line.
/// For families (family.mirrored).
class MirroredInitializer final : public Initializer {
 public:
  /// Throws InputError for none.
  explicit MirroredInitializer(std::shared_ptr<const Initializer> original);
  std::string_view name() const override { return "mirrored"; }
  /// Throws InitializationError for rings and where the image has no continuous projection.
  FirstPath first_path(const Problem& problem, const Monitor& monitor) const override;

 private:
  std::shared_ptr<const Initializer> original_;
};

}  // namespace leastcost
