// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

namespace leastcost::app {

/// The whole content. Throws InputError that names the file.
std::string text_of_file(const std::filesystem::path& file);

/// A JSON object of a file, read by dotted keys ("cost.value"). Every access throws InputError with file and key where
/// there is something else than expected.
class JsonFile {
 public:
  explicit JsonFile(const std::filesystem::path& file);

  bool has(const std::string& key) const { return find(key) != nullptr; }
  /// null is NaN, "Infinity" and "-Infinity" are the infinities.
  double number(const std::string& key) const;
  /// null is empty; other values than texts as they are written.
  std::string text(const std::string& key) const;
  bool flag(const std::string& key) const;
  std::vector<std::string> texts(const std::string& key) const;
  std::vector<double> numbers(const std::string& key) const;
  /// Of a list, whatever is in it; a missing one has none.
  std::size_t size(const std::string& key) const;
  /// The objects of a list; a missing list has none.
  std::vector<JsonFile> objects(const std::string& key) const;
  /// The keys of an object and their texts, in the order of the alphabet; a missing object has none.
  std::vector<std::pair<std::string, std::string>> named_texts(const std::string& key) const;
  const std::string& name() const { return name_; }

 private:
  JsonFile(std::string name, nlohmann::json value) : name_(std::move(name)), value_(std::move(value)) {}
  const nlohmann::json* find(const std::string& key) const;
  const nlohmann::json& at(const std::string& key) const;
  [[noreturn]] void wrong(const std::string& key, const char* expected) const;
  double number_of(const nlohmann::json& value, const std::string& key) const;

  std::string name_;
  nlohmann::json value_;
};

}  // namespace leastcost::app
