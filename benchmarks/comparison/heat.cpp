// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/fields/heat.hpp>
#include "benchmarks/comparison/field_path.hpp"

namespace leastcost::comparison {
namespace {

class HeatPaths final : public Method {
 public:
  void prepare(const TriangleMesh& mesh, const Stop& stop) override {
    mesh_ = &mesh;
    HeatOptions options;
    options.stop = stop;
    heat_ = std::make_unique<HeatDistances>(mesh, options);
  }

  Answer shortest(std::int32_t source, std::int32_t target, const Stop&) override {
    return path_down(*mesh_, heat_->from(vertex_point(*mesh_, source)), source, target);
  }

 private:
  const TriangleMesh* mesh_ = nullptr;
  std::unique_ptr<HeatDistances> heat_;
};

}  // namespace

std::unique_ptr<Method> make_heat() { return std::make_unique<HeatPaths>(); }

}  // namespace leastcost::comparison
