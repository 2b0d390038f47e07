// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/mesh/length_search.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <span>

#include "problems/mesh/edge_landmarks.hpp"
#include "problems/mesh/edge_search.hpp"
#include "problems/mesh/move_table.hpp"
#include "problems/mesh/slot_queue.hpp"

namespace leastcost {
namespace {

using Vector = Eigen::Vector3d;

/// Floats of two lengths are off by half of this, relative to the longer.
constexpr float kFloatRounding = 4 * std::numeric_limits<float>::epsilon();
/// Straight lines between places in floats are off by less, relative to the mesh's diameter: at each end half an
/// epsilon of every coordinate, and three more of their length.
constexpr float kLineRounding = 6 * std::numeric_limits<float>::epsilon();

/// The length in one constant metric.
class LengthCost {
 public:
  static constexpr int kLookEvery = 256;

  LengthCost(const TriangleMesh& mesh, const LengthSearchOptions& options) : mesh_(&mesh), options_(&options) {}

  double operator()(const Vector& a, const Vector& b) const { return std::sqrt(squared(a, b)); }

  DiagonalMove across(const Vector& from, const Vector& tail, const Vector& head, const Vector& to) const {
    Vector e = head - tail, a = from - tail, b = to - tail;
    if (options_->metric) {
      const Eigen::Matrix3d& root = *options_->metric;
      e = Vector(root * e);
      a = Vector(root * a);
      b = Vector(root * b);
    }
    const auto crossing = unfolded_crossing(e, a, b);
    if (!crossing) return {};
    const auto& [at, squared, along, depth] = *crossing;
    return {std::sqrt((along * along + depth * depth) / squared), at};
  }

  /// A displacement in floats, in coordinates where its length is its norm.
  Eigen::Vector3f in_floats(const Vector& d, double unit) const {
    if (options_->metric) return (*options_->metric * d / unit).cast<float>();
    return (d / unit).cast<float>();
  }

  /// The landmarks' distances to the target: one in another component says nothing, and infinite values only get in the
  /// way.
  void aim(const Vector& goal, std::span<const std::int32_t> vertices, const Vector& origin, double unit) {
    goal_ = in_floats(goal - origin, unit);
    unit_ = unit;
    rounding_ = kLineRounding *
                static_cast<float>(mesh_->diameter() / unit * (options_->metric ? options_->metric->norm() : 1.0));
    aims_ = true;
    if (options_->landmarks == nullptr) return;
    const EdgeLandmarks& landmarks = *options_->landmarks;
    target_fields_.assign(static_cast<std::size_t>(landmarks.count()), std::numeric_limits<float>::infinity());
    for (const std::int32_t v : vertices) {
      const double further = (*this)(mesh_->position(v), goal);
      const std::span<const float> fields = landmarks.of(v);
      for (std::size_t i = 0; i < fields.size(); ++i)
        target_fields_[i] = std::min(target_fields_[i], static_cast<float>(static_cast<double>(fields[i]) + further));
    }
    if (!std::all_of(target_fields_.begin(), target_fields_.end(), [](float f) { return std::isfinite(f); }))
      target_fields_.clear();
  }

  /// The straight line, and what the landmarks leave open; from a place in the table, and where it is in_floats().
  double rest(const MoveTable& table, std::int32_t place, const Eigen::Vector3f& at) const {
    if (!aims_) return 0;
    const double straight = unit_ * static_cast<double>(std::max(0.0F, (at - goal_).norm() - rounding_));
    if (target_fields_.empty()) return straight;
    float best = 0;
    const std::span<const float> fields = options_->landmarks->of(table.vertex(place));
    for (std::size_t i = 0; i < fields.size(); ++i)
      best = std::max(
          best, std::abs(fields[i] - target_fields_[i]) - kFloatRounding * std::max(fields[i], target_fields_[i]));
    return std::max(straight, static_cast<double>(best));
  }

 private:
  double squared(const Vector& a, const Vector& b) const {
    if (options_->metric) [[unlikely]]
      return (*options_->metric * (b - a)).squaredNorm();
    return (b - a).squaredNorm();
  }

  const TriangleMesh* mesh_;
  const LengthSearchOptions* options_;
  Eigen::Vector3f goal_ = Eigen::Vector3f::Zero();  // from the search's origin, in_floats()
  double unit_ = 1;
  float rounding_ = 0;                // of straight lines to the goal, in units
  std::vector<float> target_fields_;  // of the landmarks, at the target
  bool aims_ = false;
};

/// Of a place in the table: all that a move to it asks for, two to a line of memory.
struct alignas(32) LengthRecord {
  std::uint32_t stamp = 0;  // of the query that reached it, so that nothing is ever cleared; one more: it was left
  std::int32_t predecessor = -1;
  double length = std::numeric_limits<double>::infinity();
  std::uint32_t moves = 0;        // number in the table; 0: not made
  Eigen::Vector3f position = {};  // from the origin of the search, LengthCost::in_floats()
};
static_assert(sizeof(LengthRecord) == 32);

/// Near a length, so that nothing is lost where it is divided by.
double power_of_two(double length) { return length > 0 && std::isfinite(length) ? std::exp2(std::ilogb(length)) : 1; }

bool same_metric(const MetricRoot& a, const MetricRoot& b) {
  return a.has_value() == b.has_value() && (!a || *a == *b);
}

}  // namespace

/// A* over a table of moves. Its nodes are the places of the table; the ends that are no vertices are -1 and -2.
struct LengthSearch::State {
  static constexpr std::int32_t kSource = -1, kTarget = -2;
  static constexpr double kSlotsPerEdge = 8;  // of the queue: mean edge over width

  explicit State(const TriangleMesh& of) : mesh(&of), moves(of, false), origin(of.position(0)) {}

  void begin(const LengthSearchOptions& options, const LengthCost& cost) {
    if (!same_metric(metric, options.metric) || (options.diagonals && !moves.diagonals())) {
      moves = MoveTable(*mesh, options.diagonals);
      records.clear();
      metric = options.metric;
      width = 0;
    }
    if (!(width > 0)) {
      unit = power_of_two(mesh->diameter() * (options.metric ? options.metric->norm() : 1.0));
      width = mean_edge(cost) / kSlotsPerEdge;
    }
    stamp += 2;
    if (stamp == 0) {  // wrapped around after two thousand million queries
      for (LengthRecord& r : records) r.stamp = 0;
      ends = {};
      stamp = 2;
    }
    corners = {kTarget, kTarget, kTarget};
    settled = 0;
  }

  /// About, of a few hundred faces.
  double mean_edge(const LengthCost& cost) const {
    constexpr std::int32_t kFaces = 300;
    const std::int32_t step = std::max(1, mesh->face_count() / kFaces);
    double sum = 0;
    int count = 0;
    for (std::int32_t f = 0; f < mesh->face_count(); f += step, ++count)
      sum += cost(mesh->position(mesh->face(f)[0]), mesh->position(mesh->face(f)[1]));
    return sum > 0 ? sum / count : 1;
  }

  void aim(const SurfacePoint& from, const SurfacePoint& to, LengthCost& cost) {
    const std::int32_t s = vertex_at(*mesh, from), t = vertex_at(*mesh, to);
    source = s >= 0 ? moves.place(s) : kSource;
    target = t >= 0 ? moves.place(t) : kTarget;
    source_position = mesh->point(from);
    target_position = mesh->point(to);
    source_face = from.face;
    target_face = to.face;
    if (t < 0)
      for (std::size_t k = 0; k < 3; ++k) corners[k] = moves.place(mesh->face(to.face)[k]);
    cost.aim(t < 0 ? target_position : mesh->position(t),
             t < 0 ? std::span<const std::int32_t>(mesh->face(to.face)) : std::span<const std::int32_t>(&t, 1), origin,
             unit);
    meet(cost);
    ends = {};
  }

  /// Records of the vertices that were met since.
  void meet(const LengthCost& cost) {
    while (records.size() < static_cast<std::size_t>(moves.size())) {
      const std::int32_t v = moves.vertex(static_cast<std::int32_t>(records.size()));
      records.push_back({.position = cost.in_floats(mesh->position(v) - origin, unit)});
    }
  }

  LengthRecord& record(std::int32_t node) {
    return node >= 0 ? records[static_cast<std::size_t>(node)] : ends[static_cast<std::size_t>(node + 2)];
  }

  double rest(std::int32_t node, const LengthRecord& r, const LengthCost& cost) const {
    return node >= 0 ? cost.rest(moves, node, r.position) : 0;
  }

  void reach(std::int32_t from, std::int32_t node, double length, const LengthCost& cost) {
    LengthRecord& r = record(node);
    if ((r.stamp | 1) == (stamp | 1) && !(length < r.length)) return;
    r.stamp = stamp;
    r.predecessor = from;
    r.length = length;
    open.push({length + rest(node, r, cost), node});
  }

  void leave(std::int32_t node, bool diagonals, const LengthCost& cost) {
    const double so_far = record(node).length;
    if (node < 0) {  // the source, inside a face
      for (const std::int32_t v : mesh->face(source_face)) {
        const std::int32_t corner = moves.place(v);
        meet(cost);
        reach(node, corner, cost(source_position, mesh->position(v)), cost);
      }
      if (target == kTarget && target_face == source_face)
        reach(node, kTarget, cost(source_position, target_position), cost);
      return;
    }
    if (record(node).moves == 0) {
      record(node).moves = moves.make_moves(node, cost, 1 / unit);
      meet(cost);
    }
    for (const MoveTable::Move& move : moves.moves(record(node).moves, diagonals))
      reach(node, move.to, so_far + unit * static_cast<double>(move.length), cost);
    if (target == kTarget && std::find(corners.begin(), corners.end(), node) != corners.end())
      reach(node, kTarget, so_far + cost(mesh->position(moves.vertex(node)), target_position), cost);
  }

  /// Has brought near what the nodes ask for that come next: searches on large meshes wait for memory most of the time.
  /// Inline, because compilers leave calls out that they find to have no effect.
  [[gnu::always_inline]] void expect(bool diagonals) const {
    constexpr std::size_t kRecord = 12, kMoves = 6, kEnds = 2;  // nodes before
    constexpr std::size_t kNearAnyway = 65536;                  // records
    if (records.size() < kNearAnyway) {
      if (const std::int32_t node = open.coming(0); node >= 0) moves.expect(records[at(node)].moves);
      return;
    }
    if (const std::int32_t node = open.coming(kRecord); node >= 0) __builtin_prefetch(&records[at(node)]);
    if (const std::int32_t node = open.coming(kMoves); node >= 0) moves.expect(records[at(node)].moves);
    if (const std::int32_t node = open.coming(kEnds); node >= 0 && records[at(node)].stamp == stamp)
      for (const MoveTable::Move& move : moves.moves(records[at(node)].moves, diagonals))
        __builtin_prefetch(&records[at(move.to)]);
  }

  static std::size_t at(std::int32_t place) { return static_cast<std::size_t>(place); }

  bool found() { return (record(target).stamp | 1) == (stamp | 1); }

  EdgePathOutcome run(const LengthSearchOptions& options, const LengthCost& cost) {
    open.begin(rest(source, record(source), cost), width);
    reach(source, source, 0, cost);
    while (!open.empty()) {
      if (found() && open.floor() >= record(target).length) break;
      const std::int32_t node = open.pop();
      LengthRecord& r = record(node);
      if (r.stamp != stamp || node == target) continue;  // it was left, over a way that is no longer
      ++r.stamp;
      expect(options.diagonals);
      if (++settled % LengthCost::kLookEvery == 0 && options.stop && options.stop()) return EdgePathOutcome::stopped;
      leave(node, options.diagonals, cost);
    }
    return found() ? EdgePathOutcome::found : EdgePathOutcome::no_finite_route;
  }

  /// Nodes from the source to the target as a MoveTracer numbers them.
  std::vector<std::int32_t> nodes() {
    const auto number = [&](std::int32_t node) {
      return node >= 0 ? moves.vertex(node) : mesh->vertex_count() - 1 - node;
    };
    std::vector<std::int32_t> found{number(target)};
    for (std::int32_t node = target; node != source;) found.push_back(number(node = record(node).predecessor));
    std::reverse(found.begin(), found.end());
    return found;
  }

  const TriangleMesh* mesh;
  MetricRoot metric;
  MoveTable moves;
  Vector origin;
  double unit = 1;                    // of lengths in floats: no mesh is too large or too small for them
  std::vector<LengthRecord> records;  // of the places
  std::array<LengthRecord, 2> ends;   // of the target, of the source, where they are no vertices
  SlotQueue open;
  double width = 0;  // of its slots, length units
  std::uint32_t stamp = 0;
  std::int32_t settled = 0, source = kSource, target = kTarget, source_face = -1, target_face = -1;
  Vector source_position, target_position;
  std::array<std::int32_t, 3> corners;  // where the target is no vertex
};

LengthSearch::LengthSearch(const TriangleMesh& mesh) : state_(std::make_unique<State>(mesh)) {}
LengthSearch::~LengthSearch() = default;
LengthSearch::LengthSearch(LengthSearch&&) noexcept = default;
LengthSearch& LengthSearch::operator=(LengthSearch&&) noexcept = default;

EdgePath LengthSearch::shortest(const SurfacePoint& source, const SurfacePoint& target,
                                const LengthSearchOptions& options) {
  State& state = *state_;
  const TriangleMesh& mesh = *state.mesh;
  EdgePath result;
  const std::int32_t from = mesh.component(mesh.face(source.face)[0]), to = mesh.component(mesh.face(target.face)[0]);
  result.source_component_size = mesh.component_sizes()[static_cast<std::size_t>(from)];
  result.target_component_size = mesh.component_sizes()[static_cast<std::size_t>(to)];
  if (from != to) {
    result.outcome = EdgePathOutcome::different_components;
    return result;
  }
  LengthCost cost(mesh, options);
  state.begin(options, cost);
  state.aim(source, target, cost);
  result.outcome = state.run(options, cost);
  result.settled = state.settled;
  if (!result.found()) return result;
  const std::vector<std::int32_t> nodes = state.nodes();
  std::copy_if(nodes.begin(), nodes.end(), std::back_inserter(result.vertices),
               [&mesh](std::int32_t n) { return n < mesh.vertex_count(); });
  result.path = MoveTracer<LengthCost>{mesh, cost, options.diagonals, source, target}.path(nodes);
  result.cost = path_length(result.path, options.metric);
  return result;
}

std::vector<double> LengthSearch::lengths_from(std::int32_t vertex, const LengthSearchOptions& options) {
  State& state = *state_;
  LengthSearchOptions all = options;
  all.diagonals = true;
  const LengthCost cost(*state.mesh, all);
  state.begin(all, cost);
  state.source = state.moves.place(vertex);
  state.meet(cost);
  state.target = State::kTarget;
  state.run(all, cost);
  std::vector<double> lengths(static_cast<std::size_t>(state.mesh->vertex_count()),
                              std::numeric_limits<double>::infinity());
  for (std::int32_t place = 0; place < state.moves.size(); ++place)
    if (const LengthRecord& r = state.record(place);
        (r.stamp | 1) == (state.stamp | 1))  // of one that the search came to
      lengths[static_cast<std::size_t>(state.moves.vertex(place))] = r.length;
  return lengths;
}

}  // namespace leastcost
