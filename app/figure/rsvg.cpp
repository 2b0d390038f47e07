// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "app/figure/rsvg.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <filesystem>
#include <system_error>
#include <vector>

#include "app/report/page/json_file.hpp"
#include "catalogue/output/output_folder.hpp"
#include "catalogue/output/temporary_folder.hpp"

namespace leastcost::app {
namespace {

namespace fs = std::filesystem;

constexpr int kNotStarted = 127;

/// Exit code of a program with its output in files; kNotStarted where it is not there.
int exit_of(std::vector<std::string> arguments, const fs::path& in, const fs::path& out, const fs::path& err) {
  std::vector<char*> argv;
  argv.reserve(arguments.size() + 1);
  for (std::string& a : arguments) argv.push_back(a.data());
  argv.push_back(nullptr);
  const std::string from = in.string(), to = out.string(), words = err.string();
  const pid_t child = ::fork();
  if (child < 0) throw HostError("no process could be started: " + std::generic_category().message(errno));
  if (child == 0) {
    constexpr int kMode = 0600;
    ::dup2(::open(from.c_str(), O_RDONLY), STDIN_FILENO);
    ::dup2(::open(to.c_str(), O_CREAT | O_WRONLY | O_TRUNC, kMode), STDOUT_FILENO);
    ::dup2(::open(words.c_str(), O_CREAT | O_WRONLY | O_TRUNC, kMode), STDERR_FILENO);
    ::execvp(argv[0], argv.data());
    ::_exit(kNotStarted);
  }
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : 1;
}

[[noreturn]] void fail_without(const std::string& program, const std::string& word) {
  throw HostError(fmt::format(
      "{0} is needed for .{1} and was not found: install librsvg2-bin, or write .svg and convert that", program, word));
}

std::string word_of(FigureFormat format) { return format == FigureFormat::pdf ? "pdf" : "png"; }

}  // namespace

void require_converter(FigureFormat format, const std::string& program) {
  if (format != FigureFormat::pdf && format != FigureFormat::png) return;
  const TemporaryFolder temporary;
  const fs::path& passing = temporary.path();
  write_whole_file(passing / "nothing", "");
  if (exit_of({program, "--version"}, passing / "nothing", passing / "out", passing / "err") == kNotStarted)
    fail_without(program, word_of(format));
}

std::string converted_svg(const std::string& svg, FigureFormat format, double dpi, const std::string& program) {
  const TemporaryFolder temporary;
  const fs::path& passing = temporary.path();
  const fs::path in = passing / "figure.svg", out = passing / "figure", err = passing / "words";
  write_whole_file(in, svg);
  const std::string word = word_of(format);
  // A drawing of a PDF has 72 units per inch, whatever its pixels.
  const std::string resolution = fmt::format("{:g}", dpi);
  const int exit =
      exit_of({program, "--format", word, "--dpi-x", resolution, "--dpi-y", resolution, "--unlimited"}, in, out, err);
  if (exit == kNotStarted) fail_without(program, word);
  if (exit == 0 && fs::file_size(out) > 0) return text_of_file(out);
  std::string reason = text_of_file(err);
  reason = reason.substr(0, reason.find('\n'));
  throw HostError(fmt::format("{} could not make the .{}{}{}", program, word, reason.empty() ? "" : ": ", reason));
}

}  // namespace leastcost::app
