// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/framework/path/path.hpp>

namespace leastcost {

double extent_of(const Points& points) { return (points.rowwise().maxCoeff() - points.rowwise().minCoeff()).norm(); }

}  // namespace leastcost
