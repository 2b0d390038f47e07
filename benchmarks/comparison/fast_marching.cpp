// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/fields/fast_marching.hpp>
#include "benchmarks/comparison/field_path.hpp"

namespace leastcost::comparison {
namespace {

class FastMarchingPaths final : public Method {
 public:
  void prepare(const TriangleMesh& mesh, const Stop&) override {
    mesh_ = &mesh;
    fields_ = std::make_unique<FastMarching>(mesh);
  }

  Answer shortest(std::int32_t source, std::int32_t target, const Stop& stop) override {
    const std::vector<double> field = fields_->distances(vertex_point(*mesh_, source), {target, stop});
    if (!stop || !stop()) return path_down(*mesh_, field, source, target);
    Answer answer;
    answer.outcome = Outcome::out_of_time;
    return answer;
  }

 private:
  const TriangleMesh* mesh_ = nullptr;
  std::unique_ptr<FastMarching> fields_;
};

}  // namespace

std::unique_ptr<Method> make_fast_marching() { return std::make_unique<FastMarchingPaths>(); }

}  // namespace leastcost::comparison
