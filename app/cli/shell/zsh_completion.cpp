// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string_view>

#include "app/cli/shell/completion.hpp"

namespace leastcost::app {
namespace {

/// A sentence inside the single quotes of a specification of _arguments: on one line, its marks escaped.
std::string zsh_text(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '\'')
      out += "'\\''";
    else if (c == '\n')
      out += ' ';
    else if (std::string_view("[]:\\").find(c) != std::string_view::npos)
      out += std::string("\\") + c;
    else
      out += c;
  }
  return out;
}

std::string zsh_action(const CommandOption& option) {
  switch (option.completes) {
    case Completes::nothing:
    case Completes::anything: return " ";
    case Completes::words: return fmt::format("({})", fmt::join(option.words, " "));
    case Completes::types: return "_leastcost_types";
    case Completes::files:
      return option.words.empty() ? "_files" : fmt::format("_files -g \"*.({})\"", fmt::join(option.words, "|"));
    case Completes::folders: return "_files -/";
    case Completes::keys: return "_leastcost_keys";
  }
  return " ";
}

std::string zsh_option(const CommandOption& option) {
  std::string names = option.names.front(), out;
  if (option.names.size() > 1) names = fmt::format("'{{{}}}'", fmt::join(option.names, ","));
  if (option.repeats)
    out = "*";
  else if (option.names.size() > 1)
    out = fmt::format("({})", fmt::join(option.names, " "));
  out = "'" + out + names + "[" + zsh_text(option.help) + "]";
  if (!option.value.empty()) out += ":" + zsh_text(option.value) + ":" + zsh_action(option);
  return out + "'";
}

std::string zsh_arguments(const CommandHelp& command) {
  std::string out;
  for (const CommandOption& option : command.options) out += " \\\n        " + zsh_option(option);
  for (const CommandOption& argument : command.arguments)
    out += fmt::format(" \\\n        '{}{}:{}:{}'", argument.repeats ? "*" : "", argument.required ? "" : ":",
                       zsh_text(argument.value), zsh_action(argument));
  return out;
}

}  // namespace

std::string zsh_completion(const CommandTable& table) {
  std::string out = "#compdef leastcost\n# Completion of leastcost for zsh, made by: leastcost completion zsh\n";
  out += "_leastcost_types() {\n  case ${${1:-$words[2]}%s} in\n";
  for (const WordsOfKind& kind : words_of_kinds())
    out += fmt::format("    {}) compadd {} ;;\n", kind.kind, fmt::join(kind.types, " "));
  out += "  esac\n}\n\n_leastcost_keys() {\n  if compset -P '*='; then\n    _leastcost_types ${IPREFIX%=}\n  else\n";
  out += fmt::format("    compadd -S = {}\n  fi\n}}\n\n", fmt::join(configuration_keys(), " "));
  out += "_leastcost() {\n  local context state state_descr line\n  typeset -A opt_args\n  local -a commands=(\n";
  for (const CommandHelp& command : table.commands)
    out += fmt::format("    '{}:{}'\n", command.name, zsh_text(command.help));
  out += "  )\n  _arguments -C";
  for (const CommandOption& option : table.program.options) out += " \\\n    " + zsh_option(option);
  out += " \\\n    '1:command:->command' '*::argument:->argument'\n  case $state in\n";
  out += "    command) _describe command commands ;;\n    argument)\n      case $words[1] in\n";
  for (const CommandHelp& command : table.commands)
    out += fmt::format("      {})\n        _arguments{}\n        ;;\n", command.name, zsh_arguments(command));
  return out + "      esac\n      ;;\n  esac\n}\n\n_leastcost \"$@\"\n";
}

}  // namespace leastcost::app
