// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <leastcost/framework/base/monitor.hpp>
#include <leastcost/framework/domain/has_images.hpp>
#include <leastcost/framework/problem/problem.hpp>

namespace leastcost {

/// `x` by its name nearest to `reference`, where coordinates are names only (HasImages::nearest_name); else `x`.
Eigen::VectorXd nearest_name(const Problem& problem, const Eigen::VectorXd& x, const Eigen::VectorXd& reference);

/// Renames the target of an open path accordingly; not to the source's own coordinates, and not in a loop with a fixed
/// point.
void name_target_near(const Eigen::VectorXd& reference, Problem& problem);

/// Images of a target that are looked at: the nearest to the source in coordinates. Three turns either way about each
/// of two seams and over two poles make more; those are farther.
inline constexpr std::size_t kMostTriedImages = 12;

/// An image of the target, the cost of the straight start to it included.
struct TriedImage {
  PointImage image;  ///< the target by other coordinates
  double cost = 0;   ///< of 32 chords along the straight line in coordinates, projected; infinite where it has none
};

/// Cost of the straight start to the target as it is given; infinite where it has none.
double straight_start_cost(const Problem& problem, const Deadline& deadline);

/// The images of the target (HasImages), cheapest straight start first; the nearest in coordinates need not be the
/// cheapest. Empty for rings and loops with a fixed point, and where the domain knows of none. Throws Interrupted.
std::vector<TriedImage> other_images(const Problem& problem, const Deadline& deadline);

/// Whether source and target are one point: the straight line from the source to the target, or to an image of it, has
/// no length. `image`, where it is given, receives that image; it is left alone where the line to the target itself
/// has no length (two longitudes of a pole). Never for rings and loops with a fixed point.
bool ends_are_one_point(const Problem& problem, std::optional<PointImage>* image = nullptr);

/// The image to which a path costs less than to the target as it is given, by coarse solves of the two with the
/// cheapest straight starts (a straight line through a pole may be cheap, and what becomes of it dear). Less than a
/// hundredth must be seen with twice the segments as well. Nothing where there is none.
struct CheaperImage {
  PointImage image;            ///< the target by other coordinates
  double cost = 0, given = 0;  ///< of coarse solves, to the image and to the target as it is given
  std::size_t tried = 0;       ///< images whose straight starts were looked at
};
/// Looks for such an image. Throws Interrupted.
std::optional<CheaperImage> find_cheaper_image(const Problem& problem, const Monitor& monitor = {});

/// What a report should say of a path that costs `cost`: that its ends are one point, or that a path to another image
/// of the target costs less, by the straight start to it or by a coarse solve of the two most promising ones. Empty
/// where nothing cheaper was seen. Throws Interrupted.
std::string cheaper_image(const Problem& problem, double cost, const Monitor& monitor);

}  // namespace leastcost
