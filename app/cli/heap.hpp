// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

namespace leastcost::app {

/// Sets up the heap of this process for many arrays that live shortly: the memory is taken from the system in large
/// steps, in pages of 2 MB where the kernel offers them on request, and kept. Without it a third of a run on a mesh
/// went into page faults. Does nothing with other C libraries than glibc. Call it before the first large array.
void prepare_heap();

}  // namespace leastcost::app
