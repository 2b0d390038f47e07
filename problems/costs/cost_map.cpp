// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/costs/cost_map.hpp>

#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/cost/segment_cost_function.hpp>
#include <leastcost/framework/domain/has_blocks.hpp>
#include <leastcost/problems/bracket/cost_density.hpp>
#include <leastcost/problems/chart/is_geographic.hpp>
#include <leastcost/problems/raster/has_raster.hpp>
#include <leastcost/problems/raster/has_voids.hpp>
#include "framework/base/point_text.hpp"
#include "problems/costs/cell_cost.hpp"
#include "problems/costs/raster_density.hpp"
#include "problems/raster/has_cell_index.hpp"
#include "problems/raster/raster_cells.hpp"

namespace leastcost {
namespace {

/// The value at a place from value and derivatives there: exact for as many derivatives as S has, up to the second.
template <class S>
S lifted(const PlaneJet& jet, const S& x, const S& y) {
  if constexpr (std::is_same_v<S, double>) {
    return jet.value;
  } else {
    const S dx = x - S(innermost(x)), dy = y - S(innermost(y));
    return S(jet.value) + dx * jet.gradient[0] + dy * jet.gradient[1] + dx * dx * (0.5 * jet.hessian(0, 0)) +
           dx * dy * jet.hessian(0, 1) + dy * dy * (0.5 * jet.hessian(1, 1));
  }
}

template <int D>
struct CostMap {
  static constexpr int dim = D;
  std::shared_ptr<const RasterFunction> n;

  /// Exact for straight moves, but the least-cost chain is equal in its costs to second order only.
  CostTraits traits() const { return {.unit = "cost", .symmetric = true}; }

  /// The mean of n along the move: the polynomial on each patch integrated exactly.
  template <class S>
  S mean(const Point<S, D>& a, const Point<S, D>& b) const {
    const RasterPatches& patches = n->patches();
    const PatchQuadrature rule = n->quadrature();
    const Eigen::Matrix<S, 2, 1> from = patches.in_cells(a[0], a[1]), to = patches.in_cells(b[0], b[1]);
    S sum(0.0);
    const bool known = patches.cut(from, to, [&](const RasterPatch& patch, const S& begin, const S& end) {
      const S length = end - begin;
      for (std::size_t k = 0; k < rule.nodes.size(); ++k) {
        const S t = begin + rule.nodes[k] * length;
        const S column = from[0] + t * (to[0] - from[0]), row = from[1] + t * (to[1] - from[1]);
        const PlaneJet jet = n->in_patch(patch, innermost(column), innermost(row));
        sum += rule.weights[k] * length * lifted<S>(jet, S(column * patches.cell()[0]), S(row * patches.cell()[1]));
      }
    });
    return known ? sum : S(std::numeric_limits<double>::infinity());
  }

  template <class S>
  S value(const Point<S, D>& a, const Point<S, D>& b) const {
    const S by = mean<S>(a, b);
    if (!std::isfinite(innermost(by))) return S(std::numeric_limits<double>::infinity());
    return by * by * (b - a).squaredNorm();
  }
  double line_element(const Eigen::VectorXd& x, const Eigen::VectorXd& v) const {
    const double factor = n->at(x[0], x[1]).value;
    return std::isfinite(factor) ? factor * v.norm() : std::numeric_limits<double>::infinity();
  }
  /// Names the first end or, between them, the first place of many that is not known.
  std::string why_infinite(const Eigen::VectorXd& a, const Eigen::VectorXd& b) const {
    constexpr int kPlaces = 1000;
    for (int i = 0; i <= kPlaces; ++i) {
      const Eigen::VectorXd x = a + (b - a) * i / kPlaces;
      std::string why = n->patches().why_unknown(x[0], x[1]);
      if (!why.empty()) return why;
    }
    return "";
  }
};

template <int D>
class CostMapCost final : public SegmentCostOf<CostMap<D>>,
                          public HasCellIndex,
                          public CostDensity,
                          public HasRaster,
                          public HasRasterCells,
                          public HasVoids,
                          public IsGeographic {
 public:
  CostMapCost(std::shared_ptr<const RasterFunction> n, RasterGrid values)
      : SegmentCostOf<CostMap<D>>(CostMap<D>{n}), n_(std::move(n)), values_(std::move(values)) {}
  double cost_over_cells(const Eigen::Ref<const Eigen::MatrixXd>& curve) const override {
    return leastcost::cost_over_cells(values_, curve);
  }
  const RasterGrid& raster() const override { return values_; }
  Eigen::Vector2d longitude_latitude(const Eigen::VectorXd& u) const override {
    return values_.longitude_latitude(u.head<2>());
  }
  std::string place_note() const override { return values_.place_note(); }
  Eigen::VectorXd coordinates_of(const Eigen::Vector2d& lonlat) const override { return values_.place_of(lonlat); }
  const RasterPatches& patches() const override { return n_->patches(); }
  const RasterPatches& known_patches() const override { return n_->patches(); }
  PatchBounds bounds(const RasterPatch& patch) const override { return n_->bounds(patch); }
  PlaneJet index(double x, double y) const override { return n_->at(x, y); }
  std::optional<std::array<double, 4>> corners(const RasterPatch& patch) const override { return n_->corners(patch); }
  double density(const Eigen::Vector2d& x) const override { return n_->at(x[0], x[1]).value; }
  DensityEnclosure enclose_density(const Eigen::AlignedBox2d& cell) const override { return enclose_over(*n_, cell); }

 private:
  bool has_raster() const override { return D == 2; }
  bool is_geographic() const override { return D == 2 && values_.on_earth(); }

  std::shared_ptr<const RasterFunction> n_;
  RasterGrid values_;  // without its values
};

void check_positive(const RasterGrid& values) {
  for (int row = values.rows - 1; row >= 0; --row)
    for (int column = 0; column < values.columns; ++column)
      if (values.value(row, column) <= 0)
        throw OptionError("file", values.name_of(row, column) + ": the cost per unit of length is " +
                                      short_number(values.value(row, column), 9) +
                                      "; it must be greater than 0. If this value marks missing data, set nodata: " +
                                      short_number(values.value(row, column), 9));
}

}  // namespace

Words<CostMapInterpolation> words(CostMapInterpolation) {
  static constexpr std::array<Word<CostMapInterpolation>, 4> kWords = {{{CostMapInterpolation::automatic, "auto"},
                                                                        {CostMapInterpolation::cells, "cells"},
                                                                        {CostMapInterpolation::bilinear, "bilinear"},
                                                                        {CostMapInterpolation::smooth, "smooth"}}};
  return kWords;
}

void CostMapOptions::fields(FieldVisitor& visit) {
  raster.fields(visit);
  visit.choice("interpolation", interpolation,
               {.help = "cells: constant in each cell. bilinear: through the values, with kinks between cells. smooth: "
                        "the bicubic spline with the values as coefficients, without kinks and smoother than the "
                        "values. auto: cells for a path between two ends in the plane without obstacles, unless a "
                        "solver, a post-processor or a clearance is given; otherwise smooth."});
}

std::shared_ptr<const SegmentCost> make_cost_map(const RasterGrid& values, CostMapInterpolation interpolation,
                                                 int dim) {
  if (dim != 2 && dim != 3)
    throw OptionError("type", "'cost_map' needs points in the plane or in space, but these points have " +
                                  std::to_string(dim) + " coordinates");
  check_positive(values);
  if (interpolation == CostMapInterpolation::cells) return make_cell_cost(values, dim);
  std::shared_ptr<const RasterFunction> n;
  if (interpolation == CostMapInterpolation::bilinear)
    n = std::make_shared<const BilinearFunction>(values);
  else
    n = std::make_shared<const SplineFunction>(SplineFunction::near(values));
  if (dim == 2) return std::make_shared<const CostMapCost<2>>(std::move(n), values);
  return std::make_shared<const CostMapCost<3>>(std::move(n), values);
}

std::string why_no_map_of(const ConstraintManifold* domain) {
  if (domain == nullptr || domain->dimensions().tangent != 3 || find_ability<HasBlocks>(*domain) != nullptr) return "";
  return "a cost map has values over a plane, but the points of this manifold fill space, where it would be the same "
         "at every height: use the plane or a surface (a terrain, say), or a cost in x, y and z (refractive_index, "
         "formula)";
}

}  // namespace leastcost
