#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The leastcost authors
# SPDX-License-Identifier: MIT
"""Random robots, scenes and ends, run by the program and judged independently.

    random_robots.py PROGRAM JUDGE FOLDER [--first 1] [--count 200] [--exact] [--keep]

PROGRAM is leastcost, JUDGE is robot_fcl_judge. Each seed becomes a folder with the files that a user would have; the
folders of seeds with a finding are kept, or all (--keep). Results are lines of FOLDER/runs.jsonl; seeds that are there
are not run again. --exact: links of spheres and capsules only, by which the judge is as sharp as its places are near
to each other. Of paths that come nearer than 1 mm to what they keep away from, it also says whether parts enlarged by 3 mm
would meet something: most must. The table at the end is over all lines. See path_judge.py for what is judged.
"""
import argparse
import collections
import json
import os
import re
import shutil
import subprocess
import sys
import time

import numpy as np

from path_judge import between, collisions, left_out_pairs
from random_cases import Case

SECONDS = 20        # a run that takes longer hangs
NEAR = 1e-9         # of ends and limits, rad or m
NEAR_TOOL = 1e-6    # of the tool, m or rad
CODES = {0: "certified", 3: "configuration", 4: "input", 5: "uncertified", 6: "no path", 130: "time is up"}


def run(program, case):
    begin = time.monotonic()
    output = os.path.join(case.folder, "out")
    try:
        done = subprocess.run([program, "run", case.configuration, "--output", output, "--quiet"], capture_output=True,
                              text=True, timeout=SECONDS)
        code, message = done.returncode, done.stderr.strip()
    except subprocess.TimeoutExpired:
        code, message = "hang", ""
    result = os.path.join(output, "result.json")
    return code, message, time.monotonic() - begin, json.load(open(result)) if os.path.exists(result) else None


def path_of(case):
    lines = open(os.path.join(case.folder, "out", "path.csv")).read().splitlines()
    columns = range(1, 1 + len(case.robot.names))  # after the index
    return np.array([[float(line.split(",")[c]) for c in columns] for line in lines[1:]])


def ends_fault(case, path):
    if np.abs(path[0] - case.source).max() > NEAR:
        return f"it begins {np.abs(path[0] - case.source).max()} off the source"
    if case.tool is None:
        off = min(np.abs(path[-1] - t).max() for t in case.targets)
        return f"it ends {off} off the target" if off > NEAR else ""
    link, offset, place, turn = case.tool
    frame = case.robot.frames(path[-1:])[link][0]
    off = np.linalg.norm(frame[:3, 3] + frame[:3, :3] @ offset - place)
    if turn is not None:
        off = max(off, np.linalg.norm(frame[:3, :3] - turn))
    return f"the tool is {off} off" if off > NEAR_TOOL else ""


def faults_of(judge, case, result):
    """What is wrong with a path that is certified, or whose clearance is proved; and the places looked at."""
    certified, robot, faults = result["status"] == "certified", case.robot, []
    clearance = (result.get("certificate") or {}).get("clearance") or {}
    proved = clearance.get("collision") == "proved" and "touches" not in [f["name"] for f in result["failures"]]
    path = path_of(case)
    if not np.isfinite(path).all():
        return ["the path has numbers that are not finite"], 0, False
    if not certified and not proved:
        return [], 0, False
    places, apart = between(robot, path)
    if apart > 1.01e-3:
        faults.append(f"the judge looked only every {apart} m")
    left_out = left_out_pairs(result["notes"])
    faults += collisions(judge, robot, case.obstacles, case.clearance, places, left_out)
    beyond = max((robot.lower - path).max(), (path - robot.upper).max())
    if beyond > NEAR:
        faults.append(f"a joint is {beyond} beyond its limits")
    if fault := ends_fault(case, path):
        faults.append(fault)
    if certified:
        length, cost = np.linalg.norm(np.diff(path, axis=0), axis=1).sum(), result["cost"]
        bar = cost["error_estimate"] or 0
        straight, tiny = np.linalg.norm(path[-1] - path[0]), 1e-9 * (1 + np.linalg.norm(path[-1] - path[0]))
        if abs(length - cost["chain"]) > tiny:
            faults.append(f"the path is {length} long, stated {cost['chain']}")
        if not straight - tiny <= cost["value"] + bar or cost["value"] - bar > length + tiny:
            faults.append(f"cost {cost['value']} +- {bar}, but the straight way is {straight}, the path {length}")
    return faults, len(places), proved


def judged(program, judge, seed, folder, exact):
    case = Case(seed, folder, exact)
    code, message, seconds, result = run(program, case)
    row = {"seed": seed, "kind": case.kind, "joints": len(case.robot.names), "obstacles": len(case.obstacles),
           "code": code, "seconds": round(seconds, 3), "faults": [], "places": 0, "failures": [], "message": message,
           "left_out": 0, "proved": False}
    if code not in CODES:
        row["faults"].append("it hangs" if code == "hang" else f"it crashes or fails: exit code {code}: {message}")
        return row
    ends = np.array([case.source] + case.targets)
    inside = np.isfinite(ends).all() and (ends >= case.robot.lower - NEAR).all() and (ends <= case.robot.upper + NEAR).all()
    if code == 3 and inside:
        row["ends_touch"] = bool(collisions(judge, case.robot, case.obstacles, 0, ends, set()))
    if code != 130 and (result is None) != (code not in (0, 5)):
        row["faults"].append("the exit code and the result do not fit each other")
    if result is not None:
        row["failures"] = [f["name"] for f in result["failures"]]
        known = (result.get("certificate") or {}).get("clearance") or {}
        row["beyond_clearance"] = float(known.get("lower") or "nan")
        row["left_out"] = len(left_out_pairs(result["notes"]))
        row["faults"], row["places"], row["proved"] = faults_of(judge, case, result)
        if code == 0 and row["beyond_clearance"] < 1e-3 and case.obstacles:
            row["enlarged_meets"] = bool(collisions(judge, case.robot, case.obstacles, case.clearance + 3e-3, between(
                case.robot, path_of(case))[0], left_out_pairs(result["notes"])))
        if code == 0 and seed % 5 == 0:
            row["straight_meets"] = bool(collisions(judge, case.robot, case.obstacles, case.clearance, between(
                case.robot, path_of(case)[[0, -1]])[0], left_out_pairs(result["notes"])))
        if code == 0 and not inside and case.kind == "outside":
            row["faults"].append("certified with an end outside the limits")
    elif not message:
        row["faults"].append("it says nothing")
    elif len([line for line in message.splitlines() if "error" in line or "no path" in line]) > 6:
        row["faults"].append("it says too much: " + message)
    return row


def pattern(message):
    """A message without its numbers and names."""
    line = next((m for m in message.splitlines() if "error" in m or "no path" in m), message.splitlines()[0])
    line = re.sub(r"^\S*run\.yaml:\d+:\d+: ", "", line)
    line = re.sub(r"(link_\d+|base|thing_\d+|joint_\d+)", "NAME", line)
    line = re.sub(r"the (box|ball|cylinder|cone|capsule|mesh|half_space|points?)\b", "the SHAPE", line)
    return re.sub(r"[-+]?\d[\d.e+-]*", "#", line)[:150]


def table(rows):
    outcome = collections.Counter(CODES.get(r["code"], "CRASH OR HANG") for r in rows)
    print(f"\n{len(rows)} runs, seeds {min(r['seed'] for r in rows)} to {max(r['seed'] for r in rows)}: "
          + ", ".join(f"{name} {n}" for name, n in outcome.most_common()))
    kinds = sorted({r["kind"] for r in rows})
    print(f"{'ends':14} {'runs':>6} " + " ".join(f"{name:>13}" for name in outcome))
    for kind in kinds:
        of = collections.Counter(CODES.get(r["code"], "CRASH OR HANG") for r in rows if r["kind"] == kind)
        print(f"{kind:14} {sum(of.values()):6d} " + " ".join(f"{of[name]:13d}" for name in outcome))
    for title, which in (("not certified for", lambda r: set(r["failures"])),
                         ("refused with", lambda r: {pattern(r["message"])} if r["code"] in (3, 4, 6) else set())):
        counts = collections.Counter(name for r in rows for name in which(r))
        print(title + ":" + "".join(f"\n  {n:6d}  {name}" for name, n in counts.most_common(25)))
    wrong = [r for r in rows if r["faults"]]
    refused = [r for r in rows if r["code"] == 3 and r["kind"] in ("points", "state") and not r.get("ends_touch", True)]
    at_walls = [r for r in rows if r["code"] == 0 and r["beyond_clearance"] < 1e-3]
    print(f"certified paths that come nearer than 1 mm to what they have to keep: {len(at_walls)}; enlarged by 3 "
          f"mm {sum(r.get('enlarged_meets', False) for r in at_walls)} of them meet something")
    seconds = sorted(r["seconds"] for r in rows)
    straight = [r["straight_meets"] for r in rows if "straight_meets" in r]
    print(f"the straight way between the same ends, judged for {len(straight)} of the certified: {sum(straight)} meet "
          "something")
    print(f"judged paths: {sum(r['places'] > 0 for r in rows)} at {sum(r['places'] for r in rows)} places; proved but "
          f"not certified: {sum(r['proved'] and r['code'] == 5 for r in rows)}; with pairs left out: "
          f"{sum(r['left_out'] > 0 for r in rows)}; refused with ends at which the exact shapes are free: {len(refused)}")
    print(f"seconds: median {seconds[len(seconds) // 2]:.2f}, p95 {seconds[int(0.95 * len(seconds))]:.2f}, worst "
          f"{seconds[-1]:.2f}")
    print(f"findings: {len(wrong)}")
    for r in wrong:
        print(f"  seed {r['seed']} ({r['kind']}, code {r['code']}): " + "; ".join(r["faults"])[:300])


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("program")
    parser.add_argument("judge")
    parser.add_argument("folder")
    parser.add_argument("--first", type=int, default=1)
    parser.add_argument("--count", type=int, default=200)
    parser.add_argument("--exact", action="store_true")
    parser.add_argument("--keep", action="store_true")
    given = parser.parse_args()
    os.makedirs(given.folder, exist_ok=True)
    log = os.path.join(given.folder, "runs.jsonl")
    rows = [json.loads(line) for line in open(log)] if os.path.exists(log) else []
    done = {r["seed"] for r in rows}
    with open(log, "a") as out:
        for seed in range(given.first, given.first + given.count):
            if seed in done:
                continue
            folder = os.path.join(given.folder, f"seed_{seed}")
            shutil.rmtree(folder, ignore_errors=True)
            os.makedirs(folder)
            row = judged(given.program, given.judge, seed, folder, given.exact)
            rows.append(row)
            out.write(json.dumps(row) + "\n")
            out.flush()
            if row["faults"]:
                print(f"seed {seed}: " + "; ".join(row["faults"])[:300], flush=True)
            elif not given.keep:
                shutil.rmtree(folder)
    table(rows)
    return 1 if any(r["faults"] for r in rows) else 0


if __name__ == "__main__":
    sys.exit(main())
