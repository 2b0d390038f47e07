// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/costs/combined_cost.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/cost/has_conformal_metric.hpp>
#include <leastcost/framework/cost/has_constant_metric.hpp>
#include <leastcost/framework/cost/has_interfaces.hpp>
#include <leastcost/framework/cost/has_notes.hpp>
#include <leastcost/framework/cost/regularized.hpp>
#include <leastcost/problems/costs/metric_tensor.hpp>
#include "problems/costs/derived_cost.hpp"
#include "problems/formula/coordinate_names.hpp"
#include "problems/formula/formula.hpp"

namespace leastcost {
namespace {

using Terms = std::vector<WeightedCost>;

template <class Holds>
bool all_terms(const Terms& terms, Holds holds) {
  return std::all_of(terms.begin(), terms.end(), holds);
}

/// Whether all are lengths under multiples of one metric.
bool are_conformal(const Terms& terms) {
  const auto* first = find_ability<HasConformalMetric>(*terms.front().cost);
  return first != nullptr && all_terms(terms, [&](const WeightedCost& t) {
           const auto* other = find_ability<HasConformalMetric>(*t.cost);
           return other != nullptr && other->base() == first->base();
         });
}

CostTraits traits_of_sum(const Terms& terms) {
  const auto all = [&](bool CostTraits::*trait) {
    return all_terms(terms, [&](const WeightedCost& t) { return t.cost->traits().*trait; });
  };
  CostTraits out{.unit = terms.front().cost->traits().unit,
                 .symmetric = all(&CostTraits::symmetric),
                 .additive = all(&CostTraits::additive),
                 .below_curves = all(&CostTraits::below_curves),
                 .quadratic_at_rest = terms.size() == 1 ? all(&CostTraits::quadratic_at_rest) : are_conformal(terms)};
  if (!all_terms(terms, [&](const WeightedCost& t) { return t.cost->traits().unit == out.unit; })) out.unit = "cost";
  return out;
}

std::vector<std::string> notes_of(const SegmentCost& cost) {
  const auto* told = find_ability<HasNotes>(cost);
  return told != nullptr ? told->notes() : std::vector<std::string>();
}

class SumCost : public DerivedCost, public HasNotes {
 public:
  explicit SumCost(Terms terms)
      : DerivedCost(traits_of_sum(terms), terms.front().cost->dim()), terms_(std::move(terms)) {}

  const Terms& terms() const { return terms_; }

  void squared_costs(const AmbientPath& path, std::span<double> q) const override {
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(static_cast<Index>(q.size()));
    for (const WeightedCost& t : terms_) sum += t.weight * segment_costs(*t.cost, path);
    Eigen::Map<Eigen::VectorXd>(q.data(), sum.size()) = sum.cwiseAbs2();
  }
  double line_element(const Eigen::VectorXd& x, const Eigen::VectorXd& v) const override {
    double sum = 0;
    for (const WeightedCost& t : terms_) sum += t.weight * t.cost->line_element(x, v);
    return sum;
  }
  std::string why_infinite(const Eigen::VectorXd& a, const Eigen::VectorXd& b) const override {
    for (const WeightedCost& t : terms_) {
      const auto* explains = find_ability<ExplainsInfinity>(*t.cost);
      std::string why = explains != nullptr ? explains->why_infinite(a, b) : "";
      if (!why.empty()) return why;
    }
    return "";
  }
  std::vector<std::string> notes() const override {
    std::vector<std::string> all;
    for (const WeightedCost& t : terms_)
      for (std::string& note : notes_of(*t.cost)) all.push_back(std::move(note));
    return all;
  }

 private:
  SquaredCosts derive(const AmbientPath& path, bool with_hessians) const override {
    std::vector<SquaredCosts> parts;
    Index rows = 0;
    for (const WeightedCost& t : terms_)
      rows += parts.emplace_back(squared_costs_of(*t.cost, path, with_hessians)).residuals.rows();
    const Index n = path.segment_count(), width = 2 * dim();
    SquaredCosts out;
    out.q.resize(n);
    out.gradients.resize(width, n);
    out.residuals.resize(rows, n);
    out.jacobians.resize(rows, width * n);
    if (with_hessians) out.hessians.resize(width, width * n);
    for (Index i = 0; i < n; ++i) add_segment(parts, i, with_hessians, out);
    return out;
  }

  /// With c = sum w c_k: q = c^2, grad q = 2 c grad c, and grad c_k = grad q_k / (2 c_k), Hess c_k = (Hess q_k / 2 -
  /// grad c_k grad c_k') / c_k. A part that costs nothing there has no say. The residual has those of the parts below
  /// each other, r_k sqrt(w c / c_k), whose squares add up to c sum w c_k.
  void add_segment(const std::vector<SquaredCosts>& parts, Index i, bool with_hessians, SquaredCosts& out) const {
    double c = 0;
    for (std::size_t k = 0; k < parts.size(); ++k) c += terms_[k].weight * std::sqrt(parts[k].q[i]);
    const Index width = 2 * dim();
    Eigen::VectorXd slope = Eigen::VectorXd::Zero(width);
    Points bend = Points::Zero(width, width);
    for (std::size_t k = 0; k < parts.size(); ++k) {
      const double own = std::sqrt(parts[k].q[i]), w = terms_[k].weight;
      if (!(own > 0)) {
        if (with_hessians && c == 0) at_rest(parts, i, bend);
        continue;
      }
      const Eigen::VectorXd g = parts[k].gradients.col(i) / (2 * own);
      slope += w * g;
      if (with_hessians) bend += (w / own) * (parts[k].hessian(i) / 2 - g * g.transpose());
    }
    out.q[i] = c * c;
    out.gradients.col(i) = 2 * c * slope;
    if (with_hessians) out.hessian(i) = c > 0 ? Points(2 * (slope * slope.transpose() + c * bend)) : bend;
    stack_residuals(parts, i, c, slope, out);
  }

  /// Of a move from a place to itself q has a Hessian where all metrics are multiples of one: that of one times the
  /// square of the sum of all roots.
  void at_rest(const std::vector<SquaredCosts>& parts, Index i, Points& bend) const {
    double roots = 0;
    const double first = parts.front().hessian(i).trace();
    if (!traits().quadratic_at_rest || !(first > 0)) return;
    for (std::size_t k = 0; k < parts.size(); ++k)
      roots += terms_[k].weight * std::sqrt(parts[k].hessian(i).trace() / first);
    bend = roots * roots * parts.front().hessian(i);
  }

  void stack_residuals(const std::vector<SquaredCosts>& parts, Index i, double c, const Eigen::VectorXd& slope,
                       SquaredCosts& out) const {
    Index row = 0;
    for (std::size_t k = 0; k < parts.size(); ++k) {
      const Index rows = parts[k].residuals.rows();
      const double own = std::sqrt(parts[k].q[i]);
      auto r = out.residuals.col(i).segment(row, rows);
      auto jacobian = out.jacobian(i).middleRows(row, rows);
      row += rows;
      if (own > 0) {
        const double scale = std::sqrt(terms_[k].weight * c / own);
        const Eigen::RowVectorXd grows =
            0.5 * scale * (slope / c - parts[k].gradients.col(i) / (2 * own * own)).transpose();
        r = scale * parts[k].residuals.col(i);
        jacobian = scale * parts[k].jacobian(i);
        jacobian.noalias() += parts[k].residuals.col(i) * grows;
      } else {
        r.setZero();
        jacobian.setZero();
      }
    }
  }

  Terms terms_;
};

/// n = sum w_k n_k.
class ConformalSumCost final : public SumCost, public ConformalMetricBy<ConformalSumCost> {
 public:
  using SumCost::SumCost;
  Eigen::MatrixXd base() const override { return find_ability<HasConformalMetric>(*terms().front().cost)->base(); }

  template <class Jet>
  Jet squared_index(std::span<const Jet> x) const {
    Jet n(0.0);
    for (const WeightedCost& t : terms()) {
      const Jet own = find_ability<HasConformalMetric>(*t.cost)->enclose_squared_index(x);
      n += sqrt(own).scaled(Interval(t.weight));
    }
    return square(n);
  }
};

class SumOnData final : public SumCost, public FollowsDomain {
 public:
  using SumCost::SumCost;
  std::shared_ptr<const SegmentCost> on(const ConstraintManifold& domain) const override {
    Terms others = terms();
    for (WeightedCost& t : others)
      if (const auto* follows = find_ability<FollowsDomain>(*t.cost)) t.cost = follows->on(domain);
    return make_sum_cost(std::move(others));
  }
};

/// What no sum or multiple is: layers, whose interfaces a path has to know, and walking, whose hull is not that of the
/// sum and whose kinks would be missing in the bar.
void check_part(const SegmentCost& cost, const std::string& key) {
  if (find_ability<HasInterfaces>(cost) != nullptr)
    throw OptionError(
        key,
        "jumps at interfaces ('layers', or a cost map as 'cells'), which cannot be in a sum or a multiple: use it as "
        "the cost itself, or use smooth layers ('refractive_index') or 'interpolation: smooth'");
  if (find_ability<Regularized>(cost) != nullptr)
    throw OptionError(
        key, "is the hull of a law ('walking'), which cannot be in a sum or a multiple: use it as the cost itself");
}

void check_terms(const Terms& terms) {
  if (terms.empty()) throw OptionError("terms", "a sum must have at least one term");
  for (std::size_t k = 0; k < terms.size(); ++k) {
    const double weight = terms[k].weight;
    if (!(weight > 0) || !std::isfinite(weight))
      throw OptionError("terms." + std::to_string(k) + ".weight", "must be a number greater than 0");
    check_part(*terms[k].cost, "terms." + std::to_string(k) + ".cost");
    if (terms[k].cost->dim() != terms.front().cost->dim())
      throw OptionError("terms." + std::to_string(k), "has a different dimension than the first");
  }
}

/// c_0 times a field.
class ScaledCost : public DerivedCost, public HasNotes {
 public:
  ScaledCost(ScaleOptions options, Formula field, std::shared_ptr<const SegmentCost> cost)
      : DerivedCost(scaled_traits(cost->traits()), cost->dim()),
        options_(std::move(options)),
        field_(std::move(field)),
        cost_(std::move(cost)) {}

  const ScaleOptions& options() const { return options_; }
  const SegmentCost& unscaled() const { return *cost_; }
  const Formula& field() const { return field_; }

  void squared_costs(const AmbientPath& path, std::span<double> q) const override {
    cost_->squared_costs(path, q);
    for (Index i = 0; i < path.segment_count(); ++i) {
      const double f = at<double>((path.x.col(i) + path.x.col(i + 1)) / 2);
      double& own = q[static_cast<std::size_t>(i)];
      own = f > 0 ? f * f * own : kOutside;
      if (!(own >= 0)) own = kOutside;
    }
  }
  double line_element(const Eigen::VectorXd& x, const Eigen::VectorXd& v) const override {
    const double f = at<double>(x);
    return f > 0 ? f * cost_->line_element(x, v) : kOutside;
  }
  std::string why_infinite(const Eigen::VectorXd& a, const Eigen::VectorXd& b) const override {
    const auto* explains = find_ability<ExplainsInfinity>(*cost_);
    std::string why = explains != nullptr ? explains->why_infinite(a, b) : "";
    const Eigen::VectorXd middle = (a + b) / 2;
    if (!why.empty() || at<double>(middle) > 0) return why;
    std::ostringstream out;
    out << "at " << middle.format(Eigen::IOFormat(6, Eigen::DontAlignCols, ", ", ", ", "", "", "(", ")"))
        << " the field '" << options_.by << (std::isnan(at<double>(middle)) ? "' has no value" : "' is not positive");
    return out.str();
  }
  std::vector<std::string> notes() const override { return notes_of(*cost_); }

 private:
  static constexpr double kOutside = std::numeric_limits<double>::infinity();

  static CostTraits scaled_traits(CostTraits traits) {
    traits.additive = traits.below_curves = false;
    return traits;
  }

  template <class S>
  S at(const Eigen::VectorXd& place) const {
    const std::vector<S> x(place.begin(), place.end());
    return field_(std::span<const S>(x));
  }

  /// f in the middle of a segment, its gradient over both ends, and its Hessian where it is asked for.
  double jet(const Eigen::VectorXd& middle, bool with_hessian, Eigen::VectorXd& slope, Points& bend) const {
    using S = Dual<Dual<double, 1>, 1>;
    const Index d = middle.size();
    std::vector<S> x(middle.begin(), middle.end());
    Eigen::VectorXd gradient(d);
    Points hessian(d, d);
    double value = 0;
    for (Index i = 0; i < d; ++i) {
      S& xi = x[static_cast<std::size_t>(i)];
      xi.d[0] = Dual<double, 1>(1.0);
      for (Index j = 0; j <= (with_hessian ? i : 0); ++j) {
        S& xj = x[static_cast<std::size_t>(j)];
        xj.value.d[0] = 1;
        const S f = field_(std::span<const S>(x));
        xj.value.d[0] = 0;
        value = f.value.value;
        gradient[i] = f.d[0].value;
        hessian(i, j) = hessian(j, i) = f.d[0].d[0];
      }
      xi.d[0] = Dual<double, 1>(0.0);
    }
    slope << gradient / 2, gradient / 2;
    if (with_hessian) bend = hessian.replicate(2, 2) / 4;
    return value;
  }

  SquaredCosts derive(const AmbientPath& path, bool with_hessians) const override {
    SquaredCosts c = squared_costs_of(*cost_, path, with_hessians);
    const Index d = dim();
    Eigen::VectorXd slope(2 * d);
    Points bend(2 * d, 2 * d);
    for (Index i = 0; i < c.count(); ++i) {
      const double f = jet((path.x.col(i) + path.x.col(i + 1)) / 2, with_hessians, slope, bend);
      if (i == 0 && path.begin_fixed()) forget(0, d, slope, bend);
      if (i + 1 == c.count() && path.end_fixed()) forget(d, d, slope, bend);
      if (!(f > 0)) c.q[i] = kOutside;
      if (with_hessians) {
        const Points both = slope * c.gradients.col(i).transpose();
        c.hessian(i) = (f * f * c.hessian(i) + 2 * f * (both + both.transpose()) +
                        2 * c.q[i] * (slope * slope.transpose() + f * bend))
                           .eval();
      }
      c.gradients.col(i) = f * f * c.gradients.col(i) + 2 * f * c.q[i] * slope;
      c.jacobian(i) = (f * c.jacobian(i) + c.residuals.col(i) * slope.transpose()).eval();
      c.residuals.col(i) *= f;
      c.q[i] *= f * f;
    }
    return c;
  }

  static void forget(Index first, Index count, Eigen::VectorXd& slope, Points& bend) {
    slope.segment(first, count).setZero();
    bend.middleRows(first, count).setZero();
    bend.middleCols(first, count).setZero();
  }

  ScaleOptions options_;
  Formula field_;
  std::shared_ptr<const SegmentCost> cost_;
};

class ScaledMetricCost final : public ScaledCost, public EnclosesMetricBy<ScaledMetricCost> {
 public:
  using ScaledCost::ScaledCost;
  template <class Jet>
  void enclose(std::span<const Jet> x, std::span<Jet> upper) const {
    find_ability<EnclosesMetric>(unscaled())->enclose_metric(x, upper);
    const Jet f = field()(x), factor = f > Jet(0.0) ? square(f) : Jet::unknown();
    for (Jet& entry : upper) entry *= factor;
  }
};

class ScaledConformalCost final : public ScaledCost, public ConformalMetricBy<ScaledConformalCost> {
 public:
  using ScaledCost::ScaledCost;
  Eigen::MatrixXd base() const override { return find_ability<HasConformalMetric>(unscaled())->base(); }
  template <class Jet>
  Jet squared_index(std::span<const Jet> x) const {
    const Jet f = field()(x);
    return f > Jet(0.0) ? square(f) * find_ability<HasConformalMetric>(unscaled())->enclose_squared_index(x)
                        : Jet::unknown();
  }
};

class ScaledOnData final : public ScaledCost, public FollowsDomain {
 public:
  using ScaledCost::ScaledCost;
  std::shared_ptr<const SegmentCost> on(const ConstraintManifold& domain) const override {
    return make_scaled_cost(options(), find_ability<FollowsDomain>(unscaled())->on(domain));
  }
};

}  // namespace

void ScaleOptions::fields(FieldVisitor& visit) {
  visit.field("by", by, {.help = "f(x) > 0 in the coordinates, like \"1 + x^2\".", .required = true});
  visit.field("parameters", parameters, {.help = "Constants that the formula can use, like {a: 2, b: 1}."});
}

std::shared_ptr<const SegmentCost> make_sum_cost(std::vector<WeightedCost> terms) {
  check_terms(terms);
  const bool conformal = are_conformal(terms);
  if (conformal &&
      all_terms(terms, [](const WeightedCost& t) { return find_ability<HasConstantMetric>(*t.cost) != nullptr; })) {
    double sum = 0;
    for (const WeightedCost& t : terms) sum += t.weight;
    const Eigen::MatrixXd metric = find_ability<HasConstantMetric>(*terms.front().cost)->metric();
    return make_metric_tensor_cost({sum * sum * metric}, static_cast<int>(metric.rows()));
  }
  if (conformal) return std::make_shared<ConformalSumCost>(std::move(terms));
  if (all_terms(terms, [](const WeightedCost& t) { return find_ability<FollowsDomain>(*t.cost) == nullptr; }))
    return std::make_shared<SumCost>(std::move(terms));
  return std::make_shared<SumOnData>(std::move(terms));
}

std::shared_ptr<const SegmentCost> make_scaled_cost(const ScaleOptions& options,
                                                    std::shared_ptr<const SegmentCost> cost) {
  check_part(*cost, "cost");
  Formula field(formulas_of_option("by", {options.by}, coordinate_names(cost->dim()), options.parameters));
  if (find_ability<HasConformalMetric>(*cost) != nullptr)
    return std::make_shared<ScaledConformalCost>(options, std::move(field), std::move(cost));
  if (find_ability<EnclosesMetric>(*cost) != nullptr)
    return std::make_shared<ScaledMetricCost>(options, std::move(field), std::move(cost));
  if (find_ability<FollowsDomain>(*cost) != nullptr)
    return std::make_shared<ScaledOnData>(options, std::move(field), std::move(cost));
  return std::make_shared<ScaledCost>(options, std::move(field), std::move(cost));
}

}  // namespace leastcost
