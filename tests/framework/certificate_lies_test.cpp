// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
// The certificate against lies: doctored chains are handed to certify() directly, and each is refused for its own
// reason. Chains that are right, made by a formula and not by a solver, pass.
#include <numbers>

#include <leastcost/framework/certificate/certify.hpp>
#include <leastcost/framework/cost/segment_cost_function.hpp>
#include <leastcost/problems/costs/metric_field.hpp>
#include <leastcost/problems/initializers/dijkstra.hpp>
#include <leastcost/problems/manifolds/data/mesh.hpp>
#include <leastcost/problems/post_processors/straighten.hpp>
#include <leastcost/problems/post_processors/trace.hpp>
#include <leastcost/problems/straighten/straighten.hpp>
#include "framework/certificate/certify_straightened.hpp"
#include "problems/mesh/mesh_curve.hpp"
#include "tests/problems/sample_meshes.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/compose.hpp"
#include "tests/support/pi.hpp"
#include "tests/support/sample_domains.hpp"
#include "tests/support/trench.hpp"

namespace leastcost::test {
namespace {

struct Weighted {  // 1 + 2 exp(-r^2): a hill at the origin
  static constexpr int dim = 2;
  CostTraits traits() const { return {}; }
  template <class S>
  S value(const Point<S, 2>& a, const Point<S, 2>& b) const {
    using std::exp;
    const S weight = S(1.0) + 2 * exp(S(-((a + b) * S(0.5)).squaredNorm()));
    return (b - a).squaredNorm() * weight * weight;
  }
};

/// n + 1 points x(t), t from 0 to 1; a ring leaves out the last.
template <class Curve>
CoordinatePath chain(int d, int n, bool ring, Curve curve) {
  CoordinatePath path{Points(d, ring ? n : n + 1), {}, ring};
  for (Index i = 0; i < path.u.cols(); ++i) path.u.col(i) = curve(static_cast<double>(i) / n);
  return path;
}

/// The problem whose ends a chain has.
Problem between_ends(std::shared_ptr<const ConstraintManifold> manifold, std::shared_ptr<const SegmentCost> cost,
                     const CoordinatePath& path, std::shared_ptr<const Kernel> kernel = make_kernel<Expm1Square>()) {
  if (path.ring) return closed(std::move(manifold), std::move(cost), std::move(kernel));
  return between(std::move(manifold), std::move(cost), path.u.col(0), path.u.rightCols(1), std::move(kernel));
}

CoordinatePath great_circle(double angle, int n, bool ring = false) {
  return chain(3, n, ring, [&](double t) -> Eigen::VectorXd {
    return Eigen::Vector3d(std::cos(angle * t), std::sin(angle * t), 0);
  });
}
Certificate certify_on_sphere(const CoordinatePath& path) {
  return certify_chain(between_ends(std::make_shared<Sphere>(), make_euclidean_cost(3), path), path);
}

}  // namespace

TEST_CASE("a path of which a proof knows that a far shorter one may exist is not certified", "[framework]") {
  const auto line = chain(2, 3, false, [](double t) { return Eigen::VectorXd::Constant(2, 3 * t); });
  const Problem problem = between_ends(space(2), make_euclidean_cost(2), line);
  PostProcessed path;
  path.curve.x = line.u;
  path.curve.cost = 3 * std::sqrt(2.0);
  path.curve.straightness = 0;
  GlobalBound& global = path.curve.global.emplace();
  global.reason = "a shorter path could cross a degenerate face";
  global.lower_bound = 2;
  global.gap = 1 - 2 / path.curve.cost;
  for (const ProofOutcome outcome : {ProofOutcome::blocked, ProofOutcome::bounded}) {
    global.outcome = outcome;
    Certificate c;
    certify_straightened(problem, path, {}, c);
    CHECK(failed(c, "global") == (outcome == ProofOutcome::blocked));
    if (outcome == ProofOutcome::blocked)
      CHECK_THAT(failures(c), Catch::Contains("a path of cost 2 may exist") && Catch::Contains(global.reason));
  }
  global.outcome = ProofOutcome::blocked;
  global.gap = 1e-6;  // what is left open is little
  Certificate c;
  certify_straightened(problem, path, {}, c);
  CHECK_FALSE(failed(c, "global"));
}

TEST_CASE("right chains pass: by formula", "[framework]") {
  const int n = GENERATE(8, 13, 32);
  const auto line = chain(7, n, false, [](double t) { return Eigen::VectorXd::LinSpaced(7, 1, 3) * t; });
  const auto waist = chain(3, n, true, [](double t) { return Torus::at(2 * kPi * t, kPi); });
  const Certificate certificates[] = {
      certify_chain(between_ends(space(7), make_euclidean_cost(7), line), line),
      certify_on_sphere(great_circle(2.5, n)),
      certify_chain(between_ends(std::make_shared<Torus>(), make_euclidean_cost(3), waist), waist)};
  for (const Certificate& c : certificates) {
    CAPTURE(n, failures(c));
    CHECK(c.certified());
    CHECK(c.scope == Scope::local);
  }
}

TEST_CASE("lie: a bar beside a path that is not stationary", "[framework]") {
  CoordinatePath bent = great_circle(2, 32);
  bent.u.col(10) = (bent.u.col(10) + Eigen::Vector3d(0, 0, 0.02)).normalized();
  const Certificate c = certify_on_sphere(bent);
  CHECK(failed(c, "stationarity"));
  CHECK(std::isnan(c.estimate.error));
  CHECK_FALSE((c.estimate.lower || c.estimate.upper));
  double chords = 0;
  for (Index i = 0; i + 1 < bent.u.cols(); ++i) chords += (bent.u.col(i + 1) - bent.u.col(i)).norm();
  CHECK(c.estimate.value == Approx(chords).epsilon(1e-12));
}

TEST_CASE("lie: a saddle", "[framework]") {
  const Certificate arc = certify_on_sphere(great_circle(1.5 * kPi, 48));
  CAPTURE(failures(arc));
  CHECK(failed(arc, "saddle"));
  CHECK_FALSE(failed(arc, "stationarity"));  // it is a geodesic; its only fault is that it is not a minimum
  const Problem hill = between(space(2), make_segment_cost(Weighted{}), Eigen::Vector2d(-2, 0), Eigen::Vector2d(2, 0));
  const Result over = find(hill, 31);
  CHECK(failed(certify_chain(hill, over.path), "saddle"));
}

TEST_CASE("lie: a degenerate path", "[framework]") {
  const Certificate half = certify_on_sphere(great_circle(kPi, 32));
  CAPTURE(failures(half));
  CHECK(failed(half, "degenerate"));
}

TEST_CASE("lie: a collapsed ring", "[framework]") {
  const double radius = GENERATE(0.0, 1e-12, 1e-3, 1.0);  // the last has not collapsed yet, but would
  const auto ring = chain(2, 16, true, [&](double t) -> Eigen::VectorXd {
    return radius * Eigen::Vector2d(std::cos(2 * kPi * t), std::sin(2 * kPi * t));
  });
  const Certificate c = certify_chain(between_ends(space(2), make_euclidean_cost(2), ring), ring);
  CAPTURE(radius, failures(c));
  CHECK(failed(c, "collapsed"));
}

TEST_CASE("lie: a sinkhole path across a narrow trench", "[framework]") {
  const auto solved = [](const Problem& problem, CoordinatePath path) {
    const double s0 = PathEnergy(problem, 1).cost(path) / static_cast<double>(path.segment_count());
    PathEnergy energy(problem, s0);
    const SolveReport report = Newton({.max_iterations = 2000}).solve(energy, path, {});
    CHECK(report.termination == Termination::converged);  // it is a minimum of the chain, and no path
    return certify_chain(problem, path, s0);
  };
  const Trench gentle(2, 0.5), steep(4, 0.4);
  const Certificate right = solved(gentle.problem(), gentle.through(511));
  CAPTURE(failures(right), right.longest_segment);
  CHECK(right.certified());
  for (const int n : {31, 63, 127}) {
    const Certificate c = solved(steep.problem(make_kernel<Square>()), steep.jumping(n));
    CAPTURE(n, c.longest_segment, failures(c));
    CHECK(failed(c, "longest_segment"));
  }
}

TEST_CASE("lie: a badly spaced path", "[framework]") {
  const auto line = chain(2, 20, false, [](double t) { return Eigen::Vector2d(3 * t * t, 4 * t * t); });
  const Certificate c = certify_chain(between_ends(space(2), make_euclidean_cost(2), line), line);
  CAPTURE(failures(c));
  CHECK(failed(c, "spacing"));
  const Problem rest = bead(Eigen::Vector2d(0, 0), Eigen::Vector2d(2, -1));
  Result result = find(rest, 30);
  result.path.u.col(7) = result.path.u.col(6) + 1e-3 * (result.path.u.col(7) - result.path.u.col(6));
  CHECK(failed(certify_chain(rest, result.path), "spacing"));
}

TEST_CASE("lie: unequal times of an additive cost, though the total is right to 1e-11", "[framework]") {
  const Problem rest = bead(Eigen::Vector2d(0, 0), Eigen::Vector2d(2, -1));
  Result result = find(rest, 30);
  const double before = result.costs.sum();
  result.path.u.col(12) += 3e-6 * (result.path.u.col(13) - result.path.u.col(12));
  const Certificate c = certify_chain(rest, result.path);
  CAPTURE(failures(c), c.spacing);
  CHECK(PathEnergy(rest, 1).cost(result.path) == Approx(before).epsilon(1e-9));
  CHECK(failed(c, "spacing"));
  CHECK_FALSE(failed(c, "stationarity"));
}

TEST_CASE("lie: segments that cost nothing where a bound is hugged", "[framework]") {
  // The soap film between two rings that are too far apart: down to y = 0, along it for nothing, and up again.
  MetricFieldOptions options;
  options.field = metric::Formula{{"y^2", "0", "y^2"}};
  const int n = GENERATE(15, 31, 63);
  const double height = GENERATE(1, 2);
  const Result result =
      find(between(box(Eigen::Vector2d(-5, 0), Eigen::Vector2d(5, 5)), make_metric_field_cost(options, 2),
                   Eigen::Vector2d(-0.67 * height, height), Eigen::Vector2d(0.67 * height, height)),
           n);
  CAPTURE(n, height, failures(result.certificate), result.certificate.spacing);
  CHECK(result.certificate.spacing > 1);
  CHECK(failed(result.certificate, "spacing"));
}

TEST_CASE("lie: a bar below the rounding of an ill-conditioned tensor", "[framework]") {
  MetricFieldOptions options;
  options.field = metric::Formula{{"30161626.53531196", "-36296095.80716718", "43678236.090502486"}};
  const Problem problem = between(space(2), make_metric_field_cost(options, 2), Eigen::Vector2d(0, 0),
                                  Eigen::Vector2d(0.913668311176993, 0.7592475403307616));
  const int n = GENERATE(20, 63, 64, 100);
  const Result result = find(problem, n);
  const long double x = 0.913668311176993, y = 0.7592475403307616;
  const long double truth = std::sqrt(static_cast<long double>(30161626.53531196) * x * x -
                                      2 * static_cast<long double>(36296095.80716718) * x * y +
                                      static_cast<long double>(43678236.090502486) * y * y);
  const CostEstimate& e = result.certificate.estimate;
  CAPTURE(n, e.value, e.error, static_cast<double>(truth), failures(result.certificate));
  CHECK(result.status == Status::certified);
  CHECK(std::abs(e.value - static_cast<double>(truth)) <= e.error);
  CHECK(e.error < 1e-6);
}

TEST_CASE("lie: a path that has not converged", "[framework]") {
  const Problem rest = bead(Eigen::Vector2d(0, 0), Eigen::Vector2d(2, -1));
  CoordinatePath path = sample_equally(rest, StraightInitializer().first_path(rest, {}).path, 30);
  PathEnergy energy(rest, PathEnergy(rest, 1).cost(path) / 31);
  const int iterations = GENERATE(1, 2, 3);
  Newton({.max_iterations = iterations}).solve(energy, path, {});
  const Certificate c = certify_chain(rest, path);
  CAPTURE(iterations, failures(c));
  CHECK(failed(c, "stationarity"));
}

TEST_CASE("lie: a path off its domain", "[framework]") {
  CoordinatePath path = great_circle(2, 24);
  path.u.col(5) *= 1 + 1e-6;
  const Certificate c = certify_on_sphere(path);
  CAPTURE(failures(c));
  CHECK(failed(c, "residual"));
}

TEST_CASE("lie: H = s claims a spacing and an index", "[framework]") {
  const auto line = chain(2, 20, false, [](double t) { return Eigen::Vector2d(3 * t, 4 * t); });
  const Certificate c =
      certify_chain(between_ends(space(2), make_euclidean_cost(2), line, make_kernel<Linear>()), line);
  CAPTURE(failures(c));
  CHECK(failed(c, "index_not_applicable"));
}

TEST_CASE("lie: a discretisation too coarse to extrapolate from", "[framework]") {
  const Problem hill =
      between(space(2), make_segment_cost(Weighted{}), Eigen::Vector2d(-40, 0.1), Eigen::Vector2d(40, 0.1));
  const Result result = find(hill, 7);  // segments of ten times the hill's width step over it
  CAPTURE(failures(result.certificate));
  CHECK_FALSE(result.certificate.certified());
}

TEST_CASE("lie: a bent path on a mesh", "[framework]") {
  const auto mesh = std::make_shared<MeshManifold>(TriangleMesh(sphere(4)));
  const Problem problem =
      between(mesh, make_euclidean_cost(3), Eigen::Vector3d(0.1, 0.2, 0.97), Eigen::Vector3d(0.9, -0.3, -0.3));
  const FirstPath first = DijkstraInitializer().first_path(problem, {});
  CoordinatePath path = sample_equally(problem, first.path, 32);
  const TracePostProcessor trace;
  const StraightenPostProcessor straighten;
  const auto traced = [&](const CoordinatePath& p) {
    return trace.apply(problem, first, as_delivered(problem, p), {});
  };
  const auto certified = [&](const PostProcessed& p) { return certify(problem, p.curve.cost / 33, p, traced, {}, {}); };
  SECTION("straightened, it passes") {
    const Certificate c = certified(straighten.apply(problem, first, traced(path), {}));
    CAPTURE(failures(c));
    CHECK(c.certified());
  }
  SECTION("the edge path as it is: not stationary") {
    const Certificate c = certified(traced(path));
    CAPTURE(failures(c));
    CHECK(failed(c, "stationarity"));
  }
  SECTION("the edge path that claims to be straight: measured, and refused") {
    PostProcessed bent = traced(path);
    bent.curve.straightness = check_straight(mesh->mesh(), as_surface_path(bent.curve));
    const Certificate c = certified(bent);
    CAPTURE(failures(c), *bent.curve.straightness);
    CHECK(failed(c, "straightness"));
  }
  SECTION("a curve that cuts through the body") {
    PostProcessed cut = straighten.apply(problem, first, traced(path), {});
    cut.curve.x.col(cut.curve.x.cols() / 2) *= 0.999;
    const Certificate c = certified(cut);
    CAPTURE(failures(c));
    CHECK(failed(c, "residual"));
  }
  SECTION("points crowded on a straight curve") {
    PostProcessed crowded = straighten.apply(problem, first, traced(path), {});
    crowded.curve_costs[3] *= 1.01;
    CHECK(failed(certified(crowded), "spacing"));
  }
}

TEST_CASE("lie: a certificate that was interrupted", "[framework]") {
  const Problem line = between(space(2), make_euclidean_cost(2), Eigen::Vector2d(0, 0), Eigen::Vector2d(1, 2));
  const Result result = find(line, 9);
  Monitor stop;
  stop.stop_requested = [] { return true; };
  const Certificate c = certify(
      line, 0.1, as_delivered(line, result.path), [&](const CoordinatePath& p) { return as_delivered(line, p); }, {},
      stop);
  CHECK(failed(c, "interrupted"));
  CHECK_FALSE(c.certified());
}

}  // namespace leastcost::test
