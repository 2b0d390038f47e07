// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "app/cli/command_line.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <map>
#include <ostream>

#include "app/cli/command_options.hpp"
#include "app/cli/commands.hpp"
#include "app/cli/shell/command_table.hpp"
#include "app/cli/shell/completion.hpp"
#include "app/cli/shell/man_pages.hpp"
#include "catalogue/output/manifest.hpp"
#include "catalogue/yaml/suggest.hpp"

namespace leastcost::app {
namespace {

/// A text for those who install the program, under the name that this one has.
std::string renamed(std::string text, const std::string& program) {
  static const std::string kName = "leastcost";
  if (program == kName) return text;
  for (std::size_t at = text.find(kName); at != std::string::npos; at = text.find(kName, at + program.size()))
    text.replace(at, kName.size(), program);
  return text;
}

/// For those who install the program: made of the same tables as --help.
void add_shell(const CommandLine& line) {
  OptionValues& v = line.values;
  CLI::App& completion = *line.app.add_subcommand("completion", "Print the script that completes commands in a shell");
  completion.footer(
      "bash: leastcost completion bash > ~/.local/share/bash-completion/completions/leastcost\n"
      "zsh:  leastcost completion zsh > DIR/_leastcost, with DIR in fpath\n"
      "fish: leastcost completion fish > ~/.config/fish/completions/leastcost.fish\n"
      "The Debian package and cmake --install install all three.");
  completion.add_option("shell", v.name, "bash, zsh or fish")
      ->required()
      ->check(CLI::IsMember({"bash", "zsh", "fish"}))
      ->type_name("SHELL");
  completion.callback([&] {
    line.chosen = [&] {
      const CommandTable table = command_table(line.app);
      const std::string script = v.name == "bash"  ? bash_completion(table)
                                 : v.name == "zsh" ? zsh_completion(table)
                                                   : fish_completion(table);
      line.streams.out << renamed(script, line.app.get_name());
      return Exit::certified;
    };
  });

  CLI::App& man =
      *line.app.add_subcommand("man", "Write the man pages, leastcost.1 and one for each command, into a folder");
  man.add_option("folder", v.output, "Folder")->required()->type_name("DIR")->check(empty_fault);
  man.callback([&] {
    line.chosen = [&] {
      std::map<std::string, std::string> pages;
      for (const auto& [name, text] : man_pages(command_table(line.app), std::string(program_version())))
        pages[renamed(name, line.app.get_name())] = renamed(text, line.app.get_name());
      return pages_command(pages, v.output, line.streams);
    };
  });
}

/// Below the footer that a command has of its own.
void add_exit_codes(CLI::App& command) {
  const std::string own = command.get_footer();
  command.footer(own.empty() || own == kExitCodes ? kExitCodes : own + "\n" + kExitCodes);
}

std::vector<std::string> names_of(const std::vector<CLI::App*>& commands) {
  std::vector<std::string> names;
  names.reserve(commands.size());
  for (const CLI::App* command : commands) names.push_back(command->get_name());
  return names;
}

/// CLI11 suggests nothing; for the first option that the command does not have, we do.
std::string option_hint(const CLI::App& app, const std::vector<std::string>& arguments) {
  const CLI::App* command = &app;
  for (const CLI::App* c : app.get_subcommands({}))
    if (arguments.size() > 1 && c->get_name() == arguments[1]) command = c;
  std::vector<std::string> known;
  for (const CLI::Option* option : command->get_options())
    for (const std::string& name : option->get_lnames()) known.push_back("--" + name);
  for (const std::string& argument : arguments) {
    const std::string word = argument.substr(0, argument.find('='));
    if (word.rfind("--", 0) == 0 && std::count(known.begin(), known.end(), word) == 0) return did_you_mean(word, known);
  }
  return "";
}

/// "'leastcost run' needs CONFIG: Configuration (YAML); write 'leastcost run CONFIG'". Empty: nothing is missing.
std::string missing_arguments(const CLI::App& app, const std::vector<std::string>& arguments) {
  const CLI::App* command = nullptr;
  for (const CLI::App* c : app.get_subcommands({}))
    if (arguments.size() > 1 && c->get_name() == arguments[1]) command = c;
  if (command == nullptr) return "";
  std::string missing, whole = app.get_name() + " " + command->get_name();
  for (const CLI::Option* option : command->get_options()) {
    if (!option->get_required()) continue;
    const std::string name =
        option->get_positional() ? option->get_type_name() : option->get_name() + " " + option->get_type_name();
    whole += " " + name;
    if (option->count() == 0) missing += (missing.empty() ? "" : ", and ") + name + ": " + option->get_description();
  }
  if (missing.empty()) return "";
  return fmt::format("'{} {}' needs {}; write '{}'", app.get_name(), command->get_name(), missing, whole);
}

/// Help and version are no errors; everything else is one of usage.
Exit parse_outcome(const CLI::App& app, const CLI::ParseError& e, const std::vector<std::string>& arguments,
                   const Streams& streams) {
  if (e.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success)) {
    app.exit(e, streams.out, streams.err);
    return Exit::certified;
  }
  std::string message = e.what();
  if (e.get_exit_code() == static_cast<int>(CLI::ExitCodes::RequiredError))
    if (std::string missing = missing_arguments(app, arguments); !missing.empty()) message = std::move(missing);
  if (const std::vector<std::string> extra = app.remaining(true);
      !extra.empty())  // its own message has them in reverse
    message = fmt::format("not expected here: {}", fmt::join(extra, " "));
  std::replace(message.begin(), message.end(), '\n', ' ');
  streams.err << "error: " << message << option_hint(app, arguments)
              << fmt::format("\nTry: {0} --help, {0} COMMAND --help\n", app.get_name());
  return Exit::usage;
}

Exit parse_and_run(const std::vector<std::string>& arguments, const Streams& streams, OptionValues& values) {
  CLI::App app("Find least-cost paths on manifolds, with points equally spaced in cost",
               std::filesystem::path(arguments.front()).filename().string());
  app.set_version_flag("--version", "leastcost " + std::string(program_version()));
  app.require_subcommand(1);
  app.footer(kExitCodes);
  std::function<Exit()> chosen;
  const CommandLine line{app, values, arguments, streams, chosen};
  add_run(line);
  add_study(line);
  add_merge(line);
  add_validate(line);
  add_report(line);
  add_figure(line);
  add_reference(line);
  add_init(line);
  add_doctor(line);
  add_distances(line);
  add_field(line);
  add_shell(line);
  for (CLI::App* command : app.get_subcommands({})) add_exit_codes(*command);

  const std::vector<std::string> names = names_of(app.get_subcommands({}));
  if (arguments.size() > 1 && arguments[1].rfind('-', 0) != 0 &&
      std::count(names.begin(), names.end(), arguments[1]) == 0) {
    streams.err << "error: unknown command '" << arguments[1] << "'" << did_you_mean(arguments[1], names)
                << "; commands: " << joined(names) << '\n';
    return Exit::usage;
  }
  try {
    // CLI11 takes the arguments in reverse, without the program.
    app.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend() - 1));
  } catch (const CLI::ParseError& e) {
    return parse_outcome(app, e, arguments, streams);
  }
  return chosen();
}

}  // namespace

int run_program(const std::vector<std::string>& arguments, const Streams& streams) {
  OptionValues values;
  try {
    const Exit exit = parse_and_run(arguments, streams, values);
    if (streams.out.flush()) return static_cast<int>(exit);
    streams.err << "error: the result could not be written to standard output\n";
    return static_cast<int>(Exit::output);
  } catch (...) {
    return static_cast<int>(exit_of_exception(streams, values.json()));
  }
}

}  // namespace leastcost::app
