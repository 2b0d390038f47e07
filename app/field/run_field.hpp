// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <leastcost/catalogue/plugins/end_options.hpp>
#include <leastcost/catalogue/run/run.hpp>
#include <leastcost/framework/base/monitor.hpp>
#include <leastcost/problems/fields/cost_field.hpp>
#include <leastcost/problems/fields/space_field.hpp>
#include "app/field/mesh_field.hpp"

namespace leastcost::app {

/// A place as an end of a configuration, with the words that an error begins with: "--to 3,4".
struct FieldPlace {
  EndOptions end;
  std::string words;
};

/// Where a field is from and leads to, as far as the configuration does not say it.
struct FieldEnds {
  std::vector<FieldPlace> from;      ///< empty: the source of the configuration
  std::optional<FieldPlace> target;  ///< where a configuration without target leads
};

/// A way between a place and the nearest of those of a field.
struct FieldWay {
  std::vector<Eigen::VectorXd> points;                      ///< as it is walked; coordinates
  double cost = 0;                                          ///< under the cost of the configuration
  double value = std::numeric_limits<double>::quiet_NaN();  ///< of the field at its end; NaN: not known
};

/// What the nodes of a field are: a lattice in two coordinates, one in space, or the vertices of a mesh.
enum class FieldNodes { plane, space, mesh };
FieldNodes field_nodes(const Problem& problem);
/// Throws InputError for a domain whose coordinates have no field, whatever the places are.
void check_dimension_of_field(const Problem& problem);

/// The field of a configuration: over a lattice in two coordinates or in space, or over the vertices of a mesh.
class RunField {
 public:
  /// From the places, or to them (`options`). The run may have been read without its ends (EndsFrom::caller). Throws
  /// InputError for configurations and places that have no field, OptionError ("resolution"), Interrupted.
  RunField(const Run& run, const FieldEnds& ends, const CostFieldOptions& options, const Monitor& monitor);

  /// A place of the domain, free of obstacles. Throws InputError.
  PathEnd place(const FieldPlace& at) const;
  /// The target of the configuration, or that of FieldEnds; of a corridor where it leads. Throws InputError where there
  /// is none.
  const PathEnd& target() const;
  /// How much dearer a path to `target` through each node is than the cheapest of all. Throws InputError, Interrupted.
  RunField corridor(const PathEnd& target, const Monitor& monitor) const;
  /// Down the field, which is no corridor. Throws InputError where no way leads there; Interrupted.
  FieldWay way(const PathEnd& place, const Monitor& monitor) const;

  FieldNodes nodes() const { return nodes_; }
  bool on_mesh() const { return nodes_ == FieldNodes::mesh; }
  bool in_space() const { return nodes_ == FieldNodes::space; }
  bool is_corridor() const { return corridor_; }
  bool to_places() const { return options_.to_places; }
  const CostField& lattice() const { return lattice_; }  ///< in two coordinates
  const SpaceField& space() const { return space_; }     ///< in space
  const MeshField& on_vertices() const { return vertices_; }
  const TriangleMesh& mesh() const { return fields_->mesh(); }
  const Problem& problem() const { return problem_; }
  const std::vector<PathEnd>& places() const { return places_; }
  /// Of the coordinates: x and y, the joints of an arm, x, y and the angle of a body.
  std::vector<std::string> names() const;
  /// What the user should know about how the configuration was read.
  const std::vector<std::string>& notes() const { return notes_; }
  /// Of all nodes; NaN: no path.
  const std::vector<double>& values() const {
    return on_mesh() ? vertices_.values : in_space() ? space_.values : lattice_.values;
  }

 private:
  std::shared_ptr<const RunOrigin> origin_;
  std::vector<std::string> notes_;
  EndOptions source_;  ///< of the configuration, or the first of the places
  bool has_target_ = true;
  Problem problem_;
  std::vector<PathEnd> places_;
  CostFieldOptions options_;
  FieldNodes nodes_ = FieldNodes::plane;
  CostField lattice_;
  SpaceField space_;
  std::shared_ptr<const MeshFields> fields_;  ///< null: a lattice
  MeshField vertices_;
  bool corridor_ = false;
};

}  // namespace leastcost::app
