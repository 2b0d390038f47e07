// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// A domain that the catalogue has never heard of: its ends, its first paths, its tables and its picture come from its
// abilities alone.
#include <leastcost/framework/problem/has_graph.hpp>
#include <leastcost/problems/drawing/draws_itself.hpp>
#include <leastcost/problems/initializers/dijkstra.hpp>
#include <leastcost/problems/manifolds/file_places.hpp>
#include <leastcost/problems/manifolds/made_from_data.hpp>
#include "catalogue/output/path_table.hpp"
#include "catalogue/run/ends.hpp"
#include "catalogue/scene/scene.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/compose.hpp"

namespace leastcost::test {
namespace {

constexpr int kWidth = 8;

/// The plane z = 0 over a lattice of kWidth x kWidth numbered nodes; its points are named by polar coordinates around
/// (-1, -1).
class Lattice final : public ConstraintManifold,
                      public HasChart,
                      public HasGraph,
                      public HasVertices,
                      public HasFilePlaces,
                      public MadeFromData,
                      public DrawsItself {
 public:
  Dimensions dimensions() const override { return {2, 3, 2}; }
  Shape shape() const override { return Shape::smooth; }
  Projection project(CoordinatePath& path) const override {
    Projection result;
    for (Index i = 0; i < path.u.cols(); ++i) {
      const double inside = std::max(path.u(0, i), 0.5);
      result.moved = std::max(result.moved, inside - path.u(0, i));
      path.u(0, i) = inside;
    }
    return result;
  }
  void tangent_bases(const CoordinatePath& path, Points& bases) const override {
    bases = Points::Identity(2, 2).replicate(1, path.u.cols());
  }
  void retract(const CoordinatePath& from, const Points& step, CoordinatePath& to) const override {
    prepare_like(from, to);
    to.u.middleCols(from.free_begin(), from.free_count()) =
        from.u.middleCols(from.free_begin(), from.free_count()) + step;
  }
  double residual(const CoordinatePath&) const override { return 0; }

  void embed(const CoordinatePath& path, Points& x) const override {
    x.resize(3, path.u.cols());
    for (Index i = 0; i < path.u.cols(); ++i)
      x.col(i) << path.u(0, i) * std::cos(path.u(1, i)) - 1, path.u(0, i) * std::sin(path.u(1, i)) - 1, 0;
  }
  void jacobians(const CoordinatePath& path, Points& j) const override {
    j.resize(3, 2 * path.u.cols());
    for (Index i = 0; i < path.u.cols(); ++i) {
      const double r = path.u(0, i), c = std::cos(path.u(1, i)), s = std::sin(path.u(1, i));
      j.middleCols(2 * i, 2) << c, -r * s, s, r * c, 0, 0;
    }
  }
  void curvatures(const CoordinatePath& path, const Points& w, Points& h) const override {
    h.resize(2, 2 * path.u.cols());
    for (Index i = 0; i < path.u.cols(); ++i) {
      const double r = path.u(0, i), c = std::cos(path.u(1, i)), s = std::sin(path.u(1, i));
      const double mixed = -w(0, i) * s + w(1, i) * c;
      h.middleCols(2 * i, 2) << 0, mixed, mixed, -r * (w(0, i) * c + w(1, i) * s);
    }
  }
  const std::vector<SeamMap>& poles() const override { return poles_; }
  std::vector<std::string> coordinate_names() const override { return {"r", "phi"}; }

  PathEnd vertex(int number) const override {
    if (number >= kWidth * kWidth) throw OptionError("vertex", "no such node");
    return {polar(number % kWidth, number / kWidth), kNoSite};
  }
  FirstPath least_cost_edges(const Problem& problem, const Monitor&) const override {
    FirstPath first;  // over the node beside the source
    first.path.u.resize(2, 3);
    first.path.u << problem.source.u, polar(1, 0), problem.target.u;
    first.graph_vertices = 1;
    return first;
  }
  std::vector<std::string> place_columns() const override { return {"column", "row"}; }
  Eigen::VectorXd place_in_file(Site, const Eigen::VectorXd& x) const override {
    return Eigen::Vector2d(std::round(x[0]), std::round(x[1]));
  }
  double diameter() const override { return kWidth; }
  std::vector<std::string> notes() const override { return {"a lattice"}; }
  std::vector<DataCount> counts() const override { return {{"node", "nodes", kWidth * kWidth}}; }
  void draw(const DrawnPaths& paths, Drawing& out) const override {
    out.surface.vertices = {Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitX(), Eigen::Vector3d(paths.x.col(0))};
    out.surface.triangles = {{0, 1, 2}};
  }

 private:
  static Eigen::Vector2d polar(int x, int y) { return {std::hypot(x + 1, y + 1), std::atan2(y + 1, x + 1)}; }
  std::vector<SeamMap> poles_;
};

}  // namespace

TEST_CASE("a new domain: ends, first path, tables and picture from its abilities alone") {
  const auto lattice = std::make_shared<const Lattice>();
  EndOptions end;
  end.vertex = kWidth + 2;
  const PlacedEnd source = place_end(*lattice, end, "ends.source");
  CHECK(source.end.u.isApprox(Eigen::Vector2d(std::sqrt(13.0), std::atan2(2.0, 3.0))));
  end.vertex = kWidth * kWidth;
  CHECK_THROWS_WITH(place_end(*lattice, end, "ends.source"), "ends.source.vertex: no such node");
  end = {};
  end.face = 0;
  end.barycentric = Eigen::Vector3d(1, 0, 0);
  CHECK_THROWS_WITH(place_end(*lattice, end, "ends.source"), Catch::Contains("has no faces"));
  end = {};
  end.point = Eigen::Vector2d(0.45, 0);  // off by less than a hundredth of its size
  CHECK(place_end(*lattice, end, "ends.source").moved == Approx(0.05));

  const Problem problem =
      between(lattice, make_euclidean_cost(3), source.end.u, Eigen::Vector2d(std::sqrt(72.0), std::atan2(6.0, 6.0)));
  const Result result = find(problem, 9, DijkstraInitializer());
  CHECK(result.first.graph_vertices == 1);
  CHECK(result.curve.cost == Approx(std::hypot(3, 4)).epsilon(1e-9));
  const std::string csv = csv_text(delivered_points(problem, result));
  CHECK(csv.substr(0, csv.find('\n')) == "index,x,y,z,r,phi,segment_cost,cumulative_cost,column,row");
  CHECK(first_path_csv(problem, result.first).substr(0, 19) == "index,x,y,z,r,phi\n0");
  CHECK(csv.substr(csv.rfind(','), 3) == ",5\n");
  const Scene scene = make_scene(problem, result);
  CHECK(scene.surface.triangles.size() == 1);
  CHECK(scene.lines.path.cols() > 100);  // along the chart
}

}  // namespace leastcost::test
