// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include <leastcost/framework/domain/has_images.hpp>
#include <leastcost/framework/path/path.hpp>
#include <leastcost/problems/chart/seams.hpp>

namespace leastcost {

/// The images of u across the seams of a chart and over up to two of its poles in turn, without u itself: the `most`
/// nearest to `reference`, nearest first. Across each seam those up to one turn either way from the nearest are looked
/// at, however many turns off u itself is.
std::vector<PointImage> chart_images(const std::vector<Seam>& seams, const std::vector<SeamMap>& poles,
                                     const Eigen::VectorXd& u, const Eigen::VectorXd& reference, std::size_t most);

/// The columns of a path in a chart, each by that of its names that is nearest to the column before it: the points of a
/// chain are where they are in space, and their coordinates may be those of another sheet of the cover.
Points continued(const HasImages& chart, const Points& u);

}  // namespace leastcost
