// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/costs/sampled_tensors.hpp>

#include <array>
#include <utility>
#include <vector>

#include <leastcost/framework/base/errors.hpp>
#include "problems/readers/tensor_reader.hpp"
#include "problems/tensor/curvature.hpp"

namespace leastcost {
namespace {

constexpr double kMeshFit = 2.5;  ///< local spacings: 23 vertices of a regular mesh

SurfaceSamples samples_on(TensorPlace on, const ConstraintManifold* domain) {
  const auto* mesh = find_ability<HasMesh>(domain);
  const auto* cloud = find_ability<HasPointCloud>(domain);
  if (mesh == nullptr && cloud == nullptr)
    throw OptionError("field.type", "tensors given on data need a mesh or a point cloud as the manifold");
  if (on == TensorPlace::points && cloud == nullptr)
    throw OptionError("field.on", "a mesh has vertices and faces, not points");
  if (on != TensorPlace::points && on != TensorPlace::automatic && mesh == nullptr)
    throw OptionError("field.on", "a point cloud has points, not " + std::string(word_of(on)));
  if (cloud != nullptr) return point_samples(cloud->cloud());
  return on == TensorPlace::faces ? face_samples(mesh->mesh()) : vertex_samples(mesh->mesh());
}

}  // namespace

Words<TensorPlace> words(TensorPlace) {
  static constexpr std::array<Word<TensorPlace>, 4> kWords = {{{TensorPlace::automatic, "auto"},
                                                               {TensorPlace::vertices, "vertices"},
                                                               {TensorPlace::faces, "faces"},
                                                               {TensorPlace::points, "points"}}};
  return kWords;
}

void TensorFileOptions::fields(FieldVisitor& visit) {
  visit.file("file", file,
             {.help = "Text file with one row per vertex, face or point, in the order of the manifold's file: xx xy xz "
                      "yy yz zz, the entries of a symmetric positive definite tensor of R^3.",
              .required = true});
  visit.choice("on", on,
               {.help = "Elements to which the rows belong; auto: the vertices of a mesh, the points of a cloud."});
}

void CurvatureMetricOptions::fields(FieldVisitor& visit) {
  visit.field(
      "weight", weight,
      {.help = "The length w in M = I + w^2 (k1^2 t1 t1' + k2^2 t2 t2'): a normal that turns by one radian costs as "
               "much as this length.",
       .unit = "length",
       .minimum = 0,
       .exclusive_minimum = true,
       .required = true});
  visit.field_or_zero("radius", radius,
                      {.help = "Radius of the quadratic fits that measure the curvatures; 0: 2.5 on a mesh, the radius "
                               "of the surface fit on a cloud. A larger radius averages over noise and creases.",
                       .unit = "local spacings",
                       .minimum = 0,
                       .maximum = 100});
}

std::shared_ptr<const TensorSamples> tensors_from_file(const TensorFileOptions& options,
                                                       const ConstraintManifold* domain,
                                                       const std::filesystem::path& folder) {
  const SurfaceSamples samples = samples_on(options.on, domain);
  const std::filesystem::path file = folder / options.file;
  const std::vector<Eigen::Matrix3d> rows = read_tensors(file);
  if (rows.size() != static_cast<std::size_t>(samples.count_in_file))
    throw InputError(file.string() + ": " + std::to_string(rows.size()) +
                     " tensors, but the file of the manifold has " + std::to_string(samples.count_in_file) + " " +
                     samples.what);
  std::vector<Eigen::Matrix3d> tensors;
  tensors.reserve(samples.in_file.size());
  for (const std::int32_t number : samples.in_file) tensors.push_back(rows[static_cast<std::size_t>(number)]);
  return std::make_shared<const TensorSamples>(samples, tensors);
}

std::shared_ptr<const TensorSamples> tensors_from_curvature(const CurvatureMetricOptions& options,
                                                            const ConstraintManifold* domain) {
  const auto* cloud = find_ability<HasPointCloud>(domain);
  if (cloud == nullptr && find_ability<HasMesh>(domain) == nullptr)
    throw OptionError("field.type", "curvature needs a mesh or a point cloud as the manifold");
  const SurfaceSamples samples = samples_on(TensorPlace::automatic, domain);
  if (options.radius && !(*options.radius > 0)) throw OptionError("field.radius", "must be greater than 0");
  const double radius = options.radius.value_or(cloud != nullptr ? *cloud->cloud().settings().radius : kMeshFit);
  return std::make_shared<const TensorSamples>(samples,
                                               isophotic_metric(shape_operators(samples, radius), options.weight));
}

}  // namespace leastcost
