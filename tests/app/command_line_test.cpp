// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT

// The commands inside the process: what goes to which stream, and the exit codes.
#include "app/cli/command_line.hpp"

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>

#include "catalogue/registry/registry.hpp"
#include "tests/app/called.hpp"
#include "tests/app/config_text.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/data.hpp"

namespace leastcost::test {

namespace fs = std::filesystem;
using Catch::Contains;
using Json = nlohmann::json;

namespace {

std::string write_text(const fs::path& file, const std::string& text) {
  std::ofstream(file) << text;
  return file.string();
}

}  // namespace

TEST_CASE("command line: wrong usage is exit 2, with a suggestion") {
  CHECK(call({}).exit == 2);
  const Called wrong = call({"rnu", "x.yaml"});
  CHECK(wrong.exit == 2);
  CHECK(wrong.out == "");
  CHECK_THAT(wrong.err, Contains("unknown command 'rnu' (did you mean 'run'?)"));
  CHECK_THAT(call({"validate", "--sett", "a=1", "x"}).err, Contains("(did you mean '--set'?)"));
  CHECK(call({"run"}).exit == 2);
  CHECK(call({"run", "x.yaml", "--format", "xml"}).exit == 2);
  CHECK(call({"run", "x.yaml", "-q", "-v"}).exit == 2);
  CHECK(call({"describe"}).exit == 2);
}

TEST_CASE("command line: help and version are results") {
  CHECK(call({"--version"}).exit == 0);
  CHECK_THAT(call({"--version"}).out, Contains("leastcost "));
  const Called help = call({"--help"});
  CHECK(help.exit == 0);
  CHECK_THAT(help.out, Contains("validate") && Contains("doctor") && Contains("Exit codes"));
  CHECK_THAT(call({"run", "--help"}).out, Contains("--dry-run") && Contains("--set"));
}

TEST_CASE("command line: run prints the result and nothing else on stdout") {
  const ScratchDir dir;
  const std::string config = write_text(dir / "plane.yaml", kPlane);
  const Called text = call({"run", config, "-o", (dir / "out").string()});
  CHECK(text.exit == 0);
  CHECK(text.err == "");
  CHECK_THAT(text.out, Contains("status      certified (local, proved)") && Contains("cost        5 +- ") &&
                           Contains("length") && Contains("spacing") && Contains("time        read ") &&
                           Contains((dir / "out").string()));
  const Called json = call({"run", config, "-o", (dir / "out").string(), "--force", "--format", "json"});
  CHECK(json.exit == 0);
  const Json result = Json::parse(json.out);
  CHECK(result["status"] == "certified");
  CHECK(result["output"] == (dir / "out").string());
}

TEST_CASE("command line: exit codes of run") {
  const ScratchDir dir;
  const std::string out = (dir / "out").string();
  const Called invalid = call({"run", write_text(dir / "a.yaml", "manifold: 3\n"), "-o", out, "--format", "json"});
  CHECK(invalid.exit == 3);
  CHECK(Json::parse(invalid.out)["status"] == "configuration_error");
  CHECK(call({"run", (dir / "none.yaml").string(), "-o", out}).exit == 4);
  const std::string mesh =
      "manifold: {type: mesh, file: none.obj}\ncost: euclidean\nends: {source: {vertex: 0}, target: {vertex: 1}}\n";
  const Called missing = call({"run", write_text(dir / "b.yaml", mesh), "-o", out});
  CHECK(missing.exit == 4);
  CHECK_THAT(missing.err, Contains("b.yaml:1:30: ") && Contains("none.obj: no such file"));
  CHECK_FALSE(fs::exists(out));
  const Called no_path =
      call({"run", (project_dir() / "configs/no_path.yaml").string(), "-o", out, "--format", "json"});
  CHECK(no_path.exit == 6);
  CHECK_THAT(no_path.err, Contains("no path: "));
  CHECK(Json::parse(no_path.out)["status"] == "no_path");
  CHECK_FALSE(fs::exists(out));
  const std::string plane = write_text(dir / "plane.yaml", kPlane);
  CHECK(call({"run", plane, "-o", out, "--set", "certificate.enabled=false"}).exit == 5);
  CHECK(call({"run", plane, "-o", out}).exit == 2);
  CHECK(call({"run", plane, "-o", "/proc/leastcost/x"}).exit == 8);
}

TEST_CASE("command line: words that are not expected are named in their order") {
  const Called schema = call({"schema", "-o", "x"});
  CHECK(schema.exit == 2);
  CHECK_THAT(schema.err, Contains("not expected here: -o x"));
  CHECK_THAT(call({"list", "costs", "b", "c"}).err, Contains("not expected here: b c"));
  CHECK_THAT(call({"run", "a.yaml", "--outptu", "x"}).err, Contains("did you mean '--output'"));
}

TEST_CASE("command line: --set and --seed") {
  const ScratchDir dir;
  const std::string plane = write_text(dir / "plane.yaml", kPlane);
  const Called run = call({"run", plane, "--set", "path.points=5", "--set", "kernel=square", "--seed", "7", "--format",
                           "json", "-o", (dir / "out").string()});
  CHECK(run.exit == 0);
  CHECK(Json::parse(run.out)["points"] == 5);
  const Called wrong = call({"run", plane, "--seed", "x"});
  CHECK(wrong.exit == 3);
  CHECK(wrong.err == "--seed x: error: 'seed' must be a whole number (found 'x')\n1 error in " + plane + "\n");
}

TEST_CASE("command line: dry run solves and writes nothing") {
  const ScratchDir dir;
  const std::string plane = write_text(dir / "plane.yaml", kPlane);
  const Called text = call({"run", plane, "-n", "-o", (dir / "out").string()});
  CHECK(text.exit == 0);
  CHECK_THAT(text.out, Contains("would run   straight, newton, certificate") && Contains("dimension 2 in R^2"));
  CHECK_THAT(text.out, Contains("\n            first path: straight, because there are no obstacles") &&
                           Contains("\n            solver: newton, because ") &&
                           Contains("\n            post-processors: none, because ") &&
                           Contains("\n            proof over all paths: none, because "));
  CHECK_FALSE(fs::exists(dir / "out"));
  const Called json = call({"run", plane, "--dry-run", "--format", "json"});
  CHECK(Json::parse(json.out)["status"] == "dry_run");
  CHECK(Json::parse(json.out)["why"].size() == 4);
  CHECK_THAT(call({"run", plane, "-n", "--set", "solver=lbfgs"}).out, !Contains("solver: "));
  CHECK(call({"run", write_text(dir / "bad.yaml", "x: 1\n"), "-n"}).exit == 3);
}

TEST_CASE("command line: validate") {
  const ScratchDir dir;
  const std::string good = write_text(dir / "good.yaml", kPlane),
                    bad = write_text(dir / "bad.yaml", kPlane + "nmae: x\n");
  CHECK(call({"validate", good}).out == good + ": valid\n");
  for (const char* fault : {"obstacles=[bal]", "obstacles=[3]", "post_process=[trac]"}) {
    CAPTURE(fault);
    CHECK(call({"validate", good, "--set", fault}).exit == 3);
  }
  const Called both = call({"validate", good, bad});
  CHECK(both.exit == 3);
  CHECK(both.err ==
        bad + ":6:1: error: unknown key 'nmae' (did you mean 'name'?)\n    6 | nmae: x\n      | ^~~~\n1 error in " +
            bad + "\n");
  const Json report = Json::parse(call({"validate", good, bad, "--format", "json"}).out);
  CHECK(report["valid"] == false);
  CHECK(report["files"][1]["errors"][0]["line"] == 6);
  const Called missing = call({"validate", (dir / "none.yaml").string(), good});
  CHECK(missing.exit == 4);
  CHECK_THAT(missing.err, Contains("cannot be opened"));
  CHECK(missing.out == good + ": valid\n");
}

TEST_CASE("command line: validate says which files it did not read and which are missing") {
  const ScratchDir dir;
  write_text(dir / "dem.asc", "no raster at all\n");
  const std::string ends = "ends: {source: {point: [0, 0]}, target: {point: [1, 1]}}\n",
                    there = write_text(dir / "there.yaml", "manifold: {type: terrain, file: dem.asc}\n" + ends),
                    gone = write_text(dir / "gone.yaml", "manifold: {type: terrain, file: gone.asc}\n" + ends);
  CHECK(call({"validate", there}).out ==
        there + ": valid\n  not checked: the contents of dem.asc; leastcost run reads it\n");
  const Json report = Json::parse(call({"validate", there, "--format", "json"}).out);
  CHECK(report["files"][0]["not_checked"][0] == "dem.asc");
  const Called missing = call({"validate", gone});
  CHECK(missing.exit == 3);
  CHECK_THAT(missing.err, Contains("gone.yaml:1:33: error: ") && Contains("gone.asc: no such file"));
}

TEST_CASE("command line: exit codes are in the help of every command") {
  for (const char* command : {"run", "field", "study", "validate", "doctor", "figure"}) {
    const std::string help = call({command, "--help"}).out;
    CHECK_THAT(help, Contains("Exit codes: 0 certified"));
    CHECK(help.find("Exit codes: 0 certified") == help.rfind("Exit codes: 0 certified"));
  }
}

TEST_CASE("command line: list and describe, singular and plural") {
  CHECK_THAT(call({"list"}).out, Contains("expm1_square") && Contains("dijkstra") && Contains("formats"));
  CHECK(call({"list", "kernels"}).out == call({"list", "kernel"}).out);
  const Json solvers = Json::parse(call({"list", "solvers", "--format", "json"}).out)["solvers"];
  CHECK(solvers.size() == kind("solver").entries.size());
  const Called wrong = call({"list", "kernles"});
  CHECK(wrong.exit == 2);
  CHECK_THAT(wrong.err, Contains("did you mean 'kernels'?"));
  CHECK(call({"describe", "cost", "travel_time"}).out == call({"describe", "costs", "travel_time"}).out);
  CHECK_THAT(call({"describe", "cost", "travel_time"}).out,
             Contains("gravity") && Contains("default 9.80665") && Contains("greater than 0"));
  CHECK_THAT(call({"describe", "cost", "euclidean"}).out, Contains("It has no options."));
  CHECK_THAT(call({"describe", "cost", "euclidan"}).err, Contains("did you mean 'euclidean'?"));
  CHECK_THAT(call({"describe", "cost"}).out, Contains("metric_tensor"));
  CHECK_THAT(call({"describe", "run"}).out, Contains("max_seconds"));
}

TEST_CASE("command line: a configuration from standard input") {
  if (program().empty()) return record_skip("standard input", "the program was not built");
  const ScratchDir dir;
  std::filesystem::copy(project_dir() / "configs/data/hill.obj", dir / "hill.obj");
  write_text(dir / "a.yaml",
             "manifold: {type: mesh, file: hill.obj}\ncost: euclidean\n"
             "ends: {source: {vertex: 0}, target: {vertex: 20}}\npath: {points: 9}\n");
  const auto shell = [&](const std::string& command) {
    const int status = std::system(("cd '" + dir.path().string() + "' && " + command).c_str());
    return (status >> 8) & 0xff;
  };
  const std::string leastcost = "'" + program().string() + "' ";
  for (const char* name : {"-", "/dev/stdin"}) {
    CAPTURE(name);
    CHECK(shell(leastcost + "run " + name + " -q --force <a.yaml >out.txt 2>&1") == 0);
    CHECK(std::filesystem::exists(dir / "results/stdin/result.json"));
    CHECK(shell(leastcost + "validate " + name + " <a.yaml >out.txt 2>&1") == 0);
    CHECK(shell("echo 'cost: euclidian' | " + leastcost + "validate " + name + " 2>err.txt") == 3);
    CHECK_THAT(content(dir / "err.txt"), Contains("stdin:1:7: error: unknown cost 'euclidian'"));
  }
  CHECK(shell("grep -q '<stdin>' results/stdin/manifest.json") == 0);
  CHECK_THAT(call({"run", "--help"}).out, Contains("standard input"));
}

TEST_CASE("command line: ends of a chart are not moved onto anything") {
  const ScratchDir dir;
  const std::string chart = (project_dir() / "configs/torus_parametric.yaml").string();
  const Called run = call({"run", chart, "-q", "-o", (dir / "out").string()});
  CHECK_THAT(run.out, Contains("source      (0, 0)\n"));
  CHECK(run.out.find("onto the manifold") == std::string::npos);
  CHECK(call({"run", chart, "-n"}).out.find("onto the manifold") == std::string::npos);
  const std::string sphere = (project_dir() / "configs/implicit_torus.yaml").string();
  CHECK_THAT(
      call({"run", sphere, "-n", "--set", "ends.source.point=[3.001, 0, 0]", "--set", "ends.source.tolerance=1"}).out,
      Contains("moved by 0.001 onto the manifold"));
}

TEST_CASE("command line: parts of a run are described, and formats of rasters are listed") {
  CHECK(call({"describe", "run", "cost"}).out == call({"describe", "cost"}).out);
  CHECK(call({"describe", "post_process"}).out == call({"describe", "post_processor"}).out);
  const Called wrong = call({"describe", "run", "costt"});
  CHECK(wrong.exit == 2);
  CHECK_THAT(wrong.err, Contains("did you mean 'cost'?"));
  CHECK_THAT(call({"list", "formats"}).out, Contains("rasters: asc") && Contains("GDAL"));
}

TEST_CASE("command line: an end on the side of an obstacle is as much too near as the clearance") {
  const ScratchDir dir;
  const std::string text =
      "manifold: {type: euclidean, lower: [0, 0], upper: [10, 10]}\n"
      "obstacles: [{type: polygon, corners: [[3, 2], [6, 2], [6, 7], [3, 7]]}]\n"
      "clearance: 0.001\ncost: euclidean\nends: {source: {point: [X, 5]}, target: {point: [8, 5]}}\n";
  const auto refusal = [&](const std::string& x) {
    std::string config = text;
    config.replace(config.find('X'), 1, x);
    return call({"run", write_text(dir / "end.yaml", config), "-n"}).err;
  };
  CHECK_THAT(refusal("3"), Contains("it is 0.001 too close to the polygon") && !Contains("inside"));
  CHECK_THAT(refusal("3.25"), Contains("end_in_clearance: it lies 0.25 deep inside the polygon"));
}

TEST_CASE("command line: an end far off a mesh is told by a note with its distance") {
  const ScratchDir dir;
  write_text(dir / "flat.obj", "v 0 0 0\nv 4 0 0\nv 4 3 0\nv 0 3 0\nf 1 2 3\nf 1 3 4\n");
  const auto notes = [&](const std::string& height) {
    const std::string config =
        "manifold: {type: mesh, file: flat.obj}\ncost: euclidean\nends: {source: {point: [1, 1, " + height +
        "], tolerance: 10}, target: {point: [3, 2, 0]}}\n";
    return call({"run", write_text(dir / "far.yaml", config), "-q", "--force", "-o", (dir / "out").string()}).out;
  };
  CHECK_THAT(notes("2.5"), Contains("the source is 2.5 from the domain; the path has its nearest point on it"));
  CHECK_THAT(notes("0.04"), Contains("moved by 0.04") && !Contains("from the domain"));
}

TEST_CASE("command line: an end in unknown cells of a map is refused as one, with the option that lets it be there") {
  const ScratchDir dir;
  write_text(dir / "room.pgm", "P2\n3 1\n255\n254 205 0\n");
  const auto run_to = [&](const std::string& x, const std::string& more) {
    return call({"run", "-n",
                 write_text(dir / "a.yaml", "manifold: {type: map, file: room.pgm" + more +
                                                "}\ncost: euclidean\nends: {source: {point: [0.5, 0.5]}, target: "
                                                "{point: [" +
                                                x + ", 0.5]}}\npath: {points: 5}\n")});
  };
  CHECK_THAT(run_to("1.5", "").err, Contains("the target is in unknown cells of") &&
                                        Contains("`unknown: free` of the map") && Contains("is 0.5 away"));
  CHECK(run_to("1.5", ", unknown: free").exit == 0);
  CHECK_THAT(run_to("2.5", "").err, Contains("the target is in blocked cells of"));
  CHECK_THAT(run_to("3.5", "").err, Contains("the target is outside"));
}

TEST_CASE("command line: doctor") {
  const ScratchDir dir;
  const std::string mesh =
      write_text(dir / "fan.obj", "v 0 0 0\nv 0 0 1\nv 1 0 0\nv -1 1 0\nv -1 -1 0\nf 1 2 3\nf 1 2 4\nf 1 2 5\n");
  const Called text = call({"doctor", mesh});
  CHECK(text.exit == 4);
  CHECK(call({"doctor", write_text(dir / "sound.obj", "v 0 0 0\nv 0 0 1\nv 1 0 0\nf 1 2 3\n")}).exit == 0);
  CHECK_THAT(text.out, Contains("edges with three or more faces: 1 (0-1)"));
  const Json report = Json::parse(call({"doctor", mesh, "--format", "json"}).out);
  CHECK(report["faults"]["non_manifold_edges"]["count"] == 1);
  CHECK(call({"doctor", (dir / "none.obj").string()}).exit == 4);
}

/// A square of two triangles folded along its diagonal, and a triangle apart: distances by hand.
TEST_CASE("command line: distances") {
  const ScratchDir dir;
  const std::string mesh = write_text(dir / "fold.obj",
                                      "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 9 0 0\nv 9 1 0\nv 9 0 1\n"
                                      "f 1 2 3\nf 2 4 3\nf 5 6 7\n");
  const Called table = call({"distances", mesh, "--from", "0"});
  CHECK(table.exit == 0);
  CHECK_THAT(table.out, Contains("vertex,x,y,z,distance,error,state\n0,0,0,0,0,0,exact\n"));
  CHECK_THAT(table.out, Contains("\n3,1,1,0,1.41421356"));
  CHECK_THAT(table.out, Contains("\n5,9,1,0,inf,0,no_path\n"));
  for (const std::string ending : {"csv", "vtp", "ply"}) {
    const std::string file = (dir / ("d." + ending)).string();
    const Called written = call({"distances", mesh, "--from", "0", "-o", file});
    CHECK(written.exit == 0);
    CHECK_THAT(written.out, Contains("4 of 7 vertices reached, the farthest at 1.414213562"));
    CHECK_THAT(content(file), Contains("1.41421356"));
  }
  CHECK(content(dir / "d.csv") == table.out);
  CHECK_THAT(content(dir / "d.ply"), Contains("element vertex 7") && Contains("9 0 1 -1 0\n3 0 1 2\n"));
  CHECK_THAT(call({"distances", mesh, "--from", "0", "-o", "d.txt"}).err, Contains(".csv, .vtp or .ply"));
  CHECK_THAT(call({"distances", mesh, "--from", "7"}).err, Contains("7"));
  CHECK(call({"distances", mesh, "--from", "7"}).exit == 4);
}

TEST_CASE("command line: distances from several vertices, and no farther than asked for") {
  const ScratchDir dir;
  const std::string mesh = write_text(dir / "strip.obj",
                                      "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 3 0 0\nv 0 1 0\nv 1 1 0\nv 2 1 0\nv 3 1 0\n"
                                      "f 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\n");
  const Called both = call({"distances", mesh, "--from", "0", "--from", "7"});
  CHECK(both.exit == 0);
  CHECK_THAT(both.out, Contains("\n3,3,0,0,1,") && Contains("\n4,0,1,0,1,") && Contains("\n2,2,0,0,1.41421356"));
  const std::string list = write_text(dir / "sources.txt", "0\n7\n");
  CHECK(call({"distances", mesh, "--from", list}).out == both.out);
  CHECK_THAT(call({"distances", mesh, "--from", write_text(dir / "bad.txt", "0 x")}).err, Contains("found 'x'"));
  CHECK_THAT(call({"distances", mesh, "--from", "none.txt"}).err, Contains("there is no such file"));
  const Called near = call({"distances", mesh, "--from", "0", "--max-distance", "2"});
  CHECK(near.exit == 0);
  CHECK_THAT(near.out, Contains("\n2,2,0,0,2,") && Contains("\n3,3,0,0,inf,inf,not_reached\n"));
}

TEST_CASE("command line: a cap of distances speaks, and the option that it names lets the search go on") {
  const ScratchDir dir;
  const std::string mesh = write_text(dir / "square.obj",
                                      "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 2 1 0.5\n"
                                      "f 1 2 3\nf 2 4 3\nf 2 5 4\n");
  const Called full = call({"distances", mesh, "--from", "0"});
  const Called capped = call({"distances", mesh, "--from", "0", "--max-memory", "1e-9"});
  CHECK(capped.exit == 5);
  CHECK_THAT(capped.err, Contains("--max-memory 2e-09") && Contains("of 5 vertices were not reached"));
  CHECK_THAT(capped.out, Contains("not_reached"));
  CHECK(call({"distances", mesh, "--from", "0", "--max-memory", "0.001"}).out == full.out);
  CHECK(call({"distances", mesh, "--from", "0", "--max-windows", "1000"}).out == full.out);
}

TEST_CASE("command line: a missing argument is named with what to write") {
  CHECK_THAT(call({"run"}).err, Contains("'leastcost run' needs CONFIG: Configuration (YAML)") &&
                                    Contains("; write 'leastcost run CONFIG'"));
  CHECK_THAT(call({"study"}).err,
             Contains("'leastcost study' needs CONFIG") && Contains("write 'leastcost study CONFIG'"));
  CHECK_THAT(call({"merge", "a"}).err, Contains("'leastcost merge' needs "));
}

TEST_CASE("command line: exit codes are said in one place") {
  for (const char* command : {"run", "study"}) {
    const std::string help = call({command, "--help"}).out;
    CHECK(help.find("Exit codes") == help.rfind("Exit codes"));
  }
}

}  // namespace leastcost::test
