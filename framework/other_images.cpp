// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/framework/other_images.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include <leastcost/framework/checks_moves.hpp>
#include <leastcost/framework/errors.hpp>
#include <leastcost/framework/path_energy.hpp>
#include "framework/chain_newton.hpp"
#include "framework/in_parts.hpp"
#include "framework/point_text.hpp"
#include "framework/spacing.hpp"

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

/// How many significant digits show that two numbers differ, and by how much: two more than the first that does.
int digits_apart(double a, double b) {
  constexpr int kLeast = 3, kMost = 15;
  const double size = std::max(std::abs(a), std::abs(b)), apart = std::abs(a - b);
  if (!(apart > 0) || !std::isfinite(size)) return kLeast;
  return std::clamp(static_cast<int>(std::ceil(std::log10(size / apart))) + 2, kLeast, kMost);
}

/// Cost of a path that `segments` make of the straight start; infinite where they make none.
double solved_cost(const Problem& problem, const Monitor& monitor, Index segments = kPieces) {
  constexpr double kUnsolved = std::numeric_limits<double>::infinity();
  try {
    const std::optional<CoordinatePath> line = straight_line(problem, monitor.deadline);
    if (!line) return kUnsolved;
    CoordinatePath path = sample_equally(problem, *line, static_cast<int>(segments) - 1, 0.05, 8, monitor.deadline);
    const double s0 = PathEnergy(problem, 1, monitor.deadline).cost(path) / static_cast<double>(segments);
    if (!(s0 > 0) || !std::isfinite(s0)) return kUnsolved;
    PathEnergy energy(problem, s0, monitor.deadline);
    const Termination end = ChainNewton().solve(energy, path, monitor).termination;
    return is_solved(end) ? energy.cost(path) : kUnsolved;
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

std::string named(const PointImage& image) { return point_text(image.u) + ", " + image.where; }

}  // namespace

std::vector<TriedImage> other_images(const Problem& problem, const Deadline& deadline) {
  std::vector<TriedImage> all;
  for (PointImage& image : images_of(problem)) {
    const Problem there = ending_at(problem, image.u);
    const std::optional<CoordinatePath> line = straight_line(there, deadline);
    const double cost = line ? PathEnergy(there, 1, deadline).cost(*line) : std::numeric_limits<double>::infinity();
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
  const std::vector<TriedImage> tried = other_images(problem, monitor.deadline);
  if (tried.empty()) return std::nullopt;
  const double given = solved_cost(problem, monitor);
  std::optional<CheaperImage> best = best_of(problem, tried, given, kCheaper, monitor);
  if (best && best->cost > (1 - kCoarseSaving) * given && !saves_finer_too(problem, *best, monitor)) best.reset();
  return best;
}

std::string cheaper_image(const Problem& problem, double cost, const Monitor& monitor) {
  std::optional<PointImage> same;
  if (ends_are_one_point(problem, &same))
    return "the ends are one point of the domain" + (same ? ": the target is also " + named(*same) : "") +
           "; this path is a loop from that point to itself, and staying there costs nothing";
  const std::vector<TriedImage> tried = other_images(problem, monitor.deadline);
  if (tried.empty()) return "";
  const auto said = [&](const PointImage& image, const std::string& way, double less) {
    const int digits = digits_apart(less, cost);
    return "the target is also " + named(image) + ": " + way + short_number(less, digits) + ", this path " +
           short_number(cost, digits) + " (images tried: " + std::to_string(tried.size()) + ")";
  };
  if (const std::optional<CheaperImage> best = best_of(problem, tried, cost, kCoarseSaving, monitor))
    return said(best->image, "a path to it costs about ", best->cost);
  // A straight line through obstacles promises nothing.
  const bool obstacles = find_ability<ChecksMoves>(*problem.manifold) != nullptr;
  if (!obstacles && tried[0].cost < (1 - kCheaper) * cost)
    return said(tried[0].image, "even the straight line to it costs ", tried[0].cost);
  return "";
}

}  // namespace leastcost
