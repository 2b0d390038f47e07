// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "app/report/page/json_file.hpp"

#include <fstream>
#include <iterator>
#include <limits>
#include <sstream>

#include <leastcost/framework/base/errors.hpp>

namespace leastcost::app {

std::string text_of_file(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in || std::filesystem::is_directory(file)) throw InputError(file.string() + ": cannot be read");
  std::string text{std::istreambuf_iterator<char>(in), {}};
  if (in.bad()) throw InputError(file.string() + ": cannot be read completely");
  return text;
}

JsonFile::JsonFile(const std::filesystem::path& file) : name_(file.string()) {
  try {
    value_ = nlohmann::json::parse(text_of_file(file));
  } catch (const nlohmann::json::exception& e) {
    throw InputError(name_ + ": is not JSON: " + e.what());
  }
  if (!value_.is_object()) throw InputError(name_ + ": is not a JSON object");
}

const nlohmann::json* JsonFile::find(const std::string& key) const {
  const nlohmann::json* at = &value_;
  std::istringstream parts(key);
  for (std::string part; std::getline(parts, part, '.');) {
    if (!at->is_object() || !at->contains(part)) return nullptr;
    at = &at->at(part);
  }
  return at;
}

const nlohmann::json& JsonFile::at(const std::string& key) const {
  const nlohmann::json* found = find(key);
  if (found == nullptr) throw InputError(name_ + ": has no '" + key + "'; it may be from another version of leastcost");
  return *found;
}

void JsonFile::wrong(const std::string& key, const char* expected) const {
  throw InputError(name_ + ": '" + key + "' is not " + expected);
}

double JsonFile::number_of(const nlohmann::json& value, const std::string& key) const {
  if (value.is_null()) return std::numeric_limits<double>::quiet_NaN();
  if (value == "Infinity") return std::numeric_limits<double>::infinity();
  if (value == "-Infinity") return -std::numeric_limits<double>::infinity();
  if (!value.is_number()) wrong(key, "a number");
  return value.get<double>();
}

double JsonFile::number(const std::string& key) const { return number_of(at(key), key); }

std::string JsonFile::text(const std::string& key) const {
  const nlohmann::json& value = at(key);
  if (value.is_null()) return "";
  if (value.is_string()) return value.get<std::string>();
  if (value.is_structured()) wrong(key, "a text");
  return value.dump();
}

bool JsonFile::flag(const std::string& key) const {
  const nlohmann::json& value = at(key);
  if (!value.is_boolean()) wrong(key, "true or false");
  return value.get<bool>();
}

std::vector<std::string> JsonFile::texts(const std::string& key) const {
  const nlohmann::json& list = at(key);
  if (!list.is_array()) wrong(key, "a list");
  std::vector<std::string> out;
  for (const nlohmann::json& item : list) {
    if (!item.is_string()) wrong(key, "a list of strings");
    out.push_back(item.get<std::string>());
  }
  return out;
}

std::vector<double> JsonFile::numbers(const std::string& key) const {
  const nlohmann::json& list = at(key);
  if (!list.is_array()) wrong(key, "a list");
  std::vector<double> out;
  for (const nlohmann::json& item : list) out.push_back(number_of(item, key));
  return out;
}

std::size_t JsonFile::size(const std::string& key) const {
  const nlohmann::json* value = find(key);
  if (value == nullptr) return 0;
  if (!value->is_array()) wrong(key, "a list");
  return value->size();
}

std::vector<JsonFile> JsonFile::objects(const std::string& key) const {
  const nlohmann::json* list = find(key);
  if (list == nullptr) return {};
  if (!list->is_array()) wrong(key, "a list");
  std::vector<JsonFile> out;
  for (const nlohmann::json& item : *list) {
    if (!item.is_object()) wrong(key, "a list of objects");
    out.push_back(JsonFile(name_ + ": " + key, item));
  }
  return out;
}

std::vector<std::pair<std::string, std::string>> JsonFile::named_texts(const std::string& key) const {
  std::vector<std::pair<std::string, std::string>> out;
  const nlohmann::json* found = find(key);
  if (found == nullptr) return out;
  if (!found->is_object()) wrong(key, "an object");
  for (const auto& [name, value] : found->items())
    out.emplace_back(name, value.is_string() ? value.get<std::string>() : value.dump());
  return out;
}

}  // namespace leastcost::app
