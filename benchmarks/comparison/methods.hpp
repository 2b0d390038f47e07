// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include "benchmarks/comparison/method.hpp"

namespace leastcost::comparison {

std::unique_ptr<Method> make_dijkstra();
std::unique_ptr<Method> make_fast_marching();
std::unique_ptr<Method> make_heat();
std::unique_ptr<Method> make_chen_han();
std::unique_ptr<Method> make_improved_chen_han();
std::unique_ptr<Method> make_vertex_oriented();
std::unique_ptr<Method> make_selective_refinement();
std::unique_ptr<Method> make_local_straightening();
std::unique_ptr<Method> make_differential_evolution();
std::unique_ptr<Method> make_squared_length();
std::unique_ptr<Method> make_crossing_lbfgs();
std::unique_ptr<Method> make_vfcs();
std::unique_ptr<Method> make_ours();

}  // namespace leastcost::comparison
