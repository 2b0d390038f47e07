// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/chart/seams.hpp>

#include <cmath>
#include <limits>

namespace leastcost {

SeamMap seam_map(const std::vector<Seam>& seams, int dimension, const Eigen::VectorXi& windings) {
  SeamMap map{Eigen::VectorXd::Ones(dimension), Eigen::VectorXd::Zero(dimension)};
  for (std::size_t s = 0; s < seams.size(); ++s) {
    const int turns = windings[static_cast<Index>(s)];
    map.shift[seams[s].coordinate] += turns * seams[s].period;
    if (seams[s].flipped && turns % 2 != 0) map.sign[*seams[s].flipped] *= -1;
  }
  return map;
}

Eigen::VectorXi nearest_image(const std::vector<Seam>& seams, const Eigen::VectorXd& u, const Eigen::VectorXd& near) {
  const auto count = static_cast<Index>(seams.size());
  const int dimension = static_cast<int>(u.size());
  Eigen::VectorXi best = Eigen::VectorXi::Zero(count), turns = best;
  double least = std::numeric_limits<double>::infinity();
  // A flip depends on the parity of another seam's turns: both parities are tried, each with the best turns of the
  // rest.
  for (int parities = 0; parities < 1 << count; ++parities) {
    for (Index s = 0; s < count; ++s) turns[s] = parities >> s & 1;
    const SeamMap flips = seam_map(seams, dimension, turns);
    for (Index s = 0; s < count; ++s) {
      const Seam& seam = seams[static_cast<std::size_t>(s)];
      const double off = near[seam.coordinate] - flips.sign[seam.coordinate] * u[seam.coordinate];
      turns[s] += 2 * static_cast<int>(std::lround((off / seam.period - turns[s]) / 2));
    }
    const double distance = (seam_map(seams, dimension, turns).apply(u) - near).norm();
    if (distance >= least) continue;
    least = distance;
    best = turns;
  }
  return best;
}

}  // namespace leastcost
