// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/kernels/kernels.hpp>
#include "tests/contracts/kernel_contract.hpp"

namespace leastcost::test {

TEST_CASE("kernel contract: linear", "[contract]") { check_kernel_contract(*make_kernel<Linear>()); }
TEST_CASE("kernel contract: square", "[contract]") { check_kernel_contract(*make_kernel<Square>()); }
TEST_CASE("kernel contract: expm1_square", "[contract]") { check_kernel_contract(*make_kernel<Expm1Square>()); }
TEST_CASE("kernel contract: exp", "[contract]") { check_kernel_contract(*make_kernel<Exp>()); }
TEST_CASE("kernel contract: expm1", "[contract]") { check_kernel_contract(*make_kernel<Expm1>()); }
TEST_CASE("kernel contract: exp_square", "[contract]") { check_kernel_contract(*make_kernel<ExpSquare>()); }

}  // namespace leastcost::test
