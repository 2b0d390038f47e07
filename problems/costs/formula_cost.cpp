// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/costs/formula_cost.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <sstream>
#include <utility>
#include <vector>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/cost/encloses_metric.hpp>
#include <leastcost/framework/cost/has_notes.hpp>
#include <leastcost/framework/cost/segment_cost_function.hpp>
#include <leastcost/framework/domain/has_box.hpp>
#include "framework/base/counted.hpp"
#include "problems/costs/lagrangian/lagrangian_check.hpp"
#include "problems/costs/lagrangian/lagrangian_form.hpp"
#include "problems/costs/lagrangian/lagrangian_hull.hpp"
#include "problems/costs/lagrangian/lagrangian_memory.hpp"
#include "problems/formula/coordinate_names.hpp"
#include "problems/formula/formula.hpp"

namespace leastcost {
namespace {

/// F(x, v), or its hull.
template <int D>
struct Lagrangian {
  Formula formula;
  bool hull = false;

  template <class S>
  S operator()(const Point<S, D>& x, const Point<S, D>& v) const {
    if constexpr (D == 2) {
      if (hull) {
        const Point<double, 2> place(innermost(x[0]), innermost(x[1]));
        const auto gap = gap_around(formula, place, std::atan2(innermost(v[1]), innermost(v[0])));
        if (gap) return hull_in_gap<S>(formula, x, v, *gap);
      }
    }
    constexpr int kBoth = D == Eigen::Dynamic ? 2 * kMaxDimension : 2 * D;
    std::array<S, kBoth> xv;
    const auto d = static_cast<std::size_t>(x.size());
    for (std::size_t i = 0; i < d; ++i) {
      xv[i] = x[static_cast<Index>(i)];
      xv[d + i] = v[static_cast<Index>(i)];
    }
    return formula(std::span<const S>(xv.data(), 2 * d));
  }
};

template <int D>
struct FormulaCost {
  static constexpr int dim = D;
  Lagrangian<D> lagrangian;
  CostTraits says;

  CostTraits traits() const { return says; }

  template <class S>
  S value(const Point<S, D>& a, const Point<S, D>& b) const {
    const Point<S, D> middle = 0.5 * (a + b), v = b - a;
    if (at_rest<S>(v)) return says.quadratic_at_rest ? metric_form<S>(middle, v) : S(0.0);
    const S f = lagrangian.template operator()<S>(middle, v);
    if (!(innermost(f) > 0)) return S(std::numeric_limits<double>::infinity());
    return f * f;
  }

  double line_element(const Eigen::VectorXd& x, const Eigen::VectorXd& v) const {
    if (v.isZero(0)) return 0;
    const double f = lagrangian.template operator()<double>(Point<double, D>(x), Point<double, D>(v));
    return f > 0 ? f : std::numeric_limits<double>::infinity();
  }

  std::string why_infinite(const Eigen::VectorXd& a, const Eigen::VectorXd& b) const {
    if (std::isfinite(value<double>(Point<double, D>(a), Point<double, D>(b)))) return "";
    const Eigen::IOFormat row(6, Eigen::DontAlignCols, ", ", ", ", "", "", "(", ")");
    std::ostringstream out;
    const Eigen::VectorXd middle = (a + b) / 2, v = (b - a).normalized();
    const double f = lagrangian.template operator()<double>(Point<double, D>(middle), Point<double, D>(v));
    out << "at x = " << middle.format(row) << (std::isnan(f) ? " F(x, v) has no value" : " F(x, v) is not positive")
        << " for v = " << v.format(row);
    if (!std::isnan(f)) out << ": F = " << f;
    return out.str();
  }

 private:
  /// v'Gv = F^2, without the root that F has at v = 0.
  template <class S>
  S metric_form(const Point<S, D>& x, const Point<S, D>& v) const {
    const auto squared = [&](Index i, Index j) {
      Point<S, D> unit = Point<S, D>::Constant(v.size(), S(0.0));
      unit[i] = unit[j] = S(1.0);
      const S f = lagrangian.template operator()<S>(x, unit);
      return S(f * f);
    };
    S sum(0.0);
    for (Index i = 0; i < v.size(); ++i) {
      sum += squared(i, i) * v[i] * v[i];
      for (Index j = 0; j < i; ++j) sum += (squared(i, j) - squared(i, i) - squared(j, j)) * v[i] * v[j];
    }
    return sum;
  }
  template <class S>
  static bool at_rest(const Point<S, D>& v) {
    for (Index i = 0; i < v.size(); ++i)
      if (innermost(v[i]) != 0) return false;
    return true;
  }
};

/// With what was found about its formula.
template <int D>
class FormulaCostWithNote : public SegmentCostOf<FormulaCost<D>>, public HasNotes {
 public:
  FormulaCostWithNote(FormulaCost<D> function, int dim, std::string note)
      : SegmentCostOf<FormulaCost<D>>(std::move(function), dim), note_(std::move(note)) {}
  std::vector<std::string> notes() const override { return {note_}; }

 private:
  std::string note_;
};

/// F^2 = v'Gv, by the text of the formula: G from F^2 at unit vectors and their sums.
template <int D>
class MetricLagrangianCost final : public FormulaCostWithNote<D>, public EnclosesMetricBy<MetricLagrangianCost<D>> {
 public:
  using FormulaCostWithNote<D>::FormulaCostWithNote;

  template <class Jet>
  void enclose(std::span<const Jet> x, std::span<Jet> upper) const {
    const auto squared = [&](std::size_t i, std::size_t j) {
      std::array<Jet, 2 * static_cast<std::size_t>(D)> xv;
      std::copy(x.begin(), x.end(), xv.begin());
      xv[D + i] = xv[D + j] = Jet(1.0);
      return square(this->function().lagrangian.formula(std::span<const Jet>(xv)));
    };
    std::size_t k = 0;
    for (std::size_t i = 0; i < D; ++i)
      for (std::size_t j = i; j < D; ++j)
        upper[k++] = i == j ? squared(i, i) : Jet(squared(i, j) - squared(i, i) - squared(j, j)).scaled(Interval(0.5));
  }
};

LagrangianForm form_of(const Formula& formula, int dim) {
  std::vector<LagrangianForm> xv(static_cast<std::size_t>(dim), LagrangianForm::position());
  xv.resize(2 * xv.size(), LagrangianForm::velocity());
  return formula(std::span<const LagrangianForm>(xv));
}

template <int D>
std::shared_ptr<const SegmentCost> lifted_lagrangian(FormulaCost<D> function, int dim, std::string note, bool metric) {
  if constexpr (D != Eigen::Dynamic)
    if (metric) return std::make_shared<MetricLagrangianCost<D>>(std::move(function), dim, std::move(note));
  return std::make_shared<FormulaCostWithNote<D>>(std::move(function), dim, std::move(note));
}

}  // namespace

std::vector<std::string> velocity_names(int dim) {
  if (dim > 3) return numbered_names("v", dim);
  std::vector<std::string> names = {"vx", "vy", "vz"};
  names.resize(static_cast<std::size_t>(std::max(0, dim)));
  return names;
}

void FormulaCostOptions::fields(FieldVisitor& visit) {
  visit.field("lagrangian", lagrangian,
              {.help = "F(x, v) > 0 of degree 1 in v, like \"sqrt(vx^2 + vy^2) * (1 + x^2)\"; in more than three "
                       "dimensions in x0, x1, ... and v0, v1, ...",
               .required = true});
  visit.field("parameters", parameters, {.help = "Constants that the formula can use, like {a: 2, b: 1}."});
  visit.field(
      "convexify", convexify,
      {.help = "In the plane: replaces F by its convex hull in v where F is not convex; zigzags attain the hull."});
  visit.field("unit", unit, {.help = "Unit of the cost, as free text."});
}

std::optional<CheckedRegion> checked_region(const ConstraintManifold& domain,
                                            const std::optional<Eigen::VectorXd>& source,
                                            const std::optional<Eigen::VectorXd>& target) {
  const auto* box = find_ability<HasBox>(domain);
  if (box != nullptr && domain.shape() == Shape::flat && find_ability<HasChart>(domain) == nullptr &&
      box->box_lower().allFinite() && box->box_upper().allFinite())
    return CheckedRegion{box->box_lower(), box->box_upper()};
  if (!source || !target) return std::nullopt;
  const Eigen::VectorXd middle = (*source + *target) / 2, half = (*target - *source).cwiseAbs() / 2;
  const Eigen::VectorXd wide = half.cwiseMax(half.maxCoeff() / 2);
  return CheckedRegion{middle - wide, middle + wide};
}

std::shared_ptr<const SegmentCost> make_formula_cost(const FormulaCostOptions& options, int dim,
                                                     const std::optional<CheckedRegion>& region) {
  if (dim < 1 || dim > kMaxDimension) throw OptionError("lagrangian", "the space must have 1 to 64 dimensions");
  if (options.convexify && dim != 2)
    throw OptionError("convexify", "works in the plane only, but this space has " + counted(dim, "dimension"));
  std::vector<std::string> names = coordinate_names(dim);
  const std::vector<std::string> velocities = velocity_names(dim);
  names.insert(names.end(), velocities.begin(), velocities.end());
  const Formula formula(formulas_of_option("lagrangian", {options.lagrangian}, names, options.parameters));
  const LagrangianForm form = form_of(formula, dim);
  const LagrangianBox box = region ? LagrangianBox{region->lower, region->upper} : LagrangianBox{};
  LagrangianCheck check = remembered_check({options.lagrangian, options.parameters, box, dim, options.convexify}, [&] {
    return check_lagrangian(formula, form, box, dim, options.convexify);
  });
  const bool hull = options.convexify && !check.convex;
  if (hull)
    check.note +=
        "; it is not convex there, so its convex hull is used. Where a path runs between the two directions of a "
        "zigzag, its value holds, but the path is not unique";
  const bool metric = form.kind == LagrangianForm::Kind::root && !hull;
  const CostTraits says{
      .unit = options.unit, .symmetric = form.parity == LagrangianForm::Parity::even, .quadratic_at_rest = metric};
  if (dim == 2) return lifted_lagrangian<2>({{formula, hull}, says}, dim, std::move(check.note), metric);
  if (dim == 3) return lifted_lagrangian<3>({{formula}, says}, dim, std::move(check.note), metric);
  return lifted_lagrangian<Eigen::Dynamic>({{formula}, says}, dim, std::move(check.note), metric);
}

}  // namespace leastcost
