// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include <leastcost/framework/path/path.hpp>
#include "framework/proof/detail_verdict.hpp"

namespace leastcost {

/// A proof that a smooth curve is nearly the cheapest of all in a tube around it.
///
/// In tube coordinates x = gamma(t) + N(t) z, |z_j| <= R, a potential u(t, z) = tau(t) + q(t).z + z'W(t)z / 2 is made
/// whose gradient has the dual norm 1 along the curve: tau' is the speed of the curve, q is the part of the momentum
/// across it, W solves the Riccati equation of its Jacobi fields with a margin. Where the squared dual norm f of grad u
/// is at most 1 + e in the tube, no curve in the tube between its two ends costs less than (u(1) - u(0)) (1 - e), and
/// u(1) - u(0) is the cost of the curve (Weierstrass' field of extremals; a calibration). f(t, 0) = 1 exactly; the
/// Hessian of f across the curve is bounded by -2m over the whole tube, and its slope on the curve by r, both in
/// interval arithmetic: e = r^2 / 4m. Gamma need not be an extremal: r measures how far it is from one.
///
/// So a feature of the cost that no point of a chain saw, in the tube, makes the proof fail.
struct Calibration {
  bool applies = false;  ///< there is a tube: what can_calibrate() says, and no ring
  bool proved = false;
  double gap = 0;               ///< relative; no curve in the tube costs less than (1 - gap) times the curve
  double half_width = 0;        ///< of the tube where it is narrowest, units of the cost
  double lower = 0;             ///< where proved: no curve in the tube costs less. Units of the cost
  std::optional<double> upper;  ///< the curve costs no more
  Index segments = 0;           ///< of the tube; 0 where none was needed
  DetailVerdict details = DetailVerdict::undecided;
  Index detail = 0;  ///< the point of the chain where there are details, or may be
};

struct CalibrationOptions {
  Index segments = 0;  ///< of the delivered path: the tube reaches a quarter of one to each side
  double gap = 0;      ///< relative; no more effort where it is reached
  int boxes = 4;       ///< at most this many per segment of the tube, in the mean: the effort for the proof
};

}  // namespace leastcost
