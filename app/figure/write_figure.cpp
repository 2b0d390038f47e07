// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/app/figure/write_figure.hpp>

#include <functional>

#include "app/figure/figure_request.hpp"

namespace leastcost {

WrittenFigure write_figure(const std::filesystem::path& folder, const std::filesystem::path& file,
                           const FigureOptions& options) {
  const auto read = [](const char*, const std::function<void()>& option) { option(); };
  return app::write_figure(app::figure_request(folder, file, options, read), file);
}

}  // namespace leastcost
