// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// A chart, sampled on a grid of its two coordinates.
#include <algorithm>
#include <cmath>
#include <limits>

#include <leastcost/problems/chart/seams.hpp>
#include "problems/drawing/domain_shapes.hpp"

namespace leastcost {
namespace {

constexpr double kMostCells = 9000;
constexpr double kPadding = 0.3;  ///< put on each side where the surface goes on, in parts of the extent of the path

struct ShownRange {
  double from = 0, to = 0;
  double length() const { return to - from; }
  double at(Index i, Index cells) const {
    return from + length() * static_cast<double>(i) / static_cast<double>(cells);
  }
};

/// Mean length of dx/du_c over the columns, where it is finite.
double stretch(const HasChart& chart, const Points& u, Index c) {
  Points j;
  chart.jacobians({u, {}, true}, j);
  double sum = 0, count = 0;
  for (Index i = 0; i < u.cols(); ++i) {
    const double length = j.col(u.rows() * i + c).norm();
    if (std::isfinite(length)) sum += length, ++count;
  }
  return count > 0 ? sum / count : 0;
}

class ChartExtent {
 public:
  ChartExtent(const ConstraintManifold& manifold, const HasChart& chart, const Points& u)
      : chart_(chart), path_(around(u)), bounds_(unbounded(u.rows())), u_(u) {
    if (find_ability<HasBounds>(manifold) != nullptr) bounds_ = coordinate_bounds(manifold, u.col(0));
    if (const auto* domain = find_ability<HasSeams>(manifold)) seams_ = domain->seams();
    Points x;
    chart.embed({u, {}, true}, x);
    size_ = around(x).extent().norm();
  }

  ShownRange interval(Index c) const {
    for (const Seam& seam : seams_)
      if (seam.coordinate == c) return {0, seam.period};
    std::vector<double> poles;
    for (const SeamMap& pole : chart_.poles())
      if (pole.sign[c] < 0) poles.push_back(pole.shift[c] / 2);
    if (poles.size() > 1)
      return {*std::min_element(poles.begin(), poles.end()), *std::max_element(poles.begin(), poles.end())};
    if (poles.size() == 1) return beyond(c, poles[0]);
    return within_bounds(c);
  }

 private:
  static Surroundings unbounded(Index n) {
    const double infinity = std::numeric_limits<double>::infinity();
    return {Eigen::VectorXd::Constant(n, -infinity), Eigen::VectorXd::Constant(n, infinity)};
  }

  double padding(Index c) const {
    const double rate = stretch(chart_, u_, c);
    return kPadding * std::max(path_.extent()[c], rate > 0 ? size_ / rate : 0);
  }

  ShownRange beyond(Index c, double pole) const {
    const double reach = std::max(std::abs(path_.lower[c] - pole), std::abs(path_.upper[c] - pole));
    return {pole, std::min(pole + reach + padding(c), bounds_.upper[c])};
  }

  ShownRange within_bounds(Index c) const {
    ShownRange shown{path_.lower[c] - padding(c), path_.upper[c] + padding(c)};
    // Bounds that are not far away are shown, and what a seam turns over is shown on both sides of zero.
    const double more = shown.length();
    if (bounds_.lower[c] > shown.from - more) shown.from = bounds_.lower[c];
    if (bounds_.upper[c] < shown.to + more) shown.to = bounds_.upper[c];
    const bool flipped = std::any_of(seams_.begin(), seams_.end(), [c](const Seam& s) { return s.flipped == c; });
    if (!flipped) return shown;
    const double reach = std::max(std::abs(shown.from), std::abs(shown.to));
    return {-reach, reach};
  }

  const HasChart& chart_;
  Surroundings path_, bounds_;
  const Points& u_;
  std::vector<Seam> seams_;
  double size_ = 0;
};

Points grid_of(const ShownRange& u, const ShownRange& v, Index columns, Index rows) {
  Points nodes(2, (columns + 1) * (rows + 1));
  for (Index j = 0; j <= rows; ++j)
    for (Index i = 0; i <= columns; ++i) nodes.col(j * (columns + 1) + i) << u.at(i, columns), v.at(j, rows);
  return nodes;
}

}  // namespace

TriangleSoup chart_surface(const ConstraintManifold& manifold, const HasChart& chart, const Points& u) {
  if (u.rows() != 2) return {};
  const ChartExtent extent(manifold, chart, u);
  const ShownRange first = extent.interval(0), second = extent.interval(1);
  const Points coarse = grid_of(first, second, 9, 9);
  const double ratio = first.length() * stretch(chart, coarse, 0) / (second.length() * stretch(chart, coarse, 1));
  const double wanted = std::isfinite(ratio) && ratio > 0 ? std::sqrt(kMostCells * ratio) : std::sqrt(kMostCells);
  const auto columns = static_cast<Index>(std::clamp(wanted, 24.0, 360.0));
  const auto rows = static_cast<Index>(std::clamp(kMostCells / static_cast<double>(columns), 24.0, 360.0));

  Points x;
  chart.embed({grid_of(first, second, columns, rows), {}, true}, x);
  TriangleSoup out;
  for (const auto column : x.colwise())
    out.vertices.push_back(column.allFinite() ? Eigen::Vector3d(column) : Eigen::Vector3d(Eigen::Vector3d::Zero()));
  const auto add = [&](Index a, Index b, Index c) {
    if (x.col(a).allFinite() && x.col(b).allFinite() && x.col(c).allFinite())
      out.triangles.push_back({static_cast<int>(a), static_cast<int>(b), static_cast<int>(c)});
  };
  for (Index j = 0; j < rows; ++j)
    for (Index i = 0; i < columns; ++i) {
      const Index a = j * (columns + 1) + i, b = a + 1, c = a + columns + 1, d = c + 1;
      add(a, b, d);
      add(a, d, c);
    }
  return out;
}

}  // namespace leastcost
