# SPDX-FileCopyrightText: 2026 The leastcost authors
# SPDX-License-Identifier: MIT
"""Random robots, scenes and ends for random_robots.py: files as a user has them, and what the judge needs of them."""
import math
import os

import numpy as np

from path_judge import Robot, rpy_matrix
from random_shapes import (along, flow, frame_of, random_mesh, random_obstacle, random_rotation, rpy_of, text,
                           write_mesh)

ENDS = {"points": 0.62, "state": 0.1, "goals": 0.08, "tool": 0.07, "tool_turned": 0.03, "collides": 0.04,
        "equal": 0.03, "outside": 0.03}


class Case:
    """Writes robot.urdf, mostly robot.srdf, scene.yaml, meshes and run.yaml into a folder. What the judge is told:
    `meshes` (file: convex bodies), `obstacles`, `options` of the robot, `ends`, `clearance`. `exact`: only shapes of links that are covered exactly, so that
    paths that are in contact with something are so by the judge as well."""

    def __init__(self, seed, folder, exact=False):
        self.rng, self.folder = np.random.default_rng([20261127, seed]), folder
        self.meshes, self.obstacles, self.exact = {}, [], exact
        rng = self.rng
        self.make_tree()
        self.write_urdf()
        self.options, self.group = {}, []
        if rng.random() < 0.25:
            self.options["base"] = {"position": list(rng.uniform(-0.3, 0.3, 3)), "rpy": list(rng.uniform(-3, 3, 3))}
        if rng.random() < 0.15:
            self.options["soft_limits"] = False
        self.srdf = rng.random() < 0.8
        if self.srdf:
            self.choose_group()
            self.write_srdf({})
        self.robot = Robot(folder, self.options, self.srdf, self.meshes)
        self.clearance = float(rng.choice([0.001, 0.005, 0.02]))
        self.make_scene()
        self.choose_ends()
        self.write_run()

    # The robot

    def make_tree(self):
        rng = self.rng
        moving = int(rng.integers(1, 9))
        self.links, self.joints = [{"name": "base", "shapes": []}], []
        base_shaped = rng.random() < 0.7
        if base_shaped:
            self.links[0]["shapes"] = self.random_shapes(0, np.array([0, 0, rng.uniform(0.08, 0.2)]), 0.06)
        tips = {0: np.array([0, 0, 0.2])}
        while moving > 0:
            parent = len(self.links) - 1 if rng.random() < 0.75 else int(rng.integers(0, len(self.links)))
            number = len(self.links)
            kind = rng.choice(["revolute", "continuous", "prismatic", "fixed"], p=[0.55, 0.12, 0.2, 0.13])
            bone = rng.normal(size=3)
            bone *= rng.uniform(0.12, 0.4) / np.linalg.norm(bone)
            joint = {"name": f"joint_{number}", "type": str(kind), "parent": parent, "child": number,
                     "xyz": tips[parent], "rpy": rng.uniform(-3.1, 3.1, 3) if rng.random() < 0.6 else np.zeros(3),
                     "axis": np.eye(3)[rng.integers(3)] * rng.choice([-1, 1]) if rng.random() < 0.5 else
                     rng.normal(size=3) * rng.uniform(0.1, 10)}
            if kind in ("revolute", "prismatic"):
                wide = rng.uniform(0.3, 3) if kind == "revolute" else rng.uniform(0.05, 0.4)
                joint["lower"] = -wide * rng.uniform(0.1, 1) if rng.random() < 0.8 else wide * rng.uniform(0.05, 0.3)
                joint["upper"] = joint["lower"] + wide
                if rng.random() < 0.15:
                    joint["soft"] = [joint["lower"] + 0.1 * wide, joint["upper"] - 0.05 * wide]
            others = [j["name"] for j in self.joints if j["type"] in ("revolute", "prismatic")]
            if others and kind != "fixed" and rng.random() < 0.12:
                joint["mimic"] = (str(rng.choice(others)), float(rng.choice([-1, 1, 0.5, -2, rng.normal()])),
                                  float(rng.choice([0, rng.uniform(-0.2, 0.2)])))
            elif kind != "fixed":
                moving -= 1
            self.joints.append(joint)
            thick = rng.uniform(0.015, 0.05)
            shapes = self.random_shapes(number, bone, thick) if rng.random() < 0.92 else []
            self.links.append({"name": f"link_{number}", "shapes": shapes})
            tips[number] = bone
        if not any(link["shapes"] for link in self.links):
            self.links[-1]["shapes"] = self.random_shapes(len(self.links) - 1, tips[len(self.links) - 1], 0.04)
        self.order = rng.permutation(len(self.joints)) if rng.random() < 0.3 else np.arange(len(self.joints))

    def random_shapes(self, link, bone, thick):
        """(element, origin) of shapes along a bone from the origin of the link."""
        rng = self.rng
        turn, length = along(bone, rng), np.linalg.norm(bone)
        kind = rng.choice(["spheres", "capsule", "cylinder", "box", "mesh"],
                          p=[0.4, 0.6, 0, 0, 0] if self.exact else [0.2, 0.2, 0.25, 0.2, 0.15])
        middle, core = bone * rng.uniform(0.45, 0.6), length * rng.uniform(0.4, 0.75)
        if kind == "spheres":
            found = [(f'<sphere radius="{thick * rng.uniform(0.8, 1.3)!r}"/>', random_rotation(rng), bone * t)
                     for t in np.linspace(0.3, 0.9, rng.integers(1, 4))]
        elif kind == "mesh":
            name = f"part_{link}.obj"
            vertices, faces, bodies = random_mesh(rng, [2 * thick, 2 * thick, core], False)
            vertices = vertices + (place := rng.uniform(-0.02, 0.02, 3))
            write_mesh(os.path.join(self.folder, name), vertices, faces)
            self.meshes[name] = [(k, v + place, f) for k, v, f in bodies]
            scale = [1, 1, 1] if rng.random() < 0.5 else [1.2, -1, 0.8]
            found = [(f'<mesh filename="{rng.choice(["", "package://parts/", "file://"])}{name}" '
                      f'scale="{text(scale)}"/>', turn, middle)]
        elif kind == "box":
            size = [thick * rng.uniform(1, 2), thick * rng.uniform(1, 2), core]
            axes = rng.permutation(3)  # the long edge along any axis of the frame
            mix = np.zeros((3, 3))
            mix[axes, np.arange(3)] = 1
            mix[:, 0] *= np.linalg.det(mix)
            found = [(f'<box size="{text(np.asarray(size)[np.argsort(axes)])}"/>', turn @ mix.T, middle)]
        else:
            found = [(f'<{kind} radius="{thick!r}" length="{core!r}"/>', turn, middle)]
        if rng.random() < 0.25:
            more = "sphere" if self.exact else rng.choice(["sphere", "box"])
            element = f'<sphere radius="{0.8 * thick!r}"/>' if more == "sphere" else \
                f'<box size="{text(rng.uniform(0.5, 2, 3) * thick)}"/>'
            found.append((element, random_rotation(rng), middle + rng.uniform(-1, 1, 3) * thick))
        return found

    def write_urdf(self):
        lines = ['<?xml version="1.0"?>', '<robot name="random">']
        for link in self.links:
            lines.append(f'  <link name="{link["name"]}">')
            for element, turn, place in link["shapes"]:
                lines.append(f'    <collision><origin xyz="{text(place)}" rpy="{text(rpy_of(turn))}"/>'
                             f"<geometry>{element}</geometry></collision>")
            lines.append("  </link>")
        for joint in [self.joints[k] for k in self.order]:
            lines += [f'  <joint name="{joint["name"]}" type="{joint["type"]}">',
                      f'    <parent link="{self.links[joint["parent"]]["name"]}"/>',
                      f'    <child link="{self.links[joint["child"]]["name"]}"/>',
                      f'    <origin xyz="{text(joint["xyz"])}" rpy="{text(joint["rpy"])}"/>']
            if joint["type"] != "fixed":
                lines.append(f'    <axis xyz="{text(joint["axis"])}"/>')
            if "lower" in joint:
                lines.append(f'    <limit lower="{joint["lower"]!r}" upper="{joint["upper"]!r}" effort="1"/>')
            if "soft" in joint:
                lines.append(f'    <safety_controller soft_lower_limit="{joint["soft"][0]!r}" '
                             f'soft_upper_limit="{joint["soft"][1]!r}"/>')
            if "mimic" in joint:
                other, factor, offset = joint["mimic"]
                lines.append(f'    <mimic joint="{other}" multiplier="{factor!r}" offset="{offset!r}"/>')
            lines.append("  </joint>")
        open(os.path.join(self.folder, "robot.urdf"), "w").write("\n".join(lines + ["</robot>", ""]))

    def choose_group(self):
        free = [j for j in self.joints if j["type"] != "fixed" and "mimic" not in j]
        held = []
        if self.rng.random() < 0.6:
            self.group = [j["name"] for j in free if self.rng.random() < 0.8] or [free[0]["name"]]
            self.options["group"] = "some"
            held = [j for j in free if j["name"] not in self.group and "lower" in j and self.rng.random() < 0.5]
        if held:
            self.options["hold"] = {j["name"]: float(self.rng.uniform(j["lower"], j["upper"])) for j in held}

    def write_srdf(self, states):
        """Neighbours are off, and some other pairs."""
        lines = ["<robot name='random'>"]
        if self.group:
            lines += ["  <group name='some'>"] + [f"    <joint name='{n}'/>" for n in self.group] + ["  </group>"]
        for name, values in states.items():
            lines.append(f"  <group_state name='{name}' group='some'>")
            lines += [f"    <joint name='{n}' value='{float(v)!r}'/>" for n, v in values.items()] + ["  </group_state>"]
        off = {(j["parent"], j["child"]) for j in self.joints}
        parent = {j["child"]: j["parent"] for j in self.joints}
        rng = np.random.default_rng(len(self.links))  # the same each time it is written
        off |= {(parent[j["parent"]], j["child"]) for j in self.joints if j["parent"] in parent and rng.random() < 0.6}
        off |= {(a, b) for a in range(len(self.links)) for b in range(a) if rng.random() < 0.05}
        for a, b in sorted(off):
            lines.append(f"  <disable_collisions link1='{self.links[a]['name']}' link2='{self.links[b]['name']}'/>")
        open(os.path.join(self.folder, "robot.srdf"), "w").write("\n".join(lines + ["</robot>", ""]))

    # The scene

    def make_scene(self):
        rng = self.rng
        robot, base = self.robot, self.robot.base
        lower, upper = np.maximum(robot.lower, -3.1), np.minimum(robot.upper, 3.1)
        self.tries = lower + (upper - lower) * rng.random((40, len(lower)))
        frames = robot.frames(self.tries)
        moved = [(link, c) for link, c, _ in robot.rough if robot.body[link] != robot.top] or [(robot.top, np.zeros(3))]
        pose, place = rng.uniform(-1, 1, 3), rng.uniform(-0.2, 0.2, 3)
        scene = frame_of(rpy_matrix(pose), place)
        self.scene_pose = {"position": list(place), "rpy": list(pose)} if rng.random() < 0.5 else None
        if self.scene_pose is None:
            scene = np.eye(4)
        inside, outside = [], []
        free = robot.rough_gaps(self.tries, []) > self.clearance
        enough = min(int(rng.integers(3, 20)), free.sum())  # of the tries: what would leave fewer is left out
        wanted = int(rng.integers(1, 8))
        for k in range(3 * wanted):
            link, centre = moved[rng.integers(len(moved))]  # where a part of it may be
            frame = frames[link][rng.integers(len(self.tries))]
            at = frame[:3, :3] @ centre + frame[:3, 3] + rng.normal(size=3) * 0.08
            turn = random_rotation(rng) if rng.random() < 0.8 else np.eye(3)
            world = rng.random() < 0.3
            frame = np.eye(4) if world else scene
            at, home = [frame[:3, :3].T @ (place - frame[:3, 3]) for place in (at, base[:3, 3])]
            block, bodies = random_obstacle(rng, self.folder, k, at, frame[:3, :3].T @ turn, home, world)
            bodies = [(kind, numbers, frame @ local) for kind, numbers, local in bodies]
            left = free & (robot.rough_gaps(self.tries, bodies) > self.clearance)
            if left.sum() < enough:
                continue
            free = left
            (outside if world else inside).append(block if world else {"id": f"thing_{k}", **block})
            self.obstacles += bodies
            if len(inside) + len(outside) == wanted:
                break
        self.blocks = outside
        if inside:
            self.blocks = outside + [{"type": "scene", "file": "scene.yaml",
                                      **({"pose": self.scene_pose} if self.scene_pose else {})}]
            lines = ["objects:"] + [f"  - {flow(block)}" for block in inside]
            open(os.path.join(self.folder, "scene.yaml"), "w").write("\n".join(lines) + "\n")

    # The ends

    def choose_ends(self):
        rng, robot = self.rng, self.robot
        self.kind = str(rng.choice(list(ENDS), p=list(ENDS.values())))
        if self.kind == "state" and not self.group:
            self.kind = "points"
        lower, upper = np.maximum(robot.lower, -3.1), np.minimum(robot.upper, 3.1)
        q = self.tries
        gaps = robot.rough_gaps(q, self.obstacles)
        free, bad = q[gaps > self.clearance], q[gaps < 0]
        if len(free) < 2:
            free = q[np.argsort(-gaps)[:2]]
        if len(bad) == 0:
            bad = q[np.argsort(gaps)[:1]]
        pairs = [rng.choice(len(free), 2, replace=False) for _ in range(8)]
        if rng.random() < 0.7:  # one whose straight way is blocked
            middle = [np.min(robot.rough_gaps(free[a] + np.linspace(0.15, 0.85, 5)[:, None] * (free[b] - free[a]),
                                              self.obstacles)) for a, b in pairs]
            pairs = [pairs[int(np.argmin(middle))]]
        source, target = free[pairs[0][0]], free[pairs[0][1]]
        if self.kind == "collides":
            source, target = (bad[0], target) if rng.random() < 0.5 else (source, bad[0])
        if self.kind == "equal":
            target = source
        if self.kind == "outside":
            k = int(rng.integers(len(target)))
            target = target.copy()
            target[k] = (upper[k] if math.isfinite(robot.upper[k]) else 1e4) + rng.choice([1e-6, 0.1, 5, 1e9])
        self.source, self.targets, self.tool = source, [target], None
        self.blocks_of_ends = {"source": {"point": list(source)}, "target": {"point": list(target)}}
        if self.kind == "state":
            self.write_srdf({"here": dict(zip(robot.names, source)), "there": dict(zip(robot.names, target))})
            self.blocks_of_ends = {"source": {"state": "here"}, "target": {"state": "there"}}
        if self.kind == "goals":
            more = [target] + [free[k] for k in rng.integers(len(free), size=int(rng.integers(1, 3)))] + \
                ([bad[0]] if rng.random() < 0.5 else [])
            self.targets = more
            self.blocks_of_ends["target"] = {"points": [list(t) for t in more]}
        if self.kind.startswith("tool"):
            link = len(self.links) - 1 if rng.random() < 0.6 else int(rng.integers(1, len(self.links)))
            name, offset = self.links[link]["name"], rng.uniform(-0.1, 0.1, 3) if rng.random() < 0.5 else np.zeros(3)
            frame = robot.frames(target[None])[name][0]
            place = frame[:3, 3] + frame[:3, :3] @ offset
            self.tool = (name, offset, place, frame[:3, :3] if self.kind == "tool_turned" else None)
            block = {"link": name, "position": list(place)}
            if offset.any():
                block["offset"] = list(offset)
            if self.kind == "tool_turned":
                block["rpy"] = rpy_of(frame[:3, :3])
            self.blocks_of_ends["target"] = {"tool": block}

    def write_run(self):
        robot = {"type": "urdf", "file": "robot.urdf", **({"srdf": "robot.srdf"} if self.srdf else {}), **self.options}
        lines = ["name: random", "manifold: robot", f"robot: {flow(robot)}"] + ["obstacles:"] * bool(self.blocks)
        lines += [f"  - {flow(block)}" for block in self.blocks]
        lines += [f"clearance: {self.clearance!r}"] * bool(self.blocks)
        lines += ["cost: euclidean", f"ends: {flow(self.blocks_of_ends)}",
                  "max_seconds: 1.5", "output: {files: [result, path]}"]
        if self.rng.random() < 0.5:
            lines.append(f"path: {{points: {int(self.rng.integers(5, 60))}}}")
        self.configuration = os.path.join(self.folder, "run.yaml")
        open(self.configuration, "w").write("\n".join(lines) + "\n")
