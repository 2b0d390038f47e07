// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include <leastcost/app/figure/paper_figure.hpp>
#include "app/figure/figure.hpp"

namespace leastcost::app {

/// Calls `read`, whose InputError is a fault of the option with this name on the command line.
using ReadOption = std::function<void(const char* option, const std::function<void()>& read)>;

/// The request that options in words make.
FigureRequest figure_request(const std::filesystem::path& folder, const std::filesystem::path& file,
                             const FigureOptions& options, const ReadOption& read);

/// Of these options those of any picture: width, font size, pixels, parts and unit.
void read_look(const FigureOptions& options, const ReadOption& read, FigureRequest& request);

/// Throws InputError for a file that no picture can be written to, by its ending.
void check_picture_file(const std::filesystem::path& file);

/// Writes a picture: .svg; .pdf and .png by rsvg-convert. Throws InputError for another ending, HostError, OutputError.
void write_picture(const Figure& figure, const std::filesystem::path& file, double dpi);

/// write_figure() of a request.
WrittenFigure write_figure(const FigureRequest& request, const std::filesystem::path& file);

}  // namespace leastcost::app
