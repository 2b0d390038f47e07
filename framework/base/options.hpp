// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include <leastcost/eigen_alignment.hpp>

#include <leastcost/framework/base/words.hpp>

namespace leastcost {

/// What a reader of the reference page needs to know about one option.
struct FieldDoc {
  std::string_view help;       ///< one sentence
  std::string_view unit = "";  ///< "length", "m/s^2", "relative cost error", ... ; empty: a plain number
  double minimum = -std::numeric_limits<double>::infinity();  ///< least value that is allowed, see exclusive_minimum
  double maximum = std::numeric_limits<double>::infinity();   ///< greatest value that is allowed
  bool exclusive_minimum = false;                             ///< the minimum itself is not allowed
  bool required = false;                                      ///< whether a configuration has to set it
};

class FieldVisitor;

/// One of several forms that a nested block can take, see FieldVisitor::variant().
struct FieldVariant {
  std::string type;                                ///< its name in configurations
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
/// the reference page. The default is the value the struct holds before the visit. A choice is an enum, "not given" a
/// std::optional, options of which one set excludes the others a std::variant of structs:
///
///     enum class Rule { chute, midpoint };
///     Words<Rule> words(Rule);                               // {Rule::chute, "chute"}, {Rule::midpoint, "midpoint"}
///     visit.choice("rule", rule, doc);                       // rule: midpoint
///
///     std::optional<double> level;
///     visit.field("level", level, doc);                      // level: 2.5, or no such key
///
///     struct Torus {
///       static constexpr std::string_view kType = "torus", kHelp = "Around the z axis.";
///       double radius = 2;
///       void fields(FieldVisitor& visit);                    // a form without options has none
///     };
///     std::variant<Plane, Torus> surface;
///     visit.variant("surface", surface, doc);                // surface: plane, or {type: torus, radius: 3}
class FieldVisitor {
 public:
  virtual ~FieldVisitor() = default;
  virtual void field(std::string_view key, bool& value, const FieldDoc& doc) = 0;
  virtual void field(std::string_view key, int& value, const FieldDoc& doc) = 0;
  virtual void field(std::string_view key, double& value, const FieldDoc& doc) = 0;
  /// A text. An empty one is a required text that is still missing.
  virtual void field(std::string_view key, std::string& value, const FieldDoc& doc) = 0;
  /// A vector: a list of numbers. An empty one is a required vector that is still missing.
  virtual void field(std::string_view key, Eigen::VectorXd& value, const FieldDoc& doc) = 0;
  /// A matrix: a list of rows of equal length. An empty one is a required matrix that is still missing.
  virtual void field(std::string_view key, Eigen::MatrixXd& value, const FieldDoc& doc) = 0;
  /// Numbers by name, {a: 2, b: 1}: the parameters of a formula. The names are free.
  virtual void field(std::string_view key, std::map<std::string, double>& value, const FieldDoc& doc) = 0;
  /// Texts: a list, or a single one. An empty list counts as absent.
  virtual void field(std::string_view key, std::vector<std::string>& value, const FieldDoc& doc) = 0;
  /// A switch that a number may stand in the place of: {weld: true}, or {weld: 1e-6}, which is on with that number. 0:
  /// none is given. The range of `doc` is that of the number.
  virtual void switch_or_number(std::string_view key, bool& on, double& number, const FieldDoc& doc) = 0;
  /// A path to a file, relative to the folder of the configuration.
  virtual void file(std::string_view key, std::string& value, const FieldDoc& doc) = 0;
  /// A nested block with fields of its own.
  virtual void group(std::string_view key, const FieldDoc& doc, const std::function<void(FieldVisitor&)>& body) = 0;

  /// What may be left out: without its key it keeps its default, or has no value.
  template <class T>
  void field(std::string_view key, std::optional<T>& value, const FieldDoc& doc) {
    bool given = value.has_value();
    T inner = given ? *value : T{};
    optional_field(key, given, [&] { field(key, inner, doc); });
    value = given ? std::optional<T>(std::move(inner)) : std::nullopt;
  }

  /// A number that a configuration writes as 0 where it is not given, as in {radius: 0}.
  template <class Number>
  void field_or_zero(std::string_view key, std::optional<Number>& value, const FieldDoc& doc) {
    Number number = value.value_or(Number(0));
    field(key, number, doc);
    value = number == 0 ? std::nullopt : std::optional<Number>(number);
  }

  /// One value of an enum, by its word.
  template <Choice Enum>
  void choice(std::string_view key, Enum& value, const FieldDoc& doc) {
    const Words<Enum> all = words(value);
    std::vector<std::string> list;
    std::size_t chosen = 0;
    for (const Word<Enum>& w : all) {
      if (w.value == value) chosen = list.size();
      list.emplace_back(w.word);
    }
    choice_of(key, chosen, list, doc);
    value = all[chosen].value;
  }

  /// A nested block whose `type` says which fields it has: {type: torus, major_radius: 2}, or the word alone.
  template <class... Forms>
  void variant(std::string_view key, std::variant<Forms...>& value, const FieldDoc& doc) {
    std::optional<std::variant<Forms...>> given(value);
    variant(key, given, doc);
    value = *given;
  }
  /// The same, which may be left out.
  template <class... Forms>
  void variant(std::string_view key, std::optional<std::variant<Forms...>>& value, const FieldDoc& doc) {
    std::tuple<Forms...> forms;  // that of the value, the others with their defaults
    std::optional<std::size_t> chosen;
    if (value) {
      chosen = value->index();
      std::visit([&]<class Form>(const Form& form) { std::get<Form>(forms) = form; }, *value);
    }
    variant_of(key, chosen, {described(std::get<Forms>(forms))...}, doc);
    if (!chosen) return value.reset();
    [&]<std::size_t... I>(std::index_sequence<I...>) {
      ((*chosen == I ? (value.emplace(std::in_place_index<I>, std::get<I>(forms)), 0) : 0), ...);
    }
    (std::index_sequence_for<Forms...>());
  }

 protected:
  /// A field that may be absent; `given`: whether it is there. `field` visits it as one that is.
  virtual void optional_field(std::string_view key, bool& given, const std::function<void()>& field) = 0;
  /// One of several words, by its position.
  virtual void choice_of(std::string_view key, std::size_t& chosen, const std::vector<std::string>& choices,
                         const FieldDoc& doc) = 0;
  /// One of several forms, by its position; none: absent.
  virtual void variant_of(std::string_view key, std::optional<std::size_t>& chosen,
                          const std::vector<FieldVariant>& variants, const FieldDoc& doc) = 0;

 private:
  template <class Form>
  static FieldVariant described(Form& form) {
    FieldVariant out{std::string(Form::kType), Form::kHelp};
    if constexpr (requires(FieldVisitor & visit) { form.fields(visit); })
      out.fields = [&form](FieldVisitor& visit) { form.fields(visit); };
    return out;
  }
};

/// Options of a plug-in that has none.
struct NoOptions {
  void fields(FieldVisitor&) {}
};

}  // namespace leastcost
