#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The leastcost authors
# SPDX-License-Identifier: MIT
"""Problems of MotionBenchMaker for a Panda, solved by the program and judged independently.

    mbm.py DATA PROGRAM [--choose develop|held] [--count 5] [--scenario NAME] [--set 'key: value'] [--out FOLDER]

DATA holds panda_even.json.gz, panda_spherized.urdf and panda.srdf, as shipped by KavrakiLab/vamp. Each problem becomes
a configuration without options: the 59 spheres merged into 24 capsules that cover them, boxes, and cylinders as
capsules (in the scenario `box` as boxes of their size, which is what their makers take them for). The first joint turns
the world so that most boxes are along its axes; the others are meshes.

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
TABLE = [[0, 0, 0.333], [0, -math.pi / 2, 0], [0, math.pi / 2, 0.316], [0.0825, math.pi / 2, 0],
         [-0.0825, -math.pi / 2, 0.384], [0, math.pi / 2, 0], [0.088, math.pi / 2, 0]]  # a, alpha, d; modified
# Spheres of a link by number, merged into a capsule from the first to the last: those between lie in it.
MERGE_WITHIN = 1e-9


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
        self.lower = [float(j[4].find("limit").get("lower")) for j in self.joints if j[3]]
        self.upper = [float(j[4].find("limit").get("upper")) for j in self.joints if j[3]]
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

    def rigid(self):
        """Link of the table (0: base, 1 to 7) and frame in it, of each link."""
        found, link = {"panda_link0": (0, np.eye(4))}, 0
        for parent, child, frame, revolute, _ in self.joints:
            link += revolute
            found[child] = (link, np.eye(4)) if revolute else (found[parent][0], found[parent][1] @ frame)
        return found

    def capsules(self):
        """Link by name, its ends in the frames of the table, its radius. Greedy: the pair of spheres whose capsule
        covers most others without being larger than the larger of the two by more than a tenth."""
        found = []
        rigid = self.rigid()
        for name in dict.fromkeys(s[0] for s in self.spheres):
            left = [(c, r) for link, c, r in self.spheres if link == name]
            while left:
                best = ([], None)
                for a, ra in left:
                    for b, rb in left:
                        radius = max(ra, rb)
                        if min(ra, rb) < 0.9 * radius:
                            continue
                        covered = [k for k, (c, r) in enumerate(left)
                                   if 0.8 * radius <= r and to_segment(c, a, b) + r <= radius + MERGE_WITHIN]
                        if len(covered) > len(best[0]):
                            best = (covered, (a, b, radius))
                covered, (a, b, radius) = best
                link, frame = rigid[name]
                found.append((name, link, frame[:3, :3] @ a + frame[:3, 3], frame[:3, :3] @ b + frame[:3, 3], radius))
                left = [s for k, s in enumerate(left) if k not in covered]
        return found


def to_segment(p, a, b):
    way = b - a
    t = np.clip((p - a) @ way / max(way @ way, 1e-300), 0, 1)
    return np.linalg.norm(p - a - t * way)


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


def yaw_of(obstacles):
    """The turn about z that most boxes have, modulo a quarter."""
    yaws = [math.atan2(f[1, 0], f[0, 0]) % (math.pi / 2) for kind, _, f in obstacles
            if kind == "box" and abs(f[2, 2]) > 1 - 1e-9]
    return max(yaws, key=lambda y: sum(abs(math.remainder(y - o, math.pi / 2)) < 1e-6 for o in yaws), default=0)


def flat(values):
    return "[" + ", ".join(repr(float(v)) for v in values) + "]"


def mesh_of(corners):
    quads = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    lines = ["v " + " ".join(repr(float(v)) for v in c) for c in corners]
    for a, b, c, d in quads:
        lines += [f"f {a + 1} {b + 1} {c + 1}", f"f {a + 1} {c + 1} {d + 1}"]
    return "\n".join(lines) + "\n"


def write_configuration(robot, scenario, problem, extra, folder):
    obstacles = obstacles_of(scenario, problem)
    yaw = yaw_of(obstacles)
    c, s = math.cos(-yaw), math.sin(-yaw)
    world = np.array([[c, -s, 0, 0], [s, c, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]])
    name = f"{scenario}_{problem['index']:04d}"
    capsules = robot.capsules()
    ends = [[problem["start"][n] for n in robot.names], [problem["goals"][0][n] for n in robot.names]]
    lower = np.minimum(robot.lower, np.min(ends, axis=0))
    upper = np.maximum(robot.upper, np.max(ends, axis=0))
    lines = [f"name: {name}", "manifold:", "  type: euclidean", "  dimension: 7", f"  lower: {flat(lower)}",
             f"  upper: {flat(upper)}", "robot:", "  type: dh_arm", "  model:", "    type: table",
             "    convention: modified", "    rows:"]
    lines += [f"      - {flat(row + [-yaw if k == 0 else 0])}" for k, row in enumerate(TABLE)]
    lines += [f"    lower: {flat(lower)}", f"    upper: {flat(upper)}", "    shape:"]
    lines += [f"      - [{link}, " + flat([*a, *b, r])[1:] for _, link, a, b, r in capsules]
    self_pairs = [[i, j] for i, a in enumerate(capsules) for j, b in enumerate(capsules[:i])
                  if a[1] != b[1] and ((a[0], b[0]) in robot.pairs or (b[0], a[0]) in robot.pairs)]
    lines += [f"    self: {[sorted(p) for p in self_pairs]}", "obstacles:"]
    for k, (kind, size, frame) in enumerate(obstacles):
        at = world @ frame
        if kind == "capsule":
            half, radius = size
            tip, foot = at[:3, 3] + half * at[:3, 2], at[:3, 3] - half * at[:3, 2]
            aside = 5e-6 * at[:3, 0]  # a triangle so narrow is a segment
            text = "".join("v " + " ".join(repr(float(v)) for v in p) + "\n" for p in (tip, foot - aside, foot + aside))
            open(os.path.join(folder, f"{name}_{k}.obj"), "w").write(text + "f 1 2 3\n")
            lines.append(f"  - {{ type: mesh, file: {name}_{k}.obj, inside: surface, radius: {radius!r} }}")
            continue
        corners = [at[:3, 3] + at[:3, :3] @ (size * np.array([x, y, z]))
                   for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]
        if np.abs(np.abs(at[:3, :3]).max(axis=1) - 1).max() < 1e-9:
            lines.append(f"  - {{ type: box, lower: {flat(np.min(corners, axis=0))}, "
                         f"upper: {flat(np.max(corners, axis=0))} }}")
        else:
            open(os.path.join(folder, f"{name}_{k}.obj"), "w").write(mesh_of(corners))
            lines.append(f"  - {{ type: mesh, file: {name}_{k}.obj }}")
    lines += [f"clearance: {CLEARANCE!r}", "cost: euclidean", "ends:", f"  source: {{ point: {flat(ends[0])} }}",
              f"  target: {{ point: {flat(ends[1])} }}", *extra]
    path = os.path.join(folder, name + ".yaml")
    open(path, "w").write("\n".join(lines) + "\n")
    return path, obstacles


def run(program, configuration, output):
    """The result, and the seconds of processor that it took."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run([program, "run", configuration, "--output", output, "--quiet"], capture_output=True, text=True)
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
        chosen = [p for p in problems[scenario] if p["index"] % 6 == rest][:given.count]
        for problem in [p for p in problems[scenario] if p["index"] in given.index] if given.index else chosen:
            configuration, obstacles = write_configuration(robot, scenario, problem, given.set, folder)
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
