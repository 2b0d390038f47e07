// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <leastcost/framework/base/options.hpp>
#include <leastcost/framework/cost/segment_cost.hpp>
#include <leastcost/framework/domain/manifold.hpp>
#include <leastcost/problems/costs/sampled_tensors.hpp>

namespace leastcost {

/// The tensors T(x) of MetricFieldOptions.
namespace metric {

struct HalfPlane {
  static constexpr std::string_view kType = "half_plane";
  static constexpr std::string_view kHelp = "(dx^2 + dy^2) / y^2 where y > 0.";
};

struct PoincareDisc {
  static constexpr std::string_view kType = "poincare_disc";
  static constexpr std::string_view kHelp = "4 (dx^2 + dy^2) / (1 - x^2 - y^2)^2 in the unit disc.";
};

struct FisherRao {
  static constexpr std::string_view kType = "fisher_rao";
  static constexpr std::string_view kHelp =
      "(dmu^2 + 2 dsigma^2) / sigma^2: normal distributions (mu, sigma), sigma > 0.";
};

struct Formula {
  static constexpr std::string_view kType = "formula";
  static constexpr std::string_view kHelp = "T as formulas in the coordinates x, y and z.";
  std::vector<std::string> entries = {};  ///< upper triangle of the tensor, row by row
  std::map<std::string, double> parameters = {};
  void fields(FieldVisitor& visit);
};

using Field = std::variant<HalfPlane, PoincareDisc, FisherRao, Formula, TensorFileOptions, CurvatureMetricOptions>;

}  // namespace metric

/// What T means: the metric, c = sqrt(d' T d), or a root of it, c = |T d|.
enum class TensorReading { metric, root };
Words<TensorReading> words(TensorReading);

/// Where T of a segment is taken: in its middle, or as the mean of its ends. automatic: the mean for tensors on data.
enum class TensorRule { automatic, midpoint, average };
Words<TensorRule> words(TensorRule);

struct MetricFieldOptions {
  metric::Field field = {};
  TensorReading reading = TensorReading::metric;
  TensorRule rule = TensorRule::automatic;
  void fields(FieldVisitor& visit);
  bool needs_domain() const;  ///< the tensors belong to the data of the manifold
  bool averages() const;      ///< the tensor of a segment is the mean of those at its ends
};

/// Length under a metric tensor that depends on the place, in an ambient space of dimension 2 or 3: half-plane,
/// Poincare disc, Fisher-Rao metric of the normal distributions (mu, sigma), formulas, tensors given on the vertices or
/// faces of a mesh or the points of a cloud (interpolated: problems/tensor/tensor_samples), or the isophotic metric
/// from the curvatures of one of them. On a surface it is the metric induced on the tangent planes.
///
/// The paper uses T both as the metric, VFCS Eq. (1), and as a root of it, Sec. 4.5: `reading: metric` is c = sqrt(d' T
/// d), `reading: root` is c = |T d|, d = b - a. T is taken in the middle of the segment, or as the mean of both ends
/// (`rule: average`, VFCS Sec. 4.5, the default for tensors given on data, whose ends lie on the surface); both have
/// order 2. +infinity where an end or the middle lies outside the domain of the metric, or where T is not positive
/// definite; the cost says which (ExplainsInfinity). `domain` and `folder` (of the tensor file) are asked only by
/// fields that need them. Throws OptionError, InputError.
std::shared_ptr<const SegmentCost> make_metric_field_cost(const MetricFieldOptions& options, int dim,
                                                          const ConstraintManifold* domain = nullptr,
                                                          const std::filesystem::path& folder = {});

}  // namespace leastcost
