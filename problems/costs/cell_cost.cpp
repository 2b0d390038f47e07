// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/costs/cell_cost.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/cost/has_interfaces.hpp>
#include <leastcost/framework/cost/segment_cost_function.hpp>
#include <leastcost/problems/chart/is_geographic.hpp>
#include <leastcost/problems/raster/has_raster.hpp>
#include "problems/cells/beside_sides.hpp"
#include "problems/cells/cell_refraction.hpp"
#include "problems/cells/has_cost_cells.hpp"
#include "problems/raster/raster_cells.hpp"
#include "problems/raster/raster_patches.hpp"

namespace leastcost {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr double kOnSide = 1e-9;  ///< of a cell: what lies this near to a side lies on it, as in cost_over_cells

constexpr double kUlps = 4 * std::numeric_limits<double>::epsilon();  ///< of a coordinate

struct CellCostFunction {
  static constexpr int dim = 2;
  std::shared_ptr<const CellMap> map;

  CostTraits traits() const { return {.unit = "cost", .symmetric = true, .additive = true}; }

  /// The mean of the values along the move, with the derivatives of the shares at which it crosses sides.
  template <class S>
  S value(const Point<S, 2>& a, const Point<S, 2>& b) const {
    std::vector<S> shares = {S(0.0), S(1.0)};
    for (const int axis : {0, 1}) add_crossings<S>(axis, a[axis], b[axis], shares);
    std::sort(shares.begin(), shares.end(), [](const S& p, const S& q) { return innermost(p) < innermost(q); });
    const Eigen::Vector2d from(innermost(a[0]), innermost(a[1])), to(innermost(b[0]), innermost(b[1]));
    S mean(0.0);
    for (std::size_t k = 0; k + 1 < shares.size(); ++k) {
      const double begin = innermost(shares[k]), end = innermost(shares[k + 1]);
      if (!(end > begin)) continue;
      const double unit = unit_at(from + 0.5 * (begin + end) * (to - from));
      if (!(unit < kInfinite)) return S(kInfinite);
      mean += unit * (shares[k + 1] - shares[k]);
    }
    return mean * mean * (b - a).squaredNorm();
  }
  double line_element(const Eigen::VectorXd& x, const Eigen::VectorXd& v) const { return unit_at(x) * v.norm(); }
  std::string why_infinite(const Eigen::VectorXd& a, const Eigen::VectorXd& b) const {
    constexpr int kPlaces = 1000;
    for (int i = 0; i <= kPlaces; ++i)
      if (std::string why = map->why_no_end(a + (b - a) * i / kPlaces); !why.empty()) return why;
    return "";
  }

 private:
  template <class S>
  void add_crossings(int axis, const S& from, const S& to, std::vector<S>& shares) const {
    const std::vector<double>& lines = map->lines(axis);
    const double low = std::min(innermost(from), innermost(to)), high = std::max(innermost(from), innermost(to));
    const auto end = std::lower_bound(lines.begin(), lines.end(), high);
    for (auto line = std::upper_bound(lines.begin(), lines.end(), low); line < end; ++line)
      shares.push_back((S(*line) - from) / (to - from));
  }
  /// Of the cheapest cell that a place is in, or as good as beside.
  double unit_at(const Eigen::Vector2d& x) const {
    const std::vector<double>&along = map->lines(0), &up = map->lines(1);
    const double dx = std::max(kOnSide * (along[1] - along[0]), kUlps * std::abs(x[0])),
                 dy = std::max(kOnSide * (up[1] - up[0]), kUlps * std::abs(x[1]));
    double least = kInfinite;
    for (const double px : {x[0] - dx, x[0] + dx})
      for (const double py : {x[1] - dy, x[1] + dy}) {
        const CellRange columns = map->touched(0, px), rows = map->touched(1, py);
        if (!columns.empty() && !rows.empty()) least = std::min(least, map->unit(rows.last, columns.last));
      }
    return least;
  }
};

class CellCost final : public SegmentCostOf<CellCostFunction>,
                       public HasCostCells,
                       public HasInterfaces,
                       public HasRaster,
                       public HasRasterCells,
                       public IsGeographic {
 public:
  explicit CellCost(const RasterGrid& values)
      : SegmentCostOf<CellCostFunction>(CellCostFunction{std::make_shared<const CellMap>(values)}), values_(values) {}
  const CellMap& cell_map() const override { return *function().map; }
  std::vector<Crossing> crossings(const Points& polyline, const ConstraintManifold& domain) const override {
    const CellMap map = cells_in_box(*this, domain);
    return measure_cell_crossings(map, onto_sides(map, polyline));
  }
  double cost_over_cells(const Eigen::Ref<const Eigen::MatrixXd>& curve) const override {
    return leastcost::cost_over_cells(values_, curve);
  }
  const RasterGrid& raster() const override { return values_; }
  Eigen::Vector2d longitude_latitude(const Eigen::VectorXd& u) const override {
    return values_.longitude_latitude(u.head<2>());
  }
  std::string place_note() const override { return values_.place_note(); }
  Eigen::VectorXd coordinates_of(const Eigen::Vector2d& lonlat) const override { return values_.place_of(lonlat); }

 private:
  bool is_geographic() const override { return values_.on_earth(); }

  RasterGrid values_;
};

}  // namespace

std::shared_ptr<const SegmentCost> make_cell_cost(const RasterGrid& values, int dim) {
  if (dim != 2)
    throw OptionError("interpolation", "'cells' works in the plane only; in space, use 'smooth' or 'bilinear'");
  check_sound_cells(values);
  return std::make_shared<const CellCost>(values);
}

}  // namespace leastcost
