// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "app/report/study/profiles.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace leastcost::app {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

/// The distribution function of finite values among \`problems\` of them.
Profile distribution(std::vector<double> values, std::size_t problems) {
  std::sort(values.begin(), values.end());
  Profile out;
  for (std::size_t i = 0; i < values.size() && std::isfinite(values[i]); ++i) {
    const double share = static_cast<double>(i + 1) / static_cast<double>(problems);
    if (!out.at.empty() && out.at.back() == values[i]) {
      out.share.back() = share;
    } else {
      out.at.push_back(values[i]);
      out.share.push_back(share);
    }
  }
  return out;
}

/// One profile per solver of work divided by what belongs to the problem.
std::vector<Profile> profiles(const WorkTable& work, const std::vector<double>& divisors) {
  std::vector<Profile> out;
  const std::size_t solvers = work.empty() ? 0 : work[0].size();
  for (std::size_t s = 0; s < solvers; ++s) {
    std::vector<double> values;
    for (std::size_t p = 0; p < work.size(); ++p)
      values.push_back(std::isfinite(work[p][s]) ? work[p][s] / divisors[p] : kNever);
    out.push_back(distribution(std::move(values), work.size()));
  }
  return out;
}

}  // namespace

std::vector<Profile> performance_profiles(const WorkTable& work) {
  std::vector<double> best;
  for (const std::vector<double>& of_problem : work)
    best.push_back(of_problem.empty() ? kNever : *std::min_element(of_problem.begin(), of_problem.end()));
  return profiles(work, best);
}

std::vector<Profile> data_profiles(const WorkTable& work, const std::vector<double>& units) {
  return profiles(work, units);
}

std::optional<double> log_log_slope(const std::vector<double>& x, const std::vector<double>& y, double floor) {
  double n = 0, sum_x = 0, sum_y = 0, sum_xx = 0, sum_xy = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (!(x[i] > 0) || !(y[i] > floor) || !std::isfinite(x[i]) || !std::isfinite(y[i]) || y[i] <= 0) continue;
    const double a = std::log(x[i]), b = std::log(y[i]);
    ++n, sum_x += a, sum_y += b, sum_xx += a * a, sum_xy += a * b;
  }
  const double spread = n * sum_xx - sum_x * sum_x;
  if (n < 2 || spread <= 1e-12 * n * sum_xx) return std::nullopt;
  return (n * sum_xy - sum_x * sum_y) / spread;
}

double work_to_reach(const std::vector<double>& work, const std::vector<double>& excess, double tau) {
  for (std::size_t i = 0; i < work.size(); ++i)
    if (excess[i] <= tau) return work[i];
  return kNever;
}

}  // namespace leastcost::app
