// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// Polylines for viewers: VTK XML (ParaView) and Wavefront OBJ.
#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "catalogue/output/path_table.hpp"
#include "catalogue/output/vtp.hpp"

namespace leastcost {
namespace {

/// Three coordinates: the first ones, with zeros where there are fewer.
Eigen::Vector3d in_space(const PathTable& table, Index i) {
  Eigen::Vector3d p = Eigen::Vector3d::Zero();
  const Index rows = std::min<Index>(3, table.x.rows());
  p.head(rows) = table.x.col(i).head(rows);
  return p;
}

std::string number_text(double value) { return fmt::format("{:.17g}", value); }
template <class Vector>
std::string row_text(const Vector& values) {
  return fmt::format("{:.17g}", fmt::join(values, " "));
}

/// One line of text per point of all polylines.
template <class Value>
std::string over_points(const std::vector<PathTable>& lines, Value value) {
  std::string text;
  for (const PathTable& line : lines)
    for (Index i = 0; i < line.x.cols(); ++i)
      fmt::format_to(std::back_inserter(text), "          {}\n", value(line, i));
  return text;
}

std::string point_data(const std::vector<PathTable>& lines) {
  std::string text = "      <PointData Scalars=\"cumulative_cost\">\n";
  text += vtp_array("cumulative_cost", 1, "Float64",
                    over_points(lines, [](const PathTable& t, Index i) { return number_text(t.cumulative_costs[i]); }));
  text += vtp_array("segment_cost", 1, "Float64",
                    over_points(lines, [](const PathTable& t, Index i) { return number_text(t.segment_costs[i]); }));
  const auto coordinates = [](const PathTable& t) -> const Points& {
    return t.configurations.size() > 0 ? t.configurations : t.x;
  };
  const Index dimension = coordinates(lines.front()).rows();
  if (dimension > 3 || lines.front().configurations.size() > 0)
    text += vtp_array("coordinates", dimension, "Float64",
                      over_points(lines, [&](const PathTable& t, Index i) { return row_text(coordinates(t).col(i)); }));
  return text + "      </PointData>\n";
}

std::string cells(const std::vector<PathTable>& lines) {
  std::string connectivity, offsets;
  Index first = 0, end = 0;
  for (const PathTable& line : lines) {
    connectivity += "         ";
    for (Index i = 0; i < line.x.cols(); ++i) fmt::format_to(std::back_inserter(connectivity), " {}", first + i);
    if (line.ring) fmt::format_to(std::back_inserter(connectivity), " {}", first);
    connectivity += '\n';
    first += line.x.cols();
    end += line.x.cols() + (line.ring ? 1 : 0);
    fmt::format_to(std::back_inserter(offsets), "          {}\n", end);
  }
  return "      <Lines>\n" + vtp_array("connectivity", 1, "Int64", connectivity) +
         vtp_array("offsets", 1, "Int64", offsets) + "      </Lines>\n";
}

}  // namespace

std::string vtp_text(const std::vector<PathTable>& lines, const std::vector<VtpPart>& parts) {
  Index points = 0;
  std::string numbers, words;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    points += lines[k].x.cols();
    fmt::format_to(std::back_inserter(numbers), "          {}\n", k);
    fmt::format_to(std::back_inserter(words), "          {}\n", static_cast<int>(parts[k]));
  }
  std::string text = point_data(lines);
  text += "      <CellData>\n" + vtp_array("part", 1, "Int32", words) + vtp_array("line", 1, "Int32", numbers) +
          "      </CellData>\n      <Points>\n";
  text += vtp_array("Points", 3, "Float64",
                    over_points(lines, [](const PathTable& t, Index i) { return row_text(in_space(t, i)); }));
  text += "      </Points>\n" + cells(lines);
  return vtp_file({.points = points, .lines = static_cast<std::int64_t>(lines.size())}, text);
}

std::string obj_text(const PathTable& table) {
  std::string text = "# least-cost path by leastcost\n";
  for (Index i = 0; i < table.x.cols(); ++i)
    fmt::format_to(std::back_inserter(text), "v {}\n", row_text(in_space(table, i)));
  text += "l";
  for (Index i = 0; i < table.x.cols(); ++i) fmt::format_to(std::back_inserter(text), " {}", i + 1);
  text += table.ring ? " 1\n" : "\n";
  return text;
}

}  // namespace leastcost
