// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <memory>

#include <leastcost/problems/level_set/constraint_function.hpp>

/// Surfaces (and a curve) with names. All throw OptionError with the key of the parameter that cannot work.
namespace leastcost {

/// |x| = radius in R^n.
std::shared_ptr<const ConstraintFunction> make_sphere_function(int dimension, double radius);
/// (x/a)^2 + (y/b)^2 + (z/c)^2 = 1; axes a, b, c.
std::shared_ptr<const ConstraintFunction> make_ellipsoid_function(const Eigen::VectorXd& axes);
/// Around the z axis; major_radius > minor_radius.
std::shared_ptr<const ConstraintFunction> make_torus_function(double major_radius, double minor_radius);
/// 2 y (y^2 - 3 x^2) (1 - z^2) + (x^2 + y^2)^2 - (9 z^2 - 1) (1 - z^2) = 0, a closed surface with two handles.
std::shared_ptr<const ConstraintFunction> make_genus2_function();
/// sin x cos y + sin y cos z + sin z cos x = 0 with x, y, z in units of period / (2 pi).
std::shared_ptr<const ConstraintFunction> make_gyroid_function(double period);
/// The curve x^4 + y^2 + 3 x y + 3 sin x cos y - 1 = 0 in the plane, VFCS 4.4.2.
std::shared_ptr<const ConstraintFunction> make_paper_curve_function();

}  // namespace leastcost
