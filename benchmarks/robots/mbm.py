#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The leastcost authors
# SPDX-License-Identifier: MIT
"""Problems of MotionBenchMaker for a Panda, solved by the program and judged independently.

    mbm.py DATA PROGRAM [--choose develop|held] [--count 5] [--skip 0] [--scenario NAME] [--set 'key: value']
           [--out FOLDER]

DATA holds panda_even.json.gz, panda_spherized.urdf and panda.srdf, as shipped by KavrakiLab/vamp. Each problem becomes
a configuration without options, as an engineer would write it: the URDF with its spheres, the SRDF with its pairs,
boxes with their poses, and cylinders as capsules (in the scenario `box` as boxes of their size, which is what their
makers take them for).

`develop`: indices that 6 divides; `held`: those that leave 2. The judge knows nothing of the program: kinematics of the
URDF, spheres against exact boxes and capsules, every 0.004 rad.
"""
import argparse
import gzip
import json
import math
import os
import resource
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as xml

import numpy as np

JUDGED_EVERY = 0.004  # rad
CLEARANCE = 1e-4      # m
LONGEST = 60          # s, of a run


def numbers(text):
    return [float(word) for word in text.split()]


def turn(rpy):
    (cr, sr), (cp, sp), (cy, sy) = [(math.cos(a), math.sin(a)) for a in rpy]
    return np.array([[cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr],
                     [sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr], [-sp, cp * sr, cp * cr]])


class Robot:
    """What the URDF and the SRDF say: joints in order, spheres of each link, pairs that may touch."""

    def __init__(self, folder):
        urdf = xml.parse(os.path.join(folder, "panda_spherized.urdf")).getroot()
        self.joints = []
        for joint in urdf.findall("joint"):
            origin = joint.find("origin")
            frame = np.eye(4)
            frame[:3, :3] = turn(numbers(origin.get("rpy")))
            frame[:3, 3] = numbers(origin.get("xyz"))
            self.joints.append((joint.find("parent").get("link"), joint.find("child").get("link"), frame,
                                joint.get("type") == "revolute", joint))
        self.names = [j[4].get("name") for j in self.joints if j[3]]
        self.spheres = []  # link, centre, radius
        for link in urdf.findall("link"):
            for collision in link.findall("collision"):
                sphere = collision.find("geometry/sphere")
                if sphere is not None:
                    self.spheres.append((link.get("name"), np.array(numbers(collision.find("origin").get("xyz"))),
                                         float(sphere.get("radius"))))
        links = [link.get("name") for link in urdf.findall("link")]
        srdf = xml.parse(os.path.join(folder, "panda.srdf")).getroot()
        off = {frozenset((d.get("link1"), d.get("link2"))) for d in srdf.findall("disable_collisions")}
        self.pairs = [(a, b) for i, a in enumerate(links) for b in links[i + 1:] if frozenset((a, b)) not in off]

    def frames(self, q):
        """Of each link, for configurations k x 7: k x 4 x 4."""
        found = {"panda_link0": np.broadcast_to(np.eye(4), (len(q), 4, 4))}
        j = 0
        for parent, child, frame, revolute, _ in self.joints:
            at = found[parent] @ frame
            if revolute:
                c, s = np.cos(q[:, j]), np.sin(q[:, j])
                spin = np.zeros((len(q), 4, 4))
                spin[:, 0, 0], spin[:, 0, 1], spin[:, 1, 0], spin[:, 1, 1] = c, -s, s, c
                spin[:, 2, 2] = spin[:, 3, 3] = 1
                at = at @ spin
                j += 1
            found[child] = at
        return found


def obstacles_of(scenario, problem):
    """Kind, half edges or (half height, radius), frame."""
    found = []
    for o in problem["objs"]:
        frame = np.array(o["M"])
        if o["type"] == "box":
            found.append(("box", np.array(o["dim"]) / 2, frame))
        else:
            height, radius = o["dim"]
            if scenario == "box":
                found.append(("box", np.array([radius, radius, height / 2]), frame))
            else:
                found.append(("capsule", (height / 2, radius), frame))
    return found


def depths(points, radii, obstacle):
    """Of spheres, k x m x 3, in an obstacle: positive inside."""
    kind, size, frame = obstacle
    local = (points - frame[:3, 3]) @ frame[:3, :3]
    if kind == "box":
        beyond = np.abs(local) - size
        distance = np.linalg.norm(np.maximum(beyond, 0), axis=-1) + np.minimum(beyond.max(axis=-1), 0)
    else:
        half, radius = size
        local = local.copy()
        local[..., 2] -= np.clip(local[..., 2], -half, half)
        distance = np.linalg.norm(local, axis=-1) - radius
    return radii - distance


def deepest(robot, obstacles, path):
    """Of all configurations along a polyline: positive where something touches."""
    pieces = [path[:1]]
    for a, b in zip(path[:-1], path[1:]):
        n = max(1, math.ceil(np.linalg.norm(b - a) / JUDGED_EVERY))
        pieces.append(a + (b - a) * (np.arange(1, n + 1) / n)[:, None])
    q = np.concatenate(pieces)
    worst, touching = -math.inf, np.zeros(len(q), bool)
    for begin in range(0, len(q), 2000):
        part = q[begin:begin + 2000]
        frames = robot.frames(part)
        at = np.stack([np.einsum("kij,j->ki", frames[link][:, :3, :3], c) + frames[link][:, :3, 3]
                       for link, c, _ in robot.spheres], axis=1)
        radii = np.array([r for _, _, r in robot.spheres])
        moved = [k for k, s in enumerate(robot.spheres) if s[0] != "panda_link0"]
        depth = np.max([depths(at[:, moved], radii[moved], o).max(axis=1) for o in obstacles], axis=0)
        for a, b in robot.pairs:
            i = [k for k, s in enumerate(robot.spheres) if s[0] == a]
            j = [k for k, s in enumerate(robot.spheres) if s[0] == b]
            if i and j:
                apart = np.linalg.norm(at[:, i, None] - at[:, None, j], axis=-1)
                depth = np.maximum(depth, (radii[i][:, None] + radii[j][None, :] - apart).max(axis=(1, 2)))
        touching[begin:begin + 2000] = depth > 0
        worst = max(worst, depth.max())
    return worst, touching.mean()


def flat(values):
    return "[" + ", ".join(repr(float(v)) for v in values) + "]"


def pose_of(frame):
    """Position and rotation vector, as the shapes of a configuration have them."""
    turn = frame[:3, :3]
    about = np.array([turn[2, 1] - turn[1, 2], turn[0, 2] - turn[2, 0], turn[1, 0] - turn[0, 1]])
    angle = math.atan2(np.linalg.norm(about), np.trace(turn) - 1)
    if np.linalg.norm(about) < 1e-9 and angle > 1:  # half a turn: the axis is the largest column of (R + 1) / 2
        columns = (turn + np.eye(3)) / 2
        about = columns[:, np.argmax(np.diag(columns))]
    axis = about / max(np.linalg.norm(about), 1e-300)
    return f"pose: {{ position: {flat(frame[:3, 3])}, rotation: {flat(axis * angle)} }}"


def write_configuration(robot, data, scenario, problem, extra, folder):
    obstacles = obstacles_of(scenario, problem)
    name = f"{scenario}_{problem['index']:04d}"
    data = os.path.abspath(data)
    lines = [f"name: {name}", "manifold: robot", "robot:", "  type: urdf",
             f"  file: {os.path.join(data, 'panda_spherized.urdf')}", f"  srdf: {os.path.join(data, 'panda.srdf')}",
             "  group: panda_arm", "  soft_limits: false", "obstacles:"]
    for kind, size, frame in obstacles:
        if kind == "box":
            lines.append(f"  - {{ type: box, size: {flat(2 * size)}, {pose_of(frame)} }}")
        else:
            half, radius = size
            foot, tip = frame[:3, 3] - half * frame[:3, 2], frame[:3, 3] + half * frame[:3, 2]
            lines.append(f"  - {{ type: capsule, from: {flat(foot)}, to: {flat(tip)}, radius: {radius!r} }}")
    ends = [flat([point[n] for n in robot.names]) for point in (problem["start"], problem["goals"][0])]
    lines += [f"clearance: {CLEARANCE!r}", "cost: euclidean", "ends:", f"  source: {{ point: {ends[0]} }}",
              f"  target: {{ point: {ends[1]} }}", *extra]
    path = os.path.join(folder, name + ".yaml")
    open(path, "w").write("\n".join(lines) + "\n")
    return path, obstacles


def run(program, configuration, output):
    """The result, and the seconds of processor that it took."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    try:
        done = subprocess.run([program, "run", configuration, "--output", output, "--quiet", "--force"], capture_output=True,
                              text=True, timeout=LONGEST)
    except subprocess.TimeoutExpired:
        return None, LONGEST, f"did not end within {LONGEST} s"
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    used = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    path = os.path.join(output, "result.json")
    if not os.path.exists(path):
        return None, used, (done.stderr.strip().splitlines() or ["no message"])[-1]
    return json.load(open(path)), used, ""


def middle(values, part):
    return sorted(values)[min(len(values) - 1, int(part * len(values)))] if values else math.nan


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("data")
    parser.add_argument("program")
    parser.add_argument("--choose", choices=["develop", "held"], default="develop")
    parser.add_argument("--count", type=int, default=5)
    parser.add_argument("--skip", type=int, default=0, help="so many of the first of each scenario are left out")
    parser.add_argument("--scenario", action="append")
    parser.add_argument("--index", type=int, action="append")
    parser.add_argument("--set", action="append", default=[])
    parser.add_argument("--out")
    given = parser.parse_args()
    robot = Robot(given.data)
    problems = json.load(gzip.open(os.path.join(given.data, "panda_even.json.gz")))
    folder = given.out or tempfile.mkdtemp()
    os.makedirs(folder, exist_ok=True)
    rest = {"develop": 0, "held": 2}[given.choose]
    rows = []
    print(f"{'problem':22} {'status':11} {'clean':5} {'proved':6} {'cost':>8} {'path':>8} {'points':>6} {'CPU':>6} "
          f"{'first':>6} {'solve':>6} {'cert':>6}  why", flush=True)
    for scenario in given.scenario or problems:
        chosen = [p for p in problems[scenario] if p["index"] % 6 == rest][given.skip:given.skip + given.count]
        for problem in [p for p in problems[scenario] if p["index"] in given.index] if given.index else chosen:
            configuration, obstacles = write_configuration(robot, given.data, scenario, problem, given.set, folder)
            output = configuration[:-5]
            result, used, message = run(given.program, configuration, output)
            label = f"{scenario} {problem['index']}"
            if result is None:
                rows.append({"status": "failed", "used": used, "why": ["failed"]})
                print(f"{label:22} failed      {message}", flush=True)
                continue
            text = open(os.path.join(output, "path.csv")).read().splitlines()
            columns = [k for k, name in enumerate(text[0].split(",")) if name in [f"x{j}" for j in range(7)]]
            path = np.array([[float(line.split(",")[k]) for k in columns] for line in text[1:]])
            depth, share = deepest(robot, obstacles, path)
            s = result["seconds"]
            wall = sum(v for v in s.values())
            scale = used / wall if wall > 0 else 1
            clearance = (result["certificate"] or {}).get("clearance") or {}
            row = {"status": result["status"], "used": used, "clean": bool(depth <= 0),
                   "proved": clearance.get("collision") == "proved" and "touches" not in
                             [f["name"] for f in result["failures"]],
                   "length": float(np.linalg.norm(np.diff(path, axis=0), axis=1).sum()),
                   "first": s["initialize"] * scale, "solve": (s["solve"] + s["post_process"]) * scale,
                   "certify": s["certify"] * scale, "why": [f["name"] for f in result["failures"]]}
            rows.append(row)
            first = "" if not result["failures"] else result["failures"][0]["message"]
            print(f"{label:22} {row['status']:11} {str(row['clean']):5} {str(row['proved']):6} "
                  f"{result['cost']['value']:8.4f} {row['length']:8.4f} {len(path) - 2:6d} {used:6.2f} "
                  f"{row['first']:6.2f} {row['solve']:6.2f} {row['certify']:6.2f}  {','.join(row['why'])} {first[:90]}"
                  + (f" ({100 * share:.1f} % touch, {depth:.1e})" if depth > 0 else ""), flush=True)
    solved = [r for r in rows if r["status"] != "failed"]
    reasons = {}
    for r in rows:
        for why in set(r["why"]):
            reasons[why] = reasons.get(why, 0) + 1
    early = [r["first"] + r["solve"] for r in solved]
    used = [r["used"] for r in rows]
    lengths = [r["length"] for r in solved]
    print(f"\n{len(rows)} problems: solved {len(solved)}, clean {sum(r['clean'] for r in solved)}, proved clear "
          f"{sum(r['proved'] for r in solved)}, certified {sum(r['status'] == 'certified' for r in rows)}")
    print(f"length: median {middle(lengths, 0.5):.4f}, p95 {middle(lengths, 0.95):.4f}, sum {sum(lengths):.4f}")
    print(f"CPU [s]: first path and solve {middle(early, 0.5):.3f}, {middle(early, 0.95):.3f}; certificate "
          f"{middle([r['certify'] for r in solved], 0.5):.3f}, {middle([r['certify'] for r in solved], 0.95):.3f}; all "
          f"{middle(used, 0.5):.3f}, {middle(used, 0.95):.3f} (medians, p95)")
    print("refused for:", ", ".join(f"{k} {v}" for k, v in sorted(reasons.items(), key=lambda kv: -kv[1])) or "nothing")
    return 0


if __name__ == "__main__":
    sys.exit(main())
