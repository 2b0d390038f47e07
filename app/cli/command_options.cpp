// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "app/cli/command_options.hpp"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include <filesystem>

#include <leastcost/framework/base/errors.hpp>
#include "catalogue/yaml/suggest.hpp"

namespace leastcost::app {
namespace {

/// `ends: {pairs: FILE}` in the place of the ends that the configuration has. The file is relative to the current
/// folder, as all of the command line is.
Override pairs_option(const std::string& file) {
  std::string quoted = "'";
  for (const char c : std::filesystem::absolute(file).string()) quoted += c == '\'' ? "''" : std::string(1, c);
  return {"ends={pairs: " + quoted + "'}", "--pairs " + file};
}

}  // namespace

std::vector<Override> OptionValues::overrides() const {
  std::vector<Override> all;
  if (!pairs.empty()) all.push_back(pairs_option(pairs));  // before what --set adds to it
  for (const std::string& assignment : set) all.push_back(set_option(assignment));
  if (!seed.empty()) all.push_back(seed_option(seed));
  if (!timeout.empty()) all.push_back({"max_seconds=" + timeout, "--timeout " + timeout});
  if (!repetitions.empty()) all.push_back({"repetitions=" + repetitions, "--repetitions " + repetitions});
  return all;
}

void add_format(CLI::App& command, OptionValues& v) {
  command.add_option("--format", v.format, "text or json")->check(CLI::IsMember({"text", "json"}))->type_name("FORMAT");
}

void add_set(CLI::App& command, OptionValues& v) {
  command.add_option("--set", v.set, "Replace one option of the configuration, e.g. --set solver.max_iterations=50")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
  command.add_option("--seed", v.seed, "Same as --set seed=N")->type_name("N");
}

std::string empty_fault(const std::string& value) { return value.empty() ? "must not be empty" : ""; }

void add_output(CLI::App& command, OptionValues& v, const char* help, const char* type) {
  command.add_option("-o,--output", v.output, help)->type_name(type)->check(empty_fault);
}

void add_look(CLI::App& c, OptionValues& v) {
  constexpr double kLeastDpi = 72, kMostDpi = 1200;
  c.add_option("--width", v.figure.width, "Width in mm, cm, in or pt; default: 84mm, one column")->type_name("WIDTH");
  c.add_option("--font-size", v.figure.font_size, "Font size of all text, in points; default: 8")->type_name("PT");
  c.add_option("--what", v.figure.what, "What to draw: any of " + joined(figure_parts()) + "; default: all that fits")
      ->type_name("LIST");
  c.add_option("--unit", v.figure.unit,
               "Unit of the coordinates, for the axes; default: m if the cost is in m, else none")
      ->type_name("TEXT");
  c.add_option("--dpi", v.figure.dpi, "Pixels per inch of a PNG and of a shaded surface; default: 300")
      ->type_name("N")
      ->check(CLI::Range(kLeastDpi, kMostDpi));
}

void read_option(const char* option, const std::function<void()>& value) {
  try {
    value();
  } catch (const InputError& e) {
    throw CLI::ValidationError(option, e.what());
  }
}

}  // namespace leastcost::app
