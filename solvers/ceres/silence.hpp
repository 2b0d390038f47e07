// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

namespace leastcost {

/// Ceres prints its warnings through glog, whatever Options::logging_type says; a library does not print. While one of
/// these lives, in any thread, nothing below a fatal error is printed. (The level is one for the whole process: a host
/// that logs through glog is quiet as long.)
class Silence {
 public:
  Silence();
  ~Silence();
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;
};

}  // namespace leastcost
