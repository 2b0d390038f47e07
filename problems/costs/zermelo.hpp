// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <leastcost/framework/base/options.hpp>
#include <leastcost/framework/cost/segment_cost.hpp>

namespace leastcost {

/// The velocities w(x) of the medium that carries the vehicle: a wind, a current.
namespace flow {

struct Uniform {
  static constexpr std::string_view kType = "uniform";
  static constexpr std::string_view kHelp = "The same everywhere.";
  Eigen::VectorXd velocity = {};  ///< one number per coordinate
  void fields(FieldVisitor& visit);
};

struct Formula {
  static constexpr std::string_view kType = "formula";
  static constexpr std::string_view kHelp = "Formulas in the coordinates x, y and z.";
  std::vector<std::string> velocity = {};  ///< one formula per coordinate
  void fields(FieldVisitor& visit);
};

struct Grid {
  static constexpr std::string_view kType = "grid";
  static constexpr std::string_view kHelp = "Values at the nodes of a regular grid, from a CSV file.";
  std::string file = {};
  void fields(FieldVisitor& visit);
};

struct EastNorth {
  static constexpr std::string_view kType = "east_north";
  static constexpr std::string_view kHelp = "On the Earth: the same velocity to the east and to the north everywhere.";
  Eigen::VectorXd velocity = {};  ///< east, north
  void fields(FieldVisitor& visit);
};

using Field = std::variant<Uniform, Formula, Grid, EastNorth>;

}  // namespace flow

struct ZermeloOptions {
  std::string speed = {};  ///< of the vehicle through the medium: a number or a formula
  flow::Field flow = {};
  std::map<std::string, double> parameters = {};
  std::string unit = "s";  ///< of time
  void fields(FieldVisitor& visit);
  bool reads_file() const { return std::holds_alternative<flow::Grid>(flow); }  ///< whether the flow comes from a file
};

/// Time of a vehicle of speed V through a medium that moves with velocity w(x), in two or three dimensions (Zermelo
/// 1931). It heads so that it makes good the straight move d = b - a:
///
///     c(a, b) = |d|^2 / (d.w + sqrt((d.w)^2 + (V^2 - |w|^2) |d|^2)),
///
/// w and V in the middle of the move (order 2; exact where both are constant). Not symmetric. Where |w| < V it is a
/// Randers metric. Where the medium is faster, moves within the angle asin(V / |w|) of its direction are possible, and
/// of the two headings that make one good the quicker counts; every other move costs +infinity, as where V is not
/// positive, and the cost says where and why (ExplainsInfinity). On a surface w has to be tangential.
///
/// A grid is a CSV file with a row per node, x, y, u, v or x, y, z, u, v, w: docs/domains.md. Its values are
/// interpolated with two continuous derivatives; moves whose middle or one of whose ends lies outside it, or where one
/// of the up to 4^d nodes around has no value, cost +infinity. `folder` is that of the file. Throws OptionError,
/// InputError.
std::shared_ptr<const SegmentCost> make_zermelo_cost(const ZermeloOptions& options, int dim,
                                                     const std::filesystem::path& folder = {});

/// The same in a flow that is given at the nodes of a regular grid in memory: `nodes` has a row per node, as the file
/// of a grid. options.flow says nothing.
std::shared_ptr<const SegmentCost> make_zermelo_cost(ZermeloOptions options, const Eigen::MatrixXd& nodes, int dim);

/// Throws the OptionError that the first of both would throw, without reading the file of a grid.
void check_zermelo(const ZermeloOptions& options, int dim);

}  // namespace leastcost
