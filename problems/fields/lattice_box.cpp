// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/fields/lattice_box.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/domain/has_box.hpp>
#include "framework/base/counted.hpp"

namespace leastcost {

LatticeBox LatticeBox::of(const Problem& problem, const std::optional<Eigen::VectorXd>& lower,
                          const std::optional<Eigen::VectorXd>& upper) {
  const Eigen::VectorXd &a = problem.source.u, &b = problem.target.u;
  const auto* domain = find_ability<HasBox>(*problem.manifold);
  const auto side = [&](const std::optional<Eigen::VectorXd>& stated, const Eigen::VectorXd* own, const char* key) {
    if (stated && stated->size() != a.size())
      throw OptionError(
          key, "has " + counted(stated->size(), "coordinate") + ", but the domain has " + std::to_string(a.size()));
    if (stated && !stated->allFinite()) throw OptionError(key, "must be finite");
    if (stated) return *stated;
    return own != nullptr && own->size() > 0 ? *own : Eigen::VectorXd::Constant(a.size(), std::nan("")).eval();
  };
  LatticeBox box{side(lower, domain != nullptr ? &domain->box_lower() : nullptr, "lower"),
                 side(upper, domain != nullptr ? &domain->box_upper() : nullptr, "upper"),
                 {},
                 {}};
  const double margin = (b - a).norm();
  for (Eigen::Index i = 0; i < a.size(); ++i) {
    box.open_lower.push_back(!std::isfinite(box.lower[i]));
    box.open_upper.push_back(!std::isfinite(box.upper[i]));
    if (box.open_lower.back()) box.lower[i] = std::min(a[i], b[i]) - margin;
    if (box.open_upper.back()) box.upper[i] = std::max(a[i], b[i]) + margin;
    if (!(box.lower[i] < box.upper[i])) throw OptionError("upper", "must be greater than lower in every coordinate");
  }
  return box;
}

void LatticeBox::widen() {
  for (Eigen::Index i = 0; i < lower.size(); ++i) {
    const double more = (upper[i] - lower[i]) / 2;
    if (open_lower[static_cast<std::size_t>(i)]) lower[i] -= more;
    if (open_upper[static_cast<std::size_t>(i)]) upper[i] += more;
  }
}

}  // namespace leastcost
