// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "app/plot/scale.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/plot/text.hpp"

namespace leastcost::app {
namespace {

std::string with_minus(std::string text) {
  if (!text.empty() && text[0] == '-') text.replace(0, 1, "−");
  return text;
}

/// 1, 2 or 5 times a power of ten, the nearest one.
double round_step(double wanted) {
  const double power = std::pow(10.0, std::floor(std::log10(wanted))), factor = wanted / power;
  return power * (factor < 1.5 ? 1 : factor < 3.5 ? 2 : factor < 7.5 ? 5 : 10);
}

std::vector<Tick> linear_ticks(Range range, int wanted) {
  const double step = round_step((range.largest - range.least) / wanted);
  const int exponent = static_cast<int>(std::floor(std::log10(step) + 1e-9));
  const double most = std::max(std::abs(range.least), std::abs(range.largest));
  const int leading = static_cast<int>(std::floor(std::log10(most)));
  constexpr int kShort = 2, kLong = 8;  // digits: coordinates of maps are read as they are, 4412030
  const bool scientific = most < 1e-3 || (most >= 1e6 && (leading - exponent <= kShort || leading > kLong));
  std::vector<Tick> out;
  const double first = std::ceil(range.least / step - 1e-9);
  for (double k = first; k * step <= range.largest + 1e-9 * step; ++k) {
    const double at = k * step == 0 ? 0 : k * step;
    std::string label = scientific && at != 0 ? fmt::format("{:.{}f}·{}", at / std::pow(10.0, leading),
                                                            std::max(0, leading - exponent), power_of_ten(leading))
                                              : fmt::format("{:.{}f}", at, scientific ? 0 : std::max(0, -exponent));
    out.push_back({at, with_minus(std::move(label))});
  }
  return out;
}

/// So many multiples of powers of ten: 1, 2 and 5, or all digits.
std::vector<Tick> log_steps(Range range, const std::vector<int>& factors) {
  std::vector<Tick> out;
  for (int e = static_cast<int>(std::floor(std::log10(range.least))); e <= std::log10(range.largest); ++e) {
    for (const int factor : factors) {
      const double at = factor * std::pow(10.0, e);
      if (at < range.least * (1 - 1e-9) || at > range.largest * (1 + 1e-9)) continue;
      const bool plain = e >= -3 && e < 5;
      out.push_back({at, plain         ? fmt::format("{:.{}f}", at, std::max(0, -e))
                         : factor == 1 ? power_of_ten(e)
                                       : fmt::format("{}·{}", factor, power_of_ten(e))});
    }
  }
  return out;
}

/// At least two of them, also within a factor of two.
std::vector<Tick> narrow_log_ticks(Range range) {
  std::vector<Tick> out = log_steps(range, {1, 2, 5});
  if (out.size() < 2) out = log_steps(range, {1, 2, 3, 4, 5, 6, 7, 8, 9});
  return out.size() < 2 ? linear_ticks(range, 3) : out;
}

/// How many multiples of a step the exponents in a range hold.
int powers_in(Range range, int step) {
  const double least = std::ceil((std::log10(range.least) - 1e-9) / step),
               last = std::floor((std::log10(range.largest) + 1e-9) / step);
  return static_cast<int>(last - least) + 1;
}

std::vector<Tick> log_ticks(Range range, int wanted) {
  const double decades = std::log10(range.largest / range.least);
  if (decades < 2) return narrow_log_ticks(range);
  static constexpr int steps[] = {1, 2, 3, 4, 5, 10, 20, 50, 100};
  int step = 1;
  for (const int s : steps)
    if (decades / s <= wanted && powers_in(range, s) >= 2) {
      step = s;
      break;
    }
  std::vector<Tick> out;
  const int last = static_cast<int>(std::floor(std::log10(range.largest) + 1e-9));
  for (int e = static_cast<int>(std::ceil(std::log10(range.least) - 1e-9)); e <= last; ++e) {
    if (e % step == 0)
      out.push_back({std::pow(10.0, e),
                     e >= 0 && e <= 4 && step == 1 ? fmt::format("{:.0f}", std::pow(10.0, e)) : power_of_ten(e)});
    else if (step <= 3)
      out.push_back({std::pow(10.0, e), ""});
  }
  return out;
}

}  // namespace

std::vector<Tick> ticks(ScaleKind kind, Range range, int wanted) {
  return kind == ScaleKind::log ? log_ticks(range, wanted) : linear_ticks(range, wanted);
}

Range range_of(const std::vector<double>& values, ScaleKind kind) {
  Range range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (const double value : values) {
    if (!std::isfinite(value) || (kind == ScaleKind::log && value <= 0)) continue;
    range.least = std::min(range.least, value);
    range.largest = std::max(range.largest, value);
  }
  if (range.least > range.largest) return kind == ScaleKind::log ? Range{0.1, 10} : Range{0, 1};
  if (kind == ScaleKind::log) {
    const double room = std::max(1.25, std::pow(range.largest / range.least, 0.03));
    return {range.least / room, range.largest * room};
  }
  const double spread = range.largest - range.least;
  const double room = spread > 0 ? 0.05 * spread : range.least != 0 ? 0.1 * std::abs(range.least) : 1;
  return {range.least - room, range.largest + room};
}

double position_in(ScaleKind kind, Range range, double value) {
  if (kind == ScaleKind::linear) return (value - range.least) / (range.largest - range.least);
  if (!(value > 0)) return std::numeric_limits<double>::quiet_NaN();
  return std::log(value / range.least) / std::log(range.largest / range.least);
}

}  // namespace leastcost::app
