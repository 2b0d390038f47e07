// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace leastcost {

/// One reason not to trust a path. `name` is for programs, `message` for people.
struct CertificateFailure {
  std::string name;
  std::string message;
};

}  // namespace leastcost
