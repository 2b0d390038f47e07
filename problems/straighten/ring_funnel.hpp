// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <leastcost/problems/mesh/surface_path.hpp>
#include <leastcost/problems/mesh/triangle_mesh.hpp>
#include "problems/straighten/funnel.hpp"
#include "problems/straighten/strip.hpp"

namespace leastcost {

/// Pulls a closed string through a strip that closes: its last door leads to the face before the first one.
///
/// Laid out period after period, such a strip repeats itself under an isometry T of the plane, its holonomy, and the
/// shortest closed string is a line that T moves along itself, or bends at a vertex of the strip. By how much the doors
/// turn over one period tells which: a straight string turns by nothing, so there can be one only when the doors turn
/// by nothing as well; when they turn to the left, the string bends around a vertex of the strip's left side. (A strip
/// with one side, a Moebius band, has a glide reflection instead, whose axis is the only candidate.) Where lines run
/// side by side, all of one length, the middle one is taken.
class RingFunnel {
 public:
  enum class Outcome {
    collapsed,  ///< the strip contracts to a point: it goes back through its own doors, or around one vertex
    straight,   ///< see line()
    bent        ///< see bend() and strip()
  };

  RingFunnel(Unfolding& unfolding, double tolerance)
      : unfolding_(&unfolding), funnel_(tolerance), tolerance_(tolerance) {}

  /// Doors that lead straight back, also over the seam, cancel.
  Outcome pull(std::vector<Door> doors);

  /// The straight string as points on its doors, the first one repeated at the end.
  const SurfacePath& line() const { return line_; }
  /// A vertex that the shortest string goes through, and the strip from it all around to itself, trimmed.
  const StripEnd& bend() const { return bend_; }
  const Strip& strip() const { return strip_; }

 private:
  /// A vertex of the strip, told by a door that ends at it.
  struct Corner {
    std::size_t door;
    bool left;
  };
  struct Pulled {
    double length = 0;
    double turn = 0;  ///< at the corner itself, from where the string arrives to where it leaves; left positive
    bool has_next = false;
    Corner next{};  ///< the corner that it bends around most, on the same side
  };

  const TriangleMesh& mesh() const { return unfolding_->mesh(); }
  bool reduce(std::vector<Door>& doors);
  void lay_out_period();
  bool around_one_vertex() const;
  bool find_line();
  bool in_corridor(const Eigen::Vector2d& on, const Eigen::Vector2d& along, bool anywhere);
  std::int32_t vertex_of(const Corner& corner) const;
  Strip strip_from(const Corner& corner) const;
  Pulled pull_from(const Corner& corner);
  Corner descend(Corner corner);
  Corner shortest_corner();

  Unfolding* unfolding_;
  Funnel funnel_;
  double tolerance_;
  std::vector<Door> doors_;           // of one period
  std::vector<UnfoldedDoor> period_;  // these and the first one again
  double turning_ = 0;                // of the doors over one period; left positive
  bool one_sided_ = false;
  SurfacePath line_;
  StripEnd bend_;
  Strip strip_;
};

}  // namespace leastcost
