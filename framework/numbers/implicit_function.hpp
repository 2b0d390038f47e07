// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include <leastcost/framework/numbers/interval.hpp>

namespace leastcost {

/// Enclosures of a function of N variables and of all its derivatives up to the third.
template <int N>
struct IntervalDerivatives {
  Interval value;                                               ///< of the function
  std::array<Interval, N> first;                                ///< first derivatives
  std::array<std::array<Interval, N>, N> second;                ///< second derivatives
  std::array<std::array<std::array<Interval, N>, N>, N> third;  ///< third derivatives
};

/// Of h(x), x the first N variables of g and h the last one, where g(x, h(x)) = 0 and h is known to be in `value`: the
/// total derivatives of that, solved for those of h one order after the other. Nothing is known where dg/dh may vanish.
template <int M>
IntervalDerivatives<M - 1> implicit_function(const IntervalDerivatives<M>& g, const Interval& value) {
  constexpr std::size_t kN = M - 1, kH = M - 1;
  const auto& g1 = g.first;
  const auto& g2 = g.second;
  const auto& g3 = g.third;
  IntervalDerivatives<M - 1> h;
  h.value = value;
  for (std::size_t a = 0; a < kN; ++a) h.first[a] = -g1[a] / g1[kH];
  for (std::size_t a = 0; a < kN; ++a)
    for (std::size_t b = 0; b < kN; ++b) {
      const Interval &ha = h.first[a], &hb = h.first[b];
      h.second[a][b] = -(g2[a][b] + g2[a][kH] * hb + g2[b][kH] * ha + g2[kH][kH] * ha * hb) / g1[kH];
    }
  for (std::size_t a = 0; a < kN; ++a)
    for (std::size_t b = 0; b < kN; ++b)
      for (std::size_t c = 0; c < kN; ++c) {
        const Interval &ha = h.first[a], &hb = h.first[b], &hc = h.first[c], &hab = h.second[a][b],
                       &hbc = h.second[b][c], &hca = h.second[c][a];
        Interval sum = g3[a][b][c] + g3[kH][kH][kH] * ha * hb * hc;
        sum += g3[a][b][kH] * hc + g3[b][c][kH] * ha + g3[c][a][kH] * hb;
        sum += g3[a][kH][kH] * hb * hc + g3[b][kH][kH] * hc * ha + g3[c][kH][kH] * ha * hb;
        sum += g2[a][kH] * hbc + g2[b][kH] * hca + g2[c][kH] * hab;
        sum += g2[kH][kH] * (ha * hbc + hb * hca + hc * hab);
        h.third[a][b][c] = -sum / g1[kH];
      }
  return h;
}

}  // namespace leastcost
