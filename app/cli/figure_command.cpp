// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include <ostream>

#include "app/cli/command_options.hpp"
#include "app/cli/commands.hpp"
#include "app/figure/figure_request.hpp"

namespace leastcost::app {
namespace {

constexpr const char* kFigureHelp =
    "leastcost figure results/bunny_geodesic -o bunny.pdf                     one column of a paper\n"
    "leastcost figure results/bunny_geodesic -o bunny.pdf --view 30,20 --what path,ends,shading\n"
    "leastcost figure results/bunny_geodesic -o bunny.vtp                     surface and path, for ParaView\n"
    ".svg needs no other program; .pdf and .png need rsvg-convert (Debian: librsvg2-bin).";

FigureArguments figure_arguments(const OptionValues& v) {
  return {figure_request(v.config, v.output, v.figure, read_option), v.output};
}

}  // namespace

Exit figure_command(const FigureArguments& arguments, const Streams& streams) {
  const WrittenFigure figure = write_figure(arguments.request, arguments.output);
  streams.out << arguments.output;
  if (figure.width > 0) streams.out << fmt::format(": {:.4g} x {:.4g} mm", figure.width, figure.height);
  if (figure.view) streams.out << fmt::format(", --view {:g},{:g}", figure.view->first, figure.view->second);
  streams.out << '\n';
  return Exit::certified;
}

void add_figure(const CommandLine& line) {
  OptionValues& v = line.values;
  CLI::App& c = *line.app.add_subcommand("figure", "Draw a finished run for a paper: SVG, PDF or PNG of a given width");
  c.footer(kFigureHelp);
  c.add_option("folder", v.config, "Output folder of a run")->required()->type_name("DIR");
  c.add_option("-o,--output", v.output, "File: .svg, .pdf or .png; .vtp or .ply: surface and path for 3D programs")
      ->required()
      ->type_name("FILE")
      ->check(empty_fault);
  add_look(c, v);
  c.add_option("--picture", v.figure.picture,
               "Which picture: space, map, poses, coordinates or convergence; default: the best one available")
      ->type_name("NAME");
  c.add_option("--view", v.figure.view, "Look at space from these angles: azimuth and elevation in degrees, like 30,20")
      ->type_name("AZ,EL");
  c.callback([&] { line.chosen = [&, figure = figure_arguments(v)] { return figure_command(figure, line.streams); }; });
}

}  // namespace leastcost::app
