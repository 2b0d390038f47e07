// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/occupancy/occupancy_options.hpp>

#include <array>
#include <cmath>

#include <leastcost/framework/base/errors.hpp>
#include "framework/base/sound_size.hpp"

namespace leastcost {

Words<UnknownCells> words(UnknownCells) {
  static constexpr std::array<Word<UnknownCells>, 2> kWords = {
      {{UnknownCells::blocked, "blocked"}, {UnknownCells::free, "free"}}};
  return kWords;
}

void OccupancyOptions::fields(FieldVisitor& visit) {
  visit.file("file", file,
             {.help = "Map: Moving AI (.map), an image (.png, .pgm), or a map_server YAML (.yaml), which sets cell, "
                      "origin, negate and the thresholds.",
              .required = true});
  visit.field("cell", cell,
              {.help = "Side length of a cell.", .unit = "length", .minimum = 0, .exclusive_minimum = true});
  visit.field("origin", origin,
              {.help = "Position of the map's lower corner. In a Moving AI map x is the column and y the row, counted "
                       "downwards; in an image y points up.",
               .unit = "length"});
  visit.field("negate", negate, {.help = "White cells are blocked instead of black ones."});
  visit.field(
      "occupied_thresh", occupied_thresh,
      {.help = "Cells with an occupancy (blackness, 0 to 1) above it are blocked.", .minimum = 0, .maximum = 1});
  visit.field("free_thresh", free_thresh,
              {.help = "Cells with an occupancy below it are free; between the two thresholds they are unknown.",
               .minimum = 0,
               .maximum = 1});
  visit.choice("unknown", unknown, {.help = "How unknown cells are treated."});
}

OccupancyGrid placed_grid(const OccupancyOptions& options) {
  if (!(options.cell > 0) || !std::isfinite(options.cell)) throw OptionError("cell", "must be greater than 0");
  check_sound_size("the side of a cell", options.cell);
  if (options.origin.size() != 2 || !options.origin.allFinite())
    throw OptionError("origin", "must have two finite numbers, x and y");
  if (!(options.free_thresh <= options.occupied_thresh))
    throw OptionError("free_thresh", "must not be above occupied_thresh");
  OccupancyGrid grid;
  grid.cell = options.cell;
  grid.origin = options.origin;
  return grid;
}

}  // namespace leastcost
