// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <Eigen/Dense>
#include <Eigen/Geometry>
#include <cmath>
#include <functional>
#include <memory>
#include <random>

#include <leastcost/framework/search/find_path.hpp>
#include <leastcost/problems/costs/end_effector_length.hpp>
#include <leastcost/problems/costs/kinetic_energy.hpp>
#include <leastcost/problems/initializers/straight.hpp>
#include <leastcost/problems/kernels/kernels.hpp>
#include <leastcost/problems/manifolds/euclidean.hpp>
#include <leastcost/solvers/newton.hpp>
#include "tests/support/catch.hpp"

namespace leastcost {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Angles = Eigen::VectorXd;

/// Two bars, closed form (any textbook): lengths, distances of the centres from the joints, masses, inertias.
struct TwoBars {
  double l1 = 1, c1 = 0.5, c2 = 0.4, m1 = 4, m2 = 2, i1 = 0.34, i2 = 0.11;

  Matrix2d mass(double elbow) const {
    const double coupled = m2 * l1 * c2 * std::cos(elbow), second = m2 * c2 * c2 + i2;
    Matrix2d m;
    m << m1 * c1 * c1 + i1 + m2 * l1 * l1 + second + 2 * coupled, second + coupled, second + coupled, second;
    return m;
  }
  /// M q'' = h s (2 q1' q2' + q2'^2, -q1'^2), h = m2 l1 c2, s = sin q2: no gravity.
  Vector2d acceleration(const Vector2d& q, const Vector2d& v) const {
    const double h = m2 * l1 * c2 * std::sin(q[1]);
    return mass(q[1]).inverse() * Vector2d(h * (2 * v[0] * v[1] + v[1] * v[1]), -h * v[0] * v[0]);
  }
  /// Where it is after a time of 1 (Runge and Kutta).
  Vector2d flown(Vector2d q, Vector2d v) const {
    constexpr int kSteps = 2000;
    constexpr double h = 1.0 / kSteps;
    for (int k = 0; k < kSteps; ++k) {
      const Vector2d a1 = acceleration(q, v), v2 = v + h / 2 * a1, a2 = acceleration(q + h / 2 * v, v2);
      const Vector2d v3 = v + h / 2 * a2, a3 = acceleration(q + h / 2 * v2, v3);
      const Vector2d v4 = v + h * a3, a4 = acceleration(q + h * v3, v4);
      q += h / 6 * (v + 2 * v2 + 2 * v3 + v4);
      v += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
    }
    return q;
  }
  /// The length of the geodesic from a to b: its speed at the start, which shooting finds.
  double length(const Vector2d& a, const Vector2d& b) const {
    Vector2d v = b - a;
    for (int k = 0; k < 30; ++k) {
      const Vector2d off = flown(a, v) - b;
      if (off.norm() < 1e-13) break;
      Matrix2d j;
      constexpr double kStep = 1e-6;
      for (int i = 0; i < 2; ++i)
        j.col(i) = (flown(a, v + kStep * Vector2d::Unit(i)) - flown(a, v - kStep * Vector2d::Unit(i))) / (2 * kStep);
      v -= j.inverse() * off;
    }
    REQUIRE((flown(a, v) - b).norm() < 1e-11);
    return std::sqrt(v.dot(mass(a[1]) * v));
  }
};

arm_inertia::Table table_of(const TwoBars& bars) {
  arm_inertia::Table table;
  table.rows = Eigen::MatrixXd::Zero(2, 4);
  table.rows(0, 0) = bars.l1;
  table.rows(1, 0) = 0.8;
  table.links = Eigen::MatrixXd::Zero(2, 10);
  table.links(0, 0) = bars.m1;
  table.links(0, 1) = bars.c1 - bars.l1;
  table.links(0, 6) = bars.i1;
  table.links(1, 0) = bars.m2;
  table.links(1, 1) = bars.c2 - 0.8;
  table.links(1, 6) = bars.i2;
  return table;
}

Result solved(std::shared_ptr<const SegmentCost> cost, const Angles& a, const Angles& b, int points) {
  Problem problem;
  problem.manifold = std::make_shared<EuclideanManifold>(EuclideanManifoldOptions{.dimension = cost->dim()});
  problem.cost = std::move(cost);
  problem.kernel = make_kernel<Expm1Square>();
  problem.source = {a};
  problem.target = {b};
  return find_path(problem, StraightInitializer(), Newton(), {.points = points});
}

double squared(const SegmentCost& cost, const Angles& a, const Angles& b) {
  Points x(a.size(), 2);
  x << a, b;
  double q = 0;
  cost.squared_costs({{x.data(), x.rows(), 2}, {}, false}, {&q, 1});
  return q;
}

/// Frames of a table by products of transforms; modified is Craig's.
Eigen::Affine3d own_frame(const Eigen::MatrixXd& rows, bool modified, const Angles& q, Index link) {
  using Eigen::AngleAxisd, Eigen::Translation3d;
  Eigen::Affine3d frame = Eigen::Affine3d::Identity();
  for (Index j = 0; j <= link; ++j) {
    const Translation3d along_x(rows(j, 0), 0, 0), along_z(0, 0, rows(j, 2));
    const AngleAxisd about_x(rows(j, 1), Vector3d::UnitX()), about_z(q[j] + rows(j, 3), Vector3d::UnitZ());
    frame = modified ? frame * about_x * along_x * about_z * along_z : frame * about_z * along_z * along_x * about_x;
  }
  return frame;
}

/// Twice the kinetic energy, from differences of where eight points of each link are: masses at the corners of a box
/// around its centre that have its mass and its moments.
double own_energy(const arm_inertia::Table& table, const Angles& q, const Angles& rates) {
  constexpr double kStep = 1e-4;
  double sum = 0;
  for (Index i = 0; i < table.rows.rows(); ++i) {
    const auto row = table.links.row(i);
    const bool modified = table.convention == DhConvention::modified;
    const auto velocity = [&](const Vector3d& local) -> Vector3d {
      const auto at = [&](double t) -> Vector3d { return own_frame(table.rows, modified, q + t * rates, i) * local; };
      return (8 * (at(kStep) - at(-kStep)) - (at(2 * kStep) - at(-2 * kStep))) / (12 * kStep);
    };
    const Vector3d center = row.segment<3>(1);
    Eigen::Matrix3d inertia;
    inertia << row[4], row[7], row[8], row[7], row[5], row[9], row[8], row[9], row[6];
    // Second moments of mass, S = tr(I) / 2 - I, along their own axes: two points each.
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(Eigen::Matrix3d::Identity() * inertia.trace() / 2 -
                                                              inertia);
    sum += row[0] * velocity(center).squaredNorm();
    const Vector3d drift = velocity(center);
    for (int k = 0; k < 3; ++k)  // a second moment may be negative: only sums of two are moments of inertia
      sum += axes.eigenvalues()[k] * (velocity(center + axes.eigenvectors().col(k)) - drift).squaredNorm();
  }
  return sum;
}

}  // namespace

TEST_CASE("kinetic energy: two bars in closed form") {
  const TwoBars bars;
  const auto cost = make_kinetic_energy_cost({.model = table_of(bars)}, 2);
  std::mt19937 engine(20261203);
  std::uniform_real_distribution<double> angle(-3, 3);
  for (int k = 0; k < 50; ++k) {
    const Vector2d middle(angle(engine), angle(engine)), way(angle(engine) / 10, angle(engine) / 10);
    CHECK(squared(*cost, middle - way / 2, middle + way / 2) ==
          Approx(way.dot(bars.mass(middle[1]) * way)).epsilon(1e-13));
  }
}

TEST_CASE("kinetic energy: geodesics of the mass matrix are where shooting finds them, within the bar") {
  const TwoBars bars;
  const auto cost = make_kinetic_energy_cost({.model = table_of(bars)}, 2);
  for (const auto& [a, b] :
       {std::pair{Vector2d(0, 0.5), Vector2d(1.5, 2.4)}, std::pair{Vector2d(-0.4, -1), Vector2d(0.7, 1.3)},
        std::pair{Vector2d(0.2, 2.5), Vector2d(-1, 0.3)}}) {
    const Result result = solved(cost, a, b, 40);
    CHECK(result.status == Status::certified);
    const double length = bars.length(a, b);
    CAPTURE(length, result.certificate.estimate.value, result.certificate.estimate.error);
    CHECK(std::abs(result.certificate.estimate.value - length) <= result.certificate.estimate.error + 1e-10 * length);
    CHECK(result.certificate.estimate.error < 1e-4 * length);
  }
}

TEST_CASE("kinetic energy: of any table it is that of masses that move with it") {
  std::mt19937 engine(20261204);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (const DhConvention convention : {DhConvention::standard, DhConvention::modified}) {
    arm_inertia::Table table;
    table.convention = convention;
    table.rows = Eigen::MatrixXd::NullaryExpr(5, 4, [&] { return unit(engine); });
    table.links = Eigen::MatrixXd::NullaryExpr(5, 10, [&] { return 0.1 * unit(engine); });
    table.links.col(0).array() += 2;
    table.links.middleCols(4, 3).array() += 0.7;
    const auto cost = make_kinetic_energy_cost({.model = table}, 5);
    for (int k = 0; k < 20; ++k) {
      const Angles q = Angles::NullaryExpr(5, [&] { return 2 * unit(engine); });
      const Angles rates = Angles::NullaryExpr(5, [&] { return unit(engine); });
      CHECK(squared(*cost, q - rates / 2, q + rates / 2) == Approx(own_energy(table, q, rates)).epsilon(1e-8));
    }
  }
}

TEST_CASE("kinetic energy: the arms by name are not lighter than what they carry") {
  // Turning joint 1 alone moves every link about a vertical axis: at most its mass times the square of its reach.
  const auto panda = make_kinetic_energy_cost({}, 7);
  const auto ur5 = make_kinetic_energy_cost({.model = arm_inertia::Ur5{}}, 6);
  const auto about_base = [](const SegmentCost& cost, const Angles& q) {
    const Angles way = Angles::Unit(q.size(), 0);
    return squared(cost, q - way / 2, q + way / 2);
  };
  // Stretched out horizontally the UR5 has 8.393 kg at 0.2125, 2.33 at 0.575, 2.4 at about 0.8 m and more.
  CHECK(about_base(*ur5, Angles::Zero(6)) > 8.393 * 0.2125 * 0.2125 + 2.33 * 0.575 * 0.575 + 2.4 * 0.8 * 0.8);
  CHECK(about_base(*ur5, Angles::Zero(6)) < 17 * 0.9);
  Angles up = Angles::Zero(6);
  up[1] = -1.5707963267948966;
  CHECK(about_base(*ur5, up) < 0.5 * about_base(*ur5, Angles::Zero(6)));
  CHECK(about_base(*panda, Angles::Zero(7)) < 16 * 0.3);
  Angles folded = Angles::Zero(7);
  folded[1] = 1.5;
  CHECK(about_base(*panda, folded) > about_base(*panda, Angles::Zero(7)));
}

TEST_CASE("end effector length: it is that of the tool and the joints") {
  arm_joints::Table table;
  table.rows = Eigen::MatrixXd::Zero(2, 4);
  table.rows(0, 0) = 1;
  table.rows(1, 0) = 0.8;
  const double w = 0.1;
  const auto cost = make_end_effector_length({.model = table, .tool = Vector3d(0.2, 0, 0), .joint_weight = w}, 2);
  const auto tool = [](const Vector2d& q) {
    return Vector2d(std::cos(q[0]) + std::cos(q[0] + q[1]), std::sin(q[0]) + std::sin(q[0] + q[1]));
  };
  std::mt19937 engine(20261205);
  std::uniform_real_distribution<double> angle(-3, 3);
  for (int k = 0; k < 50; ++k) {
    const Vector2d a(angle(engine), angle(engine)), b(angle(engine), angle(engine));
    CHECK(squared(*cost, a, b) ==
          Approx((tool(b) - tool(a)).squaredNorm() + w * w * (b - a).squaredNorm()).epsilon(1e-13));
  }
  // The less joints count, the nearer the tool's way comes to a straight line; never below it.
  const Vector2d a(0.2, 1.2), b(1.4, 1.6);
  const double straight = (tool(b) - tool(a)).norm();
  double before = 2 * straight;
  for (const double weight : {0.3, 0.1, 0.03}) {
    const Result result = solved(
        make_end_effector_length({.model = table, .tool = Vector3d(0.2, 0, 0), .joint_weight = weight}, 2), a, b, 60);
    CHECK(result.status == Status::certified);
    double way = 0;
    for (Index i = 0; i + 1 < result.curve.x.cols(); ++i)
      way += (tool(result.curve.x.col(i + 1)) - tool(result.curve.x.col(i))).norm();
    CHECK(way >= straight * (1 - 1e-12));
    CHECK(way <= before);
    before = way;
  }
  CHECK(before < 1.02 * straight);
}

}  // namespace leastcost
