// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/costs/metric_field.hpp>

#include <array>
#include <cmath>
#include <limits>
#include <sstream>
#include <string>
#include <type_traits>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/cost/encloses_metric.hpp>
#include <leastcost/framework/cost/segment_cost_function.hpp>
#include <leastcost/problems/costs/sampled_tensors.hpp>
#include "framework/base/symmetric_eigen.hpp"
#include "problems/formula/coordinate_names.hpp"
#include "problems/formula/formula.hpp"

namespace leastcost {
namespace {

template <class S, int D>
using Tensor = Eigen::Matrix<S, D, D>;

/// ds^2 = (dx^2 + dy^2) / y^2, y > 0.
struct HalfPlane {
  static constexpr int dim = 2;
  static bool inside(const Point<double, 2>& x) { return x[1] > 0; }
  template <class S>
  Tensor<S, 2> operator()(const Point<S, 2>& x) const {
    return Tensor<S, 2>::Identity() * (1.0 / (x[1] * x[1]));
  }
};

/// ds^2 = 4 (dx^2 + dy^2) / (1 - x^2 - y^2)^2 in the unit disc.
struct PoincareDisc {
  static constexpr int dim = 2;
  static bool inside(const Point<double, 2>& x) { return x.squaredNorm() < 1; }
  template <class S>
  Tensor<S, 2> operator()(const Point<S, 2>& x) const {
    const S w = 1.0 - x[0] * x[0] - x[1] * x[1];
    return Tensor<S, 2>::Identity() * (4.0 / (w * w));
  }
};

/// ds^2 = (dmu^2 + 2 dsigma^2) / sigma^2, sigma > 0.
struct FisherRao {
  static constexpr int dim = 2;
  static bool inside(const Point<double, 2>& x) { return x[1] > 0; }
  template <class S>
  Tensor<S, 2> operator()(const Point<S, 2>& x) const {
    const S w = 1.0 / (x[1] * x[1]);
    Tensor<S, 2> m;
    m << w, S(0.0), S(0.0), 2.0 * w;
    return m;
  }
};

/// Upper triangle, row by row.
template <int D>
struct FormulaTensor {
  static constexpr int dim = D;
  Formulas entries;
  static bool inside(const Point<double, D>&) { return true; }
  template <class S>
  Tensor<S, D> operator()(const Point<S, D>& x) const {
    std::array<S, D*(D + 1) / 2> upper;
    entries.evaluate<S>({x.data(), D}, upper);
    Tensor<S, D> m;
    std::size_t k = 0;
    for (int i = 0; i < D; ++i)
      for (int j = i; j < D; ++j) m(i, j) = m(j, i) = upper[k++];
    return m;
  }
};

/// Whether m is positive definite; then its upper triangle becomes the U of m = U'U.
template <class S, int D>
bool root(Tensor<S, D>& m) {
  using std::sqrt;
  for (int i = 0; i < D; ++i) {
    for (int k = 0; k < i; ++k) m(i, i) -= m(k, i) * m(k, i);
    if (!(innermost(m(i, i)) > 0)) return false;
    m(i, i) = sqrt(m(i, i));
    for (int j = i + 1; j < D; ++j) {
      for (int k = 0; k < i; ++k) m(i, j) -= m(k, i) * m(k, j);
      m(i, j) /= m(i, i);
    }
  }
  return true;
}

template <class Field>
struct MetricField {
  static constexpr int dim = Field::dim;
  Field field;
  bool is_root = false;     ///< T is a root of the metric
  bool is_average = false;  ///< T is the mean of both ends

  CostTraits traits() const { return {.unit = "length", .symmetric = true}; }

  /// r with |r|^2 = q; infinite outside the domain.
  template <class S>
  Point<S, dim> residual(const Point<S, dim>& a, const Point<S, dim>& b) const {
    Point<S, dim> d = b - a;
    const Point<S, dim> middle = 0.5 * (a + b);
    Tensor<S, dim> t = field(is_average ? a : middle);
    if (is_average) t = Tensor<S, dim>(0.5 * (t + field(b)));  // b last: it is the a of the next segment
    if (inside(a) && inside(middle) && inside(b) && apply_root<S>(t, d)) return d;
    return Point<S, dim>::Constant(S(std::numeric_limits<double>::infinity()));
  }

  /// Why a tensor is no metric at x; nothing where it is one.
  std::string why_not(const Point<double, dim>& x, const Tensor<double, dim>& t) const {
    std::ostringstream out;
    const Eigen::IOFormat row(6, Eigen::DontAlignCols, ", ", ", ", "", "", "(", ")");
    if (!Field::inside(x)) {
      out << x.format(row) << " is outside the domain of the metric";
    } else if (!t.allFinite()) {
      out << "at " << x.format(row) << " the tensor is not finite";
    } else if (!is_root && x.allFinite()) {
      const Eigen::VectorXd values = symmetric_eigenvalues(t);
      if (values[0] > 0) return "";
      out << "at " << x.format(row) << " the tensor is not positive definite: its eigenvalues are "
          << values.format(row);
    }
    return out.str();
  }

  template <class S>
  S value(const Point<S, dim>& a, const Point<S, dim>& b) const {
    return residual<S>(a, b).squaredNorm();
  }

  /// q = u' M(m) u with u = b - a and the middle m: the field is differentiated in m alone, half as many directions as
  /// both ends have, and not its root.
  double gradient(const Point<double, dim>& a, const Point<double, dim>& b, Point<double, dim>& ga,
                  Point<double, dim>& gb) const {
    using Jet = Dual<double, dim>;
    if (is_average) {
      SegmentGradient<dim> g;
      const double q = detail::gradient_by_duals(*this, {a, b}, g);
      ga = g.a;
      gb = g.b;
      return q;
    }
    const Tensor<Jet, dim> t = field(variables<Jet>(0.5 * (a + b)));
    const double q = squared_cost_by(t, a, b);
    if (!std::isfinite(q)) return ga.setZero(), gb.setZero(), q;
    set_slopes(metric_of(t), b - a, ga, gb);
    return q;
  }

  double derivatives(const Point<double, dim>& a, const Point<double, dim>& b, Point<double, dim>& ga,
                     Point<double, dim>& gb, Eigen::Ref<Points> h) const {
    if (is_average) {
      SegmentGradient<dim> g;
      const double q = detail::hessian_nested(*this, {a, b}, g, h);
      ga = g.a;
      gb = g.b;
      return q;
    }
    using Square = Tensor<double, dim>;
    const Point<double, dim> u = b - a;
    const Tensor<NestedDual, dim> t = field(variables<NestedDual>(0.5 * (a + b)));
    const double q = squared_cost_by(t, a, b);
    if (!std::isfinite(q)) return q;
    const Tensor<NestedDual, dim> m = metric_of(t);
    set_slopes(m, u, ga, gb);
    Square in_u = Square::Zero(), mixed = in_u, in_m = in_u;  // second derivatives of q; mixed: rows u, columns m
    for (int i = 0; i < dim; ++i) {
      for (int j = 0; j < dim; ++j) {
        const NestedDual& entry = m(i, j);
        in_u(i, j) = 2 * entry.value.value;
        for (std::size_t k = 0; k < dim; ++k) {
          mixed(i, static_cast<Index>(k)) += 2 * u[j] * entry.d[k].value;
          for (std::size_t l = 0; l < dim; ++l)
            in_m(static_cast<Index>(k), static_cast<Index>(l)) += u[i] * u[j] * entry.d[k].d[l];
        }
      }
    }
    const Square both = 0.5 * (mixed + mixed.transpose()), across = 0.5 * (mixed.transpose() - mixed);
    h.topLeftCorner(dim, dim) = in_u - both + 0.25 * in_m;
    h.bottomRightCorner(dim, dim) = in_u + both + 0.25 * in_m;
    h.topRightCorner(dim, dim) = across - in_u + 0.25 * in_m;
    h.bottomLeftCorner(dim, dim) = h.topRightCorner(dim, dim).transpose();
    return q;
  }

  double line_element(const Eigen::VectorXd& x, const Eigen::VectorXd& v) const {
    const Point<double, dim> p = x;
    if (!Field::inside(p)) return std::numeric_limits<double>::infinity();
    const Tensor<double, dim> t = field(p);
    const double q = is_root ? (t * v).squaredNorm() : v.dot(t * v);
    return q >= 0 ? std::sqrt(q) : std::numeric_limits<double>::infinity();
  }

 private:
  using NestedDual = Dual<Dual<double, dim>, dim>;

  /// A place, with its first derivatives, or first and second.
  template <class S>
  static Point<S, dim> variables(const Point<double, dim>& place) {
    Point<S, dim> x;
    for (int i = 0; i < dim; ++i) {
      const auto k = static_cast<std::size_t>(i);
      x[i] = S(place[i]);
      x[i].d[k] = 1.0;
      if constexpr (std::is_same_v<S, NestedDual>) x[i].value.d[k] = 1;
    }
    return x;
  }

  template <class S>
  Tensor<S, dim> metric_of(const Tensor<S, dim>& t) const {
    return is_root ? Tensor<S, dim>(t.transpose() * t) : t;
  }

  /// d := T d, or U d with T = U'U: the residual. False where T is no metric.
  template <class S>
  bool apply_root(Tensor<S, dim>& t, Point<S, dim>& d) const {
    if (is_root) {
      d = Point<S, dim>(t * d);
      return true;
    }
    if (!root<S, dim>(t)) return false;
    for (int i = 0; i < dim; ++i) {
      d[i] *= t(i, i);
      for (int j = i + 1; j < dim; ++j) d[i] += t(i, j) * d[j];
    }
    return true;
  }

  /// value(a, b) with the tensor in the middle, of which only the values count.
  template <class S>
  double squared_cost_by(const Tensor<S, dim>& t, const Point<double, dim>& a, const Point<double, dim>& b) const {
    Tensor<double, dim> values;
    for (int j = 0; j < dim; ++j)
      for (int i = 0; i < dim; ++i) values(i, j) = innermost(t(i, j));
    Point<double, dim> d = b - a;
    if (!Field::inside(a) || !Field::inside(Point<double, dim>(0.5 * (a + b))) || !Field::inside(b) ||
        !apply_root<double>(values, d))
      return std::numeric_limits<double>::infinity();
    return d.squaredNorm();
  }

  /// Slopes of u' M(m) u by both ends.
  template <class S>
  static void set_slopes(const Tensor<S, dim>& m, const Point<double, dim>& u, Point<double, dim>& ga,
                         Point<double, dim>& gb) {
    Point<double, dim> in_u = Point<double, dim>::Zero(), in_m = in_u;
    for (int i = 0; i < dim; ++i)
      for (int j = 0; j < dim; ++j) {
        in_u[i] += 2 * innermost(m(i, j)) * u[j];
        for (int k = 0; k < dim; ++k) in_m[k] += u[i] * u[j] * innermost(m(i, j).d[static_cast<std::size_t>(k)]);
      }
    ga = 0.5 * in_m - in_u;
    gb = 0.5 * in_m + in_u;
  }

  template <class S>
  static bool inside(const Point<S, dim>& x) {
    Point<double, dim> p;
    for (int i = 0; i < dim; ++i) p[i] = innermost(x[i]);
    return Field::inside(p);
  }
};

template <class Field>
class MetricFieldCost : public SegmentCostOf<MetricField<Field>> {
 public:
  using SegmentCostOf<MetricField<Field>>::SegmentCostOf;
  std::string why_infinite(const Eigen::VectorXd& a, const Eigen::VectorXd& b) const override {
    const MetricField<Field>& metric = this->function();
    const Eigen::VectorXd middle = (a + b) / 2;
    for (const Eigen::VectorXd& x : {a, b, middle}) {
      std::string why = metric.why_not(x, metric.field(Point<double, Field::dim>(x)));
      if (!why.empty()) return why;
    }
    return "";
  }
};

/// A field by formula.
template <class Field>
class MetricByFormula final : public MetricFieldCost<Field>, public EnclosesMetricBy<MetricByFormula<Field>> {
 public:
  using MetricFieldCost<Field>::MetricFieldCost;

  template <class Jet>
  void enclose(std::span<const Jet> x, std::span<Jet> upper) const {
    constexpr int d = Field::dim;
    Point<Jet, d> place;
    for (int i = 0; i < d; ++i) place[i] = x[static_cast<std::size_t>(i)];
    Tensor<Jet, d> t = this->function().field(place);
    if (this->function().is_root) t = Tensor<Jet, d>(t.transpose() * t);
    std::size_t k = 0;
    for (int i = 0; i < d; ++i)
      for (int j = i; j < d; ++j) upper[k++] = t(i, j);
  }
};

/// Tensors on the data of a domain, which are others on another version of it.
class MetricOnData final : public MetricFieldCost<SampledTensors>, public FollowsDomain {
 public:
  MetricOnData(const MetricFieldOptions& o, const ConstraintManifold* domain, std::filesystem::path folder)
      : MetricFieldCost({{tensors(o, domain, folder)}, o.reading == TensorReading::root, o.averages()}),
        options_(o),
        folder_(std::move(folder)) {}
  std::shared_ptr<const SegmentCost> on(const ConstraintManifold& domain) const override {
    return std::make_shared<MetricOnData>(options_, &domain, folder_);
  }

 private:
  static std::shared_ptr<const TensorSamples> tensors(const MetricFieldOptions& o, const ConstraintManifold* domain,
                                                      const std::filesystem::path& folder) {
    if (const auto* file = std::get_if<TensorFileOptions>(&o.field)) return tensors_from_file(*file, domain, folder);
    return tensors_from_curvature(std::get<CurvatureMetricOptions>(o.field), domain);
  }

  MetricFieldOptions options_;
  std::filesystem::path folder_;
};

template <class Field>
std::shared_ptr<const SegmentCost> lifted(Field field, const MetricFieldOptions& o, int dim) {
  if (dim != Field::dim)
    throw OptionError("field", "this metric has dimension " + std::to_string(Field::dim) +
                                   ", but the ambient space has " + std::to_string(dim));
  return std::make_shared<MetricByFormula<Field>>(
      MetricField<Field>{std::move(field), o.reading == TensorReading::root, o.averages()});
}

template <int D>
std::shared_ptr<const SegmentCost> by_formulas(const metric::Formula& formula, const MetricFieldOptions& o) {
  constexpr std::size_t kEntries = D * (D + 1) / 2;
  const std::size_t given = formula.entries.size();
  if (given != kEntries)
    throw OptionError("field.entries", "a symmetric " + std::to_string(D) + " x " + std::to_string(D) + " tensor has " +
                                           std::to_string(kEntries) +
                                           " entries on and above the diagonal, row by row, not " +
                                           std::to_string(given));
  return lifted(
      FormulaTensor<D>{formulas_of_option("field.entries", formula.entries, coordinate_names(D), formula.parameters)},
      o, D);
}

/// Makes the cost of the field that was chosen.
struct Maker {
  const MetricFieldOptions& options;
  int dim;
  const ConstraintManifold* domain;
  const std::filesystem::path& folder;
  using Made = std::shared_ptr<const SegmentCost>;

  Made operator()(const metric::HalfPlane&) const { return lifted(HalfPlane{}, options, dim); }
  Made operator()(const metric::PoincareDisc&) const { return lifted(PoincareDisc{}, options, dim); }
  Made operator()(const metric::FisherRao&) const { return lifted(FisherRao{}, options, dim); }
  Made operator()(const metric::Formula& formula) const {
    if (dim == 2) return by_formulas<2>(formula, options);
    if (dim == 3) return by_formulas<3>(formula, options);
    throw OptionError("field", "formulas describe metrics in dimension 2 and 3, not " + std::to_string(dim));
  }
  Made operator()(const TensorFileOptions&) const { return std::make_shared<MetricOnData>(options, domain, folder); }
  Made operator()(const CurvatureMetricOptions&) const {
    return std::make_shared<MetricOnData>(options, domain, folder);
  }
};

}  // namespace

void metric::Formula::fields(FieldVisitor& visit) {
  visit.field(
      "entries", entries,
      {.help = "Entries on and above the diagonal, row by row, like [\"1 + x^2\", \"0\", \"1\"].", .required = true});
  visit.field("parameters", parameters, {.help = "Constants that the formulas can use, like {a: 2, b: 1}."});
}

Words<TensorReading> words(TensorReading) {
  static constexpr std::array<Word<TensorReading>, 2> kWords = {
      {{TensorReading::metric, "metric"}, {TensorReading::root, "root"}}};
  return kWords;
}

Words<TensorRule> words(TensorRule) {
  static constexpr std::array<Word<TensorRule>, 3> kWords = {
      {{TensorRule::automatic, "auto"}, {TensorRule::midpoint, "midpoint"}, {TensorRule::average, "average"}}};
  return kWords;
}

void MetricFieldOptions::fields(FieldVisitor& visit) {
  visit.variant("field", field,
                {.help = "The tensor T(x): by name, or as formulas in the coordinates.", .required = true});
  visit.choice("reading", reading,
               {.help = "T is the metric, c = sqrt(d' T d) (VFCS Eq. 1), or a root of it, c = |T d| (VFCS Sec. 4.5)."});
  visit.choice(
      "rule", rule,
      {.help = "midpoint: T at the middle of a segment. average: the mean of T at its ends (VFCS Sec. 4.5). auto: "
               "average for tensors given on data, whose midpoints are off the surface; otherwise midpoint."});
}

bool MetricFieldOptions::needs_domain() const {
  return std::holds_alternative<TensorFileOptions>(field) || std::holds_alternative<CurvatureMetricOptions>(field);
}

bool MetricFieldOptions::averages() const {
  switch (rule) {
    case TensorRule::automatic: return needs_domain();
    case TensorRule::midpoint: return false;
    case TensorRule::average: return true;
  }
  return false;
}

std::shared_ptr<const SegmentCost> make_metric_field_cost(const MetricFieldOptions& options, int dim,
                                                          const ConstraintManifold* domain,
                                                          const std::filesystem::path& folder) {
  return std::visit(Maker{options, dim, domain, folder}, options.field);
}

}  // namespace leastcost
