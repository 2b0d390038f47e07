// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "catalogue/options/options_reader.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "catalogue/yaml/scalars.hpp"
#include "catalogue/yaml/suggest.hpp"

namespace leastcost {

OptionsReader::OptionsReader(const ConfigNode& block, std::string name, const Place& place, Diagnostics& errors,
                             const Externals* externals)
    : block_(block),
      name_(std::move(name)),
      place_(name_.empty() ? place : blamed(block, place)),
      errors_(errors),
      externals_(externals) {
  if (block.is_block()) return;
  const std::string what = name_.empty() ? "the configuration" : "'" + shown_path(name_) + "'";
  errors_.error(block.kind == ConfigNode::Kind::nothing ? place : block.place,
                what + " must be a block of keys (" + found(block) + ")");
}

const ConfigEntry* OptionsReader::entry(std::string_view key, const FieldDoc& doc) {
  known_.emplace_back(key);
  const ConfigEntry* e = block_.find(key);
  if (e == nullptr) {
    if (doc.required && block_.is_block())
      errors_.error(place_, fmt::format("missing key '{}'{}: {}", key, inside(), doc.help));
    return nullptr;
  }
  if (e->value.kind != ConfigNode::Kind::nothing) return e;
  fault(key, e->place, "has no value: remove the key to use the default");
  return nullptr;
}

void OptionsReader::fault(std::string_view key, const Place& place, const std::string& message) {
  // A place in Python, config['path']['points'], has named the option.
  const bool named = place.origin.ends_with(fmt::format("['{}']", key));
  errors_.error(place, named ? message : fmt::format("'{}'{} {}", key, inside(), message));
}

void OptionsReader::check_range(std::string_view key, const ConfigNode& node, double value, const FieldDoc& doc) {
  const std::string what = range_fault(value, doc);
  if (!what.empty()) fault(key, node.place, what + " (" + found(node) + ")");
}

void OptionsReader::field(std::string_view key, bool& value, const FieldDoc& doc) {
  const ConfigEntry* e = entry(key, doc);
  if (e == nullptr) return;
  const Parsed<bool> parsed = parse_bool(e->value);
  if (!parsed.value) return fault(key, e->value.place, parsed.fault);
  value = *parsed.value;
}

void OptionsReader::field(std::string_view key, int& value, const FieldDoc& doc) {
  const ConfigEntry* e = entry(key, doc);
  if (e == nullptr) return;
  const Parsed<int> parsed = parse_int(e->value);
  if (!parsed.value) return fault(key, e->value.place, parsed.fault);
  value = *parsed.value;
  check_range(key, e->value, value, doc);
}

void OptionsReader::field(std::string_view key, double& value, const FieldDoc& doc) {
  const ConfigEntry* e = entry(key, doc);
  if (e == nullptr) return;
  const Parsed<double> parsed = parse_double(e->value);
  if (!parsed.value) return fault(key, e->value.place, parsed.fault);
  value = *parsed.value;
  check_range(key, e->value, value, doc);
}

void OptionsReader::field(std::string_view key, std::string& value, const FieldDoc& doc) {
  const ConfigEntry* e = entry(key, doc);
  if (e == nullptr) return;
  const Parsed<std::string> parsed = parse_text(e->value);
  if (!parsed.value) return fault(key, e->value.place, parsed.fault);
  value = *parsed.value;
}

bool OptionsReader::read_numbers(std::string_view key, const ConfigNode& list, bool infinite,
                                 std::vector<double>& out) {
  if (!list.is_list() || list.items.empty()) {
    fault(key, list.place,
          "must be a list of numbers, like [0, 1] (" + (list.is_list() ? "found an empty list" : found(list)) + ")");
    return false;
  }
  bool good = true;
  for (const ConfigNode& item : list.items) {
    const Parsed<double> parsed = parse_double(item, infinite);
    if (!parsed.value) fault(key, item.place, "has an entry that " + parsed.fault);
    good = good && parsed.value;
    out.push_back(parsed.value.value_or(0));
  }
  return good;
}

void OptionsReader::field(std::string_view key, Eigen::VectorXd& value, const FieldDoc& doc) {
  const ConfigEntry* e = entry(key, doc);
  if (e == nullptr) return;
  std::vector<double> numbers;
  if (const Parsed<double> single = parse_double(e->value, true); single.value) {
    numbers.push_back(*single.value);
    check_range(key, e->value, numbers.front(), doc);
  } else {
    if (!read_numbers(key, e->value, true, numbers)) return;
    for (std::size_t i = 0; i < numbers.size(); ++i) check_range(key, e->value.items[i], numbers[i], doc);
  }
  value = Eigen::Map<const Eigen::VectorXd>(numbers.data(), static_cast<Eigen::Index>(numbers.size()));
}

void OptionsReader::field(std::string_view key, Eigen::MatrixXd& value, const FieldDoc& doc) {
  const ConfigEntry* e = entry(key, doc);
  if (e == nullptr) return;
  const ConfigNode& node = e->value;
  if (!node.is_list() || node.items.empty() || !node.items[0].is_list())
    return fault(key, node.place,
                 "must be a list of rows, like [[1, 0], [0, 1]] (" +
                     (node.is_list() ? "found a list without rows" : found(node)) + ")");
  Eigen::MatrixXd matrix(node.items.size(), node.items[0].items.size());
  for (std::size_t i = 0; i < node.items.size(); ++i) {
    std::vector<double> row;
    if (!read_numbers(key, node.items[i], false, row)) return;
    if (static_cast<Eigen::Index>(row.size()) != matrix.cols())
      return fault(key, node.items[i].place,
                   fmt::format("has rows of different length ({} here, {} in the first)", row.size(), matrix.cols()));
    matrix.row(static_cast<Eigen::Index>(i)) = Eigen::Map<const Eigen::RowVectorXd>(row.data(), matrix.cols());
  }
  value = matrix;
}

void OptionsReader::field(std::string_view key, std::map<std::string, double>& value, const FieldDoc& doc) {
  const ConfigEntry* e = entry(key, doc);
  if (e == nullptr) return;
  if (!e->value.is_block())
    return fault(key, e->value.place,
                 "must be a block of names and numbers, like {a: 2, b: 1} (" + found(e->value) + ")");
  value.clear();
  for (const ConfigEntry& named : e->value.entries) {
    if (is_note(named.key)) continue;
    const std::string name = std::string(key) + "." + named.key;
    const Place place = named.value.kind == ConfigNode::Kind::nothing ? named.place : named.value.place;
    const Parsed<double> parsed = parse_double(named.value);
    if (!parsed.value) {
      fault(name, place, parsed.fault);
      continue;
    }
    value[named.key] = *parsed.value;
    check_range(name, named.value, *parsed.value, doc);
  }
}

void OptionsReader::field(std::string_view key, std::vector<std::string>& value, const FieldDoc& doc) {
  const ConfigEntry* e = entry(key, doc);
  if (e == nullptr) return;
  const bool list = e->value.is_list();
  if (list && e->value.items.empty()) return fault(key, e->value.place, "must not be an empty list");
  const std::vector<ConfigNode> items = list ? e->value.items : std::vector<ConfigNode>{e->value};
  std::vector<std::string> texts;
  for (const ConfigNode& item : items) {
    const Parsed<std::string> parsed = parse_text(item);
    if (!parsed.value) return fault(key, item.place, (list ? "has an entry that " : "") + parsed.fault);
    texts.push_back(*parsed.value);
  }
  value = std::move(texts);
}

void OptionsReader::switch_or_number(std::string_view key, bool& on, double& number, const FieldDoc& doc) {
  const ConfigEntry* e = entry(key, doc);
  if (e == nullptr) return;
  if (const Parsed<bool> parsed = parse_bool(e->value); parsed.value) {
    on = *parsed.value;
    number = 0;
    return;
  }
  const Parsed<double> parsed = parse_double(e->value);
  if (!parsed.value) return fault(key, e->value.place, "must be true, false or a number (" + found(e->value) + ")");
  on = true;
  number = *parsed.value;
  check_range(key, e->value, number, doc);
}

void OptionsReader::optional_field(std::string_view key, bool& given, const std::function<void()>& field) {
  const std::size_t before = errors_.size();
  field();
  if (block_.find(key) != nullptr && errors_.size() == before) given = true;
}

void OptionsReader::choice_of(std::string_view key, std::size_t& chosen, const std::vector<std::string>& choices,
                              const FieldDoc& doc) {
  const ConfigEntry* e = entry(key, doc);
  if (e == nullptr) return;
  const ConfigNode& node = e->value;
  const auto found_at = node.is_scalar() ? std::find(choices.begin(), choices.end(), node.text) : choices.end();
  if (found_at != choices.end()) {
    chosen = static_cast<std::size_t>(found_at - choices.begin());
    return;
  }
  const std::string hint = node.is_scalar() ? did_you_mean(node.text, choices) : "";
  fault(key, node.place, "must be one of: " + joined(choices) + "; " + found(node) + hint);
}

void OptionsReader::file(std::string_view key, std::string& value, const FieldDoc& doc) { field(key, value, doc); }

void OptionsReader::group(std::string_view key, const FieldDoc& doc, const std::function<void(FieldVisitor&)>& body) {
  block(key, doc, body);
}

void OptionsReader::block(std::string_view key, const FieldDoc& doc, const std::function<void(RunVisitor&)>& body) {
  const ConfigEntry* e = entry(key, doc);
  if (e == nullptr) return;
  OptionsReader inner(e->value, path(key), e->place, errors_, externals_);
  body(inner);
  inner.finish();
}

void OptionsReader::points(std::string_view key, std::optional<int>& value, const FieldDoc& doc) {
  const ConfigEntry* e = entry(key, doc);
  if (e == nullptr) return;
  if (e->value.is_scalar() && e->value.text == "auto") {
    value.reset();
    return;
  }
  const Parsed<int> parsed = parse_int(e->value);
  const bool in_digits = parsed.fault.starts_with("must be a whole number in digits");
  if (!parsed.value)
    return fault(key, e->value.place,
                 fmt::format("must be a whole number{} or auto ({})",
                             in_digits ? " in digits, without point and exponent," : "", found(e->value)));
  value = *parsed.value;
  check_range(key, e->value, *value, doc);
}

void OptionsReader::finish() {
  for (const ConfigEntry& e : block_.entries) {
    if (is_note(e.key) || std::count(known_.begin(), known_.end(), e.key) > 0) continue;
    std::string hint = did_you_mean(e.key, known_);
    if (hint.empty()) hint = known_.empty() ? "; it has no options" : "; valid keys: " + joined(known_);
    errors_.error(e.place, "unknown key " + in_quotes(e.key) + inside() + hint);
  }
}

}  // namespace leastcost
