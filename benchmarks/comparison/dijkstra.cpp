// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/mesh/edge_graph.hpp>
#include "benchmarks/comparison/methods.hpp"

namespace leastcost::comparison {
namespace {

class DijkstraPaths final : public Method {
 public:
  void prepare(const TriangleMesh& mesh, const Stop&) override {
    mesh_ = &mesh;
    search_ = std::make_unique<EdgeGraphSearch>(mesh);
  }

  Answer shortest(std::int32_t source, std::int32_t target, const Stop& stop) override {
    EdgePathOptions options;
    options.stop = stop;
    const auto length = [](const Eigen::Vector3d& a, const Eigen::Vector3d& b) { return (b - a).norm(); };
    EdgePath found = search_->shortest(vertex_point(*mesh_, source), vertex_point(*mesh_, target), length, options);
    Answer answer;
    if (!found.found()) {
      answer.outcome = found.outcome == EdgePathOutcome::stopped ? Outcome::out_of_time : Outcome::failed;
      answer.note = found.failure();
      return answer;
    }
    answer.distance = found.cost;
    answer.path = std::move(found.path);
    return answer;
  }

 private:
  const TriangleMesh* mesh_ = nullptr;
  std::unique_ptr<EdgeGraphSearch> search_;
};

}  // namespace

std::unique_ptr<Method> make_dijkstra() { return std::make_unique<DijkstraPaths>(); }

}  // namespace leastcost::comparison
