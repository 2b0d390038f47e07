// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include <leastcost/app/figure/paper_figure.hpp>

namespace leastcost {

/// Draws a finished run from the files of its folder into `file`, whose ending says the format: .svg; .pdf and .png by
/// the program rsvg-convert; .vtp and .ply, the surface with the path. Throws InputError for an option that cannot be,
/// and for a folder that is no run; HostError without rsvg-convert; OutputError.
WrittenFigure write_figure(const std::filesystem::path& folder, const std::filesystem::path& file,
                           const FigureOptions& options = {});

}  // namespace leastcost
