// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "framework/newton/chain_program.hpp"

#include <chrono>

#include <leastcost/framework/base/errors.hpp>
#include "tests/support/catch.hpp"
#include "tests/support/random.hpp"

namespace leastcost {

using Eigen::VectorXd;

TEST_CASE("chain programs: the least within half-spaces that couple neighbours, none beside it is less") {
  test::Random random(3);
  for (int k = 0; k < 20; ++k) {
    const int d = 1 + k % 7;
    constexpr Index kBlocks = 6;
    ChainSystem h;
    h.resize(d, kBlocks, false);
    h.set_zero();
    for (Index i = 0; i < kBlocks; ++i) {
      h.diagonal(i).diagonal().setConstant(2.1);
      if (i + 1 < kBlocks) h.coupling(i).diagonal().setConstant(-1);
    }
    const auto vector = [&](Index size, double range) {
      return VectorXd(VectorXd::NullaryExpr(size, [&] { return random.uniform(-range, range); }));
    };
    const VectorXd force = vector(d * kBlocks, 1);
    ChainHalfSpaces rows(d);
    for (Index i = 0; i < 12; ++i) {
      if (i % 2 == 0)
        rows.add(i % kBlocks, vector(d, 1), -random.uniform(0, 0.1));
      else
        rows.add(i % (kBlocks - 1), vector(d, 1), vector(d, 1), -random.uniform(0, 0.1));
    }
    const auto z = least_of_chain(h, force, rows, VectorXd::Zero(d * kBlocks));
    REQUIRE(z);
    const auto value = [&](const VectorXd& at) {
      VectorXd product;
      h.multiply(at, product);
      return at.dot(product) / 2 - force.dot(at);
    };
    const auto within = [&](const VectorXd& at, double slack) {
      for (Index r = 0; r < rows.count(); ++r) {
        const Index b = rows.first_block(r);
        double sum = Eigen::Map<const VectorXd>(rows.normal(r), d).dot(at.segment(d * b, d));
        if (rows.couples(r)) sum += Eigen::Map<const VectorXd>(rows.normal(r) + d, d).dot(at.segment(d * (b + 1), d));
        if (sum < rows.offset(r) - slack) return false;
      }
      return true;
    };
    CAPTURE(k, d);
    REQUIRE(within(*z, 1e-11));
    for (int j = 0; j < 500; ++j) {
      const VectorXd beside = *z + vector(d * kBlocks, 0.02);
      if (within(beside, 0)) CHECK(value(beside) > value(*z) - 1e-10);
    }
  }
  ChainHalfSpaces wrong(3);
  ChainSystem h;
  h.resize(2, 2, false);
  CHECK_THROWS_AS(least_of_chain(h, VectorXd::Zero(4), wrong, VectorXd::Zero(4)), InputError);
  CHECK_THROWS_AS(wrong.add(0, VectorXd::Zero(2), 0), InputError);
  ChainHalfSpaces beyond(2);
  beyond.add(1, VectorXd::Ones(2), VectorXd::Ones(2), 0);
  CHECK_THROWS_AS(least_of_chain(h, VectorXd::Zero(4), beyond, VectorXd::Zero(4)), InputError);
}

TEST_CASE("chain programs: end with the deadline") {
  ChainSystem h;
  h.resize(2, 3, false);
  h.set_zero();
  for (Index i = 0; i < 3; ++i) h.diagonal(i).setIdentity();
  const ChainHalfSpaces none(2);
  const VectorXd force = VectorXd::Ones(6);
  CHECK(least_of_chain(h, force, none, VectorXd::Zero(6)).value().isApprox(force));
  const Deadline past = std::chrono::steady_clock::now() - std::chrono::seconds(1);
  CHECK_THROWS_AS(least_of_chain(h, force, none, VectorXd::Zero(6), past), Interrupted);
}

}  // namespace leastcost
