// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <leastcost/framework/base/checked.hpp>
#include <leastcost/framework/base/options.hpp>
#include <leastcost/framework/energy/solver.hpp>

namespace leastcost {

struct StringMethodOptions {
  double step = 0.5;
  double tolerance = 1e-10;
  int max_iterations = 20000;    ///< steps at most
  int max_evaluations = 100000;  ///< evaluations of the energy at most
  void fields(FieldVisitor& visit);
};

/// The simplified string method (E, Ren, Vanden-Eijnden, J. Chem. Phys. 126:164103, 2007): every point moves by the
/// part of the negative gradient that is normal to the path, in units of what it can bear, then the points are spaced
/// equally in cost again by interpolation. There is no energy and no line search; the end is a fixed point of step and
/// re-spacing, the path of least true cost met on the way is returned.
class StringMethod final : public Solver {
 public:
  explicit StringMethod(StringMethodOptions options = {}) : options_(checked(options)) {}
  std::string_view name() const override { return "string"; }

 private:
  SolveReport do_solve(PathEnergy& energy, CoordinatePath& path, const Monitor& monitor) const override;
  StringMethodOptions options_;
};

}  // namespace leastcost
