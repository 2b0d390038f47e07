// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <ostream>

#include "app/cli/commands.hpp"
#include "app/figure/figure.hpp"
#include "app/figure/rsvg.hpp"
#include "app/figure/surface_files.hpp"
#include "catalogue/output/output_folder.hpp"

namespace leastcost::app {

Exit figure_command(const FigureArguments& arguments, const Streams& streams) {
  const FigureFormat format = figure_format(arguments.output);
  if (format == FigureFormat::vtp || format == FigureFormat::ply) {
    write_whole_file(arguments.output, surface_file(arguments.request.folder, format));
    streams.out << arguments.output << '\n';
    return Exit::certified;
  }
  const Figure figure = make_figure(arguments.request);
  write_whole_file(arguments.output, format == FigureFormat::svg
                                         ? figure.svg
                                         : converted_svg(figure.svg, format, arguments.request.size.dpi));
  streams.out << fmt::format("{}: {:.4g} x {:.4g} mm", arguments.output, figure.width, figure.height);
  if (figure.from) streams.out << fmt::format(", --view {:g},{:g}", figure.from->azimuth, figure.from->elevation);
  streams.out << '\n';
  return Exit::certified;
}

}  // namespace leastcost::app
