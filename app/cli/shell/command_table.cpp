// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "app/cli/shell/command_table.hpp"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include <map>

#include "app/init/templates.hpp"
#include "app/reference/field_list.hpp"
#include "catalogue/registry/registry.hpp"

namespace leastcost::app {
namespace {

std::vector<std::string> split_words(const std::string& text, char between) {
  std::vector<std::string> words;
  std::size_t begin = 0;
  for (std::size_t end = text.find(between); end != std::string::npos; end = text.find(between, begin)) {
    words.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  words.push_back(text.substr(begin));
  return words;
}

std::vector<std::string> kind_words(const std::string& command) {
  std::vector<std::string> words;
  for (const PluginKind& kind : plugin_kinds()) words.push_back(command == "list" ? kind.plural : kind.name);
  if (command == "list") words.emplace_back("formats");
  if (command == "describe") words.insert(words.begin(), {"run", "study"});
  return words;
}

std::vector<std::string> template_words() {
  std::vector<std::string> words;
  for (const Template& starter : templates()) words.push_back(starter.name);
  return words;
}

/// The names of values in --help say what is asked for.
void complete_by_value(CommandOption& option, const std::string& command) {
  static const std::map<std::string, std::vector<std::string>> extensions = {
      {"CONFIG", {"yaml", "yml"}}, {"MESH", {"obj", "off", "ply", "stl"}}, {"FILE", {}}, {"VERTEX", {}}, {"PATH", {}}};
  option.completes = Completes::anything;
  const std::string value = option.value.substr(0, option.value.find('.'));  // "CONFIG..."
  if (const auto known = extensions.find(value); known != extensions.end()) {
    option.completes = Completes::files;
    option.words = known->second;
  } else if (value == "DIR") {
    option.completes = Completes::folders;
  } else if (value == "KEY=VALUE") {
    option.completes = Completes::keys;
  } else if (value == "TYPE") {
    option.completes = Completes::types;
  } else if (value == "KIND" || value == "TEMPLATE") {
    option.completes = Completes::words;
    option.words = value == "KIND" ? kind_words(command) : template_words();
  }
}

CommandOption option_entry(const CLI::Option& from, const std::string& command) {
  CommandOption option;
  option.help = from.get_description();
  option.required = from.get_required();
  option.repeats = from.get_items_expected_max() > 1;
  if (from.get_positional()) {
    option.names = {from.get_name()};
  } else {
    for (const std::string& name : from.get_snames()) option.names.push_back("-" + name);
    for (const std::string& name : from.get_lnames()) option.names.push_back("--" + name);
  }
  if (from.get_items_expected_max() == 0) return option;  // a flag
  // "FORMAT:{text,json}", "N:INT in [1 - 1024]", "FLOAT:POSITIVE"
  const std::string type = from.get_type_name();
  const std::size_t colon = type.find(':');
  option.value = type.substr(0, colon);
  complete_by_value(option, command);
  if (colon != std::string::npos && type[colon + 1] == '{') {
    option.completes = Completes::words;
    option.words = split_words(type.substr(colon + 2, type.find('}') - colon - 2), ',');
  }
  return option;
}

/// Of its footer what stands before the exit codes.
std::string own_footer(const CLI::App& app) {
  const std::string footer = app.get_footer();
  const std::string own = footer.substr(0, footer.find(kExitCodes));
  return own.substr(0, own.find_last_not_of('\n') + 1);
}

CommandHelp command_entry(const CLI::App& app) {
  CommandHelp command{app.get_name(), app.get_description(), own_footer(app), {}, {}};
  for (const CLI::Option* option : app.get_options())
    (option->get_positional() ? command.arguments : command.options).push_back(option_entry(*option, command.name));
  return command;
}

}  // namespace

CommandTable command_table(const CLI::App& app) {
  CommandTable table{command_entry(app), {}};
  for (const CLI::App* command : app.get_subcommands({})) table.commands.push_back(command_entry(*command));
  return table;
}

std::vector<WordsOfKind> words_of_kinds() {
  std::vector<WordsOfKind> all;
  for (const PluginKind& kind : plugin_kinds()) all.push_back({kind.name, types_of(kind)});
  return all;
}

std::vector<std::string> configuration_keys() {
  std::vector<std::string> keys;
  for (const FieldInfo& field : fields_of_run()) {
    keys.push_back(field.key);
    for (const FieldInfo& child : field.children) keys.push_back(field.key + "." + child.key);
  }
  return keys;
}

}  // namespace leastcost::app
