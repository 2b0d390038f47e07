// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "app/init/sample_data.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace leastcost::app {
namespace {

/// Height 1 at (x0, y0), falling off over about one width.
double bump(double x, double y, double x0, double y0, double width) {
  return std::exp(-((x - x0) * (x - x0) + (y - y0) * (y - y0)) / (width * width));
}

}  // namespace

std::string sample_mesh() {
  constexpr int kSide = 21;
  std::string out = "# A hill over [0, 1]^2.\n";
  for (int i = 0; i < kSide; ++i)
    for (int j = 0; j < kSide; ++j) {
      const double x = i / (kSide - 1.0), y = j / (kSide - 1.0);
      out += fmt::format("v {:g} {:g} {:.6f}\n", x, y, 0.3 * bump(x, y, 0.5, 0.5, 0.25));
    }
  for (int i = 0; i + 1 < kSide; ++i)
    for (int j = 0; j + 1 < kSide; ++j) {
      const int a = i * kSide + j + 1, b = a + kSide;
      out += fmt::format("f {} {} {}\nf {} {} {}\n", a, b, b + 1, a, b + 1, a + 1);
    }
  return out;
}

std::string sample_cloud() {
  constexpr int kSamples = 3000, kNewtonSteps = 8;
  constexpr double kMajor = 2, kMinor = 1, kTurn = 2 * std::numbers::pi;
  std::string out;
  for (int i = 0; i < kSamples; ++i) {
    // Evenly over the area: v + (r / R) sin v grows evenly, and u by the golden section.
    const double area = kTurn * (i + 0.5) / kSamples, u = kTurn * std::fmod(i * std::numbers::phi, 1.0);
    double v = area;
    for (int k = 0; k < kNewtonSteps; ++k)
      v -= (v + kMinor / kMajor * std::sin(v) - area) / (1 + kMinor / kMajor * std::cos(v));
    const double nx = std::cos(v) * std::cos(u), ny = std::cos(v) * std::sin(u), nz = std::sin(v);
    out += fmt::format("{:.6f} {:.6f} {:.6f} {:.6f} {:.6f} {:.6f}\n", kMajor * std::cos(u) + kMinor * nx,
                       kMajor * std::sin(u) + kMinor * ny, kMinor * nz, nx, ny, nz);
  }
  return out;
}

std::string sample_heights() {
  constexpr int kColumns = 60, kRows = 45, kCell = 25;
  std::string out = fmt::format("ncols {}\nnrows {}\nxllcorner 0\nyllcorner 0\ncellsize {}\nNODATA_value -9999\n",
                                kColumns, kRows, kCell);
  for (int row = 0; row < kRows; ++row)
    for (int column = 0; column < kColumns; ++column) {
      const double x = kCell * (column + 0.5), y = kCell * (kRows - row - 0.5);
      const double height = 200 + 150 * bump(x, y, 700, 620, 260) + 60 * bump(x, y, 1100, 300, 300);
      out += fmt::format("{:.2f}{}", height, column + 1 < kColumns ? ' ' : '\n');
    }
  return out;
}

std::string sample_costs() {
  constexpr int kColumns = 32, kRows = 24;
  std::string out;
  for (int row = 0; row < kRows; ++row)
    for (int column = 0; column < kColumns; ++column) {
      const double x = column + 0.5, y = kRows - row - 0.5;
      out += fmt::format("{:.3f}{}", 1 + 4 * bump(x, y, 16, 11, 6), column + 1 < kColumns ? ',' : '\n');
    }
  return out;
}

std::string sample_rooms() {
  return "type octile\nheight 11\nwidth 26\nmap\n"
         "@@@@@@@@@@@@@@@@@@@@@@@@@@\n"
         "@.......@........@.......@\n"
         "@.......@..TT....@.......@\n"
         "@..........TT............@\n"
         "@.......@........@.......@\n"
         "@@@..@@@@@@@..@@@@@@@..@@@\n"
         "@.......@........@.......@\n"
         "@................@.......@\n"
         "@.......@...TTT..........@\n"
         "@.......@........@.......@\n"
         "@@@@@@@@@@@@@@@@@@@@@@@@@@\n";
}

}  // namespace leastcost::app
