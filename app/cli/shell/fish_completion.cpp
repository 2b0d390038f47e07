// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string_view>

#include "app/cli/shell/completion.hpp"

namespace leastcost::app {
namespace {

std::string fish_text(std::string_view text) {
  std::string out = "'";
  for (const char c : text) {
    if (c == '\'' || c == '\\') out += '\\';
    out += c == '\n' ? ' ' : c;
  }
  return out + "'";
}

/// What follows a name that takes a value.
std::string fish_value(const CommandOption& option) {
  switch (option.completes) {
    case Completes::nothing: return "";
    case Completes::anything:
    case Completes::types: return " -x";
    case Completes::words: return fmt::format(" -x -a '{}'", fmt::join(option.words, " "));
    case Completes::files:
      if (option.words.empty()) return " -r -F";
      return fmt::format(" -x -a '(__leastcost_files {})'", fmt::join(option.words, " "));
    case Completes::folders: return " -x -a '(__fish_complete_directories)'";
    case Completes::keys: return " -x -a '(__leastcost_settings)'";
  }
  return "";
}

std::string fish_option(const CommandOption& option, const std::string& condition) {
  std::string out = "complete -c leastcost" + condition;
  for (const std::string& name : option.names)
    out += name.rfind("--", 0) == 0 ? " -l " + name.substr(2) : " -s " + name.substr(1);
  return out + fish_value(option) + " -d " + fish_text(option.help) + "\n";
}

constexpr const char* kFishHead = R"fish(# Completion of leastcost for fish, made by: leastcost completion fish
function __leastcost_files
    for extension in $argv
        __fish_complete_suffix .$extension
    end
end
function __leastcost_settings
    set -l key (string match -r '^.*(?==)' -- (commandline -ct))
    switch "$key"
)fish";

/// An argument that takes the types of the kind before it, or the kinds themselves.
std::string fish_argument(const CommandOption& argument, const std::string& command, const std::string& condition) {
  if (argument.completes == Completes::types) {
    std::string out;
    for (const WordsOfKind& kind : words_of_kinds())
      out += fmt::format(
          "complete -c leastcost -n '__fish_seen_subcommand_from {}; and __fish_seen_subcommand_from {}' -a '{}'\n",
          command, kind.kind, fmt::join(kind.types, " "));
    return out;
  }
  if (argument.completes == Completes::words)
    return fmt::format(
        "complete -c leastcost -n '__fish_seen_subcommand_from {}; and not __fish_seen_subcommand_from {}' -a '{}'\n",
        command, fmt::join(argument.words, " "), fmt::join(argument.words, " "));
  const std::string value = fish_value(argument);
  return "complete -c leastcost" + condition + (value == " -r -F" ? " -F" : value) + "\n";
}

}  // namespace

std::string fish_completion(const CommandTable& table) {
  std::string out = kFishHead;
  for (const WordsOfKind& kind : words_of_kinds())
    out += fmt::format("        case {}\n            printf '{}=%s\\n' {}\n", kind.kind, kind.kind,
                       fmt::join(kind.types, " "));
  out += fmt::format("        case '*'\n            printf '%s=\\n' {}\n    end\nend\n",
                     fmt::join(configuration_keys(), " "));
  out += "complete -c leastcost -f\n";
  for (const CommandOption& option : table.program.options) out += fish_option(option, " -n __fish_use_subcommand");
  for (const CommandHelp& command : table.commands) {
    out += fmt::format("\ncomplete -c leastcost -n __fish_use_subcommand -a {} -d {}\n", command.name,
                       fish_text(command.help));
    const std::string condition = fmt::format(" -n '__fish_seen_subcommand_from {}'", command.name);
    for (const CommandOption& option : command.options) out += fish_option(option, condition);
    for (const CommandOption& argument : command.arguments) out += fish_argument(argument, command.name, condition);
  }
  return out;
}

}  // namespace leastcost::app
