// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/framework/certificate/resolution.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <functional>
#include <numeric>
#include <string>
#include <vector>

#include <leastcost/framework/domain/encloses_level_set.hpp>
#include "framework/base/point_text.hpp"
#include "framework/proof/calibrate.hpp"

namespace leastcost {
namespace {

/// FNV-1a of numbers, bit by bit.
std::uint64_t hash(const double* numbers, Index count) {
  std::uint64_t h = 14695981039346656037ULL;
  for (Index i = 0; i < count; ++i) {
    std::uint64_t bits = 0;
    std::memcpy(&bits, numbers + i, sizeof bits);
    for (int byte = 0; byte < 8; ++byte) h = (h ^ (bits >> (8 * byte) & 0xff)) * 1099511628211ULL;
  }
  return h;
}

/// A number of segments that no other level divides, about a third more than the path has. Which one depends on the
/// path, so that no frequency can be made to fit all levels for everybody.
int other_segments(const CoordinatePath& chain) {
  const int segments = static_cast<int>(chain.segment_count());
  const double part =
      static_cast<double>(hash(chain.u.data(), chain.u.rows()) % 1000 + hash(chain.u.data(), chain.u.size()) % 1000) /
      2000;
  int other = static_cast<int>(std::lround((1.25 + 0.25 * part) * segments)) + 3;
  while (std::gcd(other, segments) > 1 || other % 2 == 0) ++other;
  return other;
}

/// The part w of [0, 1] such that all but a thousandth of its parts of that width hold one of the points i / a or j /
/// b: the sum of what the gaps between them exceed w by is that thousandth.
double seen_width(int a, int b) {
  constexpr double kMissed = 1e-3;
  std::vector<double> at, gaps;
  for (int i = 0; i <= a; ++i) at.push_back(static_cast<double>(i) / a);
  for (int j = 1; j < b; ++j) at.push_back(static_cast<double>(j) / b);
  std::sort(at.begin(), at.end());
  for (std::size_t i = 0; i + 1 < at.size(); ++i) gaps.push_back(at[i + 1] - at[i]);
  std::sort(gaps.begin(), gaps.end(), std::greater<>());
  double sum = 0;
  for (std::size_t k = 0; k < gaps.size(); ++k) {
    sum += gaps[k];
    const double width = (sum - kMissed) / static_cast<double>(k + 1);
    if (k + 1 == gaps.size() || width >= gaps[k + 1]) return std::max(width, 0.0);
  }
  return 0;
}

class Examiner {
 public:
  Examiner(const Problem& problem, const CoordinatePath& chain, const Refinement& refinement, ProofEffort effort,
           CostEstimate& estimate, const Monitor& monitor)
      : problem_(problem),
        chain_(chain),
        refinement_(refinement),
        effort_(effort),
        estimate_(estimate),
        monitor_(monitor) {}

  ExaminedResolution run() {
    compare_other_chain();
    calibrate_finest();
    if (out_.resolution.verdict != ResolutionVerdict::sampled) out_.resolution.narrowest.reset();
    return std::move(out_);
  }

 private:
  void unresolved(std::string why) {
    out_.resolution.verdict = ResolutionVerdict::unresolved;
    out_.failures.push_back({Failure::unresolved, std::move(why)});
  }

  /// The cost of a chain with any number of segments follows from the levels where these see what there is to see.
  void compare_other_chain() {
    constexpr double kOfBar = 5, kOfDifference = 0.5, kOfCost = 1e-11;
    const auto& levels = refinement_.levels;
    if (levels.size() < 3 || !std::isfinite(estimate_.error)) return;
    const int segments = other_segments(chain_);
    const std::optional<double> cost = solved_cost(problem_, chain_, segments, monitor_);
    if (!cost) return;
    out_.resolution.narrowest = seen_width(levels[2].segments, segments) * levels[2].cost;
    const double c2 = levels[1].cost, c4 = levels[2].cost, limit = (4 * c4 - c2) / 3;
    const double ratio = static_cast<double>(levels[2].segments) / segments;
    const double expected = limit + (c4 - limit) * ratio * ratio;
    const double allowed = kOfBar * estimate_.error + kOfDifference * std::abs(expected - limit) + kOfCost * c4;
    if (std::abs(*cost - expected) <= allowed) return;
    const TwoNumbers texts = told_apart(*cost, expected);
    unresolved("a chain with " + std::to_string(segments) + " segments costs " + texts.first +
               ", but the other levels imply " + texts.second +
               ": the cost or the domain has details finer than the segments; use more points");
  }

  void calibrate_finest() {
    if (effort_ == ProofEffort::none || refinement_.paths.size() < 3 || !out_.failures.empty()) return;
    CalibrationOptions options{chain_.segment_count(), estimate_.error / estimate_.value};
    if (effort_ == ProofEffort::insist) options.boxes *= 25;
    const Calibration found = calibrate(problem_, refinement_.paths[2], options, monitor_.limit());
    if (!found.applies) return;
    Resolution& r = out_.resolution;
    r.curve_enclosed = found.upper.has_value();
    r.upper = found.upper;
    if (found.proved) {
      r.minimum_proved = true;
      r.lower = found.lower;
      quote_bounds(found);
    } else if (found.details != DetailVerdict::none) {
      // Near a pole coordinates vary much where the surface does not, and a kink has no scale: sampled.
      if (has_poles() || found.details == DetailVerdict::kink) return;
      return unresolved(
          "near " + point_text(refinement_.paths[2].u.col(found.detail)) +
          (found.details == DetailVerdict::found ? " the cost or the domain has" : " the cost or the domain may have") +
          " details finer than the segments" +
          (find_ability<EnclosesLevelSet>(*problem_.manifold) != nullptr ? " or another sheet" : "") +
          ": use more points");
    }
    r.verdict = ResolutionVerdict::proved;
    r.half_width = found.half_width;
  }

  bool has_poles() const {
    const HasChart* chart = find_ability<HasChart>(*problem_.manifold);
    return chart != nullptr && !chart->poles().empty();
  }

  /// What is proved replaces a bar that contradicts it, and one that is wider. A value between the bounds stays: it is
  /// an extrapolation, and closer than they are.
  void quote_bounds(const Calibration& found) {
    const double upper = *found.upper, proved = upper - found.lower;
    const bool agrees = estimate_.value - estimate_.error <= upper && estimate_.value + estimate_.error >= found.lower;
    if (agrees && estimate_.error <= proved) return;
    if (!(found.lower <= estimate_.value && estimate_.value <= upper)) estimate_.value = upper;
    estimate_.error = std::max(upper - estimate_.value, estimate_.value - found.lower);
    estimate_.method = ValueMethod::bracket;
    estimate_.lower = found.lower;
    estimate_.upper = upper;
  }

  const Problem& problem_;
  const CoordinatePath& chain_;
  const Refinement& refinement_;
  ProofEffort effort_;
  CostEstimate& estimate_;
  const Monitor& monitor_;
  ExaminedResolution out_;
};

}  // namespace

Words<ResolutionVerdict> words(ResolutionVerdict) {
  using enum ResolutionVerdict;
  static constexpr Word<ResolutionVerdict> kWords[] = {
      {sampled, "sampled"}, {proved, "proved"}, {unresolved, "unresolved"}};
  return kWords;
}

ExaminedResolution examine_resolution(const Problem& problem, const CoordinatePath& chain, const Refinement& refinement,
                                      ProofEffort effort, CostEstimate& estimate, const Monitor& monitor) {
  return Examiner(problem, chain, refinement, effort, estimate, monitor).run();
}

}  // namespace leastcost
