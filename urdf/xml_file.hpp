// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tinyxml2 {
class XMLElement;
}

namespace leastcost {

/// An element of an XML file that knows its line. Valid while the file is.
class XmlElement {
 public:
  XmlElement(const tinyxml2::XMLElement* element, const std::string* file) : element_(element), file_(file) {}

  std::string name() const;
  int line() const;
  /// Its elements of this name, in the order of the file.
  std::vector<XmlElement> children(const char* name) const;
  /// All of them.
  std::vector<XmlElement> children() const;
  /// The only one of this name, if there is one; throws for a second one.
  std::optional<XmlElement> child(const char* name) const;

  std::optional<std::string> attribute(const char* name) const;
  /// One that has to be there and is not empty.
  std::string text(const char* name) const;
  /// Finite numbers, separated by blanks; none where the attribute is not there.
  std::optional<double> number(const char* name) const;
  std::optional<std::vector<double>> numbers(const char* name, std::size_t count) const;
  double required_number(const char* name) const;

  /// Throws InputError("file:line: message").
  [[noreturn]] void fail(const std::string& message) const;

 private:
  [[noreturn]] void fail_at(int line, const std::string& message) const;

  const tinyxml2::XMLElement* element_;
  const std::string* file_;
};

/// An XML file of less than 64 MB.
class XmlFile {
 public:
  /// Throws InputError where it cannot be read, is no XML, or its outermost element has another name.
  XmlFile(const std::filesystem::path& file, const char* root);
  ~XmlFile();
  XmlFile(const XmlFile&) = delete;
  XmlFile& operator=(const XmlFile&) = delete;

  XmlElement root() const;

 private:
  struct Document;
  std::unique_ptr<Document> document_;
};

}  // namespace leastcost
