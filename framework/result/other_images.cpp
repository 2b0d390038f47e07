// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/framework/result/other_images.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/domain/checks_moves.hpp>
#include <leastcost/framework/energy/path_energy.hpp>
#include "framework/base/point_text.hpp"
#include "framework/domain/in_parts.hpp"
#include "framework/energy/curve_value.hpp"
#include "framework/energy/spacing.hpp"
#include "framework/newton/chain_newton.hpp"

namespace leastcost {
namespace {

constexpr Index kPieces = 32;
constexpr double kOnePoint = 1e-9;  ///< length of the line between two names of a point over the size of the numbers
constexpr double kCheaper = 1e-6;   ///< relative: below it two images cost the same
constexpr double kCoarseSaving = 0.01;  ///< of a solve with 32 segments, whose cost is good to about a tenth of that
constexpr std::size_t kSolved = 2;
constexpr double kHopeless = 4;  ///< a straight start so many times dearer than the path is not solved

Problem ending_at(const Problem& problem, const Eigen::VectorXd& target) {
  Problem other = problem;
  other.target = {target, kNoSite};
  return other;
}

/// The straight line in coordinates, projected; nothing where a point of it has no place on the domain.
std::optional<CoordinatePath> straight_line(const Problem& problem, const Deadline& deadline) {
  const Eigen::VectorXd &a = problem.source.u, &b = problem.target.u;
  CoordinatePath line{Points(a.size(), kPieces + 1), {}, false};
  for (Index i = 0; i <= kPieces; ++i) {
    const double t = static_cast<double>(i) / kPieces;
    line.u.col(i) = (1 - t) * a + t * b;
  }
  if (!project(*problem.manifold, line, deadline).failed.empty()) return std::nullopt;
  pin_ends(problem, line);
  return line;
}

bool has_no_length(const Problem& problem) {
  const std::optional<CoordinatePath> line = straight_line(problem, {});
  if (!line) return false;
  const Points x = positions(*problem.manifold, *line);
  const double farthest = (x.colwise() - x.col(0)).colwise().norm().maxCoeff();
  return farthest <= kOnePoint * (1 + x.col(0).norm());
}

std::vector<PointImage> images_of(const Problem& problem) {
  const auto* domain = find_ability<HasImages>(*problem.manifold);
  if (domain == nullptr || problem.ring || problem.based) return {};
  return domain->images(problem.target.u, problem.source.u, kMostTriedImages);
}

constexpr double kUnsolved = std::numeric_limits<double>::infinity();

/// Whether a chain has slipped to another sheet of its chart: it is then no path to the image that it was to go to.
bool jumps(PathEnergy& energy, const CoordinatePath& path, const Monitor& monitor) {
  return worst_chart_jump(energy.problem(), path, energy.costs(path), monitor.limit()).ratio > kChartJump;
}

/// Cost of a path that `segments` make of the straight start; infinite where they make none. One that jumps has another
/// chance with four times the segments: beside a pole few of them may seem to.
double solved_cost(const Problem& problem, const Monitor& monitor, Index segments = kPieces) {
  constexpr Index kMore = 4;
  try {
    const std::optional<CoordinatePath> line = straight_line(problem, monitor.limit());
    if (!line) return kUnsolved;
    CoordinatePath path = sample_equally(problem, *line, static_cast<int>(segments) - 1, monitor.limit());
    const double s0 = PathEnergy(problem, 1, monitor.limit()).cost(path) / static_cast<double>(segments);
    if (!(s0 > 0) || !std::isfinite(s0)) return kUnsolved;
    PathEnergy energy(problem, s0, monitor.limit());
    const Termination end = ChainNewton().solve(energy, path, monitor).termination;
    if (!is_solved(end)) return kUnsolved;
    if (!jumps(energy, path, monitor)) return energy.cost(path);
    return segments < kMore * kPieces ? solved_cost(problem, monitor, kMore * kPieces) : kUnsolved;
  } catch (const InitializationError&) {
    return kUnsolved;
  }
}

/// Of the images with the cheapest straight starts the one to which a coarse solve costs least, where that is less than
/// `given` by so much of it.
std::optional<CheaperImage> best_of(const Problem& problem, const std::vector<TriedImage>& tried, double given,
                                    double saving, const Monitor& monitor) {
  std::optional<CheaperImage> best;
  double least = (1 - saving) * given;
  for (std::size_t i = 0; i < std::min(kSolved, tried.size()) && tried[i].cost <= kHopeless * given; ++i) {
    const double solved = solved_cost(ending_at(problem, tried[i].image.u), monitor);
    if (!(solved < least)) continue;
    least = solved;
    best = {tried[i].image, solved, given, tried.size()};
  }
  return best;
}

/// What saves little is believed where twice the segments say so as well, by more than what they change.
bool saves_finer_too(const Problem& problem, const CheaperImage& best, const Monitor& monitor) {
  const double given = solved_cost(problem, monitor, 2 * kPieces);
  const double there = solved_cost(ending_at(problem, best.image.u), monitor, 2 * kPieces);
  const double doubt = std::abs(given - best.given) + std::abs(there - best.cost);
  return given - there > std::max(doubt, kCheaper * given);
}

/// Between opposite meridians the straight line round a pole may be solved to the way over it, with a kink in the chart
/// there: the line over the pole is that way at once.
std::optional<CheaperImage> straight_over_pole(const Problem& problem, const std::vector<TriedImage>& tried,
                                               double given, const Monitor& monitor) {
  constexpr double kMuchCheaper = 0.9, kNearlyThere = 1.001;
  const auto* chart = find_ability<HasChart>(*problem.manifold);
  if (chart == nullptr || chart->poles().size() != 2) return std::nullopt;
  const TriedImage& over = tried.front();
  if (!(over.cost < kMuchCheaper * straight_start_cost(problem, monitor.limit()))) return std::nullopt;
  const double solved = solved_cost(ending_at(problem, over.image.u), monitor);
  if (!(solved <= (1 + kCheaper) * given && over.cost <= kNearlyThere * solved)) return std::nullopt;
  return CheaperImage{over.image, solved, given, tried.size()};
}

std::string named(const PointImage& image) { return point_text(image.u) + ", " + image.where; }

}  // namespace

Eigen::VectorXd nearest_name(const Problem& problem, const Eigen::VectorXd& x, const Eigen::VectorXd& reference) {
  const auto* domain = find_ability<HasImages>(*problem.manifold);
  return domain == nullptr || x.size() != reference.size() ? x : domain->nearest_name(x, reference);
}

void name_target_near(const Eigen::VectorXd& reference, Problem& problem) {
  if (problem.ring || problem.based || problem.manifold == nullptr) return;
  if (problem.target.u.size() != problem.manifold->dimensions().coordinate) return;  // check() says so
  if (problem.source.u.size() != problem.target.u.size()) return;
  const Eigen::VectorXd name = nearest_name(problem, problem.target.u, reference);
  if (name != problem.source.u) problem.target.u = name;
}

double straight_start_cost(const Problem& problem, const Deadline& deadline) {
  const std::optional<CoordinatePath> line = straight_line(problem, deadline);
  return line ? PathEnergy(problem, 1, deadline).cost(*line) : kUnsolved;
}

std::vector<TriedImage> other_images(const Problem& problem, const Deadline& deadline) {
  std::vector<TriedImage> all;
  for (PointImage& image : images_of(problem)) {
    const double cost = straight_start_cost(ending_at(problem, image.u), deadline);
    all.push_back({std::move(image), cost});
  }
  std::stable_sort(all.begin(), all.end(), [](const TriedImage& a, const TriedImage& b) { return a.cost < b.cost; });
  return all;
}

bool ends_are_one_point(const Problem& problem, std::optional<PointImage>* image) {
  if (problem.ring || problem.based || find_ability<HasImages>(*problem.manifold) == nullptr) return false;
  if (has_no_length(problem)) return true;
  for (PointImage& other : images_of(problem)) {
    if (!has_no_length(ending_at(problem, other.u))) continue;
    if (image != nullptr) *image = std::move(other);
    return true;
  }
  return false;
}

std::optional<CheaperImage> find_cheaper_image(const Problem& problem, const Monitor& monitor) {
  const std::vector<TriedImage> tried = other_images(problem, monitor.limit());
  if (tried.empty()) return std::nullopt;
  const double given = solved_cost(problem, monitor);
  std::optional<CheaperImage> best = best_of(problem, tried, given, kCheaper, monitor);
  if (best && best->cost > (1 - kCoarseSaving) * given && !saves_finer_too(problem, *best, monitor)) best.reset();
  return best ? best : straight_over_pole(problem, tried, given, monitor);
}

std::string cheaper_image(const Problem& problem, double cost, const Monitor& monitor) {
  std::optional<PointImage> same;
  if (ends_are_one_point(problem, &same))
    return "both ends are the same point of the domain" + (same ? ": the target is also " + named(*same) : "") +
           "; this path is a loop from that point to itself, and the cheapest path is to stay there";
  const std::vector<TriedImage> tried = other_images(problem, monitor.limit());
  if (tried.empty()) return "";
  const auto said = [&](const PointImage& image, const std::string& start, const std::string& costs, double less) {
    const std::string there =
        image.way.empty() ? "the target is also " + named(image) + ": " + start + " to it" : start + " " + image.way;
    const TwoNumbers texts = told_apart(less, cost);
    return there + costs + texts.first + ", but this path costs " + texts.second +
           " (images tried: " + std::to_string(tried.size()) + ")";
  };
  if (const std::optional<CheaperImage> best = best_of(problem, tried, cost, kCoarseSaving, monitor))
    return said(best->image, "a path", " costs about ", best->cost);
  // A straight line through obstacles promises nothing, nor does a coarse one that saves what its chords cut off.
  const bool obstacles = find_ability<ChecksMoves>(*problem.manifold) != nullptr;
  if (!obstacles && tried[0].cost < (1 - kCoarseSaving) * cost)
    return said(tried[0].image, "even the straight line", " costs ", tried[0].cost);
  return "";
}

}  // namespace leastcost
