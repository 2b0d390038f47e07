// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "urdf/xml_file.hpp"

#include <tinyxml2.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <system_error>

#include <leastcost/framework/base/errors.hpp>
#include "problems/readers/file_content.hpp"
#include "problems/readers/text_scanner.hpp"

namespace leastcost {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

/// The numbers of a text; none where one of its words is not a finite number.
std::optional<std::vector<double>> numbers_of(std::string_view text) {
  std::vector<double> all;
  while (true) {
    while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
    if (text.empty()) return all;
    if (text.front() == '+') text.remove_prefix(1);
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || !std::isfinite(value)) return std::nullopt;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    if (!text.empty() && !is_blank(text.front())) return std::nullopt;
    all.push_back(value);
  }
}

/// Without the numbers of TinyXML-2's own errors.
std::string reason(const tinyxml2::XMLDocument& document) {
  switch (document.ErrorID()) {
    case tinyxml2::XML_ERROR_MISMATCHED_ELEMENT: return "an element is not closed by its own name";
    case tinyxml2::XML_ERROR_EMPTY_DOCUMENT: return "there is no element";
    case tinyxml2::XML_ELEMENT_DEPTH_EXCEEDED: return "elements are nested too deeply";
    default: return std::string("not well formed (") + tinyxml2::XMLDocument::ErrorIDToName(document.ErrorID()) + ")";
  }
}

}  // namespace

std::string XmlElement::name() const { return element_->Name(); }

int XmlElement::line() const { return element_->GetLineNum(); }

std::vector<XmlElement> XmlElement::children(const char* name) const {
  std::vector<XmlElement> all;
  for (const auto* e = element_->FirstChildElement(name); e != nullptr; e = e->NextSiblingElement(name))
    all.emplace_back(e, file_);
  return all;
}

std::vector<XmlElement> XmlElement::children() const { return children(nullptr); }

std::optional<XmlElement> XmlElement::child(const char* name) const {
  const std::vector<XmlElement> all = children(name);
  if (all.size() > 1) all[1].fail("a second <" + std::string(name) + "> in <" + this->name() + ">: remove one");
  return all.empty() ? std::nullopt : std::optional<XmlElement>(all.front());
}

std::optional<std::string> XmlElement::attribute(const char* name) const {
  const char* value = element_->Attribute(name);
  return value == nullptr ? std::nullopt : std::optional<std::string>(value);
}

std::string XmlElement::text(const char* name) const {
  const std::optional<std::string> value = attribute(name);
  if (!value || value->empty()) fail("<" + this->name() + "> must have the attribute '" + name + "'");
  return *value;
}

std::optional<std::vector<double>> XmlElement::numbers(const char* name, std::size_t count) const {
  const tinyxml2::XMLAttribute* found = element_->FindAttribute(name);
  if (found == nullptr) return std::nullopt;
  const std::optional<std::vector<double>> all = numbers_of(found->Value());
  if (!all || all->size() != count)
    fail_at(found->GetLineNum(), "'" + std::string(name) + "' of <" + this->name() + "> must be " +
                                     (count == 1 ? "a finite number" : std::to_string(count) + " finite numbers") +
                                     ", not " + printable(found->Value()));
  return all;
}

std::optional<double> XmlElement::number(const char* name) const {
  const std::optional<std::vector<double>> all = numbers(name, 1);
  return all ? std::optional<double>(all->front()) : std::nullopt;
}

double XmlElement::required_number(const char* name) const {
  text(name);
  return *number(name);
}

void XmlElement::fail(const std::string& message) const { fail_at(line(), message); }

void XmlElement::fail_at(int line, const std::string& message) const {
  throw InputError(*file_ + ":" + std::to_string(line) + ": " + message);
}

struct XmlFile::Document {
  std::string file;
  tinyxml2::XMLDocument xml;
};

XmlFile::XmlFile(const std::filesystem::path& file, const char* root) : document_(std::make_unique<Document>()) {
  constexpr std::uintmax_t kMost = std::uintmax_t(64) << 20;
  document_->file = file.string();
  std::error_code unknown;
  if (const std::uintmax_t size = std::filesystem::file_size(file, unknown); !unknown && size > kMost)
    throw InputError(document_->file + " is " + std::to_string(size >> 20) + " MB; the limit is 64 MB");
  const std::string content = read_content(file);
  tinyxml2::XMLDocument& xml = document_->xml;
  if (xml.Parse(content.data(), content.size()) != tinyxml2::XML_SUCCESS)
    throw InputError(document_->file + ":" + std::to_string(std::max(1, xml.ErrorLineNum())) +
                     ": not XML: " + reason(xml));
  if (xml.RootElement() == nullptr || std::string_view(xml.RootElement()->Name()) != root)
    throw InputError(document_->file + ":" +
                     std::to_string(xml.RootElement() == nullptr ? 1 : xml.RootElement()->GetLineNum()) +
                     ": must have <" + root + "> as its outermost element");
}

XmlFile::~XmlFile() = default;

XmlElement XmlFile::root() const { return {document_->xml.RootElement(), &document_->file}; }

}  // namespace leastcost
