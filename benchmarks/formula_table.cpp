// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// A formula from text against the same formula in C++, with the same dual numbers: nanoseconds for value and gradient,
// and the ratio. Target: below 8.
#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <limits>
#include <random>
#include <vector>

#include "problems/formula/formula.hpp"

namespace {

using namespace leastcost;

constexpr std::size_t kPoints = 1024;
constexpr int kRepetitions = 200;

template <class S>
struct Torus {
  static constexpr const char* text = "(sqrt(x^2 + y^2) - R)^2 + z^2 - r^2";
  static S value(const std::array<S, 3>& p) {
    const S w = sqrt(p[0] * p[0] + p[1] * p[1]) - 2.0;
    return w * w + p[2] * p[2] - 1.0;
  }
};
template <class S>
struct Gyroid {
  static constexpr const char* text = "sin(x)*cos(y) + sin(y)*cos(z) + sin(z)*cos(x)";
  static S value(const std::array<S, 3>& p) {
    return sin(p[0]) * cos(p[1]) + sin(p[1]) * cos(p[2]) + sin(p[2]) * cos(p[0]);
  }
};
template <class S>
struct Ellipsoid {
  static constexpr const char* text = "x^2/9 + y^2/4 + z^2 - 1";
  static S value(const std::array<S, 3>& p) { return p[0] * p[0] / 9.0 + p[1] * p[1] / 4.0 + p[2] * p[2] - 1.0; }
};
template <class S>
struct Heart {
  static constexpr const char* text = "(2*x^2 + y^2 + z^2 - 1)^3 - x^2*z^3/10 - y^2*z^3";
  static S value(const std::array<S, 3>& p) {
    const S x2 = p[0] * p[0], y2 = p[1] * p[1], z2 = p[2] * p[2], z3 = z2 * p[2];
    const S s = 2.0 * x2 + y2 + z2 - 1.0;
    return s * s * s - x2 * z3 / 10.0 - y2 * z3;
  }
};

template <class S>
std::vector<std::array<S, 3>> points() {
  std::mt19937_64 engine(1);
  std::uniform_real_distribution<double> uniform(0.2, 2);
  std::vector<std::array<S, 3>> all(kPoints);
  for (auto& p : all)
    for (std::size_t k = 0; k < 3; ++k) {
      p[k] = S(uniform(engine));
      if constexpr (!std::is_same_v<S, double>) p[k].d[k] = decltype(p[k].value)(1.0);
    }
  return all;
}

volatile double sink = 0;

/// Everything that was computed counts, or the compiler leaves it out.
double all_of(double x) { return x; }
template <class S, int N>
double all_of(const Dual<S, N>& x) {
  double sum = all_of(x.value);
  for (const S& d : x.d) sum += all_of(d);
  return sum;
}

/// Nanoseconds per evaluation, the best of several runs.
template <class S, class F>
double measure(const std::vector<std::array<S, 3>>& at, F f) {
  double best = std::numeric_limits<double>::infinity();
  for (int i = 0; i < kRepetitions; ++i) {
    const auto begin = std::chrono::steady_clock::now();
    double sum = 0;
    for (const auto& p : at) sum += all_of(f(p));
    sink = sum;
    const std::chrono::duration<double, std::nano> time = std::chrono::steady_clock::now() - begin;
    best = std::min(best, time.count() / static_cast<double>(at.size()));
  }
  return best;
}

template <template <class> class Function, class S>
void row(const char* what) {
  const Formula formula(Function<S>::text, {"x", "y", "z"}, {{"R", 2}, {"r", 1}});
  const auto at = points<S>();
  const double text = measure<S>(at, [&](const std::array<S, 3>& p) { return formula(std::span<const S>(p)); });
  const double code = measure<S>(at, [](const std::array<S, 3>& p) { return Function<S>::value(p); });
  std::printf("| %-50s | %-16s | %8.1f | %8.1f | %5.2f |\n", Function<S>::text, what, text, code, text / code);
}

template <template <class> class Function>
void rows() {
  row<Function, double>("value");
  row<Function, Dual<double, 3>>("value, gradient");
  row<Function, Dual<Dual<double, 3>, 3>>("value to Hessian");
}

}  // namespace

int main() {
  std::printf("| %-50s | %-16s | %8s | %8s | ratio |\n", "formula", "", "text, ns", "C++, ns");
  rows<Torus>();
  rows<Gyroid>();
  rows<Ellipsoid>();
  rows<Heart>();
}
