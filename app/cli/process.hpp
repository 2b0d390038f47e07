// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

namespace leastcost::app {

/// What main() does first, so that conditions of the host come back as errors of the calls that meet them:
///  * a write to a closed pipe, or beyond the limit of a file's size, fails instead of killing the program;
///  * a standard stream that the caller has closed cannot be written. Left closed, its number would go to the next file
///    that is opened, and what is printed would end up there.
void prepare_process();

}  // namespace leastcost::app
