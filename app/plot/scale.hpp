// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace leastcost::app {

enum class ScaleKind { linear, log };

/// The numbers an axis shows.
struct Range {
  double least = 0, largest = 1;
};

struct Tick {
  double at = 0;
  std::string label;  ///< empty: a small tick
};

/// Ticks at round numbers within a range, about `wanted` with a label. Linear: steps of 1, 2 or 5 times a power of ten,
/// the labels with as many decimals as the step has. Log: powers of ten, every k-th of them where there are many, 1-2-5
/// steps where there are few.
std::vector<Tick> ticks(ScaleKind kind, Range range, int wanted);

/// The smallest range around finite values (log: positive ones) with some room; a sensible one when there are none.
Range range_of(const std::vector<double>& values, ScaleKind kind);

/// Where a value lies in a range: 0 at its least, 1 at its largest end. NaN where a log scale has no place for it.
double position_in(ScaleKind kind, Range range, double value);

}  // namespace leastcost::app
