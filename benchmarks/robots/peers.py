#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The leastcost authors
# SPDX-License-Identifier: MIT
"""A table of paths by OMPL, by polish() and by our own search in problems of MotionBenchMaker.

    robot_peers_table DATA development 2 > paths.csv
    peers.py DATA paths.csv ... [--problems]

The judge is that of mbm.py: kinematics of the URDF, spheres against exact boxes and capsules, every 0.004 rad. The best
of all is the shortest of the paths that are clean.
"""
import argparse
import gzip
import json
import math
import os

import numpy as np

import mbm

METHODS = {
    "ompl": "OMPL RRTConnect",
    "ompl_max": "the same, `simplifyMax`",
    "ompl_simplify": "the same, `simplifyMax` on and on for 1 s",
    "ompl_restarts": "RRTConnect and `simplifyMax` again and again for 1 s, the shortest",
    "polish_checker": "`polish` of the simplified plan, the planner's checker alone, 1 s",
    "polish": "`polish` of the simplified plan, walls given, 1 s",
    "search_1s": "our search without options, 1 s",
    "search": "our search without options",
}
NEAR = 1.01  # of the best
LONGER = 1 + 1e-9


def read(files):
    """Of each problem: method to (seconds, how, path)."""
    found = {}
    for name in files:
        for line in open(name):
            scenario, index, method, seconds, how, *values = line.strip().split(",")
            path = np.array(values, float).reshape(-1, 7)
            found.setdefault((scenario, int(index)), {})[method] = (float(seconds), how, path)
    return found


def length(path):
    return float(np.linalg.norm(np.diff(path, axis=0), axis=1).sum())


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("data")
    parser.add_argument("paths", nargs="+")
    parser.add_argument("--problems", action="store_true", help="a line for each path as well")
    given = parser.parse_args()
    robot = mbm.Robot(given.data)
    problems = json.load(gzip.open(os.path.join(given.data, "panda_even.json.gz")))
    rows = {method: [] for method in METHODS}
    count = 0
    for (scenario, index), paths in read(given.paths).items():
        if "ends" in paths:
            print(f"{scenario} {index}: an end touches something")
            continue
        count += 1
        problem = next(p for p in problems[scenario] if p["index"] == index)
        obstacles = mbm.obstacles_of(scenario, problem)
        judged = {}
        for method, (seconds, how, path) in paths.items():
            if len(path) > 1:
                depth, share = mbm.deepest(robot, obstacles, path)
                judged[method] = (seconds, how, depth <= 0, length(path))
                if given.problems:
                    print(f"{scenario:18} {index:3d} {method:15} {seconds:7.3f} {length(path):8.4f} "
                          f"{'' if depth <= 0 else f'touches, {depth:.1e}, {100 * share:.1f} %':24} {how}", flush=True)
        best = min((row[3] for row in judged.values() if row[2]), default=math.nan)
        before = judged.get("ompl_max")
        for method, (seconds, how, clean, size) in judged.items():
            rows[method].append((seconds, how, clean, size / best, before and size > LONGER * before[3]))
    print(f"\n| {count} problems | solved | clean | certified | dearer than the simplified plan | within 1 % of the best "
          "and clean | CPU [s], median | p95 | length / best, median | p95 |\n|" + 10 * "---|")
    for method, name in METHODS.items():
        found = rows[method]
        if not found:
            continue
        times, sizes = [row[0] for row in found], [row[3] for row in found]
        print(f"| {name} | {len(found)} | {sum(row[2] for row in found)} | "
              f"{sum(row[1].endswith('certified') and row[1] != 'uncertified' for row in found)} | "
              f"{sum(bool(row[4]) for row in found)} | {sum(row[2] and row[3] <= NEAR for row in found)} | "
              f"{mbm.middle(times, 0.5):.3f} | {mbm.middle(times, 0.95):.3f} | {mbm.middle(sizes, 0.5):.4f} | "
              f"{mbm.middle(sizes, 0.95):.4f} |")


if __name__ == "__main__":
    main()
