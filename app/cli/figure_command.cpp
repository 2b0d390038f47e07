// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <ostream>

#include "app/cli/commands.hpp"
#include "app/figure/figure_request.hpp"

namespace leastcost::app {

Exit figure_command(const FigureArguments& arguments, const Streams& streams) {
  const WrittenFigure figure = write_figure(arguments.request, arguments.output);
  streams.out << arguments.output;
  if (figure.width > 0) streams.out << fmt::format(": {:.4g} x {:.4g} mm", figure.width, figure.height);
  if (figure.view) streams.out << fmt::format(", --view {:g},{:g}", figure.view->first, figure.view->second);
  streams.out << '\n';
  return Exit::certified;
}

}  // namespace leastcost::app
