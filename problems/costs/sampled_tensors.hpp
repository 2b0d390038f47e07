// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include <leastcost/framework/base/options.hpp>
#include <leastcost/framework/cost/segment_derivatives.hpp>
#include <leastcost/framework/domain/manifold.hpp>
#include <leastcost/problems/tensor/tensor_samples.hpp>

namespace leastcost {

/// What the rows of a tensor file belong to; automatic: the vertices of a mesh, the points of a cloud.
enum class TensorPlace { automatic, vertices, faces, points };
Words<TensorPlace> words(TensorPlace);

/// Tensors given by a file, one row per vertex, face or point.
struct TensorFileOptions {
  static constexpr std::string_view kType = "file";
  static constexpr std::string_view kHelp = "Tensors on a mesh or a point cloud, from a file.";
  std::string file = {};
  TensorPlace on = TensorPlace::automatic;
  void fields(FieldVisitor& visit);
};

/// The isophotic metric (problems/tensor/curvature).
struct CurvatureMetricOptions {
  static constexpr std::string_view kType = "curvature";
  static constexpr std::string_view kHelp =
      "For a mesh or a point cloud: ds^2 = |dx|^2 + weight^2 |dn|^2 with the normal n (isophotic). Crossing a feature "
      "costs more than following it.";
  double weight = 0;  ///< length; must be positive
  /// Of the fits, local spacings; else 2.5 on a mesh, the radius of the surface fit on a cloud.
  std::optional<double> radius = {};
  void fields(FieldVisitor& visit);
};

/// Throw OptionError, by the names within the block `field`, where the domain is neither mesh nor cloud; InputError for
/// bad files.
std::shared_ptr<const TensorSamples> tensors_from_file(const TensorFileOptions& options,
                                                       const ConstraintManifold* domain,
                                                       const std::filesystem::path& folder);
/// Tensors from the curvature of the surface at its vertices.
std::shared_ptr<const TensorSamples> tensors_from_curvature(const CurvatureMetricOptions& options,
                                                            const ConstraintManifold* domain);

/// The field of a metric_field cost that interpolates samples. The derivatives are formed once and then lifted into the
/// scalar by the chain rule: no dual number passes through the sums over the samples.
struct SampledTensors {
  static constexpr int dim = 3;                  ///< of the space
  std::shared_ptr<const TensorSamples> samples;  ///< tensors at points of the surface

  static bool inside(const Point<double, 3>&) { return true; }  ///< everywhere: tensors are extrapolated

  template <class S>
  Eigen::Matrix<S, 3, 3> operator()(const Point<S, 3>& x) const {
    TensorJet jet;
    samples->evaluate<order(static_cast<const S*>(nullptr))>({innermost(x[0]), innermost(x[1]), innermost(x[2])}, jet);
    Eigen::Matrix<S, 3, 3> t;
    for (int i = 0, entry = 0; i < 3; ++i)
      for (int j = i; j < 3; ++j, ++entry) t(i, j) = t(j, i) = lift(jet, entry, x);
    return t;
  }

 private:
  static constexpr int order(const double*) { return 0; }
  template <class S, int N>
  static constexpr int order(const Dual<S, N>*) {
    return 1 + order(static_cast<const S*>(nullptr));
  }

  static double lift(const TensorJet& jet, int entry, const Point<double, 3>&) { return jet.value[entry]; }

  template <int N>
  static Dual<double, N> lift(const TensorJet& jet, int entry, const Point<Dual<double, N>, 3>& x) {
    Dual<double, N> out(jet.value[entry]);
    for (std::size_t k = 0; k < N; ++k)
      for (int j = 0; j < 3; ++j) out.d[k] += jet.gradient(entry, j) * x[j].d[k];
    return out;
  }

  template <int N, int M>
  static Dual<Dual<double, N>, M> lift(const TensorJet& jet, int entry, const Point<Dual<Dual<double, N>, M>, 3>& x) {
    using Inner = Dual<double, N>;
    const Point<Inner, 3> inner(x[0].value, x[1].value, x[2].value);
    Dual<Inner, M> out(lift(jet, entry, inner), {});
    for (int j = 0; j < 3; ++j) {
      Inner slope(jet.gradient(entry, j));  // at the inner point
      for (int l = 0; l < 3; ++l)
        for (std::size_t k = 0; k < N; ++k) slope.d[k] += jet.hessian(entry, TensorJet::column(j, l)) * inner[l].d[k];
      for (std::size_t k = 0; k < M; ++k) out.d[k] += slope * x[j].d[k];
    }
    return out;
  }
};

}  // namespace leastcost
