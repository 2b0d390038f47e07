// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/costs/zermelo.hpp>

#include <charconv>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <sstream>
#include <type_traits>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/cost/segment_cost_function.hpp>
#include <leastcost/problems/bracket/cost_dual.hpp>
#include "framework/base/counted.hpp"
#include "framework/base/point_text.hpp"
#include "problems/costs/flow_grid.hpp"
#include "problems/formula/coordinate_names.hpp"
#include "problems/formula/formula.hpp"
#include "problems/readers/flow_reader.hpp"

namespace leastcost {
namespace {

template <int D>
struct UniformFlow {
  static constexpr int dim = D;
  Point<double, D> velocity;
  template <class S>
  Point<S, D> operator()(const Point<S, D>&) const {
    return velocity.template cast<S>();
  }
};

template <int D>
struct FormulaFlow {
  static constexpr int dim = D;
  Formulas velocity;
  template <class S>
  Point<S, D> operator()(const Point<S, D>& x) const {
    Point<S, D> w;
    velocity.evaluate<S>({x.data(), D}, {w.data(), D});
    return w;
  }
};

/// Of a vehicle through the medium.
struct VehicleSpeed {
  Formulas formula;
  template <class S, int D>
  S at(const Point<S, D>& x) const {
    S v;
    formula.evaluate<S>({x.data(), D}, std::span<S>(&v, 1));
    return v;
  }
};

template <class Flow>
struct Zermelo {
  static constexpr int dim = Flow::dim;
  Flow flow;
  VehicleSpeed speed;
  CostTraits own;

  CostTraits traits() const { return own; }

  /// Time of the move d under what there is at x. The speed over ground along d is the greater root g of |g d - w| = V
  /// for d of length 1; of its two forms the one without cancellation.
  template <class S>
  S time(const Point<S, dim>& x, const Point<S, dim>& d) const {
    using std::sqrt;
    const S infinite(std::numeric_limits<double>::infinity());
    const Point<S, dim> w = flow(x);
    const S v = speed.at<S, dim>(x);
    if (!(innermost(v) > 0)) return infinite;
    S along(0.0), length2(0.0), room = v * v;
    for (int k = 0; k < dim; ++k) {
      along += d[k] * w[k];
      length2 += d[k] * d[k];
      room -= w[k] * w[k];
    }
    const S radicand = along * along + room * length2;
    if (!(innermost(radicand) > 0)) return infinite;
    const S root = sqrt(radicand);
    if (innermost(along) > 0) return length2 / (along + root);
    return innermost(room) > 0 ? S((root - along) / room) : infinite;
  }

  /// No move takes no time, and has no derivative; the square of its time has one.
  template <class S>
  S value(const Point<S, dim>& a, const Point<S, dim>& b) const {
    const Point<S, dim> d = b - a;
    if (innermost(d.squaredNorm()) == 0) return S(0.0);
    if (!has_value(plain(a)) || !has_value(plain(b))) return S(std::numeric_limits<double>::infinity());
    const S t = time<S>(0.5 * (a + b), d);
    return t * t;
  }

  double line_element(const Eigen::VectorXd& x, const Eigen::VectorXd& v) const {
    return time<double>(Point<double, dim>(x), Point<double, dim>(v));
  }

  std::string why_infinite(const Eigen::VectorXd& a, const Eigen::VectorXd& b) const {
    const Point<double, dim> middle = 0.5 * (a + b), d = b - a;
    if (d.squaredNorm() == 0) return "";
    for (const Point<double, dim>& x : {Point<double, dim>(a), middle, Point<double, dim>(b)})
      if (!has_value(x)) return at(x) + no_value(x);
    if (std::isfinite(time<double>(middle, d))) return "";
    const Point<double, dim> w = flow(middle);
    const double v = speed.at<double, dim>(middle);
    std::ostringstream out;
    out << at(middle);
    if (!w.allFinite())
      out << "the flow is not finite";
    else if (!(v > 0))
      out << "the speed of the vehicle is " << v << "; it must be greater than 0";
    else
      out << "the flow has speed " << w.norm() << " and the vehicle " << v << ": it can move only within "
          << std::asin(std::min(1.0, v / w.norm())) * 180 / std::numbers::pi
          << " degrees of the direction of the flow, " << row_text(w.normalized());
    return out.str();
  }

 private:
  static std::string row_text(const Point<double, dim>& x) {
    std::ostringstream out;
    out << x.format(Eigen::IOFormat(6, Eigen::DontAlignCols, ", ", ", ", "", "", "(", ")"));
    return out.str();
  }
  static std::string at(const Point<double, dim>& x) { return "at " + row_text(x) + " "; }

  template <class S>
  static Point<double, dim> plain(const Point<S, dim>& x) {
    Point<double, dim> p;
    for (int i = 0; i < dim; ++i) p[i] = innermost(x[i]);
    return p;
  }

  /// Of a grid, which ends somewhere and has gaps.
  bool has_value(const Point<double, dim>& x) const {
    if constexpr (requires { flow.has_value(x); })
      return flow.has_value(x);
    else
      return true;
  }
  std::string no_value(const Point<double, dim>& x) const {
    if constexpr (requires { flow.contains(x); })
      return flow.contains(x) ? "a neighbouring node of the grid has no value" : "the point is outside the grid";
    else
      return "";
  }
};

/// In the plane, in a flow that is a formula: V |p| + w.p <= 1, whichever of both is the faster.
template <class Flow>
class ZermeloInCells final : public SegmentCostOf<Zermelo<Flow>>, public CostDual {
 public:
  using SegmentCostOf<Zermelo<Flow>>::SegmentCostOf;

  DualNorm<double> dual(const Eigen::Vector2d& x) const override { return norm<double>(x); }
  DualNorm<Jet> enclose_dual(const std::array<Jet, 2>& x) const override {
    const Jet unknown = Jet::unknown();
    const bool moves = lowest_speed(x) > 0;
    return moves ? norm<Jet>({x[0], x[1]}) : DualNorm<Jet>{unknown, unknown, unknown, unknown, unknown};
  }

 private:
  double lowest_speed(const std::array<Jet, 2>& x) const {
    return this->function().speed.template at<Jet, 2>({x[0], x[1]}).value().lo;
  }
  template <class S>
  DualNorm<S> norm(const Point<S, 2>& x) const {
    const Point<S, 2> w = this->function().flow(x);
    const S v = this->function().speed.template at<S, 2>(x), squared = v * v;
    return {squared, S(0.0), squared, w[0], w[1]};
  }
};

/// A number, where the text is one.
std::optional<double> as_number(const std::string& text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size() ? std::optional(value) : std::nullopt;
}

VehicleSpeed speed_of(const ZermeloOptions& options, int dim) {
  if (options.speed.empty()) throw OptionError("speed", "missing: the speed of the vehicle through the medium");
  const std::optional<double> number = as_number(options.speed);
  if (number && !(*number > 0 && std::isfinite(*number)))
    throw OptionError("speed", "must be a number greater than 0, or a formula");
  return {formulas_of_option("speed", {options.speed}, coordinate_names(dim), options.parameters)};
}

void check_count(std::size_t given, const char* what, int dim, const std::string& instead = "") {
  if (given == static_cast<std::size_t>(dim)) return;
  throw OptionError("flow.velocity", "the space has " + std::to_string(dim) +
                                         " coordinates, so a velocity has as many " + what + ", not " +
                                         std::to_string(given) + instead);
}

/// What two numbers in space are meant to be.
std::string as_east_north(const Eigen::VectorXd& velocity, int dim) {
  if (dim != 3 || velocity.size() != 2) return "";
  return "; on the Earth, east and north: flow: {type: east_north, velocity: [" + short_number(velocity[0], 9) + ", " +
         short_number(velocity[1], 9) + "]}";
}

/// East is (-y, x, 0) and north is up x east, up the normal (x, y, k z) of the ellipsoid; neither is defined at a pole.
flow::Formula in_space(const flow::EastNorth& flow) {
  constexpr double kFlattening = 1 / 298.257223563;  // WGS84
  constexpr int kDigits = 17;
  const std::string east = "(" + short_number(flow.velocity[0], kDigits) + ")";
  const std::string north = "(" + short_number(flow.velocity[1], kDigits) + ")";
  const std::string k = short_number(1 / ((1 - kFlattening) * (1 - kFlattening)), kDigits);
  const std::string rho = "sqrt(x^2 + y^2)", up = "sqrt(x^2 + y^2 + (" + k + "*z)^2)";
  const std::string sideways = north + "*" + k + "*z/(" + rho + "*" + up + ")";
  return {{"-" + east + "*y/" + rho + " - " + sideways + "*x", east + "*x/" + rho + " - " + sideways + "*y",
           north + "*" + rho + "/" + up}};
}

/// Whether a flow can be bounded over cells of the plane: a grid of values cannot.
template <class Flow>
constexpr bool kInCells = std::is_same_v<Flow, UniformFlow<2>> || std::is_same_v<Flow, FormulaFlow<2>>;

template <int D>
struct FlowMaker {
  const ZermeloOptions& options;
  const std::filesystem::path& folder;
  using Made = std::shared_ptr<const SegmentCost>;

  template <class Flow>
  Made lifted(Flow flow, bool uniform) const {
    const bool constant = uniform && as_number(options.speed);
    const CostTraits traits{.unit = options.unit,
                            .symmetric = false,
                            .additive = constant,
                            .below_curves = constant,
                            .quadratic_at_rest = false};
    Zermelo<Flow> time{std::move(flow), speed_of(options, D), traits};
    if constexpr (kInCells<Flow>)
      return std::make_shared<ZermeloInCells<Flow>>(std::move(time));
    else
      return make_segment_cost(std::move(time));
  }
  Made operator()(const flow::Uniform& uniform) const { return lifted(UniformFlow<D>{uniform.velocity}, true); }
  Made operator()(const flow::Formula& formula) const {
    return lifted(
        FormulaFlow<D>{formulas_of_option("flow.velocity", formula.velocity, coordinate_names(D), options.parameters)},
        false);
  }
  Made operator()(const flow::EastNorth& flow) const { return (*this)(in_space(flow)); }
  Made operator()(const flow::Grid& grid) const {
    const std::filesystem::path file = folder / grid.file;
    return lifted(flow_grid<D>(read_flow(file, D), file.string()), false);
  }
};

}  // namespace

void flow::Uniform::fields(FieldVisitor& visit) {
  visit.field("velocity", velocity, {.help = "One number per coordinate.", .unit = "length/time", .required = true});
}

void flow::Formula::fields(FieldVisitor& visit) {
  visit.field("velocity", velocity,
              {.help = "One formula per coordinate, like [\"-y\", \"0\"].", .unit = "length/time", .required = true});
}

void flow::EastNorth::fields(FieldVisitor& visit) {
  visit.field("velocity", velocity, {.help = "[east, north]", .unit = "length/time", .required = true});
}

void flow::Grid::fields(FieldVisitor& visit) {
  visit.file("file", file,
             {.help = "CSV with a row per node of a regular grid: x, y, u, v or x, y, z, u, v, w.", .required = true});
}

void ZermeloOptions::fields(FieldVisitor& visit) {
  visit.field("speed", speed,
              {.help = "Speed of the vehicle through the air or water: a number, or a formula in the coordinates.",
               .unit = "length/time",
               .required = true});
  visit.variant("flow", flow, {.help = "The velocity of the wind or current.", .required = true});
  visit.field("parameters", parameters, {.help = "Constants that the formulas can use, like {a: 2, b: 1}."});
  visit.field("unit", unit, {.help = "Unit of time, which follows from the units of length and speed."});
}

void check_zermelo(const ZermeloOptions& options, int dim) {
  if (dim != 2 && dim != 3)
    throw OptionError("type", "a flow needs a space of dimension 2 or 3, not " + std::to_string(dim));
  speed_of(options, dim);
  if (const auto* uniform = std::get_if<flow::Uniform>(&options.flow)) {
    check_count(static_cast<std::size_t>(uniform->velocity.size()), "numbers", dim,
                as_east_north(uniform->velocity, dim));
    if (!uniform->velocity.allFinite()) throw OptionError("flow.velocity", "must be finite");
  } else if (const auto* turned = std::get_if<flow::EastNorth>(&options.flow)) {
    if (dim != 3) throw OptionError("flow.type", "east_north works on the Earth only");
    if (turned->velocity.size() != 2 || !turned->velocity.allFinite())
      throw OptionError("flow.velocity", "must have two finite numbers, east and north");
  } else if (const auto* formula = std::get_if<flow::Formula>(&options.flow)) {
    check_count(formula->velocity.size(), "formulas", dim);
    formulas_of_option("flow.velocity", formula->velocity, coordinate_names(dim), options.parameters);
  }
}

std::shared_ptr<const SegmentCost> make_zermelo_cost(const ZermeloOptions& options, int dim,
                                                     const std::filesystem::path& folder) {
  check_zermelo(options, dim);
  if (dim == 2) return std::visit(FlowMaker<2>{options, folder}, options.flow);
  return std::visit(FlowMaker<3>{options, folder}, options.flow);
}

std::shared_ptr<const SegmentCost> make_zermelo_cost(ZermeloOptions options, const Eigen::MatrixXd& nodes, int dim) {
  options.flow = flow::Grid{};
  check_zermelo(options, dim);
  if (nodes.cols() != 2 * dim)
    throw InputError("the nodes of a flow in " + counted(dim, "dimension") + " have rows of " +
                     std::to_string(2 * dim) + " numbers, position and velocity, not " + std::to_string(nodes.cols()));
  if (dim == 2) return FlowMaker<2>{options, {}}.lifted(flow_grid<2>(nodes, "flow"), false);
  return FlowMaker<3>{options, {}}.lifted(flow_grid<3>(nodes, "flow"), false);
}

}  // namespace leastcost
