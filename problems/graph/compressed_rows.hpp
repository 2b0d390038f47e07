// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

// For the .cpp files of this folder: Boost.Graph's rows behind SparseGraph.
#include <boost/graph/compressed_sparse_row_graph.hpp>

namespace leastcost {

struct CompressedRows {
  using Graph = boost::compressed_sparse_row_graph<boost::directedS, boost::no_property, boost::no_property,
                                                   boost::no_property, std::int32_t, std::int32_t>;
  Graph graph;
};

}  // namespace leastcost
