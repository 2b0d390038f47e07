// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/cli/commands.hpp"
#include "app/figure/figure_request.hpp"

namespace CLI {
class App;
}

namespace leastcost::app {

/// What the options of all commands write into; a command reads what it has declared.
struct OptionValues {
  std::string config, output, pairs, seed, kind, type, name, mesh, shard, timeout, repetitions, weld, format = "text";
  FigureOptions figure;
  std::vector<std::string> configs, set;
  int parallel = 1;
  DistancesArguments distances;
  FieldArguments field;
  bool force = false, dry_run = false, quiet = false, verbose = false, resume = false;

  bool json_lines() const { return format == "jsonl"; }
  bool json() const { return format == "json"; }
  /// What --set and its short forms say, in their order.
  std::vector<Override> overrides() const;
};

/// The command line while its commands are declared.
struct CommandLine {
  CLI::App& app;
  OptionValues& values;
  const std::vector<std::string>& arguments;  ///< of the program, as they are
  const Streams& streams;
  std::function<Exit()>& chosen;  ///< the command that was given, after parsing
};

/// Each declares a command or a few with their options and help, beside what they do.
void add_run(const CommandLine& line);
void add_study(const CommandLine& line);
void add_merge(const CommandLine& line);
void add_validate(const CommandLine& line);
void add_report(const CommandLine& line);
void add_figure(const CommandLine& line);
void add_reference(const CommandLine& line);  ///< list, describe and schema
void add_init(const CommandLine& line);
void add_doctor(const CommandLine& line);
void add_distances(const CommandLine& line);
void add_field(const CommandLine& line);

// Options that several commands have.
void add_set(CLI::App& command, OptionValues& v);
void add_format(CLI::App& command, OptionValues& v);
void add_output(CLI::App& command, OptionValues& v, const char* help, const char* type);
/// How any picture looks.
void add_look(CLI::App& command, OptionValues& v);

/// An empty name of a folder is a variable of a shell that is not set, not a wish for the default.
std::string empty_fault(const std::string& value);
/// A fault of what an option says is one of the command line.
void read_option(const char* option, const std::function<void()>& value);

}  // namespace leastcost::app
