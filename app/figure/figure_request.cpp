// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "app/figure/figure_request.hpp"

#include <leastcost/framework/base/errors.hpp>
#include "app/figure/rsvg.hpp"
#include "app/figure/surface_files.hpp"
#include "catalogue/output/output_folder.hpp"

namespace leastcost::app {

void read_look(const FigureOptions& options, const ReadOption& read, FigureRequest& request) {
  read("--width", [&] { paper_width(options.width); });
  read("--font-size", [&] { request.size = print_size(options.width, options.font_size); });
  request.size.dpi = options.dpi;
  read("--what", [&] { request.parts = parts_shown(options.what); });
  request.points_asked = !options.what.empty();
  request.unit = options.unit;
}

FigureRequest figure_request(const std::filesystem::path& folder, const std::filesystem::path& file,
                             const FigureOptions& options, const ReadOption& read) {
  FigureRequest request;
  request.folder = folder;
  read("--output", [&] { figure_format(file.string()); });
  read_look(options, read, request);
  read("--picture", [&] { request.picture = picture_named(options.picture); });
  if (!options.view.empty()) read("--view", [&] { request.from = view_angles(options.view); });
  return request;
}

void check_picture_file(const std::filesystem::path& file) {
  const std::string ending = file.extension().string();
  if (ending != ".svg" && ending != ".pdf" && ending != ".png")
    throw InputError("'" + file.string() + "' must end in .svg, .pdf or .png");
}

void write_picture(const Figure& figure, const std::filesystem::path& file, double dpi) {
  check_picture_file(file);
  const FigureFormat format = figure_format(file.string());
  write_whole_file(file, format == FigureFormat::svg ? figure.svg : converted_svg(figure.svg, format, dpi));
}

WrittenFigure write_figure(const FigureRequest& request, const std::filesystem::path& file) {
  const FigureFormat format = figure_format(file.string());
  if (format == FigureFormat::vtp || format == FigureFormat::ply) {
    write_whole_file(file, surface_file(request.folder, format));
    return {};
  }
  const Figure figure = make_figure(request);
  write_picture(figure, file, request.size.dpi);
  WrittenFigure written{figure.width, figure.height};
  if (figure.from) written.view.emplace(figure.from->azimuth, figure.from->elevation);
  return written;
}

}  // namespace leastcost::app
