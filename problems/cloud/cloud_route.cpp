// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/cloud/cloud_route.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/cost/segment_cost.hpp>
#include "problems/cloud/unresolved.hpp"
#include "problems/graph/shortest_route.hpp"

namespace leastcost {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr int kRounds = 200;  // searches, each around the gaps found so far

/// The samples as nodes 0 .. n-1, the source n, the target n + 1.
class RouteQuery {
 public:
  RouteQuery(const Problem& problem, const HasPointCloud& domain, const Monitor& monitor)
      : problem_(problem),
        domain_(domain),
        monitor_(monitor),
        samples_(domain.cloud().size()),
        state_(static_cast<std::size_t>(samples_), State::unknown),
        position_(static_cast<std::size_t>(samples_)) {}

  CloudRoute run() {
    const std::vector<std::int32_t> from = links(problem_.source.u), to = links(problem_.target.u);
    check_components(from, to);
    for (int round = 0;; ++round) {
      CloudRoute route = shortest(from, to);
      if (!block_gaps() || round == kRounds) return route;
    }
  }

 private:
  CloudRoute shortest(const std::vector<std::int32_t>& from, const std::vector<std::int32_t>& to) {
    std::vector<RouteEnd> starts, ends;
    for (const std::int32_t i : from) starts.push_back({i, move(source(), i)});
    for (const std::int32_t i : to) ends.push_back({i, move(i, target())});
    GraphRoute route = shortest_route(
        domain_.graph().edges(), starts, ends, [this](std::int32_t a, std::int32_t b) { return move(a, b); },
        [this] { return monitor_.interrupted(); });
    if (route.outcome == RouteOutcome::stopped)
      throw Interrupted("the search was stopped after " + std::to_string(route.settled) + " samples");
    const bool neighbours = std::find(from.begin(), from.end(), to[0]) != from.end();
    const double direct = neighbours ? move(source(), target()) : kInfinity;
    if (direct <= route.cost && direct < kInfinity) return path_along({source(), target()});
    if (route.outcome == RouteOutcome::found) {
      route.nodes.insert(route.nodes.begin(), source());
      route.nodes.push_back(target());
      return path_along(route.nodes);
    }
    throw InitializationError("no route along the neighbour graph: " + std::to_string(route.settled) + " of " +
                              std::to_string(part_size_) + " samples can be reached; " + why_cut_off());
  }

  std::string why_cut_off() const {
    if (last_gap_)
      return "every continuation crosses a place without a surface; " +
             why_no_surface_at(domain_.cloud(), domain_.surface(), *last_gap_);
    return std::to_string(no_surface_) +
           " next to them are on a border or off the surface, and the cost is infinite elsewhere";
  }

  enum class State : std::uint8_t { unknown, on_surface, none };

  std::int32_t source() const { return samples_; }
  std::int32_t target() const { return samples_ + 1; }

  /// Samples that an end is joined to: the nearest one and its neighbours.
  std::vector<std::int32_t> links(const Eigen::Vector3d& end) const {
    std::vector<Neighbour> near;
    domain_.cloud().search().nearest(end - domain_.cloud().centre(), domain_.cloud().neighbour_count(), near);
    std::vector<std::int32_t> out;
    for (const Neighbour& n : near) {
      if (!(domain_.cloud().sample(n.index).trust > 0)) continue;
      if (out.empty() || domain_.graph().component(n.index) == domain_.graph().component(out[0]))
        out.push_back(n.index);
    }
    if (out.empty()) throw InitializationError("an end is among points that were excluded from the surface");
    return out;
  }

  void check_components(const std::vector<std::int32_t>& from, const std::vector<std::int32_t>& to) {
    const CloudGraph& graph = domain_.graph();
    const std::int32_t a = graph.component(from[0]), b = graph.component(to[0]);
    part_size_ = graph.component_sizes()[static_cast<std::size_t>(a)];
    if (a == b) return;
    throw InitializationError("the ends are in different parts of the cloud, with " + std::to_string(part_size_) +
                              " and " + std::to_string(graph.component_sizes()[static_cast<std::size_t>(b)]) +
                              " points; " + how_to_join(domain_.cloud(), graph, a, b));
  }

  /// Onto the surface, or to its border where it has one to rest on.
  bool on_surface(Eigen::Vector3d& x) const {
    return domain_.cloud().has_border() ? domain_.surface().project_within(x) : domain_.surface().project(x);
  }

  /// Whether a place of a move is on the surface, or just beyond the border.
  bool is_near_surface(const Eigen::Vector3d& x) const {
    constexpr double kBeyond = 0.5;  // spacings
    Eigen::Vector3d on = x;
    if (domain_.surface().project(on)) return true;
    if (!on_surface(on)) return false;
    const std::int32_t nearest = domain_.cloud().search().nearest(on - domain_.cloud().centre()).index;
    return (on - x).norm() < kBeyond * domain_.cloud().spacing(nearest);
  }

  /// The place of a node on the surface; null where it has none. Projected when it is first asked for.
  const Eigen::Vector3d* place(std::int32_t node) {
    if (node >= samples_) {
      end_ = node == source() ? problem_.source.u : problem_.target.u;
      return &end_;
    }
    State& state = state_[static_cast<std::size_t>(node)];
    Eigen::Vector3d& x = position_[static_cast<std::size_t>(node)];
    if (state == State::unknown) {
      x = domain_.cloud().sample(node).position + domain_.cloud().centre();
      state = on_surface(x) ? State::on_surface : State::none;
      if (state == State::none) ++no_surface_;
    }
    return state == State::on_surface ? &x : nullptr;
  }

  double move(std::int32_t from, std::int32_t to) {
    if (!gaps_.empty() && gaps_.count(std::minmax(from, to)) > 0) return kInfinity;
    Eigen::Matrix<double, 3, 2> ends;
    const Eigen::Vector3d* a = place(from);
    if (a == nullptr) return kInfinity;
    ends.col(0) = *a;
    const Eigen::Vector3d* b = place(to);
    if (b == nullptr) return kInfinity;
    ends.col(1) = *b;
    if (is_long(from, to) && looked_at_.insert(std::minmax(from, to)).second && !stays_near_surface(*a, *b)) {
      gaps_.insert(std::minmax(from, to));
      return kInfinity;
    }
    double q = 0;
    problem_.cost->squared_costs({{ends.data(), 3, 2}, {}, false}, {&q, 1});
    return std::sqrt(q);
  }

  /// Blocks the moves of the path whose middle has no projection (they lead over a hole or along a border); true when
  /// there are any.
  bool block_gaps() {
    bool any = false;
    for (std::size_t i = 1; i < nodes_.size(); ++i)
      if (!stays_near_surface(*place(nodes_[i - 1]), *place(nodes_[i])))
        any = gaps_.insert(std::minmax(nodes_[i - 1], nodes_[i])).second || any;
    return any;
  }

  bool stays_near_surface(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    for (const double t : {0.25, 0.5, 0.75}) {
      const Eigen::Vector3d x = (1 - t) * a + t * b;
      if (is_near_surface(x)) continue;
      last_gap_ = x;
      return false;
    }
    return true;
  }

  /// Longer than most links between neighbours: looked at at once, the others where a route uses them.
  bool is_long(std::int32_t from, std::int32_t to) const {
    constexpr double kLong = 2.2;  // spacings
    if (from >= samples_ || to >= samples_) return false;
    const PointCloud& cloud = domain_.cloud();
    const double length = (cloud.sample(from).position - cloud.sample(to).position).norm();
    return length > kLong * (cloud.spacing(from) + cloud.spacing(to)) / 2;
  }

  CloudRoute path_along(const std::vector<std::int32_t>& nodes) {
    nodes_ = nodes;
    CloudRoute route;
    for (const std::int32_t node : nodes_) route.points.push_back(*place(node));
    route.vertices = static_cast<int>(route.points.size()) - 2;
    return route;
  }

  const Problem& problem_;
  const HasPointCloud& domain_;
  const Monitor& monitor_;
  std::int32_t samples_, part_size_ = 0, no_surface_ = 0;
  std::vector<State> state_;
  std::vector<Eigen::Vector3d> position_;
  Eigen::Vector3d end_;
  std::optional<Eigen::Vector3d> last_gap_;                           // where a move was blocked last
  std::vector<std::int32_t> nodes_;                                   // of the path found last
  std::set<std::pair<std::int32_t, std::int32_t>> gaps_, looked_at_;  // smaller node first
};

}  // namespace

CloudRoute cloud_route(const Problem& problem, const HasPointCloud& domain, const Monitor& monitor) {
  return RouteQuery(problem, domain, monitor).run();
}

}  // namespace leastcost
