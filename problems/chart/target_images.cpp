// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/chart/target_images.hpp>

#include <leastcost/problems/chart/seams.hpp>

namespace leastcost {

std::vector<TargetImage> target_images(const Problem& problem, int turns) {
  std::vector<TargetImage> all;
  const auto* domain = find_ability<HasSeams>(*problem.manifold);
  if (domain == nullptr || problem.ring) return all;
  const std::vector<Seam>& seams = domain->seams();
  const auto* chart = find_ability<HasChart>(*problem.manifold);
  const std::vector<SeamMap> poles = chart != nullptr ? chart->poles() : std::vector<SeamMap>();
  const auto count = static_cast<Index>(seams.size());
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
