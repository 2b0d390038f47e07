// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Robots from URDF files, by component urdf; a library of its own, built where TinyXML-2 is found.

#include <leastcost/urdf/urdf_robot.hpp>
