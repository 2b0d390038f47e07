// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string_view>
#include <vector>

#include "app/plugin.hpp"
#include "framework/options.hpp"

namespace leastcost::app {

/// A number of points, or `auto`: as many as the first edge path has.
struct PointCount {
  int count = 64;
  bool automatic = false;
};

/// Where an end of the path is: exactly one of vertex, face + barycentric, point.
struct EndOptions {
  bool given = false;
  int vertex = -1;              ///< of the file; negative: not given
  int face = -1;                ///< of the file; negative: not given
  Eigen::VectorXd barycentric;  ///< three numbers
  Eigen::VectorXd point;
  double tolerance = -1;  ///< length units; negative: the default of the manifold
  void fields(FieldVisitor& visit);
};

struct PluginList {
  bool given = false;
  std::vector<PluginChoice> choices;
};

/// A field visitor that also knows what only a whole run has.
class RunVisitor : public FieldVisitor {
 public:
  virtual void points(std::string_view key, PointCount& value, const FieldDoc& doc) = 0;
  virtual void end(std::string_view key, EndOptions& value, const FieldDoc& doc) = 0;
  /// {type: x, options...}, or just the word x.
  virtual void plugin(std::string_view key, PluginChoice& value, const PluginKind& kind, const FieldDoc& doc) = 0;
  virtual void plugins(std::string_view key, PluginList& value, const PluginKind& kind, const FieldDoc& doc) = 0;
  /// A nested block whose fields need this visitor.
  virtual void block(std::string_view key, const FieldDoc& doc, const std::function<void(RunVisitor&)>& body) = 0;
};

}  // namespace leastcost::app
