// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "catalogue/yaml/yaml_reader.hpp"

#include <random>

#include "catalogue/yaml/yaml_writer.hpp"
#include "tests/app/config_text.hpp"
#include "tests/support/catch.hpp"

namespace leastcost::test {

using Catch::Contains;

namespace {

std::string yaml_errors(const std::string& text) {
  Diagnostics errors("a.yaml", text);
  read_yaml(text, errors);
  return errors.render();
}

ConfigNode tree(const std::string& text) {
  Diagnostics errors("a.yaml", text);
  ConfigNode node = read_yaml(text, errors);
  INFO(errors.render());
  REQUIRE(errors.empty());
  return node;
}

/// Same keys, values and quotes; places do not count.
bool same(const ConfigNode& a, const ConfigNode& b) {
  if (a.kind != b.kind || a.text != b.text || a.quoted != b.quoted) return false;
  if (a.items.size() != b.items.size() || a.entries.size() != b.entries.size()) return false;
  for (std::size_t i = 0; i < a.items.size(); ++i)
    if (!same(a.items[i], b.items[i])) return false;
  for (std::size_t i = 0; i < a.entries.size(); ++i)
    if (a.entries[i].key != b.entries[i].key || !same(a.entries[i].value, b.entries[i].value)) return false;
  return true;
}

}  // namespace

TEST_CASE("yaml: a tree with places") {
  const ConfigNode root = tree("a: 1\nb:\n  - x\n  - \"y z\"\nc: {d: [1, 2]}\n");
  REQUIRE(root.entries.size() == 3);
  CHECK(root.find("a")->value.text == "1");
  CHECK(root.find("b")->value.items[1].quoted);
  CHECK(root.find("b")->value.items[1].place.line == 4);
  CHECK(root.find("b")->value.items[1].place.column == 5);
  CHECK(root.find("b")->value.items[1].place.length == 5);
  CHECK(place_of(root, "c.d.1").column == 12);
  CHECK(place_of(root, "c.missing").line == 5);
  CHECK(place_of(root, "c.d.9").column == 8);
}

TEST_CASE("yaml: duplicate keys are errors at the second one") {
  CHECK(yaml_errors("a: 1\nb: 2\na: 3\n") ==
        "a.yaml:3:1: error: duplicate key 'a' (first given on line 1)\n    3 | a: 3\n      | ^\n");
  CHECK_THAT(yaml_errors("s: {type: x, type: y}\n"), Contains("a.yaml:1:14: error: duplicate key 'type'"));
}

TEST_CASE("yaml: one document only") {
  CHECK_THAT(yaml_errors("a: 1\n---\nb: 2\n"),
             Contains("a configuration must be one document, but another one starts here"));
  CHECK(yaml_errors("---\na: 1\n") == "");
  CHECK(yaml_errors("---\na: 1\n...\n") == "");
}

TEST_CASE("yaml: no aliases, anchors, merge keys or tags") {
  CHECK_THAT(yaml_errors("a: &x 1\nb: *x\n"),
             Contains("a.yaml:1:4: error: anchors") && Contains("a.yaml:2:4: error: aliases"));
  CHECK_THAT(yaml_errors("<<: {a: 1}\n"), Contains("merge keys (<<) are not supported"));
  CHECK_THAT(yaml_errors("a: !!int 3\n"), Contains("tags ("));
  CHECK_THAT(yaml_errors("? [1, 2]\n: 3\n"), Contains("a key must be a word (found a list)"));
}

TEST_CASE("yaml: an alias bomb is a list of errors, not of gigabytes") {
  std::string bomb = "a0: &a0 [x, x, x, x, x, x, x, x, x]\n";
  for (int i = 1; i < 12; ++i) {
    const std::string here = std::to_string(i), last = std::to_string(i - 1);
    bomb.append("a").append(here).append(": &a").append(here).append(" [*a").append(last);
    for (int k = 0; k < 8; ++k) bomb.append(", *a").append(last);
    bomb.append("]\n");
  }
  CHECK_THAT(yaml_errors(bomb), Contains("aliases"));
}

TEST_CASE("yaml: tabs, encodings and sizes") {
  CHECK(yaml_errors("a:\n\tb: 1\n") ==
        "a.yaml:2:1: error: a tab in the indentation: use spaces\n    2 | \tb: 1\n      | ^\n");
  CHECK(yaml_errors("a: 1\t# a tab after a value is fine\n") == "");
  CHECK_THAT(yaml_errors(std::string("a: b\0c\n", 7)), Contains("a.yaml:1:5: error: not UTF-8 text"));
  CHECK_THAT(yaml_errors("a: \xff\xfe\n"), Contains("a.yaml:1:4: error: not UTF-8 text"));
  CHECK_THAT(yaml_errors("a: \xc0\xaf\n"), Contains("not UTF-8 text"));
  CHECK_THAT(yaml_errors("a: \xed\xa0\x80\n"), Contains("not UTF-8 text"));
  CHECK(tree("\xef\xbb\xbf"
             "a: 1\n")
            .find("a") != nullptr);
  CHECK(tree("a: 1\r\nb: 2\r\n").find("b")->value.text == "2");
  CHECK_THAT(yaml_errors(std::string((1 << 20) + 1, '#')), Contains("a configuration can have at most 1048576 bytes"));
}

TEST_CASE("yaml: broken texts give one error with a place") {
  CHECK_THAT(yaml_errors("a: [1, 2\nb: 3\n"), Contains("a.yaml:") && Contains("YAML: "));
  CHECK(yaml_errors("a: 'open\n") == "a.yaml:1:4: error: the quote is never closed\n    1 | a: 'open\n      |    ^\n");
  CHECK_THAT(yaml_errors("a: \"open \\\""), Contains("YAML: "));
  CHECK(yaml_errors("a: 'it''s'\nb: \"say \\\"x\\\"\"\nc: 'over\n  two lines'\nd: |\n  it's\n") == "");
  CHECK_THAT(errors_of("just a word\n"), Contains("the configuration must be a block of keys (found 'just a word')"));
  CHECK_THAT(errors_of(""), Contains("the configuration must be a block of keys (found nothing)"));
  CHECK_THAT(errors_of("# only a comment\n"), Contains("found nothing"));
  CHECK_THAT(errors_of("- a\n- b\n"), Contains("found a list"));
  CHECK_THAT(errors_of(kPlane + "kernel:\n"),
             Contains("a.yaml:6:1: error: 'kernel' has no value: remove the key to use the default"));
}

TEST_CASE("yaml: nesting without end is an error") {
  CHECK(yaml_errors(std::string(100000, '[')) != "");
  CHECK(yaml_errors(std::string(5000, '{')) != "");
  std::string deep;
  for (int i = 0; i < 2000; ++i) deep += std::string(static_cast<std::size_t>(i), ' ') + "a:\n";
  CHECK_NOTHROW(yaml_errors(deep));
}

TEST_CASE("yaml: what is written reads back as the same tree") {
  for (const char* text : {"a: 1\nb: [1, 2.5, -3]\nc:\n  d: word\n  e: \"two words\"\n",
                           "m: [[1, 0], [0, 1]]\nlist: [{type: x, n: 1}, z]\n",
                           "t: \"true\"\nn: \"12\"\nq: \"a \\\"quoted\\\" \\\\ text\\x07\"\nempty: {}\nnone: []\n",
                           "f: ../some/file.obj\ng: /abs/file.obj\n"}) {
    CAPTURE(text);
    const ConfigNode first = tree(text);
    CHECK(same(first, tree(to_yaml(first))));
  }
}

TEST_CASE("yaml: random damage never crashes, hangs or escapes as an exception") {
  const std::string good =
      kPlane + "solver: {type: lbfgs, memory: 5}\npost_process: []\nname: \"a b\"\nlist: [[1, 2], [3, 4]]\n";
  std::mt19937 engine(20260501);  // NOLINT: a fixed seed, so that a failure can be repeated
  const std::string alphabet = "{}[]:,-&*!|>'\"%@`#?\n\t \\0a\xff\xc3~.<";
  for (int round = 0; round < 1500; ++round) {
    std::string text = good;
    if (round % 3 == 0) text.resize(engine() % text.size());
    for (auto flips = engine() % 6; flips > 0 && !text.empty(); --flips) {
      const std::size_t at = engine() % text.size();
      if (engine() % 2 == 0)
        text[at] = alphabet[engine() % alphabet.size()];
      else
        text.insert(at, 1, alphabet[engine() % alphabet.size()]);
    }
    CAPTURE(round, text);
    std::string rendered;
    REQUIRE_NOTHROW(rendered = errors_of(text));
    for (const char c : rendered) REQUIRE((c == '\n' || c == '\t' || static_cast<unsigned char>(c) >= 0x20));
  }
}

TEST_CASE("yaml: every truncation of a configuration is read or refused") {
  const std::string good = kPlane + "solver: {type: lbfgs, memory: 5}\ncertificate:\n  enabled: false\n";
  for (std::size_t length = 0; length < good.size(); ++length) {
    CAPTURE(length);
    CHECK_NOTHROW(errors_of(good.substr(0, length)));
  }
}

}  // namespace leastcost::test
