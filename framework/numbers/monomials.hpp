// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

namespace leastcost {

/// The monomials in N variables up to a degree of three, by degree, and which of them multiply to a third.
template <int N>
struct Monomials {
  static constexpr int kDegree = 3;  ///< of the highest monomials
  /// Number of monomials in N variables.
  static constexpr std::size_t kCount = static_cast<std::size_t>((N + 1) * (N + 2) * (N + 3) / 6);
  using Exponents = std::array<int, static_cast<std::size_t>(N)>;

  /// Monomials a and b, and the one that their product is.
  struct Product {
    std::size_t a = 0, b = 0, to = 0;  ///< numbers of the three
  };
  /// Number of products that are of no higher degree.
  static constexpr std::size_t kProducts = [] {
    int count = 1;  // pairs of monomials are monomials in 2N variables
    for (int i = 1; i <= kDegree; ++i) count = count * (2 * N + i) / i;
    return static_cast<std::size_t>(count);
  }();

  std::array<Exponents, kCount> exponents = {};  ///< of every monomial, by its number
  std::array<int, kCount> degree = {};           ///< of every monomial
  std::array<Product, kProducts> products = {};  ///< in the order of `to`

  constexpr Monomials() {
    std::size_t count = 0;
    for (int d = 0; d <= kDegree; ++d) {
      for (int code = 0; code < 64; ++code) {
        Exponents e = {};
        int rest = code, sum = 0;
        for (auto& exponent : e) {
          exponent = rest % 4;
          sum += exponent;
          rest /= 4;
        }
        if (rest != 0 || sum != d) continue;
        exponents[count] = e;
        degree[count++] = d;
      }
    }
    std::size_t k = 0;
    for (std::size_t to = 0; to < kCount; ++to)
      for (std::size_t a = 0; a < kCount; ++a)
        for (std::size_t b = 0; b < kCount; ++b)
          if (degree[a] + degree[b] == degree[to] && multiply(a, b) == exponents[to]) products[k++] = {a, b, to};
  }

  /// Exponents of the product of two monomials.
  constexpr Exponents multiply(std::size_t a, std::size_t b) const {
    Exponents e = exponents[a];
    for (std::size_t v = 0; v < e.size(); ++v) e[v] += exponents[b][v];
    return e;
  }

  /// kCount where the degree is too high.
  constexpr std::size_t index(const Exponents& e) const {
    for (std::size_t i = 0; i < kCount; ++i)
      if (exponents[i] == e) return i;
    return kCount;
  }
};
/// The table for N variables.
template <int N>
inline constexpr Monomials<N> kMonomials;

}  // namespace leastcost
