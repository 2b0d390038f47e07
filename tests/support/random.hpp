// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <cstdlib>
#include <random>
#include <string>
#include <utility>

#include "tests/support/catch.hpp"

namespace leastcost::test {

/// Random numbers of one test case. The seed is printed with every failure; LEASTCOST_TEST_SEED sets another one.
class Random {
 public:
  Random() : Random(chosen_seed()) {}
  explicit Random(std::uint64_t seed)
      : engine_(seed),
        message_(std::move(Catch::MessageBuilder("INFO", CATCH_INTERNAL_LINEINFO, Catch::ResultWas::Info)
                           << "LEASTCOST_TEST_SEED=" << seed)) {}

  double normal() { return normal_(engine_); }
  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine_); }
  int integer(int low, int high) { return std::uniform_int_distribution<int>(low, high)(engine_); }
  Eigen::VectorXd vector(Eigen::Index size) {
    return Eigen::VectorXd::NullaryExpr(size, [this] { return normal(); });
  }
  Eigen::MatrixXd matrix(Eigen::Index rows, Eigen::Index columns) {
    return Eigen::MatrixXd::NullaryExpr(rows, columns, [this] { return normal(); });
  }
  std::mt19937_64& engine() { return engine_; }

 private:
  static std::uint64_t chosen_seed() {
    const char* seed = std::getenv("LEASTCOST_TEST_SEED");  // NOLINT(concurrency-mt-unsafe)
    return seed == nullptr ? 20260101u : std::stoull(seed);
  }

  std::mt19937_64 engine_;
  std::normal_distribution<double> normal_;
  Catch::ScopedMessage message_;
};

}  // namespace leastcost::test
