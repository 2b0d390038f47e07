// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "app/report/page/provenance.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/report/page/page.hpp"

namespace leastcost::app {

std::string provenance_part(const JsonFile& manifest) {
  Table facts{{{""}, {""}}, {}, ""};
  const auto row = [&](const char* what, const std::string& value) { facts.rows.push_back({{what}, {value}}); };
  row("program", fmt::format("{} {}, {} build, {}", manifest.text("program"), manifest.text("version"),
                             manifest.text("build.type"), manifest.text("build.compiler")));
  if (manifest.has("commit")) row("sources", manifest.text("commit").empty() ? "no checkout" : manifest.text("commit"));
  std::string libraries;
  for (const auto& [name, version] : manifest.named_texts("build.libraries")) {
    // Back ends say the name of their library themselves: "NLopt 2.7.1".
    const bool named = version.find(' ') != std::string::npos;
    if (!libraries.empty()) libraries += ", ";
    libraries += named ? version : fmt::format("{} {}", name, version);
  }
  if (!libraries.empty()) row("libraries", libraries);
  row("machine", fmt::format("{}, {}, {} hardware threads", manifest.text("machine.host"), manifest.text("machine.cpu"),
                             manifest.text("machine.hardware_threads")));
  row("command", fmt::format("{}", fmt::join(manifest.texts("arguments"), " ")));
  row("in", manifest.text("working_directory"));
  row("seed", manifest.text("seed"));
  row("started", manifest.text("started"));
  row("finished", manifest.text("finished"));
  Table inputs{{{"input"}, {"file"}, {"SHA-256"}}, {}, "hash"};
  for (const JsonFile& input : manifest.objects("inputs"))
    inputs.rows.push_back({{input.text("role")}, {input.text("file")}, {input.text("sha256")}});
  return html(facts) + (inputs.rows.empty() ? "" : html(inputs));
}

}  // namespace leastcost::app
