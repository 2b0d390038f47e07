// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace leastcost {

/// The commit of the sources this was built from, "<40 digits>" or "<40 digits>, changed"; empty where the sources were
/// no checkout. Its definition is written by cmake/source_commit.cmake at build time.
std::string_view source_commit();

}  // namespace leastcost
