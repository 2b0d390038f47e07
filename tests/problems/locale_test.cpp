// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <clocale>
#include <string>

#include "problems/readers/text_scanner.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/data.hpp"

namespace leastcost::test {
namespace {

/// The numeric locale of the process, until the end of the test.
class NumericLocale {
 public:
  explicit NumericLocale(const char* name) : before_(std::setlocale(LC_NUMERIC, nullptr)) {
    set_ = std::setlocale(LC_NUMERIC, name) != nullptr;
  }
  ~NumericLocale() { std::setlocale(LC_NUMERIC, before_.c_str()); }
  NumericLocale(const NumericLocale&) = delete;
  NumericLocale& operator=(const NumericLocale&) = delete;
  bool set() const { return set_; }

 private:
  std::string before_;
  bool set_ = false;
};

double number(const std::string& text) {
  TextScanner scanner(text, "m", {});
  scanner.next_line();
  return scanner.number("a number");
}

void check_numbers() {
  CHECK(number("2.5e-400") == 0);
  CHECK(number("-2.5e-400") == 0);
  CHECK(number("1.5e-310") == 1.5e-310);
  CHECK(number("2.5") == 2.5);
  CHECK_THROWS_WITH(number("2.5e400"), Catch::Contains("finite"));
  CHECK_THROWS_WITH(number("-2.5e400"), Catch::Contains("finite"));
}

}  // namespace

TEST_CASE("readers: numbers do not depend on the locale of the host", "[problems]") {
  check_numbers();
  for (const char* name : {"de_DE.UTF-8", "de_DE.utf8", "de_DE"}) {
    const NumericLocale german(name);
    if (german.set()) return check_numbers();
  }
  record_skip("LC_NUMERIC=de_DE", "the locale is not installed");
}

}  // namespace leastcost::test
