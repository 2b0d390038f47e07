// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "catalogue/inputs/map_file.hpp"

#include <fmt/format.h>

#include <optional>
#include <string>
#include <utility>

#include <leastcost/framework/base/errors.hpp>
#include "catalogue/inputs/png_image.hpp"
#include "catalogue/yaml/scalars.hpp"
#include "catalogue/yaml/yaml_reader.hpp"
#include "problems/readers/file_content.hpp"
#include "problems/readers/occupancy_reader.hpp"

namespace leastcost {
namespace {

namespace fs = std::filesystem;

/// The keys of a map_server file. What is wrong is collected with its place.
class MapServerFile {
 public:
  MapServerFile(const ConfigNode& tree, Diagnostics& errors) : tree_(tree), errors_(errors) {
    if (!tree.is_block())
      errors.error(tree.place, "a map_server file must be a block of keys: image, resolution, origin");
  }

  std::string text(const char* key, const std::optional<std::string>& missing = {}) {
    const ConfigNode* node = find(key, missing.has_value());
    return node == nullptr ? missing.value_or("") : value(key, *node, parse_text(*node)).value_or("");
  }

  double number(const char* key, double least, double most, bool open) {
    const ConfigNode* node = find(key, false);
    if (node == nullptr) return 0;
    const double read = value(key, *node, parse_double(*node)).value_or(most);
    if (read < least || read > most || (open && read == least))
      errors_.error(node->place, fmt::format("'{}' must be {} {} and at most {} (found {})", key,
                                             open ? "greater than" : "at least", least, most, read));
    return read;
  }

  /// Map_server knows 0 and 1; newer ones write false and true.
  bool flag(const char* key) {
    const ConfigNode* node = find(key, true);
    if (node == nullptr || node->text == "0" || node->text == "false") return false;
    if (!node->is_scalar() || (node->text != "1" && node->text != "true"))
      errors_.error(node->place, fmt::format("'{}' must be 0 or 1 ({})", key, found(*node)));
    return true;
  }

  /// x and y of the lower corner; the third number is a rotation, which must be none.
  Eigen::Vector2d origin() {
    const ConfigNode* node = find("origin", false);
    if (node == nullptr) return Eigen::Vector2d::Zero();
    if (!node->is_list() || node->items.size() != 3) {
      errors_.error(node->place, "'origin' must be a list of three numbers: x, y and a rotation");
      return Eigen::Vector2d::Zero();
    }
    Eigen::Vector3d pose = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < 3; ++i)
      pose[static_cast<Eigen::Index>(i)] = value("origin", node->items[i], parse_double(node->items[i])).value_or(0);
    if (pose[2] != 0) errors_.error(node->items[2].place, "a rotated map is not supported: the rotation must be 0");
    return pose.head<2>();
  }

  void expect_trinary() {
    const ConfigNode* node = find("mode", true);
    if (node != nullptr && node->text != "trinary")
      errors_.error(node->place, fmt::format("'mode' must be trinary ({}); scale and raw maps do not define obstacles",
                                             found(*node)));
  }

 private:
  const ConfigNode* find(const char* key, bool optional) {
    const ConfigEntry* entry = tree_.is_block() ? tree_.find(key) : nullptr;
    if (entry == nullptr && !optional && tree_.is_block())
      errors_.error(tree_.place, fmt::format("missing key '{}' in the map_server file", key));
    return entry == nullptr ? nullptr : &entry->value;
  }

  template <class T>
  std::optional<T> value(const char* key, const ConfigNode& node, Parsed<T> parsed) {
    if (!parsed.value) errors_.error(node.place, fmt::format("'{}' {}", key, parsed.fault));
    return std::move(parsed.value);
  }

  const ConfigNode& tree_;
  Diagnostics& errors_;
};

/// The options with what a map_server file says put in; `file` becomes the image, relative to the folder of the YAML.
OccupancyOptions read_map_server(const fs::path& file, OccupancyOptions options) {
  constexpr double kLargest = 1e30;
  const std::string text = read_content(file);
  Diagnostics errors(file.string(), text);
  const ConfigNode tree = read_yaml(text, errors);
  if (errors.empty()) {
    MapServerFile keys(tree, errors);
    options.file = keys.text("image");
    options.cell = keys.number("resolution", 0, kLargest, true);
    options.origin = keys.origin();
    options.negate = keys.flag("negate");
    options.occupied_thresh = keys.number("occupied_thresh", 0, 1, false);
    options.free_thresh = keys.number("free_thresh", 0, 1, false);
    keys.expect_trinary();
    if (options.free_thresh > options.occupied_thresh)
      errors.error(place_of(tree, "free_thresh"), "'free_thresh' must not be above occupied_thresh");
  }
  if (!errors.empty()) throw InputError(errors.render() + errors.count());
  return options;
}

OccupancyGrid read_image(const fs::path& file, const OccupancyOptions& options) {
  const std::string kind = lower_case(file.extension().string());
  if (kind == ".map") return read_moving_ai(read_content(file), file.string(), options);
  if (kind == ".png") return occupancy_of(read_png(read_content(file), file.string()), options);
  if (kind == ".pgm") return occupancy_of(read_pgm(read_content(file), file.string()), options);
  throw InputError(file.string() + ": a map must be a .map (Moving AI), .png, .pgm or .yaml (map_server) file");
}

}  // namespace

OccupancyGrid read_map(const OccupancyOptions& options, const fs::path& folder) {
  const fs::path file = folder / options.file;
  const std::string kind = lower_case(file.extension().string());
  if (kind != ".yaml" && kind != ".yml") return read_image(file, options);
  const OccupancyOptions stated = read_map_server(file, options);
  const std::string image = lower_case(fs::path(stated.file).extension().string());
  if (image != ".png" && image != ".pgm")
    throw InputError(file.string() + ": the image of a map_server file must be a .png or .pgm file, not " +
                     in_quotes(stated.file));
  return read_image(file.parent_path() / stated.file, stated);
}

}  // namespace leastcost
