// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "framework/energy/curve_value.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "framework/base/gauss.hpp"
#include "framework/domain/around_pole.hpp"

namespace leastcost {
namespace {

/// Cubic Lagrange weights at parameter t for nodes 0, 1, 2, 3, and their derivatives.
void cubic(double t, Eigen::Vector4d& w, Eigen::Vector4d& dw) {
  const double a = t, b = t - 1, c = t - 2, d = t - 3;
  w << -b * c * d / 6, a * c * d / 2, -a * b * d / 2, a * b * c / 6;
  dw << -(c * d + b * d + b * c) / 6, (c * d + a * d + a * c) / 2, -(b * d + a * d + a * b) / 2,
      (b * c + a * c + a * b) / 6;
}

/// The line element of a cost at points given in coordinates.
class LineElement {
 public:
  explicit LineElement(const Problem& problem) : problem_(problem), chart_(find_ability<HasChart>(*problem.manifold)) {}

  /// At the only column of `point`, for a velocity in coordinates.
  double operator()(const CoordinatePath& point, const Eigen::VectorXd& velocity) {
    if (chart_ == nullptr) return problem_.cost->line_element(point.u, velocity);
    chart_->embed(point, x_);
    chart_->jacobians(point, jacobian_);
    return problem_.cost->line_element(x_, jacobian_ * velocity);
  }

 private:
  const Problem& problem_;
  const HasChart* chart_;
  Points x_, jacobian_;
};

/// Cost of the line a -> b in coordinates, which in its middle is off the straight one by `sag`; +infinity where it
/// leaves the domain.
double bent_cost(const Problem& problem, LineElement& element, const Eigen::VectorXd& a, const Eigen::VectorXd& b,
                 const Eigen::VectorXd& sag) {
  CoordinatePath point{a, {}, true};
  double sum = 0;
  for (std::size_t g = 0; g < kGaussNodes.size(); ++g) {
    const double t = kGaussNodes[g];
    point.u = a + t * (b - a) + 4 * t * (1 - t) * sag;
    if (problem.manifold->residual(point) > 0) return std::numeric_limits<double>::infinity();
    sum += kGaussWeights[g] * element(point, b - a + 4 * (1 - 2 * t) * sag);
  }
  return sum;
}

double straight_cost(const Problem& problem, LineElement& element, const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  return bent_cost(problem, element, a, b, Eigen::VectorXd::Zero(a.size()));
}

/// Beside a pole what is straight on the domain is bent in the chart, towards the pole.
double cost_beside_pole(const Problem& problem, LineElement& element, const SeamMap& pole, const Eigen::VectorXd& a,
                        const Eigen::VectorXd& b) {
  Eigen::VectorXd to_pole = Eigen::VectorXd::Zero(a.size());  // the map mirrors at the pole
  for (Index k = 0; k < a.size(); ++k)
    if (pole.sign[k] < 0) to_pole[k] = pole.shift[k] / 2 - (a[k] + b[k]) / 2;
  double least = std::numeric_limits<double>::infinity();
  for (const double part : {0.25, 0.5, 0.75})
    least = std::min(least, bent_cost(problem, element, a, b, part * to_pole));
  return least;
}

/// Cost of the cubic through four points from node `first` to the next, beside a pole of the chart: the cubic is
/// that of coordinates which are smooth there. Nothing away from poles, and where that cubic leaves the domain.
std::optional<double> cost_around_pole(const Problem& problem, LineElement& element, const Points& four, double first) {
  const auto* chart = find_ability<HasChart>(*problem.manifold);
  const std::optional<AroundPole> around = chart != nullptr ? AroundPole::of(*chart, four) : std::nullopt;
  if (!around) return std::nullopt;
  const Points p = around->flat(four);
  Eigen::Vector4d w, dw;
  CoordinatePath point{Points(2, 1), {}, true};
  double sum = 0;
  for (std::size_t g = 0; g < kGaussNodes.size(); ++g) {
    cubic(first + kGaussNodes[g], w, dw);
    Eigen::Vector2d u, velocity;
    around->chart_of(p * w, p * dw, u, velocity);
    point.u = u;
    if (problem.manifold->residual(point) > 0) return std::nullopt;
    sum += kGaussWeights[g] * element(point, velocity);
  }
  return sum;
}

}  // namespace

std::optional<double> smooth_curve_cost(const Problem& problem, const CoordinatePath& path, const Deadline& deadline) {
  const Index columns = path.u.cols();
  const bool chart = find_ability<HasChart>(*problem.manifold) != nullptr;
  if ((problem.manifold->shape() != Shape::flat && !chart) || columns < 4) return std::nullopt;
  CoordinatePath point{Points(path.u.rows(), 1), {}, true};
  LineElement element(problem);
  const auto line_element = [&](const Eigen::VectorXd& velocity) { return element(point, velocity); };
  if (!path.ring) {
    point.u = path.u.col(0);
    if (!std::isfinite(line_element(path.u.col(1) - path.u.col(0)))) return std::nullopt;
    point.u = path.u.col(columns - 1);
    if (!std::isfinite(line_element(path.u.col(columns - 1) - path.u.col(columns - 2)))) return std::nullopt;
  }
  double sum = 0;
  Eigen::Vector4d w, dw;
  Points four(path.u.rows(), 4);
  // Where the cubic leaves the domain (it overshoots where the path comes to rest on a bound) the nearest curve inside
  // takes its place.
  CoordinatePath ahead = point, behind = point;
  const auto inside = [&](double t, CoordinatePath& at) {
    cubic(t, w, dw);
    at.u = four * w;
    return problem.manifold->project(at);
  };
  const auto element_inside = [&](double t) {
    constexpr double kStep = 1e-4;  // of a segment: rounding of a central difference below 1e-11, truncation 1e-8
    if (!inside(t + kStep, ahead).failed.empty() || !inside(t - kStep, behind).failed.empty() ||
        !inside(t, point).failed.empty())
      return std::numeric_limits<double>::quiet_NaN();
    return line_element((ahead.u - behind.u) / (2 * kStep));
  };
  for (Index i = 0; i < path.segment_count(); ++i) {
    look_at_clock(deadline);
    const Index begin = path.ring ? i - 1 : std::clamp<Index>(i - 1, 0, columns - 4);
    for (Index j = 0; j < 4; ++j) four.col(j) = path.column(begin + j);
    if (const std::optional<double> around = cost_around_pole(problem, element, four, static_cast<double>(i - begin))) {
      sum += *around;
      continue;
    }
    for (std::size_t g = 0; g < kGaussNodes.size(); ++g) {
      const double t = static_cast<double>(i - begin) + kGaussNodes[g];
      cubic(t, w, dw);
      point.u = four * w;
      sum += kGaussWeights[g] * (problem.manifold->residual(point) > 0 ? element_inside(t) : line_element(four * dw));
    }
  }
  return std::isfinite(sum) ? std::optional(sum) : std::nullopt;
}

ChartJump worst_chart_jump(const Problem& problem, const CoordinatePath& path, const Eigen::VectorXd& costs,
                           const Deadline& deadline) {
  const auto* chart = find_ability<HasChart>(*problem.manifold);
  LineElement element(problem);
  ChartJump worst;
  if (chart == nullptr) return worst;
  for (Index i = 0; i < path.segment_count(); ++i) {
    look_at_clock(deadline);
    const Eigen::VectorXd a = path.column(i), b = path.column(i + 1);
    double direct = straight_cost(problem, element, a, b);
    for (const SeamMap& pole : chart->poles())
      direct =
          std::min({direct, straight_cost(problem, element, a, pole.apply(b)),
                    straight_cost(problem, element, a, pole.undo(b)), cost_beside_pole(problem, element, pole, a, b)});
    const double ratio = direct / costs[i];
    if (ratio > worst.ratio) worst = {ratio, i};
  }
  return worst;
}

}  // namespace leastcost
