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

/// write_figure() of a request.
WrittenFigure write_figure(const FigureRequest& request, const std::filesystem::path& file);

}  // namespace leastcost::app
