// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <queue>
#include <utility>

#include "benchmarks/comparison/methods.hpp"
#include "benchmarks/comparison/windows.hpp"

namespace leastcost::comparison {
namespace {

constexpr long kImprovedLook = 1024;

/// Xin and Wang 2009: Chen and Han's windows in the order of their least distance, without those to which the vertices
/// around know a shorter way. Ends when nothing open is nearer than the target.
class ImprovedChenHan final : public Method {
 public:
  void prepare(const TriangleMesh& mesh, const Stop&) override { tables_ = std::make_unique<WindowTables>(mesh); }

  Answer shortest(std::int32_t source, std::int32_t target, const Stop& stop) override {
    WindowTables& t = *tables_;
    t.begin(source);
    queue_ = {};
    holders_.assign(3 * static_cast<std::size_t>(t.edges().mesh().face_count()), {});
    Answer answer;
    queue_.push({0, ~source});
    for (long count = 1; !queue_.empty() && queue_.top().first < t.distance(target); ++count) {
      const auto [key, id] = queue_.top();
      queue_.pop();
      if (t.full()) {
        answer.outcome = Outcome::out_of_windows;
        break;
      }
      if (count % kImprovedLook == 0 && stop && stop()) {
        answer.outcome = Outcome::out_of_time;
        break;
      }
      if (id < 0) {
        if (key <= t.distance(~id)) fire(~id);
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
  using Entry = std::pair<double, std::int32_t>;

  void push(const PlainWindow& w) {
    const double key = w.key();
    queue_.push({key, tables_->add(w)});
  }
  void fire(std::int32_t v) {
    tables_->fire(
        v, [&](const PlainWindow& w) { push(w); },
        [&](std::int32_t w) {
          if (tables_->bends(w)) queue_.push({tables_->distance(w), ~w});
        });
  }

  void grow(std::int32_t id) {
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
    for (int side = 0; side < 2; ++side) {
      PlainWindow next;
      if (sides[side] && t.go_on(id, side, true, next)) push(next);
    }
  }

  std::unique_ptr<WindowTables> tables_;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue_;
  std::vector<Holder> holders_;
};

}  // namespace

std::unique_ptr<Method> make_improved_chen_han() { return std::make_unique<ImprovedChenHan>(); }

}  // namespace leastcost::comparison
