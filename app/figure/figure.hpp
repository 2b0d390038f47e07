// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "app/figure/figure_options.hpp"

namespace leastcost::app {

struct FigureRequest {
  std::filesystem::path folder;  ///< of a finished run
  PrintSize size = {};
  FigureParts parts = {};
  FigurePicture picture = FigurePicture::best;
  std::optional<Angles> from = {};  ///< of a picture in space
  std::string unit = {};            ///< of the coordinates
  bool points_asked = false;        ///< points also where they hide the path
};

struct Figure {
  std::string svg;
  double width = 0, height = 0;     ///< mm
  std::optional<Angles> from = {};  ///< of a picture in space: from where it is looked at
};

/// The picture of a run for a paper. Throws InputError that names what is missing or does not fit.
Figure make_figure(const FigureRequest& request);

}  // namespace leastcost::app
