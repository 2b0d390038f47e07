// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <optional>

#include <leastcost/problems/cloud/point_cloud.hpp>

namespace leastcost {

/// The smooth surface of a cloud: the zero set of algebraic moving least squares (APSS: Guennebaud, Gross, SIGGRAPH
/// 2007; the closed form with normals of Guennebaud, Germann, Gross 2008). At every x the algebraic sphere u_c + u_l .
/// y + u_4 |y|^2 whose gradients fit the normals and whose values fit the samples near x has a value at y = x, and that
/// value is f(x). The weights trust (1 - d^2 / h^2)^4 make f three times differentiable; its gradient is formed
/// exactly, so that projections are reproducible to rounding and tangent planes are those of the surface itself.
///
/// Samples whose normal turns more than 120 degrees from that of the nearest sample belong to another sheet and do not
/// count.
class CloudSurface {
 public:
  /// Another sheet among the samples that make the surface somewhere.
  struct OtherSheet {
    double apart = 0;  ///< distance of the two sheets, local spacings
    double share = 0;  ///< part of the samples there, at most one half
  };

  /// The cloud must outlive the surface.
  explicit CloudSurface(const PointCloud& cloud) : cloud_(&cloud) {}

  /// Moves x (in the coordinates of the file) along the gradients of f onto f = 0; on leaving, f is zero to rounding.
  /// False, and x is left alone, where there is no surface: too far from the samples or with all of them on one side
  /// (beyond the border of a scan).
  bool project(Eigen::Ref<Eigen::Vector3d> x) const;

  /// The same, and where that leads beyond the border, on to the nearest place of the border, which is the curve on f =
  /// 0 where the mean of the samples, seen along the surface, is kBorder supports away. False only where there is
  /// neither.
  bool project_within(Eigen::Ref<Eigen::Vector3d> x) const;
  /// Onto the border.
  bool project_onto_border(Eigen::Ref<Eigen::Vector3d> x) const;
  /// Onto f = 0 as far as that is defined, some supports beyond the border.
  bool project_beyond(Eigen::Ref<Eigen::Vector3d> x) const;
  /// The border near x, if any is.
  struct NearBorder {
    Eigen::Vector3d outward;  ///< unit, along the surface
    double gap = 0;           ///< to the border, to first order; negative beyond it
    bool rests = false;       ///< x lies on the border, to rounding
  };
  /// Where the surface ends near x; none: it goes on.
  std::optional<NearBorder> border_near(const Eigen::Vector3d& x) const;

  /// Unit normal of the level set of f through x, on the side of the samples' normals; nothing where f is not defined.
  std::optional<Eigen::Vector3d> normal(const Eigen::Vector3d& x) const;

  /// Whether the samples that make the surface near x lie on two sheets, so that it runs between them: their heights
  /// over the algebraic sphere fall into two groups that are far apart against their widths and stand on the same
  /// ground. Noise does not, nor does a crease. Sheets nearer than half a spacing are noise.
  std::optional<OtherSheet> other_sheet(const Eigen::Vector3d& x) const;

 private:
  enum class Border { stop, rest, ignore };
  bool project(Eigen::Ref<Eigen::Vector3d> x, Border border) const;

  const PointCloud* cloud_;
};

}  // namespace leastcost
