// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace CLI {  // NOLINT(readability-identifier-naming): of CLI11
class App;
}

namespace leastcost::app {

/// The last lines of --help, of the program and of each command.
inline constexpr const char* kExitCodes =
    "Exit codes: 0 certified (of many pairs: all; of a study: every cell ended), 1 internal error, 2 usage,\n"
    "3 configuration, 4 input, 5 uncertified or collapsed (of many pairs: some, but all have a path), 6 no path,\n"
    "7 part of a study or of many pairs failed, 8 output or system error,\n"
    "130 interrupted (a study and many pairs: resume with --resume)";

/// What may stand where an argument or the value of an option is asked for.
enum class Completes {
  nothing,  ///< it takes no value
  anything,
  words,  ///< those listed
  keys,   ///< an option of a configuration, `solver.tolerance=1e-9`
  types,  ///< a plug-in of the kind that stands before it
  files,  ///< with one of the listed extensions, if there are any
  folders
};

/// An option of a command or one of its arguments, as --help has it.
struct CommandOption {
  std::vector<std::string> names;  ///< "-o", "--output"; of an argument: "config"
  std::string value, help;         ///< value: "DIR"; empty: it is a flag
  Completes completes = Completes::nothing;
  std::vector<std::string> words;  ///< or extensions
  bool required = false, repeats = false;
};

struct CommandHelp {
  std::string name, help, footer;  ///< footer: without the exit codes
  std::vector<CommandOption> options, arguments;
};

/// The program and its commands: what man pages and completions are made of, so that they say what --help says.
struct CommandTable {
  CommandHelp program;
  std::vector<CommandHelp> commands;
};

CommandTable command_table(const CLI::App& app);

/// One kind of plug-in and its types, for completion.
struct WordsOfKind {
  std::string kind;
  std::vector<std::string> types;
};
std::vector<WordsOfKind> words_of_kinds();

/// Options of a configuration with their blocks: "name", "path.points", ...
std::vector<std::string> configuration_keys();

}  // namespace leastcost::app
