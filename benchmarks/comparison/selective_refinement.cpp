// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <Eigen/Core>
#include <algorithm>
#include <limits>
#include <queue>
#include <set>
#include <unordered_map>
#include <utility>

#include <leastcost/problems/mesh/edge_graph.hpp>
#include "benchmarks/comparison/methods.hpp"
#include "problems/mesh/surface_walk.hpp"

namespace leastcost::comparison {
namespace {

constexpr int kMostSteiner = 63;          // points on an edge
constexpr double kRefinementGain = 1e-6;  // decrease from one refinement to the next that ends it

/// Kanai and Suzuki 2001: the shortest path over the vertices and Steiner points of the faces around the last path,
/// more points each time (1, 3, 7, ... per edge).
class SelectiveRefinement final : public Method {
 public:
  void prepare(const TriangleMesh& mesh, const Stop&) override { mesh_ = &mesh; }

  Answer shortest(std::int32_t source, std::int32_t target, const Stop& stop) override {
    Answer answer;
    EdgeGraphSearch search(*mesh_);
    EdgePathOptions options;
    options.stop = stop;
    EdgePath first = search.shortest(
        vertex_point(*mesh_, source), vertex_point(*mesh_, target),
        [](const Eigen::Vector3d& a, const Eigen::Vector3d& b) { return (b - a).norm(); }, options);
    if (!first.found()) {
      answer.outcome = Outcome::failed;
      answer.note = first.failure();
      return answer;
    }
    answer.path = std::move(first.path);
    answer.lengths.push_back(path_length(answer.path));
    // The same number of points until the strip of faces has come to rest, then twice as many.
    for (int points = 1; points <= kMostSteiner;) {
      if (stop && stop()) {
        answer.outcome = Outcome::out_of_time;
        break;
      }
      SurfacePath next = refine(answer.path, source, target, points, stop);
      ++answer.iterations;
      const double before = answer.lengths.back(), now = next.points.empty() ? before : path_length(next);
      if (now < before) answer.path = std::move(next);
      answer.lengths.push_back(std::min(before, now));
      if (before - now <= kRefinementGain * before) points = 2 * points + 1;
    }
    answer.distance = answer.lengths.back();
    return answer;
  }

 private:
  /// A node of the graph: a vertex, or a point of an edge.
  struct Node {
    Eigen::Vector3d position;
    double distance = std::numeric_limits<double>::infinity();
    std::int32_t previous = -1, face = -1;
    bool settled = false;
  };

  /// Faces that the path touches.
  std::set<std::int32_t> region(const SurfacePath& path) const {
    std::set<std::int32_t> all;
    std::vector<std::int32_t> faces;
    for (std::size_t i = 0; i < path.points.size(); ++i) {
      const std::int32_t f = path.faces[std::min(i, path.faces.size() - 1)];
      faces_at(*mesh_, place_of(*mesh_, point_on_face(*mesh_, f, path.points[i])), faces);
      all.insert(faces.begin(), faces.end());
    }
    return all;
  }

  SurfacePath refine(const SurfacePath& path, std::int32_t source, std::int32_t target, int points,
                     const Stop& stop) const {
    std::vector<Node> nodes;
    std::unordered_map<std::int64_t, std::int32_t> first_of;  // of a vertex (a, a) or an edge (a < b)
    const auto key = [](std::int32_t a, std::int32_t b) { return (static_cast<std::int64_t>(a) << 32) | b; };
    const auto node_at = [&](std::int32_t a, std::int32_t b) {
      const auto [entry, made] = first_of.try_emplace(key(a, b), static_cast<std::int32_t>(nodes.size()));
      if (made) {
        const Eigen::Vector3d &p = mesh_->position(a), &q = mesh_->position(b);
        const int count = a == b ? 1 : points;
        for (int i = 1; i <= count; ++i) {
          Node node;
          node.position = p + (q - p) * (a == b ? 0.0 : i / (points + 1.0));
          nodes.push_back(node);
        }
      }
      return entry->second;
    };
    // The nodes of each face: three corners, then the points of its sides.
    std::vector<std::int32_t> numbers;
    std::vector<std::array<std::int32_t, 6>> starts;
    std::vector<std::vector<std::int32_t>> faces_of;
    for (const std::int32_t f : region(path)) {
      std::array<std::int32_t, 6> start{};
      for (std::size_t k = 0; k < 3; ++k) {
        const std::int32_t a = mesh_->face(f)[k], b = mesh_->face(f)[(k + 1) % 3];
        start[k] = node_at(a, a);
        start[k + 3] = node_at(std::min(a, b), std::max(a, b));
      }
      faces_of.resize(nodes.size());
      for (std::size_t k = 0; k < 6; ++k)
        for (std::int32_t i = 0; i < (k < 3 ? 1 : points); ++i)
          faces_of[static_cast<std::size_t>(start[k] + i)].push_back(static_cast<std::int32_t>(numbers.size()));
      starts.push_back(start);
      numbers.push_back(f);
    }
    using Entry = std::pair<double, std::int32_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
    const std::int32_t from = node_at(source, source), to = node_at(target, target);
    faces_of.resize(nodes.size());
    const auto at = [&](std::int32_t i) -> Node& { return nodes[static_cast<std::size_t>(i)]; };
    at(from).distance = 0;
    open.push({0, from});
    for (long count = 1; !open.empty(); ++count) {
      const auto [distance, here] = open.top();
      open.pop();
      if (at(here).settled) continue;
      at(here).settled = true;
      if (here == to || (count % 256 == 0 && stop && stop())) break;
      for (const std::int32_t f : faces_of[static_cast<std::size_t>(here)])
        for (std::size_t k = 0; k < 6; ++k)
          for (std::int32_t i = 0; i < (k < 3 ? 1 : points); ++i) {
            const std::int32_t next = starts[static_cast<std::size_t>(f)][k] + i;
            Node& node = at(next);
            if (node.settled) continue;
            const double d = distance + (node.position - at(here).position).norm();
            if (!(d < node.distance)) continue;
            node.distance = d;
            node.previous = here;
            node.face = numbers[static_cast<std::size_t>(f)];
            open.push({d, next});
          }
    }
    if (!at(to).settled) return {};
    SurfacePath backwards;
    backwards.points.push_back(at(to).position);
    for (std::int32_t i = to; i != from; i = at(i).previous)
      append_point(backwards, at(at(i).previous).position, at(i).face);
    return reversed(backwards);
  }

  const TriangleMesh* mesh_ = nullptr;
};

}  // namespace

std::unique_ptr<Method> make_selective_refinement() { return std::make_unique<SelectiveRefinement>(); }

}  // namespace leastcost::comparison
