// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <leastcost/eigen_alignment.hpp>

namespace leastcost {

/// What a reader of the reference page needs to know about one option.
struct FieldDoc {
  std::string_view help;       ///< one sentence
  std::string_view unit = "";  ///< "length", "m/s^2", "relative cost error", ... ; empty: a plain number
  double minimum = -std::numeric_limits<double>::infinity();
  double maximum = std::numeric_limits<double>::infinity();
  bool exclusive_minimum = false;  ///< the minimum itself is not allowed
  bool required = false;
};

class FieldVisitor;

/// One of several forms that a nested block can take, see FieldVisitor::variant().
struct FieldVariant {
  std::string type;
  std::string_view help;                           ///< one sentence
  std::function<void(FieldVisitor&)> fields = {};  ///< none: it has no options
};

/// Walks the options of one object. An options struct states its fields once,
///
///     struct LbfgsOptions {
///       int memory = 10;
///       void fields(FieldVisitor& visit) { visit.field("memory", memory, {.help = "Stored pairs.", .minimum = 1}); }
///     };
///
/// and that one list serves reading (with range and unknown-key checks), writing, `describe`, the JSON schema and
/// the reference page. The default is the value the struct holds before the visit.
class FieldVisitor {
 public:
  virtual ~FieldVisitor() = default;
  virtual void field(std::string_view key, bool& value, const FieldDoc& doc) = 0;
  virtual void field(std::string_view key, int& value, const FieldDoc& doc) = 0;
  virtual void field(std::string_view key, double& value, const FieldDoc& doc) = 0;
  virtual void field(std::string_view key, std::string& value, const FieldDoc& doc) = 0;
  /// A vector: a list of numbers. An empty one counts as absent.
  virtual void field(std::string_view key, Eigen::VectorXd& value, const FieldDoc& doc) = 0;
  /// A matrix: a list of rows of equal length. An empty one counts as absent.
  virtual void field(std::string_view key, Eigen::MatrixXd& value, const FieldDoc& doc) = 0;
  /// Numbers by name, {a: 2, b: 1}: the parameters of a formula. The names are free.
  virtual void field(std::string_view key, std::map<std::string, double>& value, const FieldDoc& doc) = 0;
  /// Texts: a list, or a single one. An empty list counts as absent.
  virtual void field(std::string_view key, std::vector<std::string>& value, const FieldDoc& doc) = 0;
  /// One word out of `choices`.
  virtual void choice(std::string_view key, std::string& value, const std::vector<std::string>& choices,
                      const FieldDoc& doc) = 0;
  /// A path to a file, relative to the folder of the configuration.
  virtual void file(std::string_view key, std::string& value, const FieldDoc& doc) = 0;
  /// A nested block with fields of its own.
  virtual void group(std::string_view key, const FieldDoc& doc, const std::function<void(FieldVisitor&)>& body) = 0;
  /// A nested block whose `type` says which fields it has: {type: torus, major_radius: 2}, or the word alone. An empty
  /// type counts as absent.
  virtual void variant(std::string_view key, std::string& type, const std::vector<FieldVariant>& variants,
                       const FieldDoc& doc) = 0;
};

/// Options of a plug-in that has none.
struct NoOptions {
  void fields(FieldVisitor&) {}
};

}  // namespace leastcost
