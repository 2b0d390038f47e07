// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "catalogue/run/memory.hpp"

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <limits>

namespace leastcost {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double limit_of(decltype(RLIMIT_AS) what) {
  rlimit limit{};
  if (::getrlimit(what, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return kInfinity;
  return static_cast<double>(limit.rlim_cur);
}

/// Of a container; "max" and no file are no limit.
double limit_of_group() {
  double bytes = 0;
  return std::ifstream("/sys/fs/cgroup/memory.max") >> bytes ? bytes : kInfinity;
}

}  // namespace

double bytes_of_path(double points, const Dimensions& dimensions) {
  constexpr double kFixed = 1200, kPerNumber = 200, kPerBlockEntry = 24;
  const double d = std::max(dimensions.ambient, dimensions.coordinate), t = dimensions.tangent;
  return points * (kFixed + kPerNumber * d + kPerBlockEntry * t * t);
}

double memory_of_host() {
  const double pages = static_cast<double>(::sysconf(_SC_PHYS_PAGES));
  const double machine = pages > 0 ? pages * static_cast<double>(::sysconf(_SC_PAGESIZE)) : kInfinity;
  return std::min({machine, limit_of(RLIMIT_AS), limit_of(RLIMIT_DATA), limit_of_group()});
}

std::string size_in_words(double bytes) {
  if (bytes < 0x1p30) return fmt::format("{:.{}f} MiB", bytes / 0x1p20, bytes < 0x1p23 ? 1 : 0);
  return fmt::format("{:.1f} GiB", bytes / 0x1p30);
}

}  // namespace leastcost
