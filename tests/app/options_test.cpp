// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// One field list serves reading, writing, describing: shown on options that have every kind of field.
#include <array>
#include <limits>
#include <optional>
#include <variant>

#include "app/reference/field_list.hpp"
#include "catalogue/options/options_reader.hpp"
#include "catalogue/options/options_writer.hpp"
#include "catalogue/yaml/scalars.hpp"
#include "catalogue/yaml/suggest.hpp"
#include "catalogue/yaml/yaml_reader.hpp"
#include "catalogue/yaml/yaml_writer.hpp"
#include "framework/base/point_text.hpp"
#include "problems/formula/edit_distance.hpp"
#include "tests/support/catch.hpp"

namespace leastcost::test {

using Catch::Contains;

namespace {

enum class Mode { fast, slow };
Words<Mode> words(Mode) {
  static constexpr std::array<Word<Mode>, 2> kWords = {{{Mode::fast, "fast"}, {Mode::slow, "slow"}}};
  return kWords;
}

struct Ball {
  static constexpr std::string_view kType = "ball", kHelp = "Round.";
  double radius = 1;
  void fields(FieldVisitor& visit) { visit.field("radius", radius, {.help = "R.", .minimum = 0}); }
};
struct Brick {
  static constexpr std::string_view kType = "brick", kHelp = "Not round.";
  Eigen::VectorXd axes;
  void fields(FieldVisitor& visit) { visit.field("axes", axes, {.help = "A.", .required = true}); }
};
struct NoBody {
  static constexpr std::string_view kType = "point", kHelp = "Neither.";
};
using Shape = std::variant<Ball, Brick, NoBody>;

struct EveryField {
  bool flag = false;
  int count = 3;
  double size = 0.1;
  std::optional<double> unset;
  std::optional<int> absent;
  std::optional<int> zero;
  std::string word = "a word";
  Eigen::VectorXd list;
  Eigen::MatrixXd matrix;
  std::map<std::string, double> parameters;
  std::vector<std::string> equations;
  Mode mode = Mode::fast;
  std::string file;
  std::optional<Shape> shape;
  double inner = 1e-6;
  bool joins = false;
  double within = 0;

  void fields(FieldVisitor& visit) {
    visit.field("flag", flag, {.help = "A flag."});
    visit.field("count", count, {.help = "A count.", .minimum = 1, .maximum = 9});
    visit.field("size", size, {.help = "A size.", .unit = "length", .minimum = 0, .exclusive_minimum = true});
    visit.field("unset", unset, {.help = "Not given unless given."});
    visit.field("absent", absent, {.help = "Not given unless given.", .minimum = 0});
    visit.field_or_zero("zero", zero, {.help = "0: not given.", .minimum = 0});
    visit.field("word", word, {.help = "Text."});
    visit.field("list", list, {.help = "Numbers."});
    visit.field("matrix", matrix, {.help = "Rows."});
    visit.field("parameters", parameters, {.help = "Numbers by name.", .minimum = -5});
    visit.field("equations", equations, {.help = "Texts."});
    visit.choice("mode", mode, {.help = "A choice."});
    visit.file("file", file, {.help = "A file."});
    visit.variant("shape", shape, {.help = "A shape."});
    visit.switch_or_number("joins", joins, within, {.help = "J.", .minimum = 0, .exclusive_minimum = true});
    visit.group("group", {.help = "A group."},
                [this](FieldVisitor& v) { v.field("inner", inner, {.help = "Inside."}); });
  }
};

std::string read(const std::string& text, EveryField& options) {
  Diagnostics errors("a.yaml", text);
  const ConfigNode node = read_yaml(text, errors);
  OptionsReader reader(node, "it", {1, 1, 1, ""}, errors);
  options.fields(reader);
  reader.finish();
  return errors.render();
}

std::string written(EveryField& options, const RenameFile& rename = {}) {
  OptionsWriter writer(rename);
  options.fields(writer);
  return to_yaml(writer.take());
}

const char* const kAll = R"(flag: true
count: 9
size: 1.25e-300
unset: -0.1
absent: 0
zero: 7
word: "true"
list: [0.1, .inf, -.inf, 1.0e+22]
matrix: [[1, 2], [3, 4.5]]
parameters:
  a: 2
  b_1: -0.5
equations: ["x0^2 - 1", x1]
mode: slow
file: a/b.obj
shape:
  type: brick
  axes: [1, 2]
joins: 1.0e-06
group:
  inner: 0.3333333333333333
)";

}  // namespace

TEST_CASE("options: every kind of field is read") {
  EveryField o;
  REQUIRE(read(kAll, o) == "");
  CHECK(o.flag);
  CHECK(o.count == 9);
  CHECK(o.size == 1.25e-300);
  CHECK(o.unset == -0.1);
  CHECK(o.absent == 0);
  CHECK(o.zero == 7);
  CHECK(o.word == "true");
  REQUIRE(o.list.size() == 4);
  CHECK(o.list[3] == 1e22);
  CHECK(o.matrix(1, 1) == 4.5);
  CHECK(o.parameters == std::map<std::string, double>{{"a", 2}, {"b_1", -0.5}});
  CHECK(o.equations == std::vector<std::string>{"x0^2 - 1", "x1"});
  CHECK(o.mode == Mode::slow);
  CHECK(std::get<Brick>(o.shape.value()).axes == Eigen::Vector2d(1, 2));
  CHECK(o.file == "a/b.obj");
  CHECK(o.inner == 0.3333333333333333);
  CHECK((o.joins && o.within == 1e-6));
}

TEST_CASE("options: what is written reads back the same, to the last bit") {
  EveryField o;
  REQUIRE(read(kAll, o) == "");
  CHECK(written(o) == kAll);
}

TEST_CASE("options: defaults are written, what stands for absent is not") {
  EveryField o;
  CHECK(written(o) ==
        "flag: false\ncount: 3\nsize: 0.1\nzero: 0\nword: \"a word\"\nmode: fast\njoins: false\ngroup:\n  inner: "
        "1.0e-06\n");
  EveryField again;
  CHECK(read(written(o), again) == "");
  CHECK_FALSE(again.unset);
  CHECK_FALSE(again.zero);
  CHECK_FALSE(again.shape);
}

TEST_CASE("options: files can be renamed while they are written") {
  EveryField o;
  o.file = "m.obj";
  CHECK_THAT(written(o, [](const std::string& f) { return "../" + f; }), Contains("file: ../m.obj\n"));
}

TEST_CASE("options: a wrong value leaves the default and the others alone") {
  EveryField o;
  const std::string errors = read("count: 12\nflag: true\nmode: medium\nsize: 0\nabsent: -1\ngroup: {outer: 1}\n", o);
  CHECK(o.flag);
  CHECK(o.mode == Mode::fast);
  CHECK_FALSE(o.absent);
  CHECK_THAT(errors, Contains("'absent' in it must be at least 0 (found '-1')"));
  CHECK_THAT(errors, Contains("'count' in it must be at least 1 and at most 9 (found '12')"));
  CHECK_THAT(errors, Contains("'mode' in it must be one of: fast, slow; found 'medium'"));
  CHECK_THAT(errors, Contains("'size' in it must be greater than 0 (found '0')"));
  CHECK_THAT(errors, Contains("unknown key 'outer' in it.group; valid keys: inner"));
}

TEST_CASE("options: the same list describes them") {
  OptionsOf<EveryField> options;
  const std::vector<app::FieldInfo> fields = app::fields_of(options);
  REQUIRE(fields.size() == 16);
  CHECK(fields[14].type_in_words() == "true, false or a number, greater than 0");
  CHECK(fields[14].default_value == "false");
  CHECK(fields[1].type_in_words() == "whole number, at least 1 and at most 9");
  CHECK(fields[1].default_value == "3");
  CHECK(fields[2].type_in_words() == "number, greater than 0");
  CHECK(fields[2].unit == "length");
  CHECK(fields[3].default_value == "");
  CHECK(fields[4].default_value == "");
  CHECK(fields[5].default_value == "0");
  CHECK(fields[9].type_in_words() == "block of names and numbers, at least -5");
  CHECK(fields[10].type_in_words() == "text or list of texts");
  CHECK(fields[11].type_in_words() == "one of fast, slow");
  CHECK(fields[13].type_in_words() == "a type, or a block with a type, of ball, brick, point");
  REQUIRE(fields[13].children.size() == 3);
  CHECK((fields[13].children[1].key == "brick" && fields[13].children[1].children[0].key == "axes"));
  REQUIRE(fields[15].children.size() == 1);
  CHECK(fields[15].children[0].key == "inner");
}

TEST_CASE("options: a switch that a number may stand in the place of") {
  EveryField o;
  CHECK(read("joins: true\n", o) == "");
  CHECK((o.joins && o.within == 0));
  CHECK_THAT(written(o), Contains("joins: true\n"));
  CHECK(read("joins: 0.5\n", o) == "");
  CHECK((o.joins && o.within == 0.5));
  CHECK(read("joins: false\n", o) == "");
  CHECK((!o.joins && o.within == 0));
  CHECK_THAT(read("joins: 0\n", o), Contains("'joins' in it must be greater than 0 (found '0')"));
  CHECK_THAT(read("joins: on\n", o), Contains("'joins' in it must be true, false or a number (found 'on')"));
}

TEST_CASE("options: a block whose type says which fields it has") {
  EveryField o;
  REQUIRE(read("shape: {type: ball, radius: 2}\n", o) == "");
  CHECK(std::get<Ball>(o.shape.value()).radius == 2);
  REQUIRE(read("shape: point\n", o) == "");
  CHECK_THAT(written(o), Contains("shape:\n  type: point\n"));
  CHECK_THAT(read("shape: {type: ball, axes: [1]}\n", o), Contains("unknown key 'axes' in it.shape"));
  CHECK_THAT(read("shape: {type: ball, radius: -1}\n", o), Contains("'radius' in it.shape must be at least 0"));
  CHECK_THAT(read("shape: brick\n", o), Contains("missing key 'axes' in it.shape"));
  CHECK_THAT(read("shape: {type: bal}\n", o),
             Contains("unknown type 'bal' of it.shape (did you mean 'ball'?); valid types: ball, brick, point"));
  CHECK_THAT(read("shape: {radius: 1}\n", o), Contains("missing key 'type' in it.shape: one of ball, brick, point"));
  CHECK_THAT(read("shape: [ball]\n", o), Contains("'it.shape' must be a type or a block with a type"));
}

TEST_CASE("options: numbers by name and lists of texts, right and wrong") {
  EveryField o;
  REQUIRE(read("parameters: {x-note: why, a: 1}\nequations: x0 - 1\n", o) == "");
  CHECK(o.parameters == std::map<std::string, double>{{"a", 1}});
  CHECK(o.equations == std::vector<std::string>{"x0 - 1"});
  const std::string errors = read("parameters:\n  a: two\n  b: -7\n  c:\nequations: []\n", o);
  CHECK_THAT(errors, Contains("a.yaml:2:6: error: 'parameters.a' in it must be a finite number (found 'two')"));
  CHECK_THAT(errors, Contains("a.yaml:3:6: error: 'parameters.b' in it must be at least -5 (found '-7')"));
  CHECK_THAT(errors, Contains("a.yaml:4:3: error: 'parameters.c' in it must be a finite number (found nothing)"));
  CHECK_THAT(errors, Contains("'equations' in it must not be an empty list"));
  CHECK_THAT(read("parameters: [1, 2]\n", o), Contains("must be a block of names and numbers, like {a: 2, b: 1}"));
  CHECK_THAT(read("equations: [x0, {a: 1}]\n", o), Contains("has an entry that must be text (found a block of keys)"));
}

TEST_CASE("suggestions: near words only") {
  CHECK(edit_distance("kitten", "sitting") == 3);
  CHECK(edit_distance("ab", "ba") == 1);
  CHECK(edit_distance("", "abc") == 3);
  const std::vector<std::string> words = {"euclidean", "metric_tensor", "travel_time"};
  CHECK(nearest_word("euclidian", words) == "euclidean");
  CHECK(nearest_word("Travel_Time", words) == "travel_time");
  CHECK(nearest_word("metric", words) == "metric_tensor");
  CHECK(nearest_word("potato", words) == "");
  CHECK(nearest_word("", words) == "");
  CHECK(nearest_word(std::string(100000, 'x'), words) == "");
}

TEST_CASE("numbers: shortest text that reads back") {
  for (const double x : {0.1, 1.0 / 3, 1e-300, 5e-324, 1e22, -2.5, 0.0, 1e-6, 123456789.123456789}) {
    const Parsed<double> parsed = parse_double(scalar_node(number_text(x)));
    CAPTURE(x, number_text(x), parsed.fault);
    CHECK(parsed.value == x);
  }
}

TEST_CASE("numbers: two that a message compares are printed so that they differ, and by how much") {
  const auto texts = [](double a, double b, int digits = 3) {
    const TwoNumbers both = told_apart(a, b, digits);
    return both.first + " " + both.second;
  };
  CHECK(texts(2, 3.124) == "2 3.12");
  CHECK(texts(20000000, 20000001.25) == "20000000 20000001.25");
  CHECK(texts(1e-12, 2e-12) == "1e-12 2e-12");
  CHECK(texts(1 + 1e-9, 1) == "1.000000001 1");
  CHECK(texts(5, 5) == "5 5");
  CHECK(texts(1, std::numeric_limits<double>::infinity(), 9) == "1 inf");
}

}  // namespace leastcost::test
