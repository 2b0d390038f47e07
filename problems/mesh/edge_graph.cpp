// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/mesh/edge_graph.hpp>

#include <boost/graph/astar_search.hpp>
#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>
#include <utility>

#include "problems/mesh/edge_query.hpp"

// The query as a model of Boost's IncidenceGraph and its maps. The out-edges of a vertex are made when Boost asks for
// them, which it does once, on examining the vertex.
namespace leastcost {
namespace {

struct EdgeGraph {
  EdgeQuery* query;
};

/// A member of the node's record.
template <class Value, Value NodeRecord::*member>
struct RecordMap {
  EdgeQuery* query;
  friend Value get(const RecordMap& map, std::int32_t node) { return map.query->record(node).*member; }
  friend void put(const RecordMap& map, std::int32_t node, Value value) { map.query->record(node).*member = value; }
};

struct ColorMap {
  EdgeQuery* query;
  friend boost::default_color_type get(const ColorMap& map, std::int32_t node) {
    const NodeState state = map.query->record(node).state;
    if (state == NodeState::unseen) return boost::white_color;
    return state == NodeState::open ? boost::gray_color : boost::black_color;
  }
  friend void put(const ColorMap& map, std::int32_t node, boost::default_color_type color) {
    map.query->record(node).state = color == boost::white_color  ? NodeState::unseen
                                    : color == boost::gray_color ? NodeState::open
                                                                 : NodeState::settled;
  }
};

struct CostMap {
  friend double get(const CostMap&, const Move& move) { return move.cost; }
};

struct TargetSettled {};
struct StopRequested {};

/// Boost's way to leave a search early is to throw.
struct SettleVisitor : boost::default_astar_visitor {
  EdgeQuery* query;
  explicit SettleVisitor(EdgeQuery* q) : query(q) {}
  template <class Graph>
  void examine_vertex(std::int32_t node, const Graph&) const {
    if (node == query->target()) throw TargetSettled{};
    if (query->settle()) throw StopRequested{};
  }
};

}  // namespace
}  // namespace leastcost

namespace boost {

template <>
struct graph_traits<leastcost::EdgeGraph> {
  using vertex_descriptor = std::int32_t;
  using edge_descriptor = leastcost::Move;
  using directed_category = directed_tag;
  using edge_parallel_category = allow_parallel_edge_tag;
  using traversal_category = incidence_graph_tag;
  using out_edge_iterator = const leastcost::Move*;
  using degree_size_type = std::size_t;
  static vertex_descriptor null_vertex() { return -1; }
};

template <class Value, Value leastcost::NodeRecord::*member>
struct property_traits<leastcost::RecordMap<Value, member>> {
  using key_type = std::int32_t;
  using value_type = Value;
  using reference = Value;
  using category = read_write_property_map_tag;
};

template <>
struct property_traits<leastcost::ColorMap> {
  using key_type = std::int32_t;
  using value_type = default_color_type;
  using reference = default_color_type;
  using category = read_write_property_map_tag;
};

template <>
struct property_traits<leastcost::CostMap> {
  using key_type = leastcost::Move;
  using value_type = double;
  using reference = double;
  using category = readable_property_map_tag;
};

}  // namespace boost

namespace leastcost {
namespace {

std::int32_t source(const Move& move, const EdgeGraph&) { return move.from; }
std::int32_t target(const Move& move, const EdgeGraph&) { return move.to; }

std::pair<const Move*, const Move*> out_edges(std::int32_t node, const EdgeGraph& graph) {
  const std::vector<Move>& moves = graph.query->moves_from(node);
  return {moves.data(), moves.data() + moves.size()};
}

[[maybe_unused]] std::size_t out_degree(std::int32_t node, const EdgeGraph& graph) {
  return graph.query->moves_from(node).size();
}

EdgePathOutcome search(EdgeQuery& query) {
  const RecordMap<std::int32_t, &NodeRecord::predecessor> predecessor{&query};
  const RecordMap<double, &NodeRecord::key> key{&query};
  const RecordMap<double, &NodeRecord::distance> distance{&query};
  query.record(query.source()).distance = 0;
  query.record(query.source()).key = query.bound(query.source());
  try {
    boost::astar_search_no_init(
        EdgeGraph{&query}, query.source(), [&query](std::int32_t node) { return query.bound(node); },
        SettleVisitor(&query), predecessor, key, distance, CostMap{}, ColorMap{&query},
        boost::typed_identity_property_map<std::int32_t>{}, std::less<double>{}, std::plus<double>{},
        std::numeric_limits<double>::infinity(), 0.0);
  } catch (const TargetSettled&) {
    return EdgePathOutcome::found;
  } catch (const StopRequested&) {
    return EdgePathOutcome::stopped;
  }
  return EdgePathOutcome::no_finite_route;
}

}  // namespace

struct EdgeGraphSearch::State {
  const TriangleMesh* mesh;
  EdgeQuery query;
};

EdgeGraphSearch::EdgeGraphSearch(const TriangleMesh& mesh)
    : state_(std::make_unique<State>(State{&mesh, EdgeQuery(mesh)})) {}
EdgeGraphSearch::~EdgeGraphSearch() = default;
EdgeGraphSearch::EdgeGraphSearch(EdgeGraphSearch&&) noexcept = default;
EdgeGraphSearch& EdgeGraphSearch::operator=(EdgeGraphSearch&&) noexcept = default;

EdgePath EdgeGraphSearch::shortest(const SurfacePoint& source, const SurfacePoint& target, const MoveCost& cost,
                                   const EdgePathOptions& options) {
  const TriangleMesh& mesh = *state_->mesh;
  EdgeQuery& query = state_->query;
  EdgePath result;
  const std::int32_t from = mesh.component(mesh.face(source.face)[0]), to = mesh.component(mesh.face(target.face)[0]);
  result.source_component_size = mesh.component_sizes()[static_cast<std::size_t>(from)];
  result.target_component_size = mesh.component_sizes()[static_cast<std::size_t>(to)];
  if (from != to) {
    result.outcome = EdgePathOutcome::different_components;
    return result;
  }
  query.begin(source, target, cost, options);
  result.outcome = search(query);
  result.settled = query.settled();
  if (!result.found()) return result;
  result.cost = query.record(query.target()).distance;
  result.path = query.path_found(result.vertices);
  return result;
}

}  // namespace leastcost
