// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "catalogue/yaml/config_node.hpp"

namespace leastcost {

/// A block of keys in a scene, or a node that should be one, which is an error. What is wrong goes to the errors with
/// its place, and reads as the default.
class SceneBlock {
 public:
  /// `what`: for messages, "the object 'can'".
  SceneBlock(const ConfigNode& node, std::string what, Diagnostics& errors);

  const std::string& what() const { return what_; }
  bool has(std::string_view key) const { return node_->find(key) != nullptr; }
  /// Null, and an error, where it is missing.
  const ConfigNode* required(const char* key);
  /// Null where it is missing.
  const ConfigNode* find(const char* key);

  /// `missing`: what an absent key reads as; none: it is required.
  double number(const char* key, std::optional<double> missing = {});
  std::string text(const char* key, const std::optional<std::string>& missing = {});
  bool flag(const char* key, bool missing);
  /// So many numbers, or 0: any number of them. Empty where the key is absent.
  Eigen::VectorXd numbers(const char* key, std::size_t count);
  /// The items of a list. None where the key is absent.
  std::vector<ConfigNode> list(const char* key);

  /// An error at a key of this block ("pose.rpy"), or at the nearest block around it that is given.
  void fault(std::string_view key, const std::string& message);
  /// Reports keys that nothing asked for.
  void finish();

 private:
  const ConfigNode* node_;
  std::string what_;
  Diagnostics& errors_;
  std::vector<std::string> known_;
};

/// A list of so many numbers (0: any), or a block of the names, {x: 1, y: 2}. Nothing, and a message, where it is
/// neither.
std::optional<Eigen::VectorXd> numbers_of(const ConfigNode& node, std::size_t count,
                                          const std::vector<std::string>& names, std::string& fault);

}  // namespace leastcost
