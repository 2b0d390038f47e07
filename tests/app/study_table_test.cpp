// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>

#include <leastcost/framework/base/errors.hpp>
#include "app/study/rows/run_table.hpp"
#include "catalogue/output/csv_text.hpp"
#include "tests/support/catch.hpp"

namespace leastcost::test {

using Catch::Contains;

namespace {

app::RunTable table() {
  app::RunTable out{{"path.cascade", "a,b"}, {}};
  app::RunRow& row = out.rows.emplace_back();
  row.cell = 7;
  row.repetition = 1;
  row.problem = "torus, \"thin\"";
  row.solver = "newton";
  row.points = 20;
  row.swept = {"true", "two\nlines"};
  row.outcome = app::outcome::kOk;
  row.cost = 0.1;
  row.cost_error_bar = std::numeric_limits<double>::quiet_NaN();
  row.spacing = std::numeric_limits<double>::infinity();
  row.s_solve = 1e-300;
  app::RunRow& failed = out.rows.emplace_back();
  failed.cell = 8;
  failed.swept = {"false", ""};
  failed.outcome = app::outcome::kCrash;
  return out;
}

}  // namespace

TEST_CASE("runs.csv reads back as it was, to the last bit") {
  const std::string text = app::runs_csv(table());
  const app::RunTable back = app::read_runs_csv(text, "runs.csv");
  CHECK(app::runs_csv(back) == text);
  CHECK(back.swept_keys == table().swept_keys);
  REQUIRE(back.rows.size() == 2);
  CHECK(back.rows[0].problem == "torus, \"thin\"");
  CHECK(back.rows[0].swept[1] == "two\nlines");
  CHECK(back.rows[0].cost == 0.1);
  CHECK(std::isnan(back.rows[0].cost_error_bar.value()));
  CHECK(std::isinf(back.rows[0].spacing.value()));
  CHECK(back.rows[0].s_solve == 1e-300);
  CHECK_FALSE(back.rows[0].optimum.has_value());
  CHECK_FALSE(back.rows[1].points.has_value());
  CHECK(back.rows[1].outcome == "crash");
}

TEST_CASE("runs.csv: a text that a spreadsheet would take for a formula is none, a number stays a number") {
  app::RunTable formulas = table();
  const std::vector<std::string> texts = {"=1+1", "+x", "-cmd", "@SUM(A1)", "\tx", "'quoted'", "=\"a\",b", "'"};
  for (const std::string& text : texts) {
    CAPTURE(text);
    const std::string field = csv_text_field(text);
    CHECK((field[0] == '\'' || field.substr(0, 2) == "\"'"));
    formulas.rows[0].problem = formulas.rows[0].message = text;
    const app::RunTable back = app::read_runs_csv(app::runs_csv(formulas), "runs.csv");
    CHECK(back.rows[0].problem == text);
    CHECK(back.rows[0].message == text);
  }
  for (const std::string number : {"-1", "+2.5", "-1e-3", "-inf", "plain", ""}) CHECK(csv_text_field(number) == number);
}

TEST_CASE("runs.csv: windows line breaks and other column orders are read") {
  std::string text = app::runs_csv(table());
  for (std::size_t at = 0; (at = text.find("\n", at)) != std::string::npos; at += 2)
    if (text.compare(at, 6, "\nlines") != 0) text.insert(at, "\r");
  CHECK(app::runs_csv(app::read_runs_csv(text, "runs.csv")) == app::runs_csv(table()));
}

TEST_CASE("traces.csv reads back as it was") {
  const std::vector<app::TraceRow> rows = {{0, 0, 1, 3, 0.25, 1.5, std::nan(""), 1e-3}, {2, 1, 0, 1, 0, 7, 1, 0}};
  const std::string text = app::traces_csv(rows);
  CHECK(app::traces_csv(app::read_traces_csv(text, "traces.csv")) == text);
}

TEST_CASE("runs.csv: what cannot be read is named with its line") {
  std::string text = app::runs_csv(table());
  CHECK_THROWS_WITH(app::read_runs_csv("", "runs.csv"), Contains("runs.csv: is empty"));
  CHECK_THROWS_WITH(app::read_runs_csv("cell,repetition\n1,2\n", "runs.csv"), Contains("has no column 'problem'"));
  CHECK_THROWS_WITH(app::read_runs_csv(text + "1,2\n", "runs.csv"), Contains("runs.csv:5: has 2 fields"));
  CHECK_THROWS_WITH(app::read_traces_csv("cell,repetition,iteration,evaluations,seconds,energy,cost_error,step\n"
                                         "0,0,1,2,3,4,x,5\n",
                                         "t.csv"),
                    Contains("t.csv:2: column 'cost_error' must hold a number (found 'x')"));
  CHECK_THROWS_WITH(csv_records("a,\"b\nc", "t.csv"), Contains("t.csv:1: a quote is never closed"));
}

}  // namespace leastcost::test
