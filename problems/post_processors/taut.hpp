// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <leastcost/framework/base/options.hpp>
#include <leastcost/framework/problem/post_processor.hpp>

namespace leastcost {

struct TautOptions {
  double excess = 1e-6;  ///< relative: what the polyline around circles may be longer by
  void fields(FieldVisitor& visit);
};

/// In the plane the shortest path of its class among obstacles, exact but for a small part of its length by which the
/// polyline around circles is longer: string pulling, then tangents. In space a locally shortest one among convex
/// obstacles (balls, boxes), with a measured excess. Of the first path and the solved one, as far as they are clear,
/// the one that gives the shorter path is kept. Needs a cost that is a length, the plane, space or a box of it, and in
/// the plane obstacles that are made of discs (balls, boxes, polygons, maps); elsewhere, and for a ring, apply() throws
/// InputError that says so.
class TautPostProcessor final : public PostProcessor {
 public:
  /// Throws OptionError for an excess below 1e-10 or above 0.01.
  explicit TautPostProcessor(TautOptions options = {});
  std::string_view name() const override { return "taut"; }
  bool finds_its_own() const override { return true; }
  PostProcessed apply(const Problem& problem, const FirstPath& first, PostProcessed current,
                      const Monitor& monitor) const override;

 private:
  TautOptions options_;
};

}  // namespace leastcost
