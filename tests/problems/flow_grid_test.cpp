// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <cmath>
#include <fstream>
#include <functional>
#include <string>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/cost/segment_cost.hpp>
#include <leastcost/problems/costs/zermelo.hpp>
#include "problems/costs/flow_grid.hpp"
#include "problems/readers/flow_reader.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/data.hpp"
#include "tests/support/random.hpp"

namespace leastcost::test {
namespace {

using Field2 = std::function<Eigen::Vector2d(double, double)>;

/// Rows of a grid over [-1, 1] x [0, 3].
Eigen::MatrixXd rows_of(const Field2& field, int columns, int lines) {
  Eigen::MatrixXd rows(columns * lines, 4);
  for (int j = 0; j < lines; ++j)
    for (int i = 0; i < columns; ++i) {
      const double x = -1 + 2.0 * i / (columns - 1), y = 3.0 * j / (lines - 1);
      rows.row(j * columns + i) << x, y, field(x, y).transpose();
    }
  return rows;
}

Eigen::Vector2d at(const FlowGrid<2>& grid, double x, double y) {
  return grid(Point<double, 2>(Eigen::Vector2d(x, y)));
}

double worst(const FlowGrid<2>& grid, const Field2& field) {
  Random random;
  double most = 0;
  for (int k = 0; k < 2000; ++k) {
    const double x = random.uniform(-1, 1), y = random.uniform(0, 3);
    most = std::max(most, (at(grid, x, y) - field(x, y)).norm());
  }
  return most;
}

Eigen::Vector2d quadratic(double x, double y) {
  return {1 + 2 * x - y + 0.5 * x * x - x * y + 0.2 * y * y, -3 + x * x * y * y};
}
Eigen::Vector2d eddy(double x, double y) { return {std::sin(2 * y) * std::cos(x), std::cos(2 * x + y)}; }

std::string refused_flow(const std::string& text, int dimension = 2) {
  const ScratchDir folder;
  std::ofstream(folder / "flow.csv") << text;
  try {
    const Eigen::MatrixXd rows = read_flow(folder / "flow.csv", dimension);
    if (dimension == 2) flow_grid<2>(rows, "flow.csv");
  } catch (const InputError& error) {
    const std::string what = error.what();
    return what.substr(what.find("flow.csv"));
  }
  return "";
}

}  // namespace

TEST_CASE("flow grid: exact for parabolas, of third order for others") {
  CHECK(worst(flow_grid<2>(rows_of(quadratic, 5, 4), ""), quadratic) < 1e-13);
  CHECK(worst(flow_grid<2>(rows_of(quadratic, 3, 3), ""), quadratic) < 1e-13);
  const double coarse = worst(flow_grid<2>(rows_of(eddy, 21, 31), ""), eddy);
  const double fine = worst(flow_grid<2>(rows_of(eddy, 41, 61), ""), eddy);
  CHECK(coarse < 1e-3);
  CHECK(std::log2(coarse / fine) > 2.7);
}

TEST_CASE("flow grid: two derivatives go over from cell to cell") {
  const FlowGrid<2> grid = flow_grid<2>(rows_of(eddy, 9, 9), "");
  using D2 = Dual<Dual<double, 1>, 1>;
  for (const double x : {-0.75, -0.5, 0.0, 0.5, 0.75}) {  // nodes
    std::array<std::array<double, 3>, 2> sides{};
    for (const int side : {0, 1}) {
      D2 s(x + (side == 0 ? -1e-12 : 1e-12));
      s.value.d[0] = 1;
      s.d[0].value = 1;
      const Point<D2, 2> w = grid(Point<D2, 2>(s, D2(1.3)));
      sides[static_cast<std::size_t>(side)] = {w[0].value.value, w[0].d[0].value, w[0].d[0].d[0]};
    }
    for (std::size_t order = 0; order < 3; ++order) CHECK(sides[0][order] == Approx(sides[1][order]).margin(1e-9));
  }
}

TEST_CASE("flow grid: gaps and the outside have no value") {
  Eigen::MatrixXd rows = rows_of(eddy, 9, 7);
  rows.row(3 * 9 + 4).tail(2).setConstant(std::numeric_limits<double>::quiet_NaN());  // the node (0, 1.5)
  const FlowGrid<2> grid = flow_grid<2>(rows, "");
  CHECK(std::isnan(at(grid, 0.1, 1.4)[0]));
  CHECK(std::isnan(at(grid, 0.4, 0.6)[0]));  // the node counts two cells away
  CHECK(std::isfinite(at(grid, 0.6, 1.5)[0]));
  CHECK(std::isfinite(at(grid, 1, 3)[0]));
  CHECK(std::isnan(at(grid, 1.01, 1)[0]));
  CHECK_FALSE(grid.contains(Point<double, 2>(Eigen::Vector2d(0, -0.1))));
}

TEST_CASE("flow grid: in space") {
  Eigen::MatrixXd rows(60, 6);
  Eigen::Index row = 0;
  for (int k = 0; k < 3; ++k)
    for (int i = 0; i < 5; ++i)
      for (int j = 0; j < 4; ++j) {
        const Eigen::Vector3d p(0.5 * i, 2 * j, 10 - k);
        rows.row(row++) << p.transpose(), p[0] * p[1], p[2] * p[2] - p[0], p[1] * p[2] + p[0] * p[0];
      }
  const FlowGrid<3> grid = flow_grid<3>(rows, "");
  const Eigen::Vector3d p(1.234, 4.321, 8.765);
  const Eigen::Vector3d w = grid(Point<double, 3>(p));
  CHECK((w - Eigen::Vector3d(p[0] * p[1], p[2] * p[2] - p[0], p[1] * p[2] + p[0] * p[0])).norm() < 1e-12);
}

TEST_CASE("flow grid: nodes in memory make the cost that a file of them makes") {
  const ScratchDir folder;
  {
    std::ofstream out(folder / "flow.csv");
    for (int k = 0; k < 12; ++k) out << k % 4 << ' ' << k / 4 << ' ' << 0.1 * k << ' ' << -0.02 * k * k << '\n';
  }
  const Eigen::MatrixXd nodes = read_flow(folder / "flow.csv", 2);
  const auto of_file = make_zermelo_cost({.speed = "3", .flow = flow::Grid{"flow.csv"}}, 2, folder.path());
  const auto in_memory = make_zermelo_cost({.speed = "3"}, nodes, 2);
  const Eigen::Vector2d a(0.3, 0.4), b(2.5, 1.7);
  CHECK(move_cost(*in_memory, a, b) == move_cost(*of_file, a, b));
  CHECK(move_cost(*in_memory, a, b) != move_cost(*in_memory, b, a));
  CHECK(std::isinf(move_cost(*in_memory, a, Eigen::Vector2d(3.5, 1))));
  CHECK_THROWS_AS(make_zermelo_cost({.speed = "3"}, nodes, 3), InputError);
  CHECK_THROWS_AS(make_zermelo_cost({.speed = "-3"}, nodes, 2), OptionError);
}

TEST_CASE("flow files: what they may say") {
  const ScratchDir folder;
  std::ofstream(folder / "flow.txt") << "# a current\nv; day; x; y; u\r\n 1;9;0;0; nan\n-2;9;1;0;  # land\n3;9;2;0;5\n";
  const Eigen::MatrixXd rows = read_flow(folder / "flow.txt", 2);
  REQUIRE(rows.rows() == 3);
  CHECK(rows.leftCols(2) == (Eigen::MatrixXd(3, 2) << 0, 0, 1, 0, 2, 0).finished());
  CHECK(std::isnan(rows(0, 2)));
  CHECK(std::isnan(rows(1, 2)));
  CHECK(rows.col(3) == Eigen::Vector3d(1, -2, 3));
  std::ofstream(folder / "blanks.txt") << "0 1 2 3\n 4 5\t6 7 8\n";
  CHECK(read_flow(folder / "blanks.txt", 2).row(1) == Eigen::RowVector4d(4, 5, 6, 7));
}

TEST_CASE("flow files: what is wrong is named, with its place") {
  CHECK(refused_flow("") == "flow.csv: has no rows");
  CHECK(refused_flow("x,y,u\n0,0,1\n").find("flow.csv:1: the columns of a flow are x, y, u, v; there is no 'v'") == 0);
  CHECK(refused_flow("0,0,1\n").find("flow.csv:1: has 3 columns; 'v' is number 4") == 0);
  CHECK(refused_flow("0,0,1,1\n0,1,fast,1\n").find("flow.csv:2: 'fast' stands where the number u should be") == 0);
  CHECK(refused_flow("0,0,1,1\n,1,1,1\n").find("flow.csv:2: nothing stands where the number x should be") == 0);
  CHECK(refused_flow("0,0,1,1\n0,1,inf,1\n").find("flow.csv:2: ") == 0);
  const std::string two = "0,0,1,1\n1,0,1,1\n0,1,1,1\n1,1,1,1\n";
  CHECK(refused_flow(two).find("the grid has 2 nodes, but needs at least 3 along x") != std::string::npos);
  std::string nine, uneven;
  for (const int y : {0, 1, 2})
    for (const int x : {0, 1, 2}) {
      nine += std::to_string(x) + "," + std::to_string(y) + ",1,1\n";
      uneven += std::to_string(x * x) + "," + std::to_string(y) + ",1,1\n";
    }
  CHECK(refused_flow(nine) == "");
  CHECK(refused_flow(uneven).find("equal steps") != std::string::npos);
  CHECK(refused_flow(nine + "1,1,1,1\n").find("9 nodes must have one row per node; the number of rows is 10") !=
        std::string::npos);
  CHECK(refused_flow(nine.substr(0, nine.rfind("2,2")) + "1,1,1,1\n").find("given twice") != std::string::npos);
}

}  // namespace leastcost::test
