// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/cli/shell/completion.hpp"

namespace leastcost::app {
namespace {

// The functions that do not depend on the commands. bash makes words of `--format=json` and `solver=newton`: three
// each.
constexpr const char* kBashHead = R"(# Completion of leastcost for bash, made by: leastcost completion bash
_leastcost_words() { COMPREPLY=($(compgen -W "$1" -- "$cur")); }

# Folders, and files with one of these extensions; without any, all files.
_leastcost_files() {
  local file extension
  compopt -o filenames 2>/dev/null
  while IFS= read -r file; do
    [[ -d $file || $# == 0 ]] && COMPREPLY+=("$file") && continue
    for extension; do [[ $file == *."$extension" ]] && COMPREPLY+=("$file"); done
  done < <(compgen -f -- "$cur")
}

_leastcost_folders() {
  compopt -o filenames 2>/dev/null
  local IFS=$'\n'
  COMPREPLY=($(compgen -d -- "$cur"))
}

_leastcost_types() {
  case ${1%s} in
)";

constexpr const char* kBashBody = R"(  esac
}

_leastcost() {
  local cur=${COMP_WORDS[COMP_CWORD]} prev=${COMP_WORDS[COMP_CWORD - 1]} key= word i
  COMPREPLY=()
  if [[ $cur == = ]]; then
    key=$prev cur=
  elif [[ $prev == = ]]; then
    key=${COMP_WORDS[COMP_CWORD - 2]}
  fi
  [[ $key == -* ]] && prev=$key key=

  local command= options= valued=
  ((COMP_CWORD > 1)) && command=${COMP_WORDS[1]}
  case $command in
)";

constexpr const char* kBashTail = R"(  esac

  # How many arguments stand before this one, and the first of them.
  local place=0 first=
  for ((i = 2; i < COMP_CWORD; i++)); do
    word=${COMP_WORDS[i]}
    if [[ $word == = ]]; then
      ((i++))
    elif [[ $word == -?* ]]; then
      [[ " $valued " == *" $word "* && ${COMP_WORDS[i + 1]} != = ]] && ((i++))
    else
      ((place++))
      first=${first:-$word}
    fi
  done

  if [[ $key ]]; then # --set solver=
    _leastcost_types "$key"
    return
  fi
)";

/// The statement that fills COMPREPLY.
std::string bash_action(const CommandOption& option) {
  switch (option.completes) {
    case Completes::nothing:
    case Completes::anything: return ":";
    case Completes::words: return fmt::format("_leastcost_words \"{}\"", fmt::join(option.words, " "));
    case Completes::types: return "_leastcost_types \"$first\"";
    case Completes::files: return fmt::format("_leastcost_files {}", fmt::join(option.words, " "));
    case Completes::folders: return "_leastcost_folders";
    case Completes::keys:
      return fmt::format("compopt -o nospace 2>/dev/null\n      _leastcost_words \"{}=\"",
                         fmt::join(configuration_keys(), "= "));
  }
  return ":";
}

std::string names_in(const std::vector<CommandOption>& options, bool only_with_value) {
  std::string names;
  for (const CommandOption& option : options) {
    if (only_with_value && option.value.empty()) continue;
    for (const std::string& name : option.names) names += (names.empty() ? "" : " ") + name;
  }
  return names;
}

}  // namespace

std::string bash_completion(const CommandTable& table) {
  std::string out = kBashHead, values, places, commands;
  for (const WordsOfKind& kind : words_of_kinds())
    out += fmt::format("    {}) _leastcost_words \"{}\" ;;\n", kind.kind, fmt::join(kind.types, " "));
  out += kBashBody;
  for (const CommandHelp& command : table.commands) {
    commands += command.name + " ";
    out += fmt::format("    {})\n      options=\"{}\"\n      valued=\"{}\"\n      ;;\n", command.name,
                       names_in(command.options, false), names_in(command.options, true));
    for (const CommandOption& option : command.options) {
      if (option.value.empty()) continue;
      std::string patterns;
      for (const std::string& name : option.names)
        patterns += fmt::format("{}\"{} {}\"", patterns.empty() ? "" : " | ", command.name, name);
      values += fmt::format("    {})\n      {}\n      return\n      ;;\n", patterns, bash_action(option));
    }
    for (std::size_t i = 0; i < command.arguments.size(); ++i)
      places +=
          fmt::format("    \"{} {}\")\n      {}\n      ;;\n", command.name,
                      command.arguments[i].repeats ? "\"*\"" : std::to_string(i), bash_action(command.arguments[i]));
  }
  out += kBashTail;
  out += "  case \"$command $prev\" in\n" + values + "  esac\n";
  out += fmt::format("  if [[ ! $command ]]; then\n    _leastcost_words \"{}{}\"\n    return\n  fi\n", commands,
                     names_in(table.program.options, false));
  out += "  if [[ $cur == -* ]]; then\n    _leastcost_words \"$options\"\n    return\n  fi\n";
  out += "  case \"$command $place\" in\n" + places + "  esac\n}\ncomplete -F _leastcost leastcost\n";
  return out;
}

}  // namespace leastcost::app
