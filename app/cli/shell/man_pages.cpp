// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "app/cli/shell/man_pages.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

namespace leastcost::app {
namespace {

/// Text that roff prints as it is.
std::string roff(std::string_view text) {
  std::string out;
  bool line_begins = true;
  for (const char c : text) {
    if (line_begins && (c == '.' || c == '\'')) out += "\\&";  // would be a command
    if (c == '\\')
      out += "\\e";
    else if (c == '-')
      out += "\\-";
    else if (c == '\'')
      out += "\\(aq";
    else
      out += c;
    line_begins = c == '\n';
  }
  return out;
}

std::string upper(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; });
  return text;
}

// Of the last change of these pages; a date is required, and that of the build would make builds differ.
constexpr const char* kManDate = "2026-11-28";

std::string head(const std::string& name, const std::string& help, const std::string& version) {
  std::string what = help;
  what.front() =
      static_cast<char>(what.front() >= 'A' && what.front() <= 'Z' ? what.front() - 'A' + 'a' : what.front());
  return fmt::format(".TH {} 1 {} \"leastcost {}\" \"User Commands\"\n.SH NAME\n{} \\- {}\n", upper(roff(name)),
                     kManDate, version, roff(name), roff(what));
}

std::string item(const CommandOption& option, bool argument) {
  std::string line;
  for (const std::string& name : option.names)
    line += (line.empty() ? "\\fB" : ", \\fB") + roff(argument ? option.value : name) + "\\fR";
  if (!argument && !option.value.empty()) line += " \\fI" + roff(option.value) + "\\fR";
  std::string text = roff(option.help);
  const bool said = std::all_of(option.words.begin(), option.words.end(),
                                [&](const std::string& word) { return option.help.find(word) != std::string::npos; });
  if (option.completes == Completes::words && !said && option.value != "TEMPLATE" && option.value != "KIND") {
    text += ". One of ";
    for (const std::string& word : option.words) text += (word == option.words.front() ? "" : ", ") + roff(word);
  }
  return ".TP\n" + line + "\n" + text + "\n";
}

std::string items(const char* title, const std::vector<CommandOption>& options, bool arguments) {
  if (options.empty()) return "";
  std::string out = fmt::format(".SH {}\n", title);
  for (const CommandOption& option : options) out += item(option, arguments);
  return out;
}

std::string synopsis(const CommandHelp& command) {
  std::string out = fmt::format(".SH SYNOPSIS\n\\fBleastcost {}\\fR [\\fIOPTIONS\\fR]", roff(command.name));
  for (const CommandOption& argument : command.arguments) {
    const std::string value = "\\fI" + roff(argument.value) + "\\fR";
    out += argument.required ? " " + value : " [" + value + "]";
  }
  return out + "\n";
}

/// Lines as they are: the footers of --help have examples and columns.
std::string as_it_is(const char* title, const std::string& text) {
  return text.empty() ? "" : fmt::format(".SH {}\n.nf\n{}\n.fi\n", title, roff(text));
}

std::string program_page(const CommandTable& table, const std::string& version) {
  std::string out = head("leastcost", table.program.help, version);
  out += ".SH SYNOPSIS\n\\fBleastcost\\fR \\fICOMMAND\\fR [\\fIOPTIONS\\fR] [\\fIARGUMENTS\\fR]\n";
  out +=
      ".SH DESCRIPTION\nA configuration (YAML) states the cost of a move and where the points may be. "
      "The result is a path whose points\nare equally spaced in cost, with a certificate: an error bar, or the "
      "reasons why it is not to be trusted.\n";
  out += ".SH COMMANDS\n";
  for (const CommandHelp& command : table.commands)
    out += fmt::format(".TP\n\\fB{}\\fR\n{}. See \\fBleastcost\\-{}\\fR(1).\n", roff(command.name), roff(command.help),
                       roff(command.name));
  out += items("OPTIONS", table.program.options, false);
  out += as_it_is("EXIT STATUS", kExitCodes);
  out += as_it_is("EXAMPLES",
                  "leastcost init mesh\nleastcost run mesh/mesh.yaml -o results/mesh\n"
                  "leastcost figure results/mesh -o mesh.svg");
  return out;
}

std::string command_page(const CommandHelp& command, const std::string& version) {
  return head("leastcost-" + command.name, command.help, version) + synopsis(command) + ".SH DESCRIPTION\n" +
         roff(command.help) + ".\n" + items("ARGUMENTS", command.arguments, true) +
         items("OPTIONS", command.options, false) + as_it_is("NOTES", command.footer) +
         as_it_is("EXIT STATUS", kExitCodes) + ".SH SEE ALSO\n\\fBleastcost\\fR(1)\n";
}

}  // namespace

std::map<std::string, std::string> man_pages(const CommandTable& table, const std::string& version) {
  std::map<std::string, std::string> pages = {{"leastcost.1", program_page(table, version)}};
  for (const CommandHelp& command : table.commands)
    pages["leastcost-" + command.name + ".1"] = command_page(command, version);
  return pages;
}

}  // namespace leastcost::app
