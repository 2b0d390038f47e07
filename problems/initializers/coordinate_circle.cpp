// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/initializers/coordinate_circle.hpp>

#include <string>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/problems/chart/seams.hpp>

namespace leastcost {
namespace {

constexpr int kPointsPerTurn = 64, kMostTurns = 1000;

/// Which seam the coordinate crosses.
Index seam_of(const std::vector<Seam>& seams, int coordinate) {
  for (std::size_t s = 0; s < seams.size(); ++s)
    if (seams[s].coordinate == coordinate) return static_cast<Index>(s);
  throw OptionError("coordinate", "coordinate " + std::to_string(coordinate) + " of this chart is not periodic");
}

}  // namespace

void CoordinateCircleOptions::fields(FieldVisitor& visit) {
  visit.field("coordinate", coordinate, {.help = "The coordinate that varies, numbered from 0.", .minimum = 0});
  visit.field("through", through,
              {.help = "A point of the circle, in the coordinates of the chart.", .required = true});
  visit.field("turns", turns, {.help = "Number of turns.", .minimum = 1, .maximum = kMostTurns});
}

CoordinateCircleInitializer::CoordinateCircleInitializer(CoordinateCircleOptions options)
    : options_(std::move(options)) {
  if (options_.turns < 1 || options_.turns > kMostTurns)
    throw OptionError("turns", "from 1 to " + std::to_string(kMostTurns) + ", not " + std::to_string(options_.turns));
}

FirstPath CoordinateCircleInitializer::first_path(const Problem& problem, const Monitor&) const {
  const auto* domain = find_ability<HasSeams>(*problem.manifold);
  if (!problem.ring) throw InitializationError("a coordinate circle is a ring: use path.ring: true");
  if (domain == nullptr) throw InitializationError("a coordinate circle needs a chart with seams");
  const int d = problem.manifold->dimensions().coordinate;
  if (options_.through.size() != d)
    throw OptionError("through",
                      std::to_string(options_.through.size()) + " coordinates, but the chart has " + std::to_string(d));
  const Index seam = seam_of(domain->seams(), options_.coordinate);
  Eigen::VectorXi windings = Eigen::VectorXi::Zero(static_cast<Index>(domain->seams().size()));
  windings[seam] = options_.turns;
  FirstPath first;
  const Index count = kPointsPerTurn * options_.turns;
  first.path = {options_.through.replicate(1, count), {}, true, seam_map(domain->seams(), d, windings)};
  const double step = domain->seams()[static_cast<std::size_t>(seam)].period / kPointsPerTurn;
  for (Index i = 0; i < count; ++i) first.path.u(options_.coordinate, i) += step * static_cast<double>(i);
  Eigen::VectorXd end = options_.through;
  end[options_.coordinate] += step * static_cast<double>(count);
  if ((first.path.column(count) - end).norm() > 1e-9 * (1 + end.norm()))
    throw InitializationError(
        "the circle does not close: crossing the seam reverses another coordinate; start where that one is 0, or use "
        "an even number of turns");
  return first;
}

}  // namespace leastcost
