// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glog/logging.h>

namespace leastcost {

/// Ceres prints its warnings through glog, whatever Options::logging_type says; a library does not print. While this lives nothing below a fatal
/// error is printed. (The level is one for the whole process: a host that logs through glog from another thread is quiet as long.)
class Silence {
 public:
  Silence() { FLAGS_minloglevel = google::GLOG_FATAL; }
  ~Silence() { FLAGS_minloglevel = before_; }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;

 private:
  int before_ = FLAGS_minloglevel;
};

}  // namespace leastcost
