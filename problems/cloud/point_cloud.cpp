// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/cloud/point_cloud.hpp>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <queue>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/problems/graph/sparse_graph.hpp>
#include "framework/base/point_text.hpp"
#include "framework/base/sound_size.hpp"
#include "problems/cloud/local_fit.hpp"
#include "problems/cloud/orient_normals.hpp"

namespace leastcost {
namespace {

constexpr double kRadius = PointCloudSettings::kCleanRadius;
constexpr std::int32_t kLook = 32;        ///< samples between looks at the clock: a fit takes some 20 us
constexpr double kWidestRadius = 32;      ///< spacings
constexpr double kNoise = 0.125;          ///< largest standard deviation of the noise, in supports
constexpr int kNoiseProbes = 400;         ///< samples that are asked for it
constexpr std::size_t kMostForFit = 160;  ///< neighbours of a fit: of more, every other or third one
constexpr double kOutlier = 6;            ///< standard deviations off the local fit at which trust ends
constexpr double kScaleFloor = 0.01;      ///< of the support: below it a deviation is curvature, not noise
constexpr double kCrowded = 0.1;          ///< part of the neighbours that is another sheet
constexpr double kPartsApart = 12;        ///< spacings between parts whose sides go together
constexpr double kSteepLink = 0.5;        ///< sine of 30 degrees out of the tangent planes
constexpr double kBends = 2;              ///< supports over the radius of curvature
constexpr double kMuchBent = 0.1;         ///< part of the cloud that is worth a note
constexpr double kRimOffset = 0.3;        ///< supports from a place one spacing outside to the mean of the samples
constexpr double kAgreement = 0.985;      ///< median |cos| of given and estimated normals (10 degrees)

/// Bits of a 21-bit number spread to every third bit.
std::uint64_t spread_bits(std::uint64_t x) {
  x &= 0x1fffff;
  x = (x | x << 32) & 0x1f00000000ffffULL;
  x = (x | x << 16) & 0x1f0000ff0000ffULL;
  x = (x | x << 8) & 0x100f00f00f00f00fULL;
  x = (x | x << 4) & 0x10c30c30c30c30c3ULL;
  return (x | x << 2) & 0x1249249249249249ULL;
}

/// Positions in the order of a Z-shaped curve: what is close in space is close in memory.
std::vector<std::int32_t> spatial_order(const std::vector<Eigen::Vector3d>& positions, const Eigen::Vector3d& low,
                                        double size) {
  std::vector<std::pair<std::uint64_t, std::int32_t>> keys;
  keys.reserve(positions.size());
  for (const Eigen::Vector3d& p : positions) {
    std::uint64_t key = 0;
    for (int axis = 0; axis < 3; ++axis)
      key |= spread_bits(static_cast<std::uint64_t>((p[axis] - low[axis]) / size * 0x1fffff)) << axis;
    keys.emplace_back(key, static_cast<std::int32_t>(keys.size()));
  }
  std::sort(keys.begin(), keys.end());
  std::vector<std::int32_t> order;
  order.reserve(keys.size());
  for (const auto& [key, index] : keys) order.push_back(index);
  return order;
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Whether the neighbours, given as offsets, leave one side free: one spacing towards it their mean is far off.
bool leave_a_side(const std::vector<Eigen::Vector3d>& offsets, const Eigen::Vector3d& normal, double spacing,
                  double radius) {
  const auto mean_along = [&](const Eigen::Vector3d& from) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double weight = 0;
    for (const Eigen::Vector3d& q : offsets) {
      const double t = 1 - (q - from).squaredNorm() / (radius * radius);
      if (!(t > 0)) continue;
      weight += t * t * t * t;
      sum += t * t * t * t * (q - from);
    }
    const Eigen::Vector3d mean = weight > 0 ? Eigen::Vector3d(sum / weight) : sum;
    return Eigen::Vector3d(mean - normal.dot(mean) * normal);
  };
  const Eigen::Vector3d inward = mean_along(Eigen::Vector3d::Zero());
  if (!(inward.norm() > 0)) return false;
  return mean_along(-spacing * inward.normalized()).norm() > kRimOffset * radius;
}

}  // namespace

Words<NormalSource> words(NormalSource) {
  static constexpr std::array<Word<NormalSource>, 3> kWords = {
      {{NormalSource::automatic, "auto"}, {NormalSource::given, "given"}, {NormalSource::estimate, "estimate"}}};
  return kWords;
}

PointCloud::PointCloud(PointSamples samples, const PointCloudSettings& settings, const Deadline& deadline)
    : settings_(settings), source_(std::move(samples.source)), search_({}), notes_(std::move(samples.notes)) {
  if (settings_.radius && !(*settings_.radius > 0)) throw OptionError("radius", "must be greater than 0");
  if (settings_.neighbours < PointCloudSettings::kFewestNeighbours ||
      settings_.neighbours > PointCloudSettings::kMostNeighbours)
    throw OptionError("neighbours", "must be from " + std::to_string(PointCloudSettings::kFewestNeighbours) + " to " +
                                        std::to_string(PointCloudSettings::kMostNeighbours) + ", not " +
                                        std::to_string(settings_.neighbours));
  place(samples);
  find_neighbours(deadline);
  measure_spacing();
  choose_radius();
  set_radii(deadline);
  fit_samples(samples, deadline);
}

void PointCloud::place(const PointSamples& samples) {
  const std::vector<Eigen::Vector3d>& all = samples.positions;
  const std::size_t fewest =
      std::max<std::size_t>(static_cast<std::size_t>(settings_.neighbours) + 1, 2 * kFewestForFit);
  if (all.size() < fewest)
    throw InputError(source_ + ": " + std::to_string(all.size()) + " points, but at least " + std::to_string(fewest) +
                     " are needed to fit surfaces to " + std::to_string(settings_.neighbours) + " neighbours");
  Eigen::AlignedBox3d box;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!all[i].allFinite())
      throw InputError(source_ + ": point " + std::to_string(i) + " has coordinates that are not finite");
    box.extend(all[i]);
  }
  centre_ = box.min() + box.sizes() / 2;
  diameter_ = box.diagonal().norm();
  check_sound_size(source_ + ": the extent of the points", box.sizes().maxCoeff());
  order_ = spatial_order(all, box.min(), box.sizes().maxCoeff());
  samples_.resize(all.size());
  in_file_.resize(all.size());
  count_in_file_ = samples.count_in_file > 0 ? samples.count_in_file : static_cast<std::int32_t>(all.size());
  std::vector<Eigen::Vector3d> points(all.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto from = static_cast<std::size_t>(order_[i]);
    points[i] = all[from] - centre_;
    samples_[i].position = points[i];
    in_file_[i] = samples.in_file.empty() ? order_[i] : samples.in_file[from];
  }
  search_ = NeighbourSearch(std::move(points));
}

void PointCloud::find_neighbours(const Deadline& deadline) {
  width_ = static_cast<std::size_t>(settings_.neighbours);
  neighbours_.resize(samples_.size() * width_);
  spacing_.resize(samples_.size());
  std::vector<Neighbour> found;
  for (std::int32_t i = 0; i < size(); ++i) {
    if (i % kLook == 0) look_at_clock(deadline);
    search_.nearest(sample(i).position, settings_.neighbours + 1, found);
    std::size_t n = 0;
    for (const Neighbour& other : found)
      if (other.index != i && n < width_) neighbours_[static_cast<std::size_t>(i) * width_ + n++] = other.index;
    spacing_[static_cast<std::size_t>(i)] =
        std::sqrt(found.back().squared_distance * std::numbers::pi / settings_.neighbours);
  }
}

/// The median over the neighbours, then their mean: an isolated point has the spacing of its surroundings.
void PointCloud::measure_spacing() {
  for (const bool robust : {true, false}) {
    std::vector<double> smooth(spacing_.size()), near(width_ + 1);
    for (std::int32_t i = 0; i < size(); ++i) {
      near[width_] = spacing(i);
      for (std::size_t j = 0; j < width_; ++j) near[j] = spacing(neighbours(i)[j]);
      smooth[static_cast<std::size_t>(i)] =
          robust ? median(near) : std::accumulate(near.begin(), near.end(), 0.0) / static_cast<double>(near.size());
    }
    spacing_ = std::move(smooth);
  }
}

void PointCloud::gather(std::int32_t i, double radius, std::vector<Neighbour>& found,
                        std::vector<Eigen::Vector3d>& offsets) const {
  search_.within(sample(i).position, radius, found);
  offsets.clear();
  const std::size_t stride = (found.size() + kMostForFit - 1) / kMostForFit;
  for (std::size_t k = 0; k < found.size(); k += stride)
    offsets.emplace_back(sample(found[k].index).position - sample(i).position);
}

double PointCloud::share_of_support() const {
  std::vector<double> counts;
  std::vector<Neighbour> found;
  const std::int32_t stride = std::max(1, size() / kNoiseProbes);
  for (std::int32_t i = stride / 2; i < size(); i += stride) {
    search_.within(sample(i).position, radius(i), found);
    counts.emplace_back(static_cast<double>(found.size()));
  }
  return median(counts) / size();
}

/// Noise must be small against the support, or there is no surface to see in it: wider until it is.
void PointCloud::choose_radius() {
  if (settings_.radius) return;
  double& support = settings_.radius.emplace(kRadius);
  std::vector<Neighbour> found;
  std::vector<Eigen::Vector3d> offsets;
  const std::int32_t stride = std::max(1, size() / kNoiseProbes);
  double noise = 0;
  for (;; support *= std::numbers::sqrt2) {
    std::vector<double> noises, counts;
    for (std::int32_t i = stride / 2; i < size(); i += stride) {
      const double radius = support * spacing(i);
      gather(i, radius, found, offsets);
      counts.emplace_back(static_cast<double>(found.size()));
      const LocalFit fit = fit_locally(offsets, radius);
      if (fit.valid) noises.emplace_back(fit.scale / radius);
    }
    if (noises.empty()) throw InputError(source_ + ": no neighbourhood looks like a surface (the points lie on lines)");
    noise = median(noises);
    const double next_count = 2 * median(counts);
    if (noise <= kNoise || support >= kWidestRadius || next_count > PointCloud::kMostOfCloud * size()) break;
  }
  if (support > kRadius)
    notes_.push_back("the cloud is noisy, or has sheets closer than two spacings: the radius was increased from " +
                     short_number(kRadius) + " to " + short_number(support) + " spacings (noise " +
                     short_number(noise * support) + " spacings)");
}

/// radius x spacing, lowered where it would change faster than kRadiusSlope per length: the smallest propagate
/// outwards.
void PointCloud::set_radii(const Deadline& deadline) {
  radius_.resize(samples_.size());
  using Entry = std::pair<double, std::int32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  for (std::int32_t i = 0; i < size(); ++i) {
    radius_[static_cast<std::size_t>(i)] = *settings_.radius * spacing(i);
    queue.emplace(radius(i), i);
  }
  for (std::int64_t step = 0; !queue.empty(); ++step) {
    look_at_clock(deadline, step);
    const auto [value, i] = queue.top();
    queue.pop();
    if (value > radius(i)) continue;
    for (std::size_t k = 0; k < width_; ++k) {
      const std::int32_t j = neighbours(i)[k];
      const double most = value + kRadiusSlope * (sample(i).position - sample(j).position).norm();
      if (most >= radius(j)) continue;
      radius_[static_cast<std::size_t>(j)] = most;
      queue.emplace(most, j);
    }
  }
  for (std::int32_t i = 0; i < size(); ++i)
    samples_[static_cast<std::size_t>(i)].inverse_radius2 = 1 / (radius(i) * radius(i));
}

void PointCloud::fit_samples(const PointSamples& samples, const Deadline& deadline) {
  std::vector<Eigen::Vector3d> estimates(samples_.size()), offsets;
  std::vector<Neighbour> found;
  std::int32_t outliers = 0, crowded = 0, bent = 0;
  for (std::int32_t i = 0; i < size(); ++i) {
    if (i % kLook == 0) look_at_clock(deadline);
    gather(i, radius(i), found, offsets);
    const LocalFit fit = fit_locally(offsets, radius(i));
    estimates[static_cast<std::size_t>(i)] = fit.valid ? fit.normal : Eigen::Vector3d::UnitZ();
    const double scale = std::max(fit.scale, kScaleFloor * radius(i));
    const double t = fit.height / (kOutlier * scale);
    const double trust = fit.valid && std::abs(t) < 1 ? (1 - t * t) * (1 - t * t) : 0;
    samples_[static_cast<std::size_t>(i)].trust = trust;
    if (!(trust > 0)) ++outliers;
    if (fit.apart > kCrowded) ++crowded;
    if (fit.shape.norm() * radius(i) > kBends) ++bent;
    if (trust > 0 && leave_a_side(offsets, fit.normal, spacing(i), radius(i))) ++rim_samples_;
  }
  if (outliers == size())
    throw InputError(source_ + ": no neighbourhood looks like a surface (the points lie on lines)");
  if (outliers > 0)
    notes_.push_back(std::to_string(outliers) + " of " + std::to_string(size()) +
                     " points were excluded from the surface: they are far from their neighbours, or have too few");
  if (crowded > 0)
    notes_.push_back(std::to_string(crowded) + " of " + std::to_string(size()) +
                     " points have another sheet, or the far side of an edge, within their radius, which pulls the "
                     "surface towards it; to separate them, use a smaller radius");
  if (bent > kMuchBent * size())
    notes_.push_back(std::to_string(bent) + " of " + std::to_string(size()) +
                     " points are where the surface bends within half a radius (thin parts, edges, noise): few paths "
                     "through them can be certified; use more samples");
  choose_normals(samples, estimates, deadline);
}

void PointCloud::choose_normals(const PointSamples& samples, const std::vector<Eigen::Vector3d>& estimates,
                                const Deadline& deadline) {
  const bool in_file = !samples.normals.empty();
  if (settings_.normals == NormalSource::given && !in_file)
    throw OptionError("normals", source_ + " has no normals: use estimate or auto");
  const auto given = [&](std::size_t i) -> const Eigen::Vector3d& {
    return samples.normals[static_cast<std::size_t>(order_[i])];
  };
  given_normals_ = in_file && settings_.normals != NormalSource::estimate;
  if (given_normals_ && settings_.normals == NormalSource::automatic) {
    std::vector<double> agreement;
    for (std::size_t i = 0; i < samples_.size(); ++i) agreement.push_back(std::abs(given(i).dot(estimates[i])));
    given_normals_ = median(agreement) >= kAgreement;
    if (!given_normals_)
      notes_.emplace_back("the normals in the file are noisy: they were estimated again, with the same orientation");
  }
  std::vector<Eigen::Vector3d> normals = estimates;
  if (given_normals_) {
    for (std::size_t i = 0; i < samples_.size(); ++i) normals[i] = given(i);
  } else if (in_file && settings_.normals == NormalSource::automatic) {
    for (std::int32_t i = 0; i < size(); ++i) {  // the side that the neighbourhood votes for
      Eigen::Vector3d side = given(static_cast<std::size_t>(i));
      for (std::size_t k = 0; k < width_; ++k) side += given(static_cast<std::size_t>(neighbours(i)[k]));
      Eigen::Vector3d& normal = normals[static_cast<std::size_t>(i)];
      if (normal.dot(side) < 0) normal = -normal;
    }
  } else {
    constexpr std::size_t kLinks = 6;  // the nearest few hold a surface together
    const auto lists = [&](std::int32_t a, std::int32_t b) {
      const std::int32_t* first = neighbours(a);
      return std::find(first, first + std::min(width_, kLinks), b) != first + std::min(width_, kLinks);
    };
    std::vector<std::pair<std::int32_t, std::int32_t>> edges;
    std::vector<Eigen::Vector3d> positions;
    for (std::int32_t i = 0; i < size(); ++i) {
      positions.push_back(sample(i).position);
      for (std::size_t k = 0; k < std::min(width_, kLinks); ++k)
        if (const std::int32_t j = neighbours(i)[k]; i < j || !lists(j, i)) edges.emplace_back(i, j);
    }
    look_at_clock(deadline);
    link_parts(normals, edges);
    orient_normals(positions, edges, normals, deadline);
  }
  for (std::size_t i = 0; i < samples_.size(); ++i) samples_[i].normal = normals[i];
}

/// Links between parts that no other links hold together, along the surface: their sides go together, as those of one
/// scan with a gap in it.
void PointCloud::link_parts(const std::vector<Eigen::Vector3d>& normals,
                            std::vector<std::pair<std::int32_t, std::int32_t>>& edges) const {
  std::vector<std::pair<std::int32_t, std::int32_t>> both = edges;
  for (const auto& [a, b] : edges) both.emplace_back(b, a);
  const Components parts = connected_components(SparseGraph(size(), std::move(both)));
  std::vector<Neighbour> found;
  for (std::int32_t i = 0; i < size(); ++i) {
    if (parts.of[static_cast<std::size_t>(i)] == 0) continue;
    search_.within(sample(i).position, kPartsApart * spacing(i), found);
    Neighbour best;
    for (const Neighbour& near : found) {
      if (parts.of[static_cast<std::size_t>(near.index)] == parts.of[static_cast<std::size_t>(i)]) continue;
      if (best.index >= 0 && near.squared_distance >= best.squared_distance) continue;
      const Eigen::Vector3d way = (sample(near.index).position - sample(i).position).normalized();
      const double steep = std::max(std::abs(way.dot(normals[static_cast<std::size_t>(i)])),
                                    std::abs(way.dot(normals[static_cast<std::size_t>(near.index)])));
      if (steep < kSteepLink) best = near;
    }
    if (best.index >= 0) edges.emplace_back(i, best.index);
  }
}

std::int32_t PointCloud::sample_of_file(std::int32_t number) const {
  const auto it = std::find(in_file_.begin(), in_file_.end(), number);
  return it == in_file_.end() ? -1 : static_cast<std::int32_t>(it - in_file_.begin());
}

/// Of two points that are nearest to each other among those left, one goes.
PointCloud PointCloud::thinned() const {
  std::vector<char> state(samples_.size(), 0);  // 1: stays, 2: goes
  PointSamples half;
  half.source = source_ + " (every other point)";
  for (std::int32_t i = 0; i < size(); ++i) {
    if (state[static_cast<std::size_t>(i)] != 0) continue;
    state[static_cast<std::size_t>(i)] = 1;
    for (std::size_t k = 0; k < width_; ++k) {
      const auto j = static_cast<std::size_t>(neighbours(i)[k]);
      if (state[j] != 0) continue;
      state[j] = 2;
      break;
    }
  }
  for (std::int32_t i = 0; i < size(); ++i) {
    if (state[static_cast<std::size_t>(i)] != 1) continue;
    half.positions.emplace_back(sample(i).position + centre_);
    if (given_normals_) half.normals.push_back(sample(i).normal);
    half.in_file.push_back(in_file(i));
  }
  half.count_in_file = count_in_file_;
  PointCloudSettings settings = settings_;
  settings.normals = given_normals_ ? NormalSource::given : NormalSource::estimate;
  return {std::move(half), settings};
}

}  // namespace leastcost
