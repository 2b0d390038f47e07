// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/readers/mesh_reader.hpp>

#include <algorithm>
#include <array>
#include <string>

#include <leastcost/framework/base/errors.hpp>
#include "problems/readers/file_content.hpp"
#include "problems/readers/format_readers.hpp"
#include "problems/readers/text_scanner.hpp"

namespace leastcost {
namespace {

struct Format {
  const char* extension;
  PolygonSoup (*read)(std::string_view content, const std::string& file, const Deadline& deadline);
};

constexpr std::array<Format, 4> kFormats = {
    {{".obj", read_obj}, {".off", read_off}, {".ply", read_ply}, {".stl", read_stl}}};

/// The extension that the first token stands for, empty when it says nothing.
std::string format_by_content(std::string_view content, const std::string& file) {
  TextScanner scanner(content.substr(0, 200), file, {});
  if (!scanner.next_line()) return "";
  const std::string first = lower_case(std::string(scanner.token()));
  if (first == "ply") return ".ply";
  if (first == "solid") return ".stl";
  if (first.size() <= 8 && first.ends_with("off")) return ".off";
  if (first == "v" || first == "mtllib") return ".obj";
  return "";
}

}  // namespace

PolygonSoup read_mesh(const std::filesystem::path& file, const Deadline& deadline) {
  const std::string name = file.string();
  const std::string extension = lower_case(file.extension().string());
  const auto format =
      std::find_if(kFormats.begin(), kFormats.end(), [&](const Format& f) { return extension == f.extension; });
  if (format == kFormats.end()) {
    throw InputError(name + ": unknown mesh format " + printable(extension) +
                     "; a mesh must be a .obj, .off, .ply or .stl file");
  }
  const std::string content = read_content(file);
  if (content.empty()) throw InputError(name + ": the file is empty");
  if (!(extension == ".stl" && is_binary_stl(content))) {
    const std::string looks_like = format_by_content(content, name);
    if (!looks_like.empty() && looks_like != extension) {
      throw InputError(name + ":1: the content is that of a " + looks_like + " file; rename it to match");
    }
  }
  PolygonSoup soup = format->read(content, name, deadline);
  if (soup.polygon_begin.size() < 2) {
    throw InputError(name + ": no faces (" + std::to_string(soup.positions.size()) +
                     " vertices); a mesh needs at least one");
  }
  soup.source = name;
  return soup;
}

}  // namespace leastcost
