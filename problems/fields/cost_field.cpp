// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/fields/cost_field.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/cost/has_conformal_metric.hpp>
#include <leastcost/framework/cost/segment_cost.hpp>
#include <leastcost/framework/domain/checks_moves.hpp>
#include <leastcost/framework/domain/manifold.hpp>
#include <leastcost/problems/bracket/cost_density.hpp>
#include "framework/base/point_text.hpp"
#include "problems/cells/has_cost_cells.hpp"
#include "problems/fields/arrival_field.hpp"
#include "problems/fields/closed_lattice.hpp"
#include "problems/fields/field_error.hpp"
#include "problems/fields/field_lattice.hpp"
#include "problems/fields/grid_search.hpp"
#include "problems/fields/isotropic_march.hpp"
#include "problems/fields/lattice_box.hpp"
#include "problems/fields/no_way.hpp"
#include "problems/fields/node_moves.hpp"
#include "problems/fields/without_cost.hpp"

namespace leastcost {
namespace {

using Eigen::Vector2d;
using Lattice2 = IsotropicMarch::Lattice;

constexpr double kNoPath = std::numeric_limits<double>::infinity();

void check_problem(const Problem& problem) {
  if (problem.ring) throw InputError("field: a ring has no source: give ends");
  const ConstraintManifold& domain = *problem.manifold;
  if (domain.dimensions().coordinate != 2 || domain.shape() == Shape::polyhedral)
    throw InputError(
        "field: needs a mesh, space or a box of it, or a domain with two coordinates (the plane, a box of it, terrain, "
        "a chart); here leastcost run gives the least cost between two places, with --pairs between many");
}

/// n at the nodes; nothing where a unit of length does not cost the same in all directions.
std::optional<std::vector<double>> densities_of(const Problem& problem, const Lattice2& lattice) {
  const Dimensions d = problem.manifold->dimensions();
  if (d.ambient != 2 || find_ability<HasChart>(*problem.manifold) != nullptr) return std::nullopt;
  const SegmentCost& cost = *problem.cost;
  const auto* density = find_ability<CostDensity>(cost);
  const auto* conformal = find_ability<HasConformalMetric>(cost);
  const bool isotropic = find_ability<HasCostCells>(cost) != nullptr ||
                         (conformal != nullptr && conformal->base().isIdentity(0)) || MoveCheck(problem).euclidean();
  if (density == nullptr && !isotropic) return std::nullopt;
  std::vector<double> n;
  n.reserve(static_cast<std::size_t>(lattice.count[0]) * static_cast<std::size_t>(lattice.count[1]));
  const Eigen::VectorXd unit = Vector2d(1, 0);
  for (std::int32_t j = 0; j < lattice.count[1]; ++j)
    for (std::int32_t i = 0; i < lattice.count[0]; ++i) {
      const Vector2d x = lattice.place(i, j);
      n.push_back(density != nullptr ? density->density(x) : cost.line_element(x, unit));
    }
  return n;
}

/// Every second node along both sides.
Lattice2 every_second(const Lattice2& lattice) {
  Lattice2 half = lattice;
  half.step *= 2;
  for (std::int32_t& count : half.count) count = (count - 1) / 2 + 1;
  return half;
}

std::vector<double> every_second(const std::vector<double>& values, const Lattice2& lattice) {
  std::vector<double> half;
  for (std::int32_t j = 0; j < lattice.count[1]; j += 2)
    for (std::int32_t i = 0; i < lattice.count[0]; i += 2)
      half.push_back(values[static_cast<std::size_t>(j) * static_cast<std::size_t>(lattice.count[0]) +
                            static_cast<std::size_t>(i)]);
  return half;
}

/// Makes fields of one problem on lattices of several fineness.
class FieldMaker {
 public:
  FieldMaker(const Problem& problem, const std::vector<Eigen::VectorXd>& places, bool to_places, const Monitor& monitor)
      : problem_(problem), moves_(problem), places_(places), to_places_(to_places), monitor_(monitor) {
    problem_.source.u = places[0];
  }

  std::vector<double> marched(const Lattice2& lattice, const std::vector<double>& densities) const {
    IsotropicMarch::Passes passes;
    if (moves_.among_obstacles())
      passes = [this](const Vector2d& a, const Vector2d& b) { return moves_.clear(a, b, kNoPath); };
    IsotropicMarch march(lattice, densities, passes);
    if (find_ability<HasCostCells>(*problem_.cost) != nullptr) march.pass_corners();
    for (const Eigen::VectorXd& place : places_)
      march.start(place, [this](const Vector2d& a, const Vector2d& b) {
        return to_places_ ? moves_.cost(b, a) : moves_.cost(a, b);
      });
    march.run([this] { return monitor_.interrupted(); });
    return march.values();
  }

  std::vector<double> arrived(const Lattice2& lattice, const std::vector<Seam>& seams) const {
    if (seams.empty()) return arrived(lattice, places_);
    const LaidOut wide(lattice, seams);
    return wide.folded(arrived(wide.lattice(), wide.images(places_)));
  }

  std::vector<double> arrived(const Lattice2& lattice, const std::vector<Eigen::VectorXd>& places) const {
    LatticeBox box{lattice.lower, lattice.place(lattice.count[0] - 1, lattice.count[1] - 1), {}, {}};
    ArrivalField::Way how;
    how.whole = true;
    how.reversed = to_places_;
    for (std::size_t i = 1; i < places.size(); ++i) how.sources.emplace_back(places[i]);
    how.cells = {lattice.count[0] - 1, lattice.count[1] - 1};
    const ArrivalField field(problem_, moves_, box, 0, how, [this] { return monitor_.interrupted(); });
    std::vector<double> values;
    const auto nodes = static_cast<std::int32_t>(field.lattice().size());
    values.reserve(static_cast<std::size_t>(nodes));
    for (std::int32_t node = 0; node < nodes; ++node) values.push_back(field.value(node));
    return values;
  }

  /// See CostField::asymmetry.
  double asymmetry(const Lattice2& lattice) const {
    constexpr std::int32_t kSamples = 12;  // along a side
    double worst = 1;
    CoordinatePath ends{Points(2, 2), {}, true};
    for (std::int32_t j = 0; j < kSamples; ++j)
      for (std::int32_t i = 0; i < kSamples; ++i)
        for (const auto& toward : kRing) {
          const Vector2d at = lattice.lower + Vector2d((i + 0.5) / kSamples * lattice.step[0] * (lattice.count[0] - 1),
                                                       (j + 0.5) / kSamples * lattice.step[1] * (lattice.count[1] - 1));
          ends.u << at, at + 0.1 * lattice.step.cwiseProduct(Vector2d(toward[0], toward[1]));
          const Points x = positions(*problem_.manifold, ends);
          const double there = moves_.cost(x.col(0), x.col(1)), back = moves_.cost(x.col(1), x.col(0));
          if (there < kNoPath && there > worst * back) worst = there / back;
          if (back == kNoPath && there < kNoPath) worst = kNoPath;
        }
    return worst;
  }

 private:
  Problem problem_;
  MoveCheck moves_;
  const std::vector<Eigen::VectorXd>& places_;
  bool to_places_;
  const Monitor& monitor_;
};

/// At a place, or a step from it.
std::string why_not_left(const Problem& problem, const Eigen::VectorXd& place, const Lattice2& lattice) {
  std::string why = why_without_cost(problem, place);
  for (std::size_t k = 0; why.empty() && k < kRing.size(); ++k)
    why = why_without_cost(problem, place + lattice.step.cwiseProduct(Vector2d(kRing[k][0], kRing[k][1])));
  return why;
}

/// Throws InputError for a place with no value near it.
void check_left(const Problem& problem, const std::vector<Eigen::VectorXd>& places, const Lattice2& lattice,
                const CostField& field) {
  constexpr double kNear = 3;  // steps
  for (const Eigen::VectorXd& place : places) {
    const Vector2d at = (Vector2d(place) - lattice.lower).cwiseQuotient(lattice.step);
    bool left = false;
    for (int j = 0; j <= 2 * kNear + 1; ++j)
      for (int i = 0; i <= 2 * kNear + 1; ++i) {
        const double x = std::floor(at[0]) - kNear + i, y = std::floor(at[1]) - kNear + j;
        if (x < 0 || y < 0 || x >= lattice.count[0] || y >= lattice.count[1]) continue;
        left = left || std::isfinite(field.value(static_cast<std::int32_t>(x), static_cast<std::int32_t>(y)));
      }
    if (left) continue;
    const std::string why = why_not_left(problem, place, lattice);
    const std::string what =
        "field: no path leaves the place " + point_text(place) + ": " +
        (!why.empty() ? why : "it has no data, obstacles enclose it, or the steps of the lattice are too long");
    if (!why_without_cost(problem, place).empty()) throw InputError(what);
    throw NoWay(what);
  }
}

/// Whether the coordinates are x and y of space, as on terrain: a raster of costs has its values at them.
bool is_over_plane(const Problem& problem, const std::vector<Eigen::VectorXd>& places) {
  constexpr double kRounding = 1e-9;
  return std::all_of(places.begin(), places.end(), [&](const Eigen::VectorXd& u) {
    if (u.size() != 2 || !u.allFinite()) return true;  // check_places() says so
    const Points x = positions(*problem.manifold, {u, {}, true});
    return x.rows() >= 2 && !((x.col(0).head(2) - u).norm() > kRounding * (1 + u.norm()));
  });
}

void check_places(const std::vector<Eigen::VectorXd>& places, const LatticeBox& box) {
  constexpr double kRounding = 1e-9;
  if (places.empty()) throw InputError("field: give at least one place");
  const double tolerance = kRounding * (box.upper - box.lower).maxCoeff();
  for (const Eigen::VectorXd& place : places) {
    if (place.size() != 2 || !place.allFinite())
      throw InputError("field: a place needs two finite coordinates (found " + point_text(place) + ")");
    if (((place - box.lower).array() < -tolerance).any() || ((box.upper - place).array() < -tolerance).any())
      throw InputError("field: the place " + point_text(place) + " is outside the box from " + point_text(box.lower) +
                       " to " + point_text(box.upper));
  }
}

}  // namespace

CostField costs_from(const Problem& problem, const std::vector<Eigen::VectorXd>& given, const CostFieldOptions& options,
                     const Monitor& monitor) {
  check_problem(problem);
  std::optional<RasterPlaces> raster = raster_places_of(*problem.cost);
  if (raster && !is_over_plane(problem, given)) raster.reset();
  const ChartBox chart = chart_box(problem);
  const LatticeBox box = field_box(problem, raster, chart);
  Lattice2 lattice = field_lattice(box, raster, options.resolution, options.equal_steps);
  close_lattice(chart.seams, options.equal_steps, lattice);
  std::vector<Eigen::VectorXd> places;
  places.reserve(given.size());
  for (const Eigen::VectorXd& place : given) places.push_back(in_period(lattice, chart.seams, chart.poles, place));
  check_places(places, box);
  const Lattice2 half = every_second(lattice);
  const bool estimates = options.estimate_error && std::min(half.count[0], half.count[1]) >= 2;
  CostField field;
  field.count = lattice.count, field.lower = lattice.lower, field.step = lattice.step;
  field.places = places;
  field.seams = chart.seams;
  field.poles = chart.poles;
  field.to_places = options.to_places;
  field.directed = !problem.cost->traits().symmetric;
  const FieldMaker maker(problem, places, options.to_places, monitor);
  if (field.directed) field.asymmetry = maker.asymmetry(lattice);
  const std::optional<std::vector<double>> densities = densities_of(problem, lattice);
  field.method = densities ? "isotropic march" : "arrival field";
  field.values = densities ? maker.marched(lattice, *densities) : maker.arrived(lattice, chart.seams);
  check_left(problem, places, lattice, field);
  const auto place_of = [&lattice](std::size_t node) -> Eigen::VectorXd {
    const auto number = static_cast<std::int32_t>(node);
    return lattice.place(number % lattice.count[0], number / lattice.count[0]);
  };
  if (densities) count_free_nodes(*densities, place_of, field);
  field.enclosed = is_enclosed<2>(field);
  if (field.enclosed) check_cost_at(problem, places);
  if (!raster || options.resolution || options.equal_steps)
    field.uncovered = (box.upper - lattice.place(lattice.count[0] - 1, lattice.count[1] - 1)).cwiseMax(0);
  if (!raster)  // whose cells without data are known
    field.without_cost = why_some_without_cost(problem, field.values, place_of);
  // Errors of order h log(1 / h) fall by less than half: the difference is then down to a third of the error.
  const bool smooth = densities && find_ability<ChecksMoves>(*problem.manifold) == nullptr;
  const double factor = smooth ? kOfDensities : kFirstOrder;
  if (estimates)
    estimate_error(
        every_second(field.values, lattice),
        densities ? maker.marched(half, every_second(*densities, lattice)) : maker.arrived(half, chart.seams), factor,
        field);
  if (estimates) allow_for_meeting_fronts<2>(field, !field.seams.empty());
  for (double& value : field.values)
    if (!std::isfinite(value)) value = std::numeric_limits<double>::quiet_NaN();
  return field;
}

CostField corridor(const CostField& from, const CostField& to, double known) {
  if (from.count != to.count || from.lower != to.lower || from.step != to.step)
    throw InputError("corridor: the two fields have different nodes");
  CostField sum = from;
  if (!add_field(to, known, sum)) throw NoWay("corridor: no path joins the two places");
  return sum;
}

}  // namespace leastcost
