// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include <leastcost/framework/base/errors.hpp>
#include "benchmarks/comparison/crossings.hpp"
#include "benchmarks/comparison/methods.hpp"

namespace leastcost::comparison {
namespace {

constexpr double kSweepKnot = 1e-3;   // part of an edge
constexpr double kSweepGain = 1e-10;  // decrease of the length per sweep that ends it
constexpr int kMostSweeps = 100000;

/// Martinez, Velho and Carvalho 2005: each point of the path in turn is put onto the straight line between its
/// neighbours in the unfolding of the two faces beside it; where it meets a vertex, the faces around that. Until a
/// sweep over all points gains nothing.
class LocalStraightening final : public Method {
 public:
  void prepare(const TriangleMesh& mesh, const Stop&) override { mesh_ = &mesh; }

  Answer shortest(std::int32_t source, std::int32_t target, const Stop& stop) override {
    Answer answer;
    try {
      CrossingPath path(*mesh_, source, target, 0, stop);
      answer.lengths.push_back(path.length());
      while (answer.iterations < kMostSweeps) {
        if (stop && stop()) {
          answer.outcome = Outcome::out_of_time;
          break;
        }
        const bool changed = path.untie_all(kSweepKnot);
        sweep(path);
        ++answer.iterations;
        const double before = answer.lengths.back();
        answer.lengths.push_back(path.length());
        if (!changed && before - answer.lengths.back() <= kSweepGain * before) break;
        // A knot may change sides for ever where rounding decides: it gains nothing.
        const std::size_t n = answer.lengths.size();
        if (n > 50 && answer.lengths[n - 50] - answer.lengths[n - 1] <= kSweepGain * before) break;
      }
      answer.path = path.path();
      answer.distance = path_length(answer.path);
    } catch (const InputError& error) {
      answer.outcome = Outcome::failed;
      answer.note = error.what();
    }
    return answer;
  }

 private:
  void sweep(CrossingPath& path) const {
    for (std::size_t i = 0; i < path.crossings().size(); ++i) {
      Crossing& c = path.crossings()[i];
      const Eigen::Vector3d a = mesh_->position(mesh_->tail(c.halfedge));
      const Eigen::Vector3d edge = mesh_->position(mesh_->head(c.halfedge)) - a;
      const double length = edge.norm();
      if (!(length > 0)) continue;
      const Eigen::Vector3d p = path.point(i) - a, q = path.point(i + 2) - a;
      const double p_along = p.dot(edge) / length, q_along = q.dot(edge) / length;
      const double p_off = std::sqrt(std::max(0.0, p.squaredNorm() - p_along * p_along));
      const double q_off = std::sqrt(std::max(0.0, q.squaredNorm() - q_along * q_along));
      if (!(p_off + q_off > 0)) continue;
      c.t = std::clamp((p_along * q_off + q_along * p_off) / ((p_off + q_off) * length), 0.0, 1.0);
    }
  }

  const TriangleMesh* mesh_ = nullptr;
};

}  // namespace

std::unique_ptr<Method> make_local_straightening() { return std::make_unique<LocalStraightening>(); }

}  // namespace leastcost::comparison
