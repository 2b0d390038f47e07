// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include <leastcost/catalogue/plugins/end_options.hpp>
#include <leastcost/framework/base/options.hpp>
#include "catalogue/plugins/plugin.hpp"
#include "catalogue/yaml/config_node.hpp"

namespace leastcost {

using PluginList = std::vector<PluginChoice>;

class RunVisitor;

/// A list of blocks with the same fields, of any element type; see blocks_of().
struct BlockList {
  std::function<std::size_t()> size;
  std::function<void(std::size_t)> resize;
  std::function<void(std::size_t, RunVisitor&)> fields;
};

template <class T>
BlockList blocks_of(std::vector<T>& items) {
  return {[&items] { return items.size(); }, [&items](std::size_t n) { items.resize(n); },
          [&items](std::size_t i, RunVisitor& visit) { items[i].fields(visit); }};
}

/// What a part of a study that is kept as it was written may look like.
enum class TreeForm {
  run,       ///< the name of a configuration file, or a configuration
  options,   ///< options of a run: {path.points: 10}
  sweep,     ///< options of a run with the values that each of them takes: {path.cascade: [true, false]}
  plugins,   ///< plug-ins as in a run, each with an optional name
  counts,    ///< numbers of points
  integers,  ///< whole numbers
};

/// A field visitor that also knows what only a whole run, or a study of runs, has.
class RunVisitor : public FieldVisitor {
 public:
  /// A number of points, or `auto`: none.
  virtual void points(std::string_view key, std::optional<int>& value, const FieldDoc& doc) = 0;
  virtual void end(std::string_view key, std::optional<EndOptions>& value, const FieldDoc& doc) = 0;
  /// {type: x, options...}, or just the word x. `kind`: its name, as "cost".
  virtual void plugin(std::string_view key, PluginChoice& value, std::string_view kind, const FieldDoc& doc) = 0;
  virtual void plugins(std::string_view key, std::optional<PluginList>& value, std::string_view kind,
                       const FieldDoc& doc) = 0;
  /// A list that may be empty.
  void plugins(std::string_view key, PluginList& value, std::string_view kind, const FieldDoc& doc) {
    std::optional<PluginList> given;
    if (!value.empty()) given = value;
    plugins(key, given, kind, doc);
    value = given.value_or(PluginList{});
  }
  /// A nested block whose fields need this visitor.
  virtual void block(std::string_view key, const FieldDoc& doc, const std::function<void(RunVisitor&)>& body) = 0;
  /// A list of such blocks.
  virtual void blocks(std::string_view key, const BlockList& list, const FieldDoc& doc) = 0;
  /// What is put into configurations and read there: kept as a tree, checked for its form only. `kind`: of plug-ins.
  virtual void tree(std::string_view key, ConfigNode& value, TreeForm form, const PluginKind* kind,
                    const FieldDoc& doc) = 0;
};

}  // namespace leastcost
