// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include <leastcost/framework/base/options.hpp>
#include <leastcost/framework/problem/post_processor.hpp>

namespace leastcost {

struct OnSurfaceOptions {
  std::optional<double> tolerance = {};  ///< length units; else 1e-6 of the path's extent
  void fields(FieldVisitor& visit);
};

/// The chain as a polyline that lies on a smooth domain to a tolerance: wherever a chord is further off the domain than
/// that, a point of the domain over its middle is put in, and so on with the halves. On a surface in space these points
/// lie in the cutting plane of the segment, VFCS Eq. (16); elsewhere, and where there is no such plane, they are the
/// nearest ones. The chain stays as it is.
class OnSurfacePostProcessor final : public PostProcessor {
 public:
  /// Throws OptionError for a tolerance that is not positive.
  explicit OnSurfacePostProcessor(const OnSurfaceOptions& options = {});
  std::string_view name() const override { return "on_surface"; }
  /// Throws InputError for a domain that is not smooth or is not embedded point by point.
  PostProcessed apply(const Problem& problem, const FirstPath& first, PostProcessed current,
                      const Monitor& monitor) const override;

 private:
  OnSurfaceOptions options_;
};

}  // namespace leastcost
