// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/chart/chart_images.hpp"

#include <algorithm>
#include <string>

namespace leastcost {
namespace {

constexpr double kSame = 1e-9;  ///< of the size of the coordinates

/// Calls visit(winding) for all windings up to one turn either way from `middle`, seam by seam.
template <class Visit>
void for_windings(const Eigen::VectorXi& middle, Visit visit) {
  Eigen::VectorXi winding = middle.array() - 1;
  for (;;) {
    visit(winding);
    Index s = 0;
    while (s < middle.size() && winding[s] == middle[s] + 1) {
      winding[s] = middle[s] - 1;
      ++s;
    }
    if (s == middle.size()) return;
    ++winding[s];
  }
}

std::string text_of(const Eigen::VectorXi& winding) {
  if (winding.size() == 0) return "";
  std::string text = "winding (";
  for (Index s = 0; s < winding.size(); ++s) text += (s > 0 ? ", " : "") + std::to_string(winding[s]);
  return text + ")";
}

/// u itself and what ways over one pole, or over two in turn, make of it.
std::vector<PointImage> over_poles(const std::vector<SeamMap>& poles, const Eigen::VectorXd& u) {
  std::vector<PointImage> all = {{u, ""}};
  const auto number = [](std::size_t i) { return std::to_string(i + 1); };
  for (std::size_t i = 0; i < poles.size(); ++i) {
    all.push_back({poles[i].apply(u), "over pole " + number(i)});
    for (std::size_t j = 0; j < poles.size(); ++j)
      if (j != i)
        all.push_back({poles[j].apply(poles[i].apply(u)), "over the poles " + number(i) + " and " + number(j)});
  }
  return all;
}

}  // namespace

std::vector<PointImage> chart_images(const std::vector<Seam>& seams, const std::vector<SeamMap>& poles,
                                     const Eigen::VectorXd& u, const Eigen::VectorXd& reference, std::size_t most) {
  std::vector<PointImage> all;
  const auto known = [&](const Eigen::VectorXd& x) {
    const auto same = [&](const Eigen::VectorXd& y) { return (x - y).norm() <= kSame * (1 + x.norm()); };
    return same(u) || std::any_of(all.begin(), all.end(), [&](const PointImage& image) { return same(image.u); });
  };
  for (const PointImage& base : over_poles(poles, u)) {
    for_windings(nearest_image(seams, base.u, reference), [&](const Eigen::VectorXi& winding) {
      PointImage image{seam_map(seams, static_cast<int>(u.size()), winding).apply(base.u), text_of(winding)};
      if (known(image.u)) return;
      if (!base.where.empty()) image.where += (image.where.empty() ? "" : " ") + base.where;
      all.push_back(std::move(image));
    });
  }
  std::stable_sort(all.begin(), all.end(), [&](const PointImage& a, const PointImage& b) {
    return (a.u - reference).norm() < (b.u - reference).norm();
  });
  if (all.size() > most) all.resize(most);
  return all;
}

Points continued(const HasImages& chart, const Points& u) {
  Points out = u;
  for (Index i = 1; i < u.cols(); ++i) {
    const Eigen::VectorXd before = out.col(i - 1);
    for (const PointImage& image : chart.images(u.col(i), before, 1))
      if ((image.u - before).norm() < (out.col(i) - before).norm()) out.col(i) = image.u;
  }
  return out;
}

}  // namespace leastcost
