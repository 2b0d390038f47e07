// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <vector>

#include <leastcost/framework/problem/problem.hpp>

namespace leastcost {

// Abilities of domains that were read from a file whose elements have numbers, counted from 0 as in the file.

/// Ability: ends can be given as vertices (points, samples) of the file.
class HasVertices {
 public:
  static constexpr std::string_view kAbility = "vertices";
  virtual ~HasVertices() = default;
  /// Its position; without a site it need not lie on the domain (the sample of a cloud) and is projected. Throws
  /// OptionError("vertex") where there is no such vertex.
  virtual PathEnd vertex(int number) const = 0;
};

/// Ability: ends can be given as faces of the file with barycentric coordinates.
class HasFaces {
 public:
  static constexpr std::string_view kAbility = "faces";
  virtual ~HasFaces() = default;
  /// Throws OptionError("face" or "barycentric") where there is no such face or point on it.
  virtual PathEnd on_face(int face, const Eigen::Vector3d& barycentric) const = 0;
};

/// Ability: points of the domain have a place in the file, which tables of points name.
class HasFilePlaces {
 public:
  virtual ~HasFilePlaces() = default;
  /// Names of the columns that say it.
  virtual std::vector<std::string> place_columns() const = 0;
  /// One number per column for the point x on the piece `site`; -1 stands for none.
  virtual Eigen::VectorXd place_in_file(Site site, const Eigen::VectorXd& x) const = 0;
};

}  // namespace leastcost
