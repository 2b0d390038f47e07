// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/chart/target_images.hpp>

#include <cmath>
#include <cstddef>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/problems/chart/seams.hpp>

namespace leastcost {

namespace {

/// Refuses more images than anybody waits for; counted in doubles, which do not overflow.
void check_count(int turns, Index seams, std::size_t poles) {
  if (turns < 0) throw OptionError("windings", "must be at least 0, not " + std::to_string(turns));
  const auto count = [&](int t) {
    return std::pow(2.0 * t + 1, static_cast<double>(seams)) * static_cast<double>(1 + poles);
  };
  if (count(turns) <= static_cast<double>(kMostTargetImages)) return;
  int most = 0;
  while (count(most + 1) <= static_cast<double>(kMostTargetImages)) ++most;
  throw OptionError("windings", std::to_string(turns) + " turns across " + std::to_string(seams) +
                                    " seams and over the poles make more than " + std::to_string(kMostTargetImages) +
                                    " images of the target; use at most " + std::to_string(most) + " turns");
}

}  // namespace

std::vector<TargetImage> target_images(const Problem& problem, int turns) {
  std::vector<TargetImage> all;
  const auto* domain = find_ability<HasSeams>(*problem.manifold);
  if (domain == nullptr || problem.ring) return all;
  const std::vector<Seam>& seams = domain->seams();
  const auto* chart = find_ability<HasChart>(*problem.manifold);
  const std::vector<SeamMap> poles = chart != nullptr ? chart->poles() : std::vector<SeamMap>();
  const auto count = static_cast<Index>(seams.size());
  if (count > 0) check_count(turns, count, poles.size());
  Eigen::VectorXi winding = Eigen::VectorXi::Constant(count, -turns);
  const auto next = [&] {  // counts through all of -turns .. turns
    for (Index s = 0; s < count; ++s) {
      if (++winding[s] <= turns) return true;
      winding[s] = -turns;
    }
    return false;
  };
  do {
    std::string name;  // empty on a chart without seams
    for (Index i = 0; i < count; ++i) name += (i ? ", " : "(") + std::to_string(winding[i]);
    if (count > 0) name += ")";
    const SeamMap map = seam_map(seams, static_cast<int>(problem.target.u.size()), winding);
    const auto add = [&](const Eigen::VectorXd& target, const std::string& where, bool given) {
      TargetImage image{problem, name + where};
      image.problem.target.u = map.apply(target);
      all.insert(given ? all.begin() : all.end(), std::move(image));
    };
    add(problem.target.u, "", winding.isZero());
    for (std::size_t i = 0; i < poles.size(); ++i)
      add(poles[i].apply(problem.target.u), " over pole " + std::to_string(i + 1), false);
  } while (next());
  return all;
}

}  // namespace leastcost
