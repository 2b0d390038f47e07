// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// The targets of tests/fuzz without a fuzzer: their corpora, and what becomes of them by a few thousand changes.
#include <cstdlib>
#include <random>

#include "tests/fuzz/targets.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/data.hpp"

namespace leastcost::test {
namespace {

namespace fs = std::filesystem;

/// Makes other inputs of one: cuts, repeats, changes bytes, puts in what readers stumble over.
class Mutator {
 public:
  explicit Mutator(unsigned seed) : engine_(seed) {}

  std::string changed(std::string text) {
    for (std::size_t times = 1 + below(4); times > 0; --times) change(text);
    return text;
  }

 private:
  std::size_t below(std::size_t n) {
    return n == 0 ? 0 : std::uniform_int_distribution<std::size_t>(0, n - 1)(engine_);
  }

  void change(std::string& text) {
    static const std::vector<std::string> kStumbles = {
        "-1",   "1e999",      "nan", "4294967296", "-9223372036854775808",
        "\n",   "\"",         "[[[", "{",          std::string(1, '\0'),
        "\xff", "0.1.2",      ",,",  "'",          ": ",
        "(",    "1000000000", "\r",  "null",       "^^"};
    const std::size_t at = below(text.size() + 1), length = below(16);
    switch (below(5)) {
      case 0: text.resize(at); break;
      case 1: text.erase(at, length); break;
      case 2: text.insert(at, text.substr(below(text.size()), length)); break;
      case 3: text.insert(at, kStumbles[below(kStumbles.size())]); break;
      default:
        if (at < text.size()) text[at] = static_cast<char>(below(256));
    }
  }

  std::mt19937 engine_;
};

std::vector<std::string> corpus(const std::string& name) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(project_dir() / "tests/fuzz/corpus" / name))
    files.push_back(entry.path());
  std::sort(files.begin(), files.end());  // in the same order everywhere
  std::vector<std::string> texts;
  for (const fs::path& file : files) texts.push_back(content(file));
  return texts;
}

}  // namespace

TEST_CASE("fuzz: every reader takes its corpus, and what becomes of it by chance, or says why not") {
  constexpr int kChanges = 300;
  for (const fuzz::Target& target : fuzz::targets()) {
    CAPTURE(target.name);
    const std::vector<std::string> texts = corpus(target.name);
    REQUIRE_FALSE(texts.empty());
    unsigned seed = 0;
    for (const std::string& text : texts) {
      CAPTURE(text);
      CHECK_NOTHROW(fuzz::ask(target, text));
      Mutator mutator(++seed);
      for (int i = 0; i < kChanges; ++i) {
        const std::string changed = mutator.changed(text);
        INFO(changed);
        REQUIRE_NOTHROW(fuzz::ask(target, changed));
      }
    }
    REQUIRE_NOTHROW(fuzz::ask(target, ""));
  }
}

TEST_CASE("fuzz: the corpora are what the readers read") {
  // A corpus that is refused at its first byte leaves a fuzzer nothing to change.
  for (const fuzz::Target& target : fuzz::targets()) {
    CAPTURE(target.name);
    int taken = 0;
    for (const std::string& text : corpus(target.name)) {
      try {
        target.read(text);
        ++taken;
      } catch (const Error& e) {
        UNSCOPED_INFO(e.what());
      }
    }
    CHECK(taken > 0);
  }
}

}  // namespace leastcost::test
