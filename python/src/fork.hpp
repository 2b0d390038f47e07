// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

namespace leastcost::python {

/// The processes that this thread forks meanwhile may call functions of Python: a fork holds the GIL, and tells the
/// interpreter of it as os.fork() does. Otherwise a thread that had the GIL at that moment would have it for ever.
class ForksPython {
 public:
  ForksPython();
  ~ForksPython();
  ForksPython(const ForksPython&) = delete;
  ForksPython& operator=(const ForksPython&) = delete;
};

}  // namespace leastcost::python
