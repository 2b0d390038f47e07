// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/cloud/cloud_surface.hpp>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

#include "problems/cloud/two_groups.hpp"

namespace leastcost {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr int kMaxSteps = 30;
constexpr double kConverged =
    1e-8;                        ///< supports: the step after one this small is below rounding (quadratic convergence)
constexpr double kSlack = 0.15;  ///< supports that x may move before its samples are gathered again
constexpr double kFarthest = 1.0;  ///< supports between x and the tangent plane of its nearest sample
/// Supports from a place on the border to the mean of its samples: 0.23 on a straight row of last samples.
constexpr double kBorder = 0.3;
constexpr double kClearlyWithin = 0.2;   ///< the same, in supports of the nearest sample: not beyond the border
constexpr double kFarFromBorder = 0.12;  ///< the same: no border is near
constexpr double kOnBorder = 1e-10;      ///< supports off the border that are rounding
constexpr double kOtherSheet = -0.5;     ///< cosine of 120 degrees
constexpr int kFewest = 6;               ///< samples with a say
constexpr double kSheetGap = 4;          ///< distance of two sheets over their widths; noise has 2.6, a crease 3.5
constexpr double kSheetValley = 0.06;    ///< part of the samples between two sheets; noise has 0.31, a crease 0.25
constexpr double kSheetSteepness = 1;    ///< from a sample to the one below it; see steepness()
constexpr double kSheetsParallel = 0.9;  ///< mean cosine of the normals of either sheet against those of the sphere
constexpr double kSheetShare = 0.05;     ///< part of the samples that a sheet has at least
constexpr double kSheetsApart = 0.5;     ///< spacings between two sheets that are told from noise
constexpr int kSheetSamples = 4;
constexpr double kFlattest = 1e-12;  ///< spread of the samples, in squared supports, below which no sphere is seen

/// Value and gradient of f, where its samples lie, and the algebraic sphere value + slope . q + bend |q|^2 itself.
struct Field {
  double value = 0;
  Vector3d gradient = Vector3d::Zero();
  Vector3d mean = Vector3d::Zero();  ///< of the samples, relative to x
  Vector3d slope = Vector3d::Zero();
  double bend = 0;
};

/// By how much a place is beyond the border, in squared supports, with the gradient of that, and the normal of f = 0.
struct Rim {
  double value = 0;
  Vector3d gradient = Vector3d::Zero();
};

struct Moments;

/// f near one place, from samples gathered once.
class LocalField {
 public:
  LocalField(const PointCloud& cloud, std::vector<Neighbour>& buffer) : cloud_(cloud), found_(buffer) {}

  /// Makes ready for points within `slack_` of x; x relative to the cloud's centre.
  void gather(const Vector3d& x) {
    const Neighbour nearest = cloud_.search().nearest(x);
    nearest_ = nearest.index;
    distance_ = std::sqrt(nearest.squared_distance);
    slack_ = kSlack * support();
    gathered_at_ = x;
    cloud_.search().within(x, cloud_.reach(nearest_, distance_ + slack_) + slack_, found_);
  }
  bool covers(const Vector3d& x) const { return (x - gathered_at_).squaredNorm() <= slack_ * slack_; }
  double support() const { return cloud_.radius(nearest_); }
  double distance() const { return distance_; }
  const CloudSample& nearest() const { return cloud_.sample(nearest_); }
  double spacing() const { return cloud_.spacing(nearest_); }

  /// False where too few samples reach x.
  bool evaluate(const Vector3d& x, Field& out) const;
  /// Both f and the border, from one pass over the samples.
  bool evaluate(const Vector3d& x, Field& out, Rim& rim) const;

  /// Heights of the samples that reach x over the algebraic sphere there, length units. Their weights are flatter than
  /// those of the fit, whose few effective samples fall into groups by chance.
  struct Heights {
    std::vector<WeightedHeight> heights;
    std::vector<Eigen::Vector2d> places;  ///< in the tangent plane
    std::vector<double> cosines;          ///< of the normals of the samples against those of the sphere
  };
  Heights heights(const Vector3d& x, const Field& sphere) const;

 private:
  int sum(const Vector3d& x, Moments& m) const;
  /// Calls visit(sample, q, t) for the samples that have a say at x: q = position - x, t = 1 - |q|^2 / support^2.
  template <class Visit>
  void for_samples(const Vector3d& x, Visit visit) const {
    const Vector3d& side = nearest().normal;
    for (const Neighbour& near : found_) {
      const CloudSample& sample = cloud_.sample(near.index);
      const Vector3d q = sample.position - x;
      const double t = 1 - q.squaredNorm() * sample.inverse_radius2;
      if (t > 0 && !(side.dot(sample.normal) < kOtherSheet)) visit(sample, q, t);
    }
  }

  const PointCloud& cloud_;
  std::vector<Neighbour>& found_;
  Vector3d gathered_at_ = Vector3d::Zero();
  std::int32_t nearest_ = -1;
  double distance_ = 0, slack_ = 0;
};

/// Weighted sums over the samples and, where a w appears, over the gradients of their weights. q = p - x, n the normal.
struct Moments {
  double weight = 0, q_n = 0, q_q = 0;
  Vector3d q = Vector3d::Zero(), n = Vector3d::Zero();
  Vector3d w = Vector3d::Zero(), w_qn = Vector3d::Zero(), w_qq = Vector3d::Zero();
  Matrix3d w_q = Matrix3d::Zero(), w_n = Matrix3d::Zero();  ///< column k: the gradient of component k
};

/// The algebraic sphere of the moments at its own origin, with the gradient of that value with respect to x, by the
/// chain rule.
bool sphere_value(const Moments& m, double support, Field& out) {
  const double s = 1 / m.weight;
  const Vector3d q = s * m.q;
  const double spread = m.q_q - m.q.dot(q);
  if (!(spread > kFlattest * m.weight * support * support)) return false;
  const double sum = m.q_n - m.n.dot(q);
  const double u4 = sum / (2 * spread);
  const Vector3d ul = s * m.n - 2 * u4 * q;
  out.value = -ul.dot(q) - s * u4 * m.q_q;
  out.mean = q;
  out.slope = ul;
  out.bend = u4;

  // Gradients of the moments: of the weights, and of q = p - x itself.
  const Vector3d d_weight = m.w;
  Matrix3d d_q = m.w_q;
  d_q.diagonal().array() -= m.weight;
  const Vector3d d_qn = m.w_qn - m.n, d_qq = m.w_qq - 2 * m.q;
  const Matrix3d mean_q = s * (d_q - d_weight * q.transpose());            // of q / weight
  const Matrix3d mean_n = s * (m.w_n - d_weight * (s * m.n).transpose());  // of n / weight
  const Vector3d d_sum = d_qn - m.w_n * q - mean_q * m.n;
  const Vector3d d_spread = d_qq - d_q * q - mean_q * m.q;
  const Vector3d d_u4 = (d_sum - 2 * u4 * d_spread) / (2 * spread);
  const Matrix3d d_ul = mean_n - 2 * (d_u4 * q.transpose() + u4 * mean_q);
  const Vector3d mean_qq = s * (d_qq - s * m.q_q * d_weight);
  out.gradient = -(d_ul * q + mean_q * ul) - s * m.q_q * d_u4 - u4 * mean_qq;
  return out.gradient.squaredNorm() > 0;
}

/// |mean of q along the surface|^2 / support^2 - kBorder^2, where the normal of the surface is that of the samples and
/// 1 / support^2 the mean of theirs: as smooth as the weights.
Rim rim_value(const Moments& m, double inverse2, const Vector3d& d_inverse2) {
  const double s = 1 / m.weight;
  const Vector3d q = s * m.q;
  Matrix3d d_q = m.w_q;
  d_q.diagonal().array() -= m.weight;
  const Matrix3d mean_q = s * (d_q - m.w * q.transpose());
  const double n2 = m.n.squaredNorm(), qn = q.dot(m.n), g = s * inverse2;
  const double along = q.squaredNorm() - qn * qn / n2;
  const Vector3d d_qn = mean_q * m.n + m.w_n * q;
  const Vector3d d_along = 2 * (mean_q * q) - 2 * qn / n2 * d_qn + 2 * (qn / n2) * (qn / n2) * (m.w_n * m.n);
  return {along * g - kBorder * kBorder, g * d_along + along * s * (d_inverse2 - g * m.w)};
}

/// Returns how many samples have a say.
int LocalField::sum(const Vector3d& x, Moments& m) const {
  int count = 0;
  for_samples(x, [&](const CloudSample& sample, const Vector3d& q, double t) {
    const Vector3d& n = sample.normal;
    const double d2 = q.squaredNorm(), t3 = sample.trust * t * t * t, w = t3 * t, qn = q.dot(n);
    const Vector3d dw = (8 * t3 * sample.inverse_radius2) * q;  // gradient of the weight with respect to x
    m.weight += w;
    m.q += w * q;
    m.n += w * n;
    m.q_n += w * qn;
    m.q_q += w * d2;
    m.w += dw;
    m.w_qn += qn * dw;
    m.w_qq += d2 * dw;
    m.w_q += dw * q.transpose();
    m.w_n += dw * n.transpose();
    if (sample.trust > 0) ++count;
  });
  return count;
}

bool LocalField::evaluate(const Vector3d& x, Field& out) const {
  Moments m;
  return sum(x, m) >= kFewest && m.weight > 0 && sphere_value(m, support(), out);
}

bool LocalField::evaluate(const Vector3d& x, Field& out, Rim& rim) const {
  Moments m;
  if (!(sum(x, m) >= kFewest && m.weight > 0 && sphere_value(m, support(), out) && m.n.squaredNorm() > 0)) return false;
  double inverse2 = 0;
  Vector3d d_inverse2 = Vector3d::Zero();
  for_samples(x, [&](const CloudSample& sample, const Vector3d& q, double t) {
    const double t3 = sample.trust * t * t * t, k = sample.inverse_radius2;
    inverse2 += t3 * t * k;
    d_inverse2 += (8 * t3 * k * k) * q;
  });
  rim = rim_value(m, inverse2, d_inverse2);
  return true;
}

LocalField::Heights LocalField::heights(const Vector3d& x, const Field& sphere) const {
  const Vector3d n = sphere.gradient.normalized(), e = n.unitOrthogonal(), f = n.cross(e);
  Heights out;
  for_samples(x, [&](const CloudSample& sample, const Vector3d& q, double t) {
    const double value = sphere.value + sphere.slope.dot(q) + sphere.bend * q.squaredNorm();
    const Vector3d up = sphere.slope + 2 * sphere.bend * q;
    const double slope = up.norm();
    if (!(slope > 0 && sample.trust > 0)) return;
    out.heights.push_back({value / slope, sample.trust * t});
    out.places.emplace_back(e.dot(q), f.dot(q));
    out.cosines.push_back(std::abs(up.dot(sample.normal)) / slope);
  });
  return out;
}

/// The mean of the samples, seen along the surface, is nearer to the foot than so many supports.
bool is_within(const Field& f, double support, double most) {
  const Vector3d n = f.gradient.normalized();
  const Vector3d along = f.mean - n.dot(f.mean) * n;
  return along.squaredNorm() < most * most * support * support;
}

/// The shortest step onto f = 0 and the border, to first order.
Vector3d step_onto_both(const Field& f, const Rim& rim) {
  const double ff = f.gradient.squaredNorm(), fr = f.gradient.dot(rim.gradient), rr = rim.gradient.squaredNorm();
  const double det = ff * rr - fr * fr;
  if (!(det > 0)) return Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
  return -((rr * f.value - fr * rim.value) * f.gradient + (ff * rim.value - fr * f.value) * rim.gradient) / det;
}

/// Newton steps on f = 0 and the border from y.
bool settle_on_border(LocalField& field, Vector3d& y) {
  Field f;
  Rim rim;
  double last = std::numeric_limits<double>::infinity();
  for (int i = 0; i < kMaxSteps; ++i) {
    if (!field.covers(y)) field.gather(y);
    if (!field.evaluate(y, f, rim)) return false;
    Vector3d step = step_onto_both(f, rim);
    const double length = step.norm(), support = field.support();
    if (!std::isfinite(length)) return false;
    if (!(length < last || length <= kConverged * support)) step *= 0.5;
    last = length;
    if (length > 0.25 * support) step *= 0.25 * support / length;
    y += step;
    if (length <= kConverged * support) return true;
  }
  return false;
}

std::vector<Neighbour>& buffer() {
  thread_local std::vector<Neighbour> instance;
  return instance;
}

}  // namespace

bool CloudSurface::project(Eigen::Ref<Vector3d> x, Border border) const {
  if (!x.allFinite()) return false;
  Vector3d y = x - cloud_->centre();
  LocalField field(*cloud_, buffer());
  field.gather(y);
  if (field.distance() > field.support()) {  // a start on the tangent plane of the nearest sample, if that is below
    const CloudSample& near = field.nearest();
    y -= near.normal.dot(y - near.position) * near.normal;
    if ((y - near.position).squaredNorm() > kFarthest * kFarthest * field.support() * field.support()) return false;
    field.gather(y);
  }
  Field f;
  double last = std::numeric_limits<double>::infinity();
  for (int i = 0; i < kMaxSteps; ++i) {
    if (!field.covers(y)) field.gather(y);
    if (!field.evaluate(y, f)) return false;
    Vector3d step = -f.value / f.gradient.squaredNorm() * f.gradient;
    const double length = step.norm(), support = field.support();
    if (!(length < last || length <= kConverged * support)) step *= 0.5;
    last = length;
    if (length > 0.5 * support) step *= 0.5 * support / length;
    y += step;
    if (length > kConverged * support) continue;
    Rim rim;
    if (border != Border::ignore && !is_within(f, support, kClearlyWithin) && field.evaluate(y, f, rim) &&
        rim.value > 0) {
      if (border == Border::stop || !settle_on_border(field, y)) return false;
    }
    x = y + cloud_->centre();
    return true;
  }
  return false;
}

bool CloudSurface::project(Eigen::Ref<Vector3d> x) const { return project(x, Border::stop); }
bool CloudSurface::project_within(Eigen::Ref<Vector3d> x) const { return project(x, Border::rest); }
bool CloudSurface::project_beyond(Eigen::Ref<Vector3d> x) const { return project(x, Border::ignore); }

bool CloudSurface::project_onto_border(Eigen::Ref<Vector3d> x) const {
  if (!x.allFinite()) return false;
  Vector3d y = x - cloud_->centre();
  LocalField field(*cloud_, buffer());
  field.gather(y);
  if (!settle_on_border(field, y)) return false;
  x = y + cloud_->centre();
  return true;
}

std::optional<CloudSurface::NearBorder> CloudSurface::border_near(const Vector3d& x) const {
  if (!x.allFinite()) return std::nullopt;
  const Vector3d y = x - cloud_->centre();
  LocalField field(*cloud_, buffer());
  field.gather(y);
  Field f;
  Rim rim;
  if (!field.evaluate(y, f) || is_within(f, field.support(), kFarFromBorder) || !field.evaluate(y, f, rim))
    return std::nullopt;
  const Vector3d n = f.gradient.normalized(), along = rim.gradient - n.dot(rim.gradient) * n;
  const double offset = std::sqrt(std::max(0.0, rim.value + kBorder * kBorder)), steep = along.norm();
  if (!(steep > 0)) return std::nullopt;
  const double gap = (kBorder - offset) * 2 * offset / steep;  // the offset is more nearly linear than its square
  return NearBorder{along / steep, gap, std::abs(rim.value) <= kOnBorder * field.support() * steep};
}

std::optional<Vector3d> CloudSurface::normal(const Vector3d& x) const {
  if (!x.allFinite()) return std::nullopt;
  const Vector3d y = x - cloud_->centre();
  LocalField field(*cloud_, buffer());
  field.gather(y);
  Field f;
  if (!field.evaluate(y, f)) return std::nullopt;
  return f.gradient.normalized();
}

namespace {

/// Whether both groups lie along the fit. Where a surface bends away from it, the far part does not.
bool parallel(const LocalField::Heights& over, double middle) {
  double cosine[2] = {0, 0}, weight[2] = {0, 0};
  for (std::size_t i = 0; i < over.heights.size(); ++i) {
    const int group = over.heights[i].height > middle ? 1 : 0;
    cosine[group] += over.heights[i].weight * over.cosines[i];
    weight[group] += over.heights[i].weight;
  }
  return cosine[0] >= kSheetsParallel * weight[0] && cosine[1] >= kSheetsParallel * weight[1];
}

}  // namespace

std::optional<CloudSurface::OtherSheet> CloudSurface::other_sheet(const Vector3d& x) const {
  if (!x.allFinite()) return std::nullopt;
  const Vector3d y = x - cloud_->centre();
  LocalField field(*cloud_, buffer());
  field.gather(y);
  Field sphere;
  if (!field.evaluate(y, sphere)) return std::nullopt;
  const LocalField::Heights over = field.heights(y, sphere);
  const TwoGroups groups = two_groups(over.heights);
  const double apart = groups.apart / field.spacing();
  if (!(apart >= kSheetsApart && groups.share >= kSheetShare && groups.fewest >= kSheetSamples)) return std::nullopt;
  if (!(groups.apart >= kSheetGap * groups.width && groups.valley <= kSheetValley)) return std::nullopt;
  if (!(steepness(over.heights, over.places, groups.middle) >= kSheetSteepness)) return std::nullopt;
  if (!parallel(over, groups.middle)) return std::nullopt;
  return OtherSheet{apart, groups.share};
}

}  // namespace leastcost
