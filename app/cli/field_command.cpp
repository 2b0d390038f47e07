// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <optional>
#include <ostream>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include <leastcost/framework/base/errors.hpp>
#include <leastcost/framework/domain/manifold.hpp>
#include "app/cli/command_options.hpp"
#include "app/cli/commands.hpp"
#include "app/cli/interrupt.hpp"
#include "app/cli/written_places.hpp"
#include "app/field/field_files.hpp"
#include "app/field/field_picture.hpp"
#include "app/field/field_summary.hpp"
#include "app/figure/figure_request.hpp"
#include "app/figure/rsvg.hpp"
#include "catalogue/output/csv_text.hpp"
#include "catalogue/run/run_origin.hpp"
#include "catalogue/run/with_notes.hpp"
#include "problems/fields/no_way.hpp"

namespace leastcost::app {
namespace {

/// How places are written.
struct PlaceForm {
  std::size_t coordinates;
  bool mesh;  ///< which has vertices, with numbers
  std::string like() const { return coordinates == 3 ? "3.5,-2,1" : "3.5,-2"; }
};

/// A place in words, "3.5,-2"; on a mesh "3.5,-2,1" or the number of a vertex.
EndOptions end_of(const std::string& text, const std::string& where, const PlaceForm& form) {
  std::vector<double> coordinates;
  bool well = true;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t comma = std::min(text.find(',', begin), text.size());
    const std::optional<double> value = csv_double(text.substr(begin, comma - begin));
    well = well && value && std::isfinite(*value);
    coordinates.push_back(value.value_or(0));
    begin = comma + 1;
  }
  EndOptions end;
  constexpr double kMostVertices = 2147483647;
  if (form.mesh && well && coordinates.size() == 1 && coordinates[0] == std::floor(coordinates[0]) &&
      coordinates[0] >= 0 && coordinates[0] <= kMostVertices) {
    end.vertex = static_cast<int>(coordinates[0]);
    return end;
  }
  if (!well || coordinates.size() != form.coordinates)
    throw InputError(form.mesh
                         ? fmt::format("{}: expected the number of a vertex, from 0, or a point like {}, found '{}'",
                                       where, form.like(), text)
                         : fmt::format("{}: expected {} numbers with commas between them, like {}, found '{}'", where,
                                       form.coordinates == 3 ? "three" : "two", form.like(), text));
  end.point = Eigen::Map<const Eigen::VectorXd>(coordinates.data(), static_cast<Eigen::Index>(coordinates.size()));
  return end;
}

/// A field can take minutes: what cannot be written is told before.
bool has_folder(const std::string& file, const Streams& streams) {
  const std::filesystem::path folder = std::filesystem::path(file).parent_path();
  if (folder.empty() || std::filesystem::is_directory(folder)) return true;
  streams.err << "error: cannot write " << file << ": there is no folder " << folder.string() << '\n';
  return false;
}

/// Places as --from has them.
std::vector<FieldPlace> places_of(const std::vector<std::string>& words, const std::string& option,
                                  const PlaceForm& form) {
  const auto is_vertex = [&form](const std::string& word) { return form.mesh && is_whole_number(word); };
  const auto has_comma = [](const std::string& word) { return word.find(',') != std::string::npos; };
  std::vector<FieldPlace> places;
  for (const WrittenPlace& place :
       written_places(words, option, is_vertex, has_comma, form.mesh ? "12 (a vertex) or " + form.like() : form.like()))
    places.push_back({end_of(place.text, place.where, form), place.in_full});
  return places;
}

/// Whether the file could be written; says so where it could not, and leaves no part of it.
bool write_bytes(const std::string& file, const std::string& text, const Streams& streams) {
  std::ofstream out(file, std::ios::binary);
  const bool opened = out.is_open();
  out << text << std::flush;
  if (out) return true;
  out.close();
  std::error_code ignored;
  if (opened && std::filesystem::is_regular_file(file, ignored)) std::filesystem::remove(file, ignored);
  streams.err << fmt::format("error: cannot write {}\n", file);
  return false;
}

/// Throws InputError for a result that would replace a file that is read.
void refuse_inputs(const FieldArguments& arguments, const Run& run) {
  std::vector<std::filesystem::path> read;
  for (const InputFile& input : run.origin->inputs) read.push_back(input.file);
  for (const auto* words : {&arguments.from, &arguments.to}) read.insert(read.end(), words->begin(), words->end());
  for (const auto& [option, file] : {std::pair("--output", &arguments.output), std::pair("--figure", &arguments.figure),
                                     std::pair("--way", &arguments.ways)})
    for (const std::filesystem::path& input : read) {
      std::error_code ignored;
      if (!file->empty() && std::filesystem::equivalent(*file, input, ignored))
        throw InputError(fmt::format("{} {} would replace a file that is read: name another file", option, *file));
    }
}

}  // namespace

Exit field_command(const FieldArguments& arguments, const Streams& streams) {
  if (arguments.corridor && arguments.to_here)
    throw InputError("--corridor has both directions already: leave out --to-here");
  const bool writes = !arguments.output.empty();
  const FieldFormat format = writes ? field_format(arguments.output) : FieldFormat::csv;  // before any work
  if (!arguments.ways.empty() && arguments.to.empty()) throw InputError("--way needs --to X,Y");
  if (!arguments.ways.empty() && arguments.ways == arguments.output)
    throw InputError("--way and --output name the same file");
  for (const std::string& file : {arguments.output, arguments.figure, arguments.ways})
    if (!has_folder(file, streams)) return Exit::output;
  const Run run = load({arguments.config, arguments.overrides, {}, false, {}, {}, EndsFrom::caller});
  refuse_inputs(arguments, run);
  const ConstraintManifold& domain = *run.parts.problem.manifold;
  check_dimension_of_field(run.parts.problem);
  const PlaceForm form{domain.dimensions().coordinate == 3 ? 3U : 2U, domain.shape() == Shape::polyhedral};
  const FieldNodes nodes = field_nodes(run.parts.problem);
  if (writes) check_format(format, nodes);
  if (!arguments.figure.empty()) {
    check_drawable(nodes);
    require_converter(figure_format(arguments.figure));
  }
  catch_interrupts();
  Monitor monitor;
  monitor.stop_requested = interrupted;
  const CostFieldOptions options{.resolution = arguments.resolution,
                                 .equal_steps = writes && format == FieldFormat::asc,
                                 .to_places = arguments.to_here};
  try {
    const std::vector<FieldPlace> to = places_of(arguments.to, "--to", form);
    if (arguments.corridor && to.size() > 1)
      throw InputError(fmt::format("--corridor leads to one place: give --to once (found {})", to.size()));
    FieldEnds ends{places_of(arguments.from, "--from", form), {}};
    if (!to.empty()) ends.target = to.front();
    RunField field(run, ends, options, monitor);
    std::vector<FieldWay> ways;
    for (const FieldPlace& place : to) {
      const PathEnd end = field.place(place);
      try {
        ways.push_back(field.way(end, monitor));
      } catch (const NoWay& e) {
        throw NoWay(fmt::format("{}: {}", place.words, e.what()));
      } catch (const InputError& e) {
        throw InputError(fmt::format("{}: {}", place.words, e.what()));
      }
    }
    std::vector<FieldWay> drawn = ways;
    if (arguments.corridor) {
      const PathEnd leads_to = to.empty() ? field.target() : field.place(to.front());
      if (!arguments.figure.empty() && ways.empty()) drawn.push_back(field.way(leads_to, monitor));
      field = field.corridor(leads_to, monitor);
    }
    if (writes && !write_bytes(arguments.output, field_text(field, format), streams)) return Exit::output;
    if (!arguments.figure.empty())
      write_picture(field_figure(field, drawn, arguments.picture), arguments.figure, arguments.picture.size.dpi);
    if (!arguments.ways.empty() && !write_bytes(arguments.ways, ways_csv(field, ways), streams)) return Exit::output;
    const std::string& file = writes ? arguments.output : arguments.figure;
    streams.out << (arguments.json ? field_summary_json(field, file, ways) : field_summary_text(field, file, ways));
    return warnings_of(field).empty() ? Exit::certified : Exit::uncertified;
  } catch (const NoWay& e) {
    throw NoWay(with_notes(e.what(), run.parts.notes));
  } catch (const InputError& e) {
    throw InputError(with_notes(e.what(), run.parts.notes));
  } catch (const Interrupted& e) {
    streams.err << e.what() << "; nothing was written\n";
    return Exit::interrupted;
  }
}

void add_field(const CommandLine& line) {
  OptionValues& v = line.values;
  CLI::App& c = *line.app.add_subcommand(
      "field", "Compute the least cost from a place, or from the nearest of several, to every cell or node");
  c.footer(
      "Nodes are on the values of a raster of costs; elsewhere the longest side of the box has 200 steps, in space 80. "
      "On a mesh "
      "they are its vertices, and the values are exact.\n"
      "  leastcost field map.yaml -o field.npy                    from the source of the configuration\n"
      "  leastcost field map.yaml -o f.csv --from 3,4 --to 20,7   and the path from there to a place\n"
      "  leastcost field map.yaml -o c.asc --corridor             the extra cost of a path through each node\n"
      "  leastcost field map.yaml --figure f.pdf --to 20,7        a picture for a paper, with the path\n"
      "  leastcost field mesh.yaml -o f.ply --from 12 --to 700    from a vertex of a mesh, and the path to another");
  c.add_option("config", v.config,
               "Configuration (YAML); - reads standard input, with files relative to the current folder")
      ->required()
      ->type_name("CONFIG");
  add_set(c, v);
  add_format(c, v);
  add_output(
      c, v,
      "Write to this file: .csv, .npy, .asc or .tif (GeoTIFF); in space .csv, .npy or .vti; on a mesh .csv, .npy, .vtp "
      "or .ply",
      "FILE");
  c.add_option("--figure", v.field.figure, "Draw the field over a lattice in the plane for a paper: .svg, .pdf or .png")
      ->type_name("FILE")
      ->check(empty_fault);
  add_look(c, v);
  c.add_option(
       "--from", v.field.from,
       "Place (in space X,Y,Z; on a mesh that or the number of a vertex), or text file with one place per line; can be "
       "repeated; default: the configuration's source")
      ->type_name("X,Y")
      ->allow_extra_args(false);
  c.add_option("--to", v.field.to, "Also find the path from there to this place; can be repeated, or a text file")
      ->type_name("X,Y")
      ->allow_extra_args(false);
  c.add_option("--way", v.field.ways, "Write the points of these paths to this CSV file")
      ->type_name("FILE")
      ->check(empty_fault);
  c.add_option("--resolution", v.field.resolution,
               "Grid spacing, in length units; at most a quarter of the shortest side of the box");
  c.add_flag("--to-here", v.field.to_here, "Compute costs of travelling to the given places instead of from them");
  c.add_flag("--corridor", v.field.corridor,
             "Instead of costs: how much more a path through each node costs than the cheapest path; to the place of "
             "--to, else "
             "to the configuration's target");
  c.callback([&] {
    if (v.output.empty() && v.field.figure.empty())
      throw CLI::ValidationError("field", "needs --output FILE, --figure FILE, or both");
    for (const char* of_picture : {"--width", "--font-size", "--what", "--unit", "--dpi"})
      if (v.field.figure.empty() && c.count(of_picture) > 0)
        throw CLI::ValidationError(of_picture, "is for the picture: add --figure FILE, or leave it out");
    read_option("--figure", [&] {
      if (!v.field.figure.empty()) check_picture_file(v.field.figure);
    });
    read_look(v.figure, read_option, v.field.picture);
    line.chosen = [&] {
      v.field.config = v.config;
      v.field.overrides = v.overrides();
      v.field.output = v.output;
      v.field.json = v.json();
      return field_command(v.field, line.streams);
    };
  });
}

}  // namespace leastcost::app
