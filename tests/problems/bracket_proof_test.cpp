// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// Brackets of planted media in the plane and in space, and what they rest on: the check of a cell, floors, ends, the
// cells that are searched.
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <set>
#include <type_traits>
#include <vector>

#include <leastcost/problems/bracket/search/bracket.hpp>
#include "problems/bracket/search/density_medium.hpp"
#include "problems/bracket/search/tube.hpp"
#include "tests/problems/planted_media.hpp"
#include "tests/problems/planted_space.hpp"
#include "tests/support/catch.hpp"

/// A namespace of its own, for names of bracket are those of others as well.
namespace leastcost::test::bracket_proofs {
namespace {

using namespace bracket;

template <int N>
using Planted = std::conditional_t<N == 2, PlantedMedium, PlantedSpace>;

std::shared_ptr<const CostDensity> density_in(const PlantedMedium& medium) { return density_of(medium.cost()); }
std::shared_ptr<const SpaceDensity> density_in(const PlantedSpace& medium) { return space_density_of(medium.cost()); }

template <int N>
Vector<N> random_direction(Random& random) {
  Vector<N> out;
  for (int k = 0; k < N; ++k) out[k] = random.normal();
  return out.normalized();
}

/// The numbers of a coefficient along the axes: 0, 1 or 2.
template <int N>
std::array<std::size_t, static_cast<std::size_t>(N)> numbers_of(std::size_t coefficient) {
  std::array<std::size_t, static_cast<std::size_t>(N)> out;
  for (std::size_t& number : out) {
    number = coefficient % 3;
    coefficient /= 3;
  }
  return out;
}

/// A cell of side 1 with random coefficients around a plane, and the largest length of its gradient at 33^2 or 9^3
/// places, in long double.
template <int N>
struct RandomCell {
  using Place = std::array<long double, static_cast<std::size_t>(N)>;
  Net<N> u = {};
  long double longest = 0;

  RandomCell(Random& random, double noise) {
    const Vector<N> along = random.uniform(0.5, 2) * random_direction<N>(random);
    for (std::size_t c = 0; c < u.size(); ++c) {
      u[c] = noise * random.normal();
      for (int k = 0; k < N; ++k)
        u[c] += along[k] * (static_cast<double>(numbers_of<N>(c)[static_cast<std::size_t>(k)]) - 1);
    }
    constexpr int kPlaces = N == 2 ? 33 : 9, kAll = N == 2 ? kPlaces * kPlaces : kPlaces * kPlaces * kPlaces;
    for (int n = 0; n < kAll; ++n) {
      Place at;
      int rest = n;
      for (long double& t : at) {
        t = static_cast<long double>(rest % kPlaces) / (kPlaces - 1) - 0.5L;
        rest /= kPlaces;
      }
      longest = std::max(longest, slope(at));
    }
  }
  long double slope(const Place& at) const {
    std::array<std::array<long double, 3>, static_cast<std::size_t>(N)> w, d;
    for (std::size_t k = 0; k < at.size(); ++k) {
      const long double t = at[k];
      w[k] = {(0.5L - t) * (0.5L - t) / 2, 0.75L - t * t, (0.5L + t) * (0.5L + t) / 2};
      d[k] = {t - 0.5L, -2 * t, t + 0.5L};
    }
    Place rise = {};
    for (std::size_t c = 0; c < u.size(); ++c) {
      const auto number = numbers_of<N>(c);
      for (std::size_t along = 0; along < at.size(); ++along) {
        long double product = u[c];
        for (std::size_t k = 0; k < at.size(); ++k) product *= (k == along ? d : w)[k][number[k]];
        rise[along] += product;
      }
    }
    long double squares = 0;
    for (const long double r : rise) squares += r * r;
    return std::sqrt(squares);
  }
};

/// How often the rules claim less than the gradient has.
template <int N>
int false_claims(const CheckRules<N>& rules, double noise, Random& random, int count = 120) {
  int wrong = 0;
  for (int k = 0; k < count; ++k) {
    const RandomCell<N> cell(random, noise);
    wrong += static_cast<long double>(proved_ratio<N>(cell.u, 1, 4, net_of<N>(1), rules)) < cell.longest ? 1 : 0;
  }
  return wrong;
}

/// Largest |grad u| / n at random places where the inequality is said to be proved, over the ratio that is proved; not
/// within obstacles, in which no path is, though the cell may be searched.
template <int N, class Density>
double worst_slope(const BoxPotential<N>& potential, const Density& density, const Eigen::AlignedBox<double, N>& box,
                   const Depth<N>& depth, int count, Random& random) {
  double worst = 0;
  for (int k = 0; k < count; ++k) {
    Vector<N> x;
    for (int axis = 0; axis < N; ++axis) x[axis] = random.uniform(box.min()[axis], box.max()[axis]);
    if (!potential.is_checked(x) || (depth && depth(x) > 0)) continue;
    worst = std::max(worst, potential.gradient(x).norm() / (potential.ratio() * density.density(x)));
  }
  return worst;
}

/// How deep a place lies in balls and cubes that come as near to the flow of a planted medium as they can, their
/// centres a little beside it: of cubes, at least.
template <int N>
class BesideFlow {
 public:
  BesideFlow(const Planted<N>& medium, Random& random) {
    constexpr double kApart = 1e-9;
    const double size = medium.box.sizes().minCoeff();
    for (int k = 0; k < 4; ++k) {
      const auto at = static_cast<std::size_t>(random.integer(0, static_cast<int>(medium.flow.size()) - 1));
      const Vector<N> center = medium.flow[at] + size * random.uniform(0.1, 0.3) * random_direction<N>(random);
      const bool round = k % 2 == 0;
      double reach = kInfinity;
      for (const Vector<N>& x : medium.flow) reach = std::min(reach, distance(x - center, round));
      obstacles_.push_back({center, reach * (1 - kApart) - medium.flow_step(), round});
    }
  }
  double operator()(const Vector<N>& x) const {
    double deepest = -kInfinity;
    for (const Taken& o : obstacles_) deepest = std::max(deepest, o.reach - distance(x - o.center, o.round));
    return deepest;
  }

 private:
  struct Taken {
    Vector<N> center;
    double reach;
    bool round;
  };
  static double distance(const Vector<N>& d, bool round) { return round ? d.norm() : d.cwiseAbs().maxCoeff(); }
  std::vector<Taken> obstacles_;
};

double cone_at(const EndSquare<DensityCone>& end, const Vector<2>& d) { return end.cone.value(d[0], d[1]); }
double cone_at(const EndBall& end, const Vector<3>& d) {
  return std::min(end.cone<double>({d[0], d[1], d[2]}), end.most);
}

}  // namespace

/// A bound above a true least cost is the worst defect. LEASTCOST_BRACKET_PROBLEMS sets another number of them. Every
/// third is among obstacles that touch the flow, nearly.
TEMPLATE_TEST_CASE_SIG("bracket: never above a planted least cost", "", ((int N), N), 2, 3) {
  constexpr double kOfTruth = 1e-13;  // relative rounding of the planted least cost itself
  Random random;
  const int count = planted_problems(N == 2 ? 40 : 12);
  std::vector<double> gaps, gaps_among;
  int open = 0;
  for (int k = 0; k < count; ++k) {
    CAPTURE(k);
    const auto medium = Planted<N>::random(random);
    const auto density = density_in(medium);
    const double truth = medium.least_cost();
    BoxBracketOptions<N> options{.tolerance = 1e-12};
    if (N == 2) {
      options.cells = k % 10 == 0 ? 64 : random.integer(24, 40);
      options.max_cells = 330;
    } else {
      options.cells = random.integer(12, 18);
      options.max_cells = k % 4 == 0 ? 72 : 36;
      options.max_searched = 2e5;
    }
    const bool among = k % 3 == 2;
    open += among ? 0 : 1;
    if (among) options.depth = BesideFlow<N>(medium, random);
    const double known = among || k % 2 == 0 ? truth * (1 + random.uniform(1e-6, 1e-3)) : kInfinity;
    const auto bracket = bracket_least_cost(*density, medium.box, medium.source, medium.target, known, options);
    REQUIRE(bracket.lower <= truth * (1 + kOfTruth));
    REQUIRE(bracket.upper >= truth * (1 - kOfTruth));
    if (!bracket.potential) continue;
    CHECK(worst_slope<N>(*bracket.potential, *density, medium.box, options.depth, N == 2 ? 500 : 2000, random) <=
          1 + 1e-11);
    (among ? gaps_among : gaps).push_back(1 - bracket.lower / truth);
  }
  std::sort(gaps.begin(), gaps.end());
  std::sort(gaps_among.begin(), gaps_among.end());
  REQUIRE(static_cast<double>(gaps.size()) >= (N == 2 ? 0.9 : 0.5) * open);
  CHECK(gaps[gaps.size() / 2] < (N == 2 ? 1e-3 : 0.03));
  if (count < 100) return;
  for (const std::vector<double>* all : {&gaps, &gaps_among})
    WARN(all->size() << " of " << count << (all == &gaps ? " bounded in the open" : " bounded among obstacles")
                     << "; gap: median " << (*all)[all->size() / 2] << ", 90 % " << (*all)[all->size() * 9 / 10]
                     << ", largest " << all->back());
}

TEMPLATE_TEST_CASE_SIG("bracket: the polyline of a planted flow costs what it has to", "", ((int N), N), 2, 3) {
  Random random;
  for (int k = 0; k < (N == 2 ? 20 : 5); ++k) {
    const auto medium = Planted<N>::random(random);
    Way<N> x(N, static_cast<Eigen::Index>(medium.flow.size()));
    for (std::size_t i = 0; i < medium.flow.size(); ++i) x.col(static_cast<Eigen::Index>(i)) = medium.flow[i];
    const double cost = polyline_cost_above(*density_in(medium), x), truth = medium.least_cost();
    CHECK(cost >= truth);
    CHECK(cost <= truth * (1 + 1e-4));
  }
}

/// Mutations of the check are seen by the same comparison that the check itself passes.
TEMPLATE_TEST_CASE_SIG("bracket: the check of a cell, and checks that are not", "", ((int N), N), 2, 3) {
  Random random;
  for (const double noise : {0.0, 1e-14, 1e-3, 0.3})
    for (const int halvings : {0, 1, 2})
      if (N == 2 || halvings < 2) CHECK(false_claims<N>({.halvings = halvings}, noise, random) == 0);
  CHECK(false_claims<N>({.rounding = -1}, 0, random) > 30);
  for (unsigned k = 0; k < Net<N>().size(); ++k) {
    const auto numbers = numbers_of<N>(k);
    const auto middles = std::ranges::count(numbers, 1U);
    if (middles == N || (N == 3 && middles > 0)) continue;  // means of others: no spline is known that needs them
    CAPTURE(k);
    CHECK(false_claims<N>({.dropped = 1U << k, .halvings = 0}, 0.3, random, 240) > 0);
  }
}

TEMPLATE_TEST_CASE_SIG("bracket: where a coefficient is not known nothing is proved", "", ((int N), N), 2, 3) {
  Random random;
  constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
  for (int k = 0; k < 200; ++k) {
    Net<N> u = RandomCell<N>(random, 0.1).u;
    const auto somewhere = [&] { return static_cast<std::size_t>(random.integer(0, static_cast<int>(u.size()) - 1)); };
    for (int n = random.integer(1, 3); n > 0; --n)
      u[somewhere()] = std::array<double, 3>{kInfinity, -kInfinity, kUnknown}[static_cast<std::size_t>(k % 3)];
    if (k % 4 == 0) u[somewhere()] = -kInfinity;
    CHECK(proved_ratio<N>(u, 1, 4, net_of<N>(1)) == kInfinity);
    Net<N> floor = net_of<N>(1);
    floor[somewhere()] = kUnknown;
    CHECK(proved_ratio<N>(RandomCell<N>(random, 0.1).u, 1, 4, floor) == kInfinity);
  }
}

TEMPLATE_TEST_CASE_SIG("bracket: the floor of a density lies below it, and near", "", ((int N), N), 2, 3) {
  Random random;
  for (int k = 0; k < 20; ++k) {
    const auto medium = Planted<N>::random(random);
    const auto density = density_in(medium);
    const Grid<N> grid = Grid<N>::over(medium.box, 40);
    bracket::Place<N> cell;
    for (std::size_t axis = 0; axis < cell.size(); ++axis) cell[axis] = random.integer(1, grid.cells[axis]);
    for (const bool is_fine : {false, true}) {
      Floors<N> floors;
      floors.add_cell(*density, grid, cell, is_fine);
      const Net<N> floor = floors.on_cell(grid, cell, 0);
      for (int n = 0; n < 50; ++n) {
        Vector<N> t;
        for (int axis = 0; axis < N; ++axis) t[axis] = random.uniform(0, 1);
        const Vector<N> x = grid.node(cell) + grid.h * (t - 0.5 * Vector<N>::Ones());
        if (!medium.box.contains(x)) continue;
        double value = 0;
        for (std::size_t c = 0; c < floor.size(); ++c) {
          double weight = 1;
          for (int axis = 0; axis < N; ++axis) {
            const double s = t[axis];
            weight *= std::array<double, 3>{(1 - s) * (1 - s), 2 * s * (1 - s),
                                            s * s}[numbers_of<N>(c)[static_cast<std::size_t>(axis)]];
          }
          value += weight * floor[c];
        }
        CHECK(value <= medium.density(x));
        CHECK(value >= medium.density(x) - 0.05);
      }
    }
  }
}

/// The cells around the ends: with those that the check left out the bound holds, with fewer it uses a part of the
/// potential that nobody has checked.
TEMPLATE_TEST_CASE_SIG("bracket: an end with too few cells is caught", "", ((int N), N), 2, 3) {
  using M = DensityMedium<N>;
  auto flat = Planted<N>();  // of density 1
  const auto density = density_in(flat);
  const std::function<bool()> never;
  const StopLook look(never);
  Vector<N> source = Vector<N>::Constant(0.512), low = Vector<N>::Constant(0.2), high = Vector<N>::Constant(0.8);
  source[0] = 0.262, low[0] = 0, high[0] = 1;
  const Vector<N> target = source + 0.5 * Vector<N>::UnitX();
  const Depth<N> open;
  const Setting<M> setting{M(*density), Obstacles<N>(open)};
  const Level<M> level = whole_level(setting, {low, high}, 40, look);
  const auto s = setting.medium.end(level.grid, source, 3, false), t = setting.medium.end(level.grid, target, 3, true);
  REQUIRE(s.valid);
  REQUIRE(t.valid);
  REQUIRE(s.k == 3);
  std::vector<double> u(level.density.size()), ratios;
  for (int node = 0; node < level.nodes.none(); ++node)
    u[static_cast<std::size_t>(node)] = level.grid.coordinate(0, level.nodes.place(node)[0]);
  // Within the cells of the source, seen by no cell outside.
  u[static_cast<std::size_t>(level.nodes.find(s.middle))] -= 0.3;
  const auto bound = [&](const typename M::End& around_s, double ratio) {
    return rim_minimum(level.grid, level.nodes, around_s, level.searched, u, -1, ratio) +
           rim_minimum(level.grid, level.nodes, t, level.searched, u, 1, ratio);
  };
  const double truth = 0.5, ratio = check(level, u, s, t, ratios, look);
  CHECK(ratio < 1 + 1e-9);
  CHECK(bound(s, ratio) <= truth);
  CHECK(bound(s, ratio) > 0.9 * truth);
  auto small = s;
  small.k = 0;
  CHECK(bound(small, ratio) > truth);  // what too few cells would claim
  const double of_small = check(level, u, small, t, ratios, look);
  CHECK(of_small > 2);
  CHECK(bound(small, of_small) <= truth);
}

/// v of the cells around the ends, against the costs of planted media: along their flow, whichever way it goes on.
TEMPLATE_TEST_CASE_SIG("bracket: the cone at an end lies below the cost", "", ((int N), N), 2, 3) {
  Random random;
  int valid = 0, straight = 0;
  const int count = N == 2 ? 200 : 40;
  for (int k = 0; k < count; ++k) {
    const auto medium = Planted<N>::random(random);
    const auto density = density_in(medium);
    const int cells = N == 3 ? random.integer(20, 80) : k % 2 == 0 ? random.integer(30, 200) : random.integer(6, 20);
    const Grid<N> grid = Grid<N>::over(medium.box, cells);
    const auto end = DensityMedium<N>(*density).end(grid, medium.source, random.integer(1, N == 2 ? 12 : 6), false);
    if (!end.valid) continue;
    ++valid;
    if constexpr (N == 2) straight += end.cone.c == 0 && end.cone.gx == 0 ? 1 : 0;
    for (const Vector<N>& x : medium.flow) {
      if (!end.holds(grid.place_at(x))) break;
      CHECK(cone_at(end, x - medium.source) <= (medium.u(x) - medium.u(medium.source)) * (1 + 1e-12) + 1e-15);
    }
  }
  CHECK(valid > 0.8 * count);
  if (N == 2) CHECK(straight > 20);  // on coarse grids
}

/// No cell of the flow is left out for what costs a little more, and some are for what costs less than any path.
TEMPLATE_TEST_CASE_SIG("bracket: the cells of a cheaper path are searched", "[slow_sanitized]", ((int N), N), 2, 3) {
  using M = DensityMedium<N>;
  Random random;
  const std::function<bool()> never;
  const StopLook look(never);
  const Depth<N> open;
  int wrong = 0;
  for (int k = 0; k < 10; ++k) {
    CAPTURE(k);
    const auto planted = Planted<N>::random(random);
    const auto density = density_in(planted);
    const Setting<M> setting{M(*density), Obstacles<N>(open)};
    const Level<M> level = whole_level(setting, planted.box, random.integer(16, 24), look);
    FastMarching marching(look);
    const auto bound = [&](const Vector<N>& from, const Vector<N>& other, bool reversed) {
      const auto end = setting.medium.end(level.grid, from, 2, reversed);
      return distance_bound(level, distance_field(setting.medium, level, end, marching), other, kInfinity, marching);
    };
    const DistanceBound<M> from_s = bound(planted.source, planted.target, false),
                           from_t = bound(planted.target, planted.source, true);
    if (!from_s.end.valid || !from_t.end.valid) continue;
    const Grid<N> fine = level.grid.refined(4);
    const auto left_out = [&](double upper) {
      const auto cells = reached_cells(setting.obstacles, level, from_s, from_t, upper, 4, look);
      const std::set<bracket::Place<N>> searched(cells.begin(), cells.end());
      return std::ranges::count_if(planted.flow,
                                   [&](const Vector<N>& x) { return !searched.contains(fine.place_at(x)); });
    };
    CHECK(left_out(planted.least_cost() * (1 + 1e-6)) == 0);
    wrong += left_out(0.8 * planted.least_cost()) > 0 ? 1 : 0;
  }
  CHECK(wrong > 2);
}

}  // namespace leastcost::test::bracket_proofs
