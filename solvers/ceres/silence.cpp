// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "solvers/ceres/silence.hpp"

#include <glog/logging.h>

#include <mutex>

namespace leastcost {
namespace {

std::mutex mutex;
int alive = 0;   ///< the last one that ends puts the level back
int before = 0;  ///< the level found by the first

}  // namespace

Silence::Silence() {
  const std::lock_guard lock(mutex);
  if (alive++ == 0) before = FLAGS_minloglevel;
  FLAGS_minloglevel = google::GLOG_FATAL;
}

Silence::~Silence() {
  const std::lock_guard lock(mutex);
  if (--alive == 0) FLAGS_minloglevel = before;
}

}  // namespace leastcost
