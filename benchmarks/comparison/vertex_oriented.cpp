// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <queue>
#include <utility>

#include "benchmarks/comparison/methods.hpp"
#include "benchmarks/comparison/windows.hpp"

namespace leastcost::comparison {
namespace {

constexpr long kVertexLook = 256;
/// Windows on either side in the list of an edge that a new one is compared with.
constexpr std::ptrdiff_t kListNeighbours = 4;
constexpr double kListTie = 1e-12;

/// True when every point of w's part is reached as soon through the part of `other` on the same edge: from a point of
/// it at or before the part's begin on to its end, or the other way round.
bool is_dominated(const PlainWindow& w, const PlainWindow& other, double margin) {
  const double from = std::min(w.begin, other.end);
  if (from >= other.begin && other.distance_at(from) + (w.end - from) <= w.distance_at(w.end) * (1 - margin))
    return true;
  const double to = std::max(w.end, other.begin);
  return to <= other.end && other.distance_at(to) + (to - w.begin) <= w.distance_at(w.begin) * (1 - margin);
}

/// Qin, Han, Yu, Yu and Zhang 2016: windows wait in the lists of their edges, pruned against their neighbours there,
/// and are moved on through the faces around one vertex at a time, the vertex with the nearest windows first.
class VertexOriented final : public Method {
 public:
  void prepare(const TriangleMesh& mesh, const Stop&) override { tables_ = std::make_unique<WindowTables>(mesh); }

  Answer shortest(std::int32_t source, std::int32_t target, const Stop& stop) override {
    WindowTables& t = *tables_;
    const TriangleMesh& mesh = t.edges().mesh();
    t.begin(source);
    lists_.assign(3 * static_cast<std::size_t>(mesh.face_count()), {});
    queue_ = {};
    holders_.assign(lists_.size(), {});
    Answer answer;
    queue_.push({0, ~source});
    for (long count = 1; !queue_.empty() && queue_.top().first < t.distance(target); ++count) {
      const auto [key, v] = queue_.top();
      queue_.pop();
      if (t.full()) {
        answer.outcome = Outcome::out_of_windows;
        break;
      }
      if (count % kVertexLook == 0 && stop && stop()) {
        answer.outcome = Outcome::out_of_time;
        break;
      }
      if (v >= 0) {
        move_on_around(v);
      } else if (key <= t.distance(~v)) {
        fire(~v);
      }
    }
    answer.windows = t.size();
    if (answer.outcome != Outcome::found) return answer;
    answer.distance = t.distance(target);
    answer.path = t.path(target);
    return answer;
  }

 private:
  struct List {
    std::vector<std::int32_t> windows;  ///< by the middle of their parts
    std::vector<std::int32_t> waiting;
  };
  struct Holder {
    std::int32_t window = -1;
    double distance = 0, crossing = 0;
  };
  using Entry = std::pair<double, std::int32_t>;  // a vertex to move windows around, or ~root

  List& list(std::int32_t h) { return lists_[static_cast<std::size_t>(h)]; }

  /// Into the list of its edge, unless a neighbour there makes it useless.
  bool insert(const PlainWindow& w) {
    WindowTables& t = *tables_;
    std::vector<std::int32_t>& all = list(w.halfedge).windows;
    const auto middle = [&](std::int32_t id) { return t.window(id).begin + t.window(id).end; };
    const auto place = std::lower_bound(all.begin(), all.end(), w.begin + w.end,
                                        [&](std::int32_t id, double m) { return middle(id) < m; });
    const auto first = place - std::min(kListNeighbours, place - all.begin());
    const auto last = place + std::min(kListNeighbours, all.end() - place);
    for (auto i = first; i != last; ++i)
      if (!t.is_stale(t.window(*i)) && is_dominated(w, t.window(*i), kListTie)) return false;
    bool removed = false;
    for (auto i = first; i != last; ++i)
      if (is_dominated(t.window(*i), w, kListTie)) t.window(*i).dead = removed = true;
    const std::int32_t id = t.add(w);
    all.insert(place, id);
    if (removed) std::erase_if(all, [&](std::int32_t i) { return t.window(i).dead; });
    list(w.halfedge).waiting.push_back(id);
    return true;
  }

  void queue_up(const PlainWindow& w) {
    const double from_tail = std::abs(w.x - w.begin), from_head = std::abs(w.end - w.x);
    const std::int32_t v =
        from_tail < from_head ? tables_->edges().tail(w.halfedge) : tables_->edges().head(w.halfedge);
    queue_.push({w.key(), v});
  }

  void fire(std::int32_t v) {
    tables_->fire(
        v,
        [&](const PlainWindow& w) {
          if (insert(w)) queue_up(w);
        },
        [&](std::int32_t w) {
          if (tables_->bends(w)) queue_.push({tables_->distance(w), ~w});
        });
  }

  void move_on_around(std::int32_t v) {
    const TriangleMesh& mesh = tables_->edges().mesh();
    open_.clear();
    for (const std::int32_t f : mesh.faces_of_vertex(v))
      for (std::int32_t h = 3 * f; h < 3 * f + 3; ++h)
        if (!list(h).waiting.empty()) open_.push_back(h);
    while (!open_.empty()) {
      const std::int32_t h = open_.back();
      open_.pop_back();
      moving_.swap(list(h).waiting);
      list(h).waiting.clear();
      for (const std::int32_t id : moving_)
        if (!tables_->is_stale(tables_->window(id))) grow(id, v);
      moving_.clear();
    }
  }

  void grow(std::int32_t id, std::int32_t around) {
    WindowTables& t = *tables_;
    const PlainWindow w = t.window(id);
    const WindowTables::Corner corner = t.corner(w);
    bool sides[2] = {true, true};
    if (corner.seen) {
      Holder& holder = holders_[static_cast<std::size_t>(w.halfedge)];
      const bool held = holder.window >= 0 && !t.is_stale(t.window(holder.window));
      // Two parts of one fan that meet in the ray to the corner tie: each goes on.
      if (held && holder.distance < corner.distance * (1 - kWindowTie)) {
        sides[corner.crossing < holder.crossing ? 1 : 0] = false;
      } else if (!held || corner.distance < holder.distance) {
        holder = {id, corner.distance, corner.crossing};
      }
      if (t.reach(corner.vertex, corner.distance, id, -1) && t.bends(corner.vertex))
        queue_.push({corner.distance, ~corner.vertex});
    }
    const TriangleMesh& mesh = t.edges().mesh();
    for (int side = 0; side < 2; ++side) {
      PlainWindow next;
      if (!sides[side] || !t.go_on(id, side, true, next) || !insert(next)) continue;
      const auto& corners = mesh.face(next.halfedge / 3);
      if (std::find(corners.begin(), corners.end(), around) != corners.end()) {
        if (list(next.halfedge).waiting.size() == 1) open_.push_back(next.halfedge);
      } else {
        queue_up(next);
      }
    }
  }

  std::unique_ptr<WindowTables> tables_;
  std::vector<List> lists_;
  std::vector<Holder> holders_;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue_;
  std::vector<std::int32_t> open_, moving_;
};

}  // namespace

std::unique_ptr<Method> make_vertex_oriented() { return std::make_unique<VertexOriented>(); }

}  // namespace leastcost::comparison
