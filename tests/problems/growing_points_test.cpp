// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "problems/initializers/growing_points.hpp"

#include "tests/support/catch.hpp"
#include "tests/support/random.hpp"

namespace leastcost::test {

TEST_CASE("growing points: the nearest one, as by looking at all, at every size and in every order") {
  Random random;
  const int d = GENERATE(1, 2, 3, 7);
  const bool on_a_line = GENERATE(false, true);  // in order, the worst case for a tree that grows by insertion
  GrowingPoints points(d);
  Eigen::MatrixXd all(d, 200);
  for (int i = 0; i < all.cols(); ++i) {
    all.col(i) = on_a_line ? Eigen::VectorXd(Eigen::VectorXd::Constant(d, i)) : random.vector(d);
    if (i % 7 == 3) all.col(i) = all.col(i - 1);  // and twice the same
    CHECK(points.add(all.col(i)) == i);
    const Eigen::VectorXd x = (on_a_line ? 50 : 1) * random.vector(d);
    const double least = (all.leftCols(i + 1).colwise() - x).colwise().norm().minCoeff();
    CHECK((points[points.nearest(x)] - x).norm() == Approx(least).epsilon(1e-14));
  }
  CHECK(points.size() == 200);
}

}  // namespace leastcost::test
