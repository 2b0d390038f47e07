// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <memory>
#include <string>
#include <vector>

#include <leastcost/framework/base/ability.hpp>
#include <leastcost/framework/path/path.hpp>

namespace leastcost {

/// Numbers of coordinates of a domain.
struct Dimensions {
  int coordinate = 0;  ///< rows of a CoordinatePath
  int ambient = 0;     ///< rows of an AmbientPath
  int tangent = 0;     ///< degrees of freedom of a point
};

/// flat: straight moves stay in the domain, retraction is addition (followed by clamping to bounds).
/// smooth: twice differentiable. polyhedral: piecewise flat, with kinks where pieces meet.
enum class Shape { flat, smooth, polyhedral };

/// A point put onto the domain.
struct Projection {
  double moved = 0;           ///< how far the worst column moved, length units
  std::vector<Index> failed;  ///< columns that could not be projected; they are left as they were
};

/// Where points may be. Immutable, hence shareable between threads. What becomes of a column depends on that column
/// alone: the columns of a long path may be handed over in parts, as rings, with a look at the clock between them.
class ConstraintManifold : public HasAbilities<ConstraintManifold> {
 public:
  virtual Dimensions dimensions() const = 0;  ///< of points, of the space around them and of the domain itself
  virtual Shape shape() const = 0;            ///< what proofs and post-processors may rely on

  /// Moves every column to the nearest feasible point and sets its site (an existing site is a hint).
  virtual Projection project(CoordinatePath& path) const = 0;

  /// Orthonormal tangent bases of all columns, side by side: coordinate x (tangent * columns). VFCS Eq. (11) is the
  /// projection T T' g.
  virtual void tangent_bases(const CoordinatePath& path, Points& bases) const = 0;

  /// to = R(from, step): the free columns moved by `step` (coordinate x free_count, tangent vectors) and back onto
  /// the domain. R(x, 0) = x and dR(x, 0) = id; R agrees with the nearest point to second order. `to` has the size of
  /// `from`; may not alias it.
  virtual void retract(const CoordinatePath& from, const Points& step, CoordinatePath& to) const = 0;

  /// Worst distance of a column from the domain, length units.
  virtual double residual(const CoordinatePath& path) const = 0;
};

/// Ability: points are given in the coordinates of a chart x = x(u) (VFCS Eq. 12). The coordinates are the unknowns:
/// retraction is addition, tangent bases are the identity. Without it coordinates are ambient positions.
class HasChart {
 public:
  virtual ~HasChart() = default;
  /// Ambient positions of all columns, ambient x columns.
  virtual void embed(const CoordinatePath& path, Points& x) const = 0;
  /// dx/du at all columns, side by side: ambient x (coordinate * columns).
  virtual void jacobians(const CoordinatePath& path, Points& j) const = 0;
  /// Both of these, for charts that make them together at less than the price of both.
  virtual void embed_with_jacobians(const CoordinatePath& path, Points& x, Points& j) const {
    embed(path, x);
    jacobians(path, j);
  }
  /// sum_j w_j Hess x_j(u) at all columns, w the columns of `weights` (ambient x columns), side by side: coordinate x
  /// (coordinate * columns).
  virtual void curvatures(const CoordinatePath& path, const Points& weights, Points& h) const = 0;
  /// Ways over a pole, where the chart goes on as another part of itself: on a sphere (u, v) is also (u + pi, pi - v).
  virtual const std::vector<SeamMap>& poles() const = 0;
  /// Names of the coordinates, one each: where points are given by name, and the columns of files.
  virtual std::vector<std::string> coordinate_names() const = 0;
};

/// Ambient positions of the columns of a path: through its chart, or the coordinates themselves.
Points positions(const ConstraintManifold& manifold, const CoordinatePath& path);

/// Ability: the domain has bounds (a box, a chart's edge, the border of a mesh) on which points may come to rest.
class HasBounds {
 public:
  virtual ~HasBounds() = default;
  /// Outward unit normals of the bounds that a column lies on, into the first columns of `normals`
  /// (coordinate x coordinate); returns how many.
  virtual int active_bounds(const CoordinatePath& path, Index column, Eigen::Ref<Points> normals) const = 0;
};

/// Ability: the domain is made of flat pieces, and its tangent bases are not theirs (smooth normals on a mesh). A
/// retraction moves a point within its piece, so the slope of an energy along a tangent vector is that along the
/// vector's part in the piece.
class HasPieces {
 public:
  virtual ~HasPieces() = default;
  /// Replaces vectors at the free points (coordinate x free_count) by their parts in the pieces the points lie on.
  virtual void into_pieces(const CoordinatePath& path, Points& vectors) const = 0;
};

/// Ability: the domain can say in words why a point has no nearest point on it.
class ExplainsProjection {
 public:
  virtual ~ExplainsProjection() = default;
  /// What to tell the user about a point without a nearest one.
  virtual std::string why_not_projected(const Eigen::VectorXd& x) const = 0;
};

/// ": " and the reason why x cannot be projected, where the domain knows it; else nothing.
std::string reason_for_failure(const ConstraintManifold& manifold, const Eigen::VectorXd& x);

/// Ability: the domain stands for data that could be coarser (a sampled cloud, a grid). The certificate solves once
/// more there, and the change of the cost says what the representation itself costs.
class HasCoarserVersion {
 public:
  virtual ~HasCoarserVersion() = default;
  /// The same domain from about half the data; made when it is asked for first, and kept: see prepare(). May throw
  /// InputError where too little is left.
  virtual std::shared_ptr<const ConstraintManifold> coarser() const = 0;
  /// Whether coarser() returns at once.
  virtual bool has_made_coarser() const = 0;
};

/// Ability: the domain is made from data and can tell where they do not say what it is: two sheets of a cloud within
/// one fit, say. No path that leads there is certified.
class HasUnresolvedPlaces {
 public:
  virtual ~HasUnresolvedPlaces() = default;
  /// What is wrong at the first column where something is, with the place; empty: nothing is known against any.
  virtual std::string why_unresolved(const CoordinatePath& path) const = 0;
};

/// Gives `to` the size, sites and fixed columns of `from`, for implementations of retract().
void prepare_like(const CoordinatePath& from, CoordinatePath& to);

/// Base for domains that are defined point by point in their ambient space: an author writes two functions.
///
///     class Sphere : public EmbeddedManifold {
///      public:
///       Sphere() : EmbeddedManifold({3, 3, 2}) {}
///       bool project_point(Eigen::Ref<Eigen::VectorXd> x) const override { return unit(x); }
///       void tangent_basis(const Eigen::VectorXd& x, Eigen::Ref<Points> basis) const override { ... }
///     };
class EmbeddedManifold : public ConstraintManifold {
 public:
  Dimensions dimensions() const override { return dimensions_; }
  Shape shape() const override { return Shape::smooth; }
  Projection project(CoordinatePath& path) const override;
  void tangent_bases(const CoordinatePath& path, Points& bases) const override;
  void retract(const CoordinatePath& from, const Points& step, CoordinatePath& to) const override;
  double residual(const CoordinatePath& path) const override;

 protected:
  explicit EmbeddedManifold(Dimensions dimensions) : dimensions_(dimensions) {}
  /// Moves x to the nearest point of the domain; false where there is none (x is then left alone).
  virtual bool project_point(Eigen::Ref<Eigen::VectorXd> x) const = 0;
  /// Orthonormal columns that span the tangent space at x, ambient x tangent.
  virtual void tangent_basis(const Eigen::VectorXd& x, Eigen::Ref<Points> basis) const = 0;

 private:
  Dimensions dimensions_;
};

}  // namespace leastcost
