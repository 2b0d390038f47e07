// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <cmath>
#include <deque>
#include <limits>
#include <utility>

#include "benchmarks/comparison/methods.hpp"
#include "benchmarks/comparison/windows.hpp"

namespace leastcost::comparison {
namespace {

constexpr long kChenHanLook = 1024;

/// Chen and Han 1990: a tree of windows, grown level by level. Of two windows that see a corner over the same edge only
/// the nearer one goes on to both sides; the other one's child on the side of the nearer one's ray is cut off, with all
/// that grew from it. No order by distance and no filter: it ends when nothing is left to grow.
class ChenHan final : public Method {
 public:
  void prepare(const TriangleMesh& mesh, const Stop&) override { tables_ = std::make_unique<WindowTables>(mesh); }

  Answer shortest(std::int32_t source, std::int32_t target, const Stop& stop) override {
    WindowTables& t = *tables_;
    t.begin(source);
    queue_.clear();
    holders_.assign(3 * static_cast<std::size_t>(t.edges().mesh().face_count()), {});
    fired_.assign(static_cast<std::size_t>(t.edges().mesh().vertex_count()), std::numeric_limits<double>::infinity());
    Answer answer;
    queue_.push_back(~source);
    for (long count = 1; !queue_.empty(); ++count) {
      const std::int32_t id = queue_.front();
      queue_.pop_front();
      if (t.full()) {
        answer.outcome = Outcome::out_of_windows;
        break;
      }
      if (count % kChenHanLook == 0 && stop && stop()) {
        answer.outcome = Outcome::out_of_time;
        break;
      }
      if (id < 0) {
        fire(~id);
      } else if (!t.is_stale(t.window(id))) {
        grow(id);
      }
    }
    answer.windows = t.size();
    if (answer.outcome != Outcome::found) return answer;
    answer.distance = t.distance(target);
    answer.path = t.path(target);
    return answer;
  }

 private:
  struct Holder {
    std::int32_t window = -1;
    double distance = 0, crossing = 0;
  };

  void fire(std::int32_t v) {
    double& before = fired_[static_cast<std::size_t>(v)];
    if (!(tables_->distance(v) < before)) return;
    before = tables_->distance(v);
    tables_->fire(
        v, [&](const PlainWindow& w) { queue_.push_back(tables_->add(w)); },
        [&](std::int32_t w) {
          if (tables_->bends(w)) queue_.push_back(~w);
        });
  }

  void cut(std::int32_t id) {
    if (id >= 0) falling_.push_back(id);
    while (!falling_.empty()) {
      PlainWindow& w = tables_->window(falling_.back());
      falling_.pop_back();
      w.dead = true;
      for (std::int32_t& child : w.child)
        if (child >= 0) falling_.push_back(std::exchange(child, -1));
    }
  }

  void grow(std::int32_t id) {
    WindowTables& t = *tables_;
    const PlainWindow w = t.window(id);
    if (w.level >= t.edges().mesh().face_count()) return;  // a shortest path crosses no face twice
    const WindowTables::Corner corner = t.corner(w);
    bool sides[2] = {true, true};
    if (corner.seen) {
      Holder& holder = holders_[static_cast<std::size_t>(w.halfedge)];
      const bool held = holder.window >= 0 && !t.is_stale(t.window(holder.window));
      // Two parts of one fan that meet in the ray to the corner tie: each goes on.
      if (held && holder.distance < corner.distance * (1 - kWindowTie)) {
        sides[corner.crossing < holder.crossing ? 1 : 0] = false;
      } else if (!held || corner.distance < holder.distance) {
        if (held && corner.distance < holder.distance * (1 - kWindowTie)) {
          const int lost = holder.crossing < corner.crossing ? 1 : 0;
          cut(t.window(holder.window).child[lost]);
          t.window(holder.window).child[lost] = -1;
        }
        holder = {id, corner.distance, corner.crossing};
      }
      if (t.reach(corner.vertex, corner.distance, id, -1) && t.bends(corner.vertex)) queue_.push_back(~corner.vertex);
    }
    for (int side = 0; side < 2; ++side) {
      PlainWindow next;
      if (!sides[side] || !t.go_on(id, side, false, next)) continue;
      const std::int32_t child = t.add(next);
      t.window(id).child[side] = child;
      queue_.push_back(child);
    }
  }

  std::unique_ptr<WindowTables> tables_;
  std::deque<std::int32_t> queue_;  // windows, or ~root
  std::vector<double> fired_;       // distance at which a root has sent its windows
  std::vector<Holder> holders_;
  std::vector<std::int32_t> falling_;
};

}  // namespace

std::unique_ptr<Method> make_chen_han() { return std::make_unique<ChenHan>(); }

}  // namespace leastcost::comparison
