// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "app/cli/command_line.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <ostream>

#include <leastcost/framework/base/errors.hpp>
#include "app/cli/commands.hpp"
#include "app/cli/shell/command_table.hpp"
#include "app/cli/shell/completion.hpp"
#include "app/cli/shell/man_pages.hpp"
#include "app/figure/figure_request.hpp"
#include "app/reference/describe.hpp"
#include "app/reference/markdown.hpp"
#include "catalogue/output/manifest.hpp"
#include "catalogue/yaml/scalars.hpp"
#include "catalogue/yaml/suggest.hpp"

namespace leastcost::app {
namespace {

/// `ends: {pairs: FILE}` in the place of the ends that the configuration has. The file is relative to the current
/// folder, as all of the command line is.
Override pairs_option(const std::string& file) {
  std::string quoted = "'";
  for (const char c : std::filesystem::absolute(file).string()) quoted += c == '\'' ? "''" : std::string(1, c);
  return {"ends={pairs: " + quoted + "'}", "--pairs " + file};
}

/// What the options of all commands write into; a command reads what it has declared.
struct Values {
  std::string config, output, pairs, seed, kind, type, name, mesh, shard, timeout, repetitions, weld, format = "text";
  FigureOptions figure;
  std::vector<std::string> configs, set;
  int parallel = 1;
  DistancesArguments distances;
  FieldArguments field;
  bool force = false, dry_run = false, quiet = false, verbose = false, resume = false;

  bool json_lines() const { return format == "jsonl"; }
  bool json() const { return format == "json"; }
  std::vector<Override> overrides() const {
    std::vector<Override> all;
    if (!pairs.empty()) all.push_back(pairs_option(pairs));  // before what --set adds to it
    for (const std::string& assignment : set) all.push_back(set_option(assignment));
    if (!seed.empty()) all.push_back(seed_option(seed));
    if (!timeout.empty()) all.push_back({"max_seconds=" + timeout, "--timeout " + timeout});
    if (!repetitions.empty()) all.push_back({"repetitions=" + repetitions, "--repetitions " + repetitions});
    return all;
  }
};

using Command = std::function<Exit()>;

/// "2/8"; empty: everything. What it is not is an error of usage.
Shard parse_shard(const std::string& text) {
  if (text.empty()) return {};
  const std::size_t slash = text.find('/');
  const std::optional<std::size_t> index = list_index(text.substr(0, slash));
  const std::optional<std::size_t> count =
      slash == std::string::npos ? std::nullopt : list_index(text.substr(slash + 1));
  if (!index || !count || *count == 0 || *index >= *count)
    throw CLI::ValidationError("--shard", "must be i/N with i from 0 to N - 1, like 0/8 (found '" + text + "')");
  return {static_cast<int>(*index), static_cast<int>(*count)};
}

void add_format(CLI::App& command, Values& v) {
  command.add_option("--format", v.format, "text or json")->check(CLI::IsMember({"text", "json"}))->type_name("FORMAT");
}

void add_set(CLI::App& command, Values& v) {
  command.add_option("--set", v.set, "Replace one option of the configuration, e.g. --set solver.max_iterations=50")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
  command.add_option("--seed", v.seed, "Same as --set seed=N")->type_name("N");
}

/// An empty name of a folder is a variable of a shell that is not set, not a wish for the default.
std::string empty_fault(const std::string& value) { return value.empty() ? "must not be empty" : ""; }

void add_output(CLI::App& command, Values& v, const char* help, const char* type) {
  command.add_option("-o,--output", v.output, help)->type_name(type)->check(empty_fault);
}

constexpr const char* kPairsHelp =
    "Many pairs of ends: a CSV file, one pair per line. The header is source,target for vertex numbers, or\n"
    "source_x,source_y,..,target_x,.. for points, with the coordinate names of the domain. Other columns are ignored.\n"
    "Each pair, valid or not, becomes one line of paths.jsonl, in the order of the file. Exit codes: 0 all pairs\n"
    "certified, 5 all pairs have a path, 7 some have none, 130 interrupted (resume with --resume), others as for\n"
    "one path";

void add_run(CLI::App& app, Values& v, const std::vector<std::string>& arguments, const Streams& streams,
             Command& chosen) {
  CLI::App& c = *app.add_subcommand(
      "run", "Find a least-cost path, or one for each of many pairs of ends, and write the results");
  c.footer(kPairsHelp);
  c.add_option("config", v.config,
               "Configuration (YAML); - reads standard input, with files relative to the current folder")
      ->required()
      ->type_name("CONFIG");
  add_set(c, v);
  c.add_option("--format", v.format, "text or json; with many pairs also jsonl: the lines of paths.jsonl")
      ->check(CLI::IsMember({"text", "json", "jsonl"}))
      ->type_name("FORMAT");
  add_output(c, v, "Output folder; default: results/<name>", "DIR");
  c.add_option("--pairs", v.pairs, "Find a path for each pair in this CSV file, instead of the configuration's ends")
      ->type_name("FILE")
      ->check(empty_fault);
  c.add_option("-j,--jobs", v.parallel, "With many pairs: number of threads")
      ->type_name("N")
      ->check(CLI::Range(1, 1024));
  auto* resume = c.add_flag("--resume", v.resume, "With many pairs: resume an interrupted or killed run");
  c.add_flag("--force", v.force, "Replace the output folder of an earlier run")->excludes(resume);
  c.add_flag("-n,--dry-run", v.dry_run,
             "Check everything, including input files, and print the plan; solve and write nothing");
  auto* quiet = c.add_flag("-q,--quiet", v.quiet, "Print no progress");
  c.add_flag("-v,--verbose", v.verbose, "Print more about the result")->excludes(quiet);
  c.callback([&] {
    chosen = [&] {
      RunArguments run{{v.config, v.overrides(), v.output, v.force, arguments}, v.dry_run, v.json(), Verbosity::normal};
      if (v.quiet) run.verbosity = Verbosity::quiet;
      if (v.verbose) run.verbosity = Verbosity::verbose;
      run.json_lines = v.json_lines();
      run.resume = v.resume;
      run.threads = v.parallel;
      return run_command(run, streams);
    };
  });
}

constexpr const char* kStudyHelp =
    "On one machine:         leastcost study CONFIG -j 4 -o DIR     (if killed: add --resume)\n"
    "Shards, GNU parallel:   seq 0 7 | parallel leastcost study CONFIG --shard {}/8 -o DIR/{} --resume\n"
    "Shards, Slurm:          sbatch --array=0-7 --wrap 'leastcost study CONFIG --shard $SLURM_ARRAY_TASK_ID/8 "
    "-o DIR/$SLURM_ARRAY_TASK_ID --resume'\n"
    "Then:                   leastcost merge DIR/* -o MERGED\n"
    "Times are comparable only if cells do not compete: use -j 1, or fewer jobs than cores.\n"
    "Exit codes: 0 every cell ended, 7 part of the study failed, 130 interrupted (resume with --resume), others as for "
    "run";

void add_study(CLI::App& app, Values& v, const std::vector<std::string>& arguments, const Streams& streams,
               Command& chosen) {
  CLI::App& c = *app.add_subcommand("study", "Run a grid of problems, solvers and options, and compare");
  c.footer(kStudyHelp);
  c.add_option("config", v.config, "Study (YAML with `problems`)")->required()->type_name("CONFIG");
  add_set(c, v);
  add_format(c, v);
  add_output(c, v, "Output folder; default: results/<name>", "DIR");
  c.add_option("-j,--jobs", v.parallel, "Number of cells to run in parallel")
      ->type_name("N")
      ->check(CLI::Range(1, 1024));
  c.add_option("--shard", v.shard, "Run only shard i of N, with i from 0 to N - 1")->type_name("i/N");
  c.add_option("--timeout", v.timeout, "Same as --set max_seconds=S")->type_name("S");
  c.add_option("--repetitions", v.repetitions, "Same as --set repetitions=R")->type_name("R");
  auto* resume = c.add_flag("--resume", v.resume, "Resume an interrupted or killed study");
  c.add_flag("--force", v.force, "Replace the output folder of an earlier study")->excludes(resume);
  c.add_flag("-n,--dry-run", v.dry_run,
             "Check the keys and types of every cell and print the grid; validate also composes each cell");
  c.add_flag("-q,--quiet", v.quiet, "Print no progress");
  c.callback([&] {
    chosen = [&, shard = parse_shard(v.shard)] {
      StudyArguments study;
      study.request.config_file = v.config;
      study.request.overrides = v.overrides();
      study.request.output = v.output;
      study.request.force = v.force;
      study.request.resume = v.resume;
      study.request.parallel = v.parallel;
      study.request.shard = shard;
      study.request.arguments = arguments;
      study.dry_run = v.dry_run;
      study.json = v.json();
      study.quiet = v.quiet;
      return study_command(study, streams);
    };
  });
}

void add_merge(CLI::App& app, Values& v, const std::vector<std::string>& arguments, const Streams& streams,
               Command& chosen) {
  CLI::App& c = *app.add_subcommand("merge", "Merge the shards of a study");
  c.add_option("folders", v.configs, "Output folders of the shards")->required()->type_name("DIR...");
  c.add_option("-o,--output", v.output, "Output folder")->required()->type_name("DIR")->check(empty_fault);
  c.add_flag("--force", v.force, "Replace the output folder of an earlier study");
  add_format(c, v);
  c.callback([&] {
    chosen = [&] {
      const MergeRequest request{{v.configs.begin(), v.configs.end()}, v.output, v.force, arguments};
      return merge_command({request, v.json()}, streams);
    };
  });
}

void add_validate(CLI::App& app, Values& v, const Streams& streams, Command& chosen) {
  CLI::App& c =
      *app.add_subcommand("validate", "Check configurations and print every error with its position, without solving");
  c.add_option("configs", v.configs, "Configurations (YAML); - reads standard input")
      ->required()
      ->type_name("CONFIG...");
  add_set(c, v);
  add_format(c, v);
  c.callback([&] { chosen = [&] { return validate_command(v.configs, v.overrides(), v.json(), streams); }; });
}

void add_report(CLI::App& app, Values& v, const Streams& streams, Command& chosen) {
  CLI::App& c = *app.add_subcommand("report", "Rebuild report.html from the files of a run or a study");
  c.add_option("folders", v.configs, "Output folder of a run or a study")->required()->type_name("DIR...");
  c.callback([&] { chosen = [&] { return report_command(v.configs, streams); }; });
}

constexpr const char* kFigureHelp =
    "leastcost figure results/bunny_geodesic -o bunny.pdf                     one column of a paper\n"
    "leastcost figure results/bunny_geodesic -o bunny.pdf --view 30,20 --what path,ends,shading\n"
    "leastcost figure results/bunny_geodesic -o bunny.vtp                     surface and path, for ParaView\n"
    ".svg needs no other program; .pdf and .png need rsvg-convert (Debian: librsvg2-bin).";

/// A fault of what an option says is one of the command line.
void read_option(const char* option, const std::function<void()>& value) {
  try {
    value();
  } catch (const InputError& e) {
    throw CLI::ValidationError(option, e.what());
  }
}

FigureArguments figure_arguments(const Values& v) {
  return {figure_request(v.config, v.output, v.figure, read_option), v.output};
}

/// How any picture looks.
void add_look(CLI::App& c, Values& v) {
  constexpr double kLeastDpi = 72, kMostDpi = 1200;
  c.add_option("--width", v.figure.width, "Width in mm, cm, in or pt; default: 84mm, one column")->type_name("WIDTH");
  c.add_option("--font-size", v.figure.font_size, "Font size of all text, in points; default: 8")->type_name("PT");
  c.add_option("--what", v.figure.what, "What to draw: any of " + joined(figure_parts()) + "; default: all that fits")
      ->type_name("LIST");
  c.add_option("--unit", v.figure.unit,
               "Unit of the coordinates, for the axes; default: m if the cost is in m, else none")
      ->type_name("TEXT");
  c.add_option("--dpi", v.figure.dpi, "Pixels per inch of a PNG and of a shaded surface; default: 300")
      ->type_name("N")
      ->check(CLI::Range(kLeastDpi, kMostDpi));
}

void add_figure(CLI::App& app, Values& v, const Streams& streams, Command& chosen) {
  CLI::App& c = *app.add_subcommand("figure", "Draw a finished run for a paper: SVG, PDF or PNG of a given width");
  c.footer(kFigureHelp);
  c.add_option("folder", v.config, "Output folder of a run")->required()->type_name("DIR");
  c.add_option("-o,--output", v.output, "File: .svg, .pdf or .png; .vtp or .ply: surface and path for 3D programs")
      ->required()
      ->type_name("FILE")
      ->check(empty_fault);
  add_look(c, v);
  c.add_option("--picture", v.figure.picture,
               "Which picture: space, map, poses, coordinates or convergence; default: the best one available")
      ->type_name("NAME");
  c.add_option("--view", v.figure.view, "Look at space from these angles: azimuth and elevation in degrees, like 30,20")
      ->type_name("AZ,EL");
  c.callback([&] { chosen = [&, figure = figure_arguments(v)] { return figure_command(figure, streams); }; });
}

void add_reference(CLI::App& app, Values& v, const Streams& streams, Command& chosen) {
  CLI::App& list = *app.add_subcommand("list", "List the types that a configuration can use");
  list.add_option("kind", v.kind,
                  "manifolds, obstacles, robots, costs, kernels, initializers, solvers, post_processors, formats")
      ->type_name("KIND");
  add_format(list, v);
  list.callback([&] { chosen = [&] { return list_command(v.kind, v.json(), streams); }; });

  CLI::App& describe = *app.add_subcommand(
      "describe", "Describe every option of a type, of a configuration (describe run) or of a study (describe study)");
  describe
      .add_option("kind", v.kind,
                  "run, study, manifold, obstacle, robot, cost, kernel, initializer, solver, post_processor")
      ->type_name("KIND");
  describe.add_option("type", v.type, "Type to describe, e.g. euclidean; without it, all types of the kind")
      ->type_name("TYPE");
  describe
      .add_option("--markdown", v.output,
                  "Instead: write a Markdown page for each type, each kind, run and study into this folder")
      ->type_name("DIR")
      ->check(empty_fault);
  describe.callback([&] {
    if (v.kind.empty() == v.output.empty()) throw CLI::ValidationError("describe", "needs a KIND or --markdown DIR");
    chosen = [&] {
      return v.output.empty() ? describe_command(v.kind, v.type, streams)
                              : pages_command(reference_pages(), v.output, streams);
    };
  });

  CLI::App& schema =
      *app.add_subcommand("schema", "Print the JSON Schema (draft 7) of configurations and studies, for editors");
  schema.callback([&] { chosen = [&] { return streams.out << json_schema(), Exit::certified; }; });
}

void add_helpers(CLI::App& app, Values& v, const Streams& streams, Command& chosen) {
  CLI::App& init = *app.add_subcommand(
      "init", "Write a commented starting configuration that runs, or, without a name, print the list of templates");
  init.footer(
      "Each template becomes a folder: the configuration, the sample data that it reads, and leastcost.schema.json, "
      "which the first line of the configuration names, for editors with the YAML language server. Files that exist "
      "are not overwritten.\n"
      "  leastcost init mesh                      mesh/mesh.yaml, ...\n"
      "  leastcost init mesh -o work/first.yaml   work/first.yaml, ...\n"
      "  leastcost init mesh -o -                 the configuration alone, on standard output");
  init.add_option("template", v.name, "Name of the template")->type_name("TEMPLATE");
  add_output(init, v, "Folder, or a .yaml file in it; default: the name of the template", "PATH");
  init.add_flag("--force", v.force, "Overwrite files that exist");
  init.callback([&] { chosen = [&] { return init_command(v.name, v.output, v.force, streams); }; });

  CLI::App& doctor = *app.add_subcommand("doctor", "Report the faults of a mesh, and what it needs for a solve");
  doctor.add_option("mesh", v.mesh, "OBJ, OFF, PLY or STL file")->required()->type_name("MESH");
  doctor.add_flag(
      "--weld", v.weld,
      "First merge vertices at equal positions; --weld=1e-6: also those no farther apart than this, in length units");
  add_format(doctor, v);
  doctor.callback([&] { chosen = [&] { return doctor_command(v.mesh, v.weld, v.json(), streams); }; });

  CLI::App& distances = *app.add_subcommand(
      "distances", "Compute exact distances on a mesh to all vertices, from one vertex or from the nearest of several");
  distances.add_option("mesh", v.mesh, "OBJ, OFF, PLY or STL file")->required()->type_name("MESH");
  DistancesArguments& d = v.distances;
  distances
      .add_option("--from", d.from,
                  "Vertex number in the file, from 0, or a text file of vertex numbers; can be repeated")
      ->required()
      ->type_name("VERTEX");
  distances.add_flag(
      "--weld", v.weld,
      "First merge vertices at equal positions; --weld=1e-6: also those no farther apart than this, in length units");
  distances.add_option("--max-distance", d.max_distance, "Go no farther than this, in length units")
      ->check(CLI::PositiveNumber);
  distances.add_option("--max-seconds", d.max_seconds, "Stop after this time, in seconds; default: no limit")
      ->check(CLI::PositiveNumber);
  distances
      .add_option("--max-memory", d.max_memory, "Stop before windows take more memory than this, in GB; default: 1.8")
      ->check(CLI::PositiveNumber);
  distances.add_option("--max-windows", d.max_windows, "Stop after this many windows; default: no limit")
      ->check(CLI::PositiveNumber);
  distances.add_flag("-q,--quiet", v.quiet, "Print no progress");
  add_output(distances, v, "Write to this file: .csv, .vtp or .ply; default: CSV on standard output", "FILE");
  distances.callback([&] {
    chosen = [&] {
      v.distances.mesh = v.mesh;
      v.distances.output = v.output;
      v.distances.weld = v.weld;
      v.distances.quiet = v.quiet;
      return distances_command(v.distances, streams);
    };
  });
}

void add_field(CLI::App& app, Values& v, const Streams& streams, Command& chosen) {
  CLI::App& c = *app.add_subcommand(
      "field", "Compute the least cost from a place, or from the nearest of several, to every cell or node");
  c.footer(
      "Nodes are on the values of a raster of costs; elsewhere the longest side of the box has 200 steps. On a mesh "
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
  add_output(c, v, "Write to this file: .csv, .npy, .asc or .tif (GeoTIFF); on a mesh .csv, .npy, .vtp or .ply",
             "FILE");
  c.add_option("--figure", v.field.figure, "Draw the field over a lattice for a paper: .svg, .pdf or .png")
      ->type_name("FILE")
      ->check(empty_fault);
  add_look(c, v);
  c.add_option("--from", v.field.from,
               "Place (on a mesh X,Y,Z or the number of a vertex), or text file with one place per line; can be "
               "repeated; default: the configuration's source")
      ->type_name("X,Y")
      ->allow_extra_args(false);
  c.add_option("--to", v.field.to, "Also find the path from there to this place; can be repeated, or a text file")
      ->type_name("X,Y")
      ->allow_extra_args(false);
  c.add_option("--way", v.field.ways, "Write the points of these paths to this CSV file")
      ->type_name("FILE")
      ->check(empty_fault);
  c.add_option("--resolution", v.field.resolution, "Grid spacing, in length units");
  c.add_flag("--to-here", v.field.to_here, "Compute costs of travelling to the given places instead of from them");
  c.add_flag(
      "--corridor", v.field.corridor,
      "Instead of costs: the extra cost of a path forced through each node, which leads to the place of --to, else to "
      "the configuration's target");
  c.callback([&] {
    if (v.output.empty() && v.field.figure.empty())
      throw CLI::ValidationError("field", "needs --output FILE, --figure FILE, or both");
    read_option("--figure", [&] {
      if (!v.field.figure.empty()) check_picture_file(v.field.figure);
    });
    read_look(v.figure, read_option, v.field.picture);
    chosen = [&] {
      v.field.config = v.config;
      v.field.overrides = v.overrides();
      v.field.output = v.output;
      v.field.json = v.json();
      return field_command(v.field, streams);
    };
  });
}

/// A text for those who install the program, under the name that this one has.
std::string renamed(std::string text, const std::string& program) {
  static const std::string kName = "leastcost";
  if (program == kName) return text;
  for (std::size_t at = text.find(kName); at != std::string::npos; at = text.find(kName, at + program.size()))
    text.replace(at, kName.size(), program);
  return text;
}

/// For those who install the program: made of the same tables as --help.
void add_shell(CLI::App& app, Values& v, const Streams& streams, Command& chosen) {
  CLI::App& completion = *app.add_subcommand("completion", "Print the script that completes commands in a shell");
  completion.footer(
      "bash: leastcost completion bash > ~/.local/share/bash-completion/completions/leastcost\n"
      "zsh:  leastcost completion zsh > DIR/_leastcost, with DIR in fpath\n"
      "fish: leastcost completion fish > ~/.config/fish/completions/leastcost.fish\n"
      "The Debian package and cmake --install install all three.");
  completion.add_option("shell", v.name, "bash, zsh or fish")
      ->required()
      ->check(CLI::IsMember({"bash", "zsh", "fish"}))
      ->type_name("SHELL");
  completion.callback([&] {
    chosen = [&] {
      const CommandTable table = command_table(app);
      const std::string script = v.name == "bash"  ? bash_completion(table)
                                 : v.name == "zsh" ? zsh_completion(table)
                                                   : fish_completion(table);
      streams.out << renamed(script, app.get_name());
      return Exit::certified;
    };
  });

  CLI::App& man =
      *app.add_subcommand("man", "Write the man pages, leastcost.1 and one for each command, into a folder");
  man.add_option("folder", v.output, "Folder")->required()->type_name("DIR")->check(empty_fault);
  man.callback([&] {
    chosen = [&] {
      std::map<std::string, std::string> pages;
      for (const auto& [name, text] : man_pages(command_table(app), std::string(program_version())))
        pages[renamed(name, app.get_name())] = renamed(text, app.get_name());
      return pages_command(pages, v.output, streams);
    };
  });
}

std::vector<std::string> names_of(const std::vector<CLI::App*>& commands) {
  std::vector<std::string> names;
  names.reserve(commands.size());
  for (const CLI::App* command : commands) names.push_back(command->get_name());
  return names;
}

/// CLI11 suggests nothing; for the first option that the command does not have, we do.
std::string option_hint(const CLI::App& app, const std::vector<std::string>& arguments) {
  const CLI::App* command = &app;
  for (const CLI::App* c : app.get_subcommands({}))
    if (arguments.size() > 1 && c->get_name() == arguments[1]) command = c;
  std::vector<std::string> known;
  for (const CLI::Option* option : command->get_options())
    for (const std::string& name : option->get_lnames()) known.push_back("--" + name);
  for (const std::string& argument : arguments) {
    const std::string word = argument.substr(0, argument.find('='));
    if (word.rfind("--", 0) == 0 && std::count(known.begin(), known.end(), word) == 0) return did_you_mean(word, known);
  }
  return "";
}

/// Help and version are no errors; everything else is one of usage.
Exit parse_outcome(const CLI::App& app, const CLI::ParseError& e, const std::vector<std::string>& arguments,
                   const Streams& streams) {
  if (e.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success)) {
    app.exit(e, streams.out, streams.err);
    return Exit::certified;
  }
  std::string message = e.what();
  if (const std::vector<std::string> extra = app.remaining(true);
      !extra.empty())  // its own message has them in reverse
    message = fmt::format("not expected here: {}", fmt::join(extra, " "));
  std::replace(message.begin(), message.end(), '\n', ' ');
  streams.err << "error: " << message << option_hint(app, arguments)
              << fmt::format("\nTry: {0} --help, {0} COMMAND --help\n", app.get_name());
  return Exit::usage;
}

Exit parse_and_run(const std::vector<std::string>& arguments, const Streams& streams, Values& values) {
  CLI::App app("Find least-cost paths on manifolds, with points equally spaced in cost",
               std::filesystem::path(arguments.front()).filename().string());
  app.set_version_flag("--version", "leastcost " + std::string(program_version()));
  app.require_subcommand(1);
  app.footer(
      "Exit codes: 0 certified, 1 internal error, 2 usage, 3 configuration, 4 input, 5 uncertified or collapsed,\n6 no "
      "path, 7 part of a study or of many pairs failed, 8 output or system error, 130 interrupted");
  Command chosen;
  add_run(app, values, arguments, streams, chosen);
  add_study(app, values, arguments, streams, chosen);
  add_merge(app, values, arguments, streams, chosen);
  add_validate(app, values, streams, chosen);
  add_report(app, values, streams, chosen);
  add_figure(app, values, streams, chosen);
  add_reference(app, values, streams, chosen);
  add_helpers(app, values, streams, chosen);
  add_field(app, values, streams, chosen);
  add_shell(app, values, streams, chosen);

  const std::vector<std::string> names = names_of(app.get_subcommands({}));
  if (arguments.size() > 1 && arguments[1].rfind('-', 0) != 0 &&
      std::count(names.begin(), names.end(), arguments[1]) == 0) {
    streams.err << "error: unknown command '" << arguments[1] << "'" << did_you_mean(arguments[1], names)
                << "; commands: " << joined(names) << '\n';
    return Exit::usage;
  }
  try {
    // CLI11 takes the arguments in reverse, without the program.
    app.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend() - 1));
  } catch (const CLI::ParseError& e) {
    return parse_outcome(app, e, arguments, streams);
  }
  return chosen();
}

}  // namespace

int run_program(const std::vector<std::string>& arguments, const Streams& streams) {
  Values values;
  try {
    const Exit exit = parse_and_run(arguments, streams, values);
    if (streams.out.flush()) return static_cast<int>(exit);
    streams.err << "error: the result could not be written to standard output\n";
    return static_cast<int>(Exit::output);
  } catch (...) {
    return static_cast<int>(exit_of_exception(streams, values.json()));
  }
}

}  // namespace leastcost::app
