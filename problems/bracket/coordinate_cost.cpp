// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/bracket/coordinate_cost.hpp>

#include <limits>
#include <utility>

namespace leastcost {

CoordinateCost::CoordinateCost(std::shared_ptr<const ConstraintManifold> domain,
                               std::shared_ptr<const SegmentCost> cost)
    : domain_(std::move(domain)), cost_(std::move(cost)) {}

Points CoordinateCost::places(const Eigen::Ref<const Eigen::Matrix2Xd>& u) const {
  const auto* chart = find_ability<HasChart>(*domain_);
  Points out(cost_->dim(), 3 * u.cols());
  Points x = u, jacobians;
  if (chart != nullptr) {
    const CoordinatePath path{u, {}, false};
    chart->embed(path, x);
    chart->jacobians(path, jacobians);
  }
  for (Index i = 0; i < u.cols(); ++i) {
    out.col(3 * i) = x.col(i);
    if (chart != nullptr)
      out.middleCols<2>(3 * i + 1) = jacobians.middleCols<2>(2 * i);
    else
      out.middleCols<2>(3 * i + 1).setIdentity();
  }
  return out;
}

void CoordinateCost::Element::move_to(const Eigen::Ref<const Points>& place) {
  x_ = place.col(0);
  jacobian_ = place.rightCols<2>();
  inside_ = place.allFinite();
}

double CoordinateCost::Element::operator()(const Eigen::Vector2d& v) const {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  if (!inside_) return kInfinity;
  velocity_.noalias() = jacobian_ * v;
  const double f = cost_.line_element(x_, velocity_);
  return f > 0 ? f : kInfinity;  // NaN as well
}

namespace {

/// With places between the vertices, so that no piece is longer than a part of the whole.
Eigen::Matrix2Xd in_pieces(const Eigen::Ref<const Eigen::Matrix2Xd>& u) {
  constexpr double kPieces = 512;
  const Index moves = u.cols() - 1;
  const Eigen::VectorXd lengths = (u.rightCols(moves) - u.leftCols(moves)).colwise().norm();
  const double most = lengths.sum() / kPieces;
  if (!(most > 0)) return u;
  Eigen::Matrix<Index, Eigen::Dynamic, 1> pieces = (lengths / most).array().ceil().max(1).cast<Index>();
  Eigen::Matrix2Xd out(2, pieces.sum() + 1);
  Index column = 0;
  for (Index i = 0; i < moves; ++i)
    for (Index k = 0; k < pieces[i]; ++k)
      out.col(column++) =
          u.col(i) + static_cast<double>(k) / static_cast<double>(pieces[i]) * (u.col(i + 1) - u.col(i));
  out.col(column) = u.col(moves);
  return out;
}

}  // namespace

double polyline_cost(const CoordinateCost& cost, const Eigen::Ref<const Eigen::Matrix2Xd>& polyline) {
  const Eigen::Matrix2Xd u = in_pieces(polyline);
  const Index moves = u.cols() - 1;
  const Eigen::Matrix2Xd middles = 0.5 * (u.leftCols(moves) + u.rightCols(moves));
  const Points corners = cost.places(u), between = cost.places(middles);
  CoordinateCost::Element element(cost);
  double sum = 0;
  for (Index i = 0; i < moves; ++i) {
    const Eigen::Vector2d v = u.col(i + 1) - u.col(i);
    if (v.isZero(0)) continue;
    const auto at = [&](const Points& places, Index k) {
      element.move_to(places.middleCols<3>(3 * k));
      return element(v);
    };
    sum += (at(corners, i) + 4 * at(between, i) + at(corners, i + 1)) / 6;
  }
  return sum;
}

}  // namespace leastcost
