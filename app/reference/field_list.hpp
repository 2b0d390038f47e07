// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "catalogue/plugins/run_visitor.hpp"

namespace leastcost::app {

enum class FieldType {
  boolean,
  integer,
  number,
  text,
  numbers,
  matrix,
  named_numbers,
  texts,
  choice,
  file,
  block,
  variant,
  switch_or_number,
  points,
  end,
  plugin,
  plugins,
  blocks,
  tree
};

/// One option as `describe`, the JSON schema and the reference page see it.
struct FieldInfo {
  std::string key;
  FieldType type = FieldType::text;
  std::string default_value;  ///< as YAML; empty: none
  std::string help, unit;
  double minimum = 0, maximum = 0;  ///< infinite where there is no bound
  bool exclusive_minimum = false, required = false;
  std::vector<std::string> choices;
  std::vector<FieldInfo> children;    ///< of a block or an end; of a variant: one block per type
  const PluginKind* kind = nullptr;   ///< of plug-ins
  TreeForm form = TreeForm::options;  ///< of a tree

  /// "integer, at least 1", "one of chute, midpoint".
  std::string type_in_words() const;
};

/// The options of an object, in the order of its field list. The object is only read.
std::vector<FieldInfo> fields_of(AnyOptions& options);
std::vector<FieldInfo> fields_of_run();
std::vector<FieldInfo> fields_of_study();

}  // namespace leastcost::app
