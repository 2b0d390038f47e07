// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <leastcost/framework/base/deadline.hpp>
#include <leastcost/framework/base/options.hpp>
#include <leastcost/problems/cloud/neighbour_search.hpp>
#include <leastcost/problems/cloud/point_samples.hpp>

namespace leastcost {

/// Whose normals a cloud has: those of its file, estimated ones, or those of the file where they agree with the
/// estimate.
enum class NormalSource { automatic, given, estimate };
Words<NormalSource> words(NormalSource);

/// How a cloud is turned into samples of a surface. Lengths are in units of the local spacing, the side of the square
/// that one sample has to itself: sqrt(pi / k) times the distance of the k-th neighbour.
struct PointCloudSettings {
  static constexpr double kCleanRadius = 4;                           ///< about 50 samples in a support, 10 by weight
  static constexpr int kFewestNeighbours = 4, kMostNeighbours = 100;  ///< range of the option `neighbours`
  int neighbours = 12;                                                ///< k, kFewestNeighbours to kMostNeighbours
  std::optional<double> radius = {};               ///< support of a sample; else 4, and wider where noise asks for it
  double max_edge = 3;                             ///< longest edge of the neighbour graph
  NormalSource normals = NormalSource::automatic;  ///< where normals come from
};

/// A point of a cloud with what the surface and the graph need to know of it.
struct CloudSample {
  Eigen::Vector3d position;    ///< relative to PointCloud::centre()
  Eigen::Vector3d normal;      ///< unit
  double inverse_radius2 = 0;  ///< 1 / support^2
  double trust = 0;            ///< 1: on the local surface, 0: an outlier, takes no part
};

/// Points sampled from a surface, prepared: spacing, supports, normals, outliers and neighbours of every sample.
/// Immutable. Samples are in an order of their own in which neighbours are close in memory; in_file() tells the number
/// in the file. Positions are relative to centre(), so that large offsets (map coordinates) cost no digits.
///
/// The support of a sample is radius x spacing, smoothed over its neighbours and made to change by at most kRadiusSlope
/// per length, so that the supports that reach a place can be found from the nearest sample alone. Each sample keeps
/// its own, constant support: the weights are then as smooth as the kernel, whatever the density does.
class PointCloud {
 public:
  /// Throws InputError for clouds with too few points or without extent, OptionError for normals: given without
  /// normals, Interrupted after the deadline.
  PointCloud(PointSamples samples, const PointCloudSettings& settings, const Deadline& deadline = {});

  std::int32_t size() const { return static_cast<std::int32_t>(samples_.size()); }  ///< number of samples
  /// A sample: place and normal.
  const CloudSample& sample(std::int32_t i) const { return samples_[static_cast<std::size_t>(i)]; }
  const std::vector<CloudSample>& samples() const { return samples_; }  ///< all of them
  /// The local spacing around a sample, length units.
  double spacing(std::int32_t i) const { return spacing_[static_cast<std::size_t>(i)]; }
  /// Its support, length units.
  double radius(std::int32_t i) const { return radius_[static_cast<std::size_t>(i)]; }
  /// Its number in the file, from 0.
  std::int32_t in_file(std::int32_t i) const { return in_file_[static_cast<std::size_t>(i)]; }
  /// The part of the cloud that a support holds (median). A support that reaches around the whole cloud averages the
  /// surface away, and a coarser version of the cloud would not show it: more than kMostOfCloud is too much.
  double share_of_support() const;
  static constexpr double kMostOfCloud = 0.25;  ///< a larger share_of_support() is too much
  /// Whether the samples end somewhere: the rim of a partial scan, or a hole wider than chance makes it.
  bool has_border() const { return rim_samples_ > 0; }
  std::int32_t rim_samples() const { return rim_samples_; }      ///< samples at the border of the surface
  std::int32_t count_in_file() const { return count_in_file_; }  ///< points of the file, those removed included
  /// The sample with this number in the file, -1 where there is none.
  std::int32_t sample_of_file(std::int32_t number) const;
  /// The k nearest samples, nearest first, without itself.
  const std::int32_t* neighbours(std::int32_t i) const { return &neighbours_[static_cast<std::size_t>(i) * width_]; }
  int neighbour_count() const { return static_cast<int>(width_); }  ///< of every sample
  const NeighbourSearch& search() const { return search_; }         ///< the tree over the samples
  const Eigen::Vector3d& centre() const { return centre_; }         ///< of the box around them
  double diameter() const { return diameter_; }                     ///< diagonal of the bounding box
  const PointCloudSettings& settings() const { return settings_; }  ///< with the radius that was chosen
  const std::vector<std::string>& notes() const { return notes_; }  ///< what was done to the file's points

  /// A radius within which every sample lies whose support reaches a point at `distance` from its nearest sample `i`.
  double reach(std::int32_t i, double distance) const {
    return (radius(i) + kRadiusSlope * distance) / (1 - kRadiusSlope);
  }

  /// The same surface from every other point, evenly thinned, supports wider accordingly.
  PointCloud thinned() const;

 private:
  static constexpr double kRadiusSlope = 0.2;

  void place(const PointSamples& samples);
  void find_neighbours(const Deadline& deadline);
  void measure_spacing();
  void choose_radius();
  void set_radii(const Deadline& deadline);
  void fit_samples(const PointSamples& samples, const Deadline& deadline);
  void choose_normals(const PointSamples& samples, const std::vector<Eigen::Vector3d>& estimates,
                      const Deadline& deadline);
  void link_parts(const std::vector<Eigen::Vector3d>& normals,
                  std::vector<std::pair<std::int32_t, std::int32_t>>& edges) const;
  void gather(std::int32_t i, double radius, std::vector<Neighbour>& found,
              std::vector<Eigen::Vector3d>& offsets) const;

  PointCloudSettings settings_;
  std::string source_;
  std::vector<CloudSample> samples_;
  std::vector<double> spacing_, radius_;
  std::vector<std::int32_t> in_file_, order_, neighbours_;
  std::int32_t count_in_file_ = 0, rim_samples_ = 0;
  std::size_t width_ = 0;
  NeighbourSearch search_;
  Eigen::Vector3d centre_ = Eigen::Vector3d::Zero();
  double diameter_ = 0;
  bool given_normals_ = false;
  std::vector<std::string> notes_;
};

}  // namespace leastcost
