# SPDX-FileCopyrightText: 2026 The leastcost authors
# SPDX-License-Identifier: MIT
"""A robot as its URDF and SRDF say, read anew, and whether a path of it is what a certificate says. It shares nothing
with the program: kinematics by numpy, shapes as they are in the file, collisions by FCL (robot_fcl_judge.cpp)."""
import math
import os
import re
import subprocess
import xml.etree.ElementTree as xml

import numpy as np

APART = 1e-3  # m: no point of the robot goes farther between two places that are looked at
PART_OF_CLEARANCE = 0.98  # of it, spheres and capsules of the robot are enlarged by, against obstacles


def rpy_matrix(rpy):
    (cr, cp, cy), (sr, sp, sy) = np.cos(rpy), np.sin(rpy)
    about_x = np.array([[1, 0, 0], [0, cr, -sr], [0, sr, cr]])
    about_y = np.array([[cp, 0, sp], [0, 1, 0], [-sp, 0, cp]])
    about_z = np.array([[cy, -sy, 0], [sy, cy, 0], [0, 0, 1]])
    return about_z @ about_y @ about_x


def numbers(text):
    return np.array([float(word) for word in text.split()])


def origin_of(element):
    frame, origin = np.eye(4), element.find("origin")
    if origin is not None:
        frame[:3, 3] = numbers(origin.get("xyz", "0 0 0"))
        frame[:3, :3] = rpy_matrix(numbers(origin.get("rpy", "0 0 0")))
    return frame


def about(axis, angles):
    """Rodrigues, k x 4 x 4."""
    x, y, z = axis
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    turn = np.eye(3) + np.sin(angles)[:, None, None] * cross + (1 - np.cos(angles))[:, None, None] * (cross @ cross)
    frames = np.tile(np.eye(4), (len(angles), 1, 1))
    frames[:, :3, :3] = turn
    return frames


class Joint:
    def __init__(self, element):
        self.name, self.type = element.get("name"), element.get("type")
        self.parent, self.child = element.find("parent").get("link"), element.find("child").get("link")
        self.origin = origin_of(element)
        axis = element.find("axis")
        self.axis = numbers(axis.get("xyz")) if axis is not None else np.array([1.0, 0, 0])
        self.axis = self.axis / np.linalg.norm(self.axis)
        limit, soft, mimic = element.find("limit"), element.find("safety_controller"), element.find("mimic")
        self.hard = (-math.inf, math.inf) if limit is None else (float(limit.get("lower")), float(limit.get("upper")))
        self.soft = self.hard if soft is None else (max(self.hard[0], float(soft.get("soft_lower_limit"))),
                                                    min(self.hard[1], float(soft.get("soft_upper_limit"))))
        self.mimic = None if mimic is None else (mimic.get("joint"), float(mimic.get("multiplier")),
                                                 float(mimic.get("offset")))


class Robot:
    """`options` are those of the configuration; `meshes`: file name to convex bodies (kind, vertices, faces)."""

    def __init__(self, folder, options, with_srdf, meshes):
        root = xml.parse(os.path.join(folder, "robot.urdf")).getroot()
        links = [link.get("name") for link in root.findall("link")]
        read = [Joint(element) for element in root.findall("joint")]
        top = next(name for name in links if name not in {j.child for j in read})
        self.joints, open_links = [], [top]
        while open_links:  # depth first, children in the order of the file
            link = open_links.pop()
            self.joints += [j for j in read if j.child == link]
            open_links += [j.child for j in reversed(read) if j.parent == link]
        srdf = xml.parse(os.path.join(folder, "robot.srdf")).getroot() if with_srdf else None
        group = None
        if "group" in options:
            group = {j.get("name") for g in srdf.findall("group") if g.get("name") == options["group"]
                     for j in g.findall("joint")}
        soft = options.get("soft_limits", True)
        hold = options.get("hold", {})
        limits = {j.name: j.soft if soft else j.hard for j in self.joints}
        self.names = [j.name for j in self.joints if j.type != "fixed" and not j.mimic and j.name not in hold
                      and (group is None or j.name in group)]
        self.lower = np.array([limits[n][0] for n in self.names])
        self.upper = np.array([limits[n][1] for n in self.names])
        base = options.get("base", {})
        self.base = np.eye(4)
        self.base[:3, :3], self.base[:3, 3] = rpy_matrix(base.get("rpy", [0, 0, 0])), base.get("position", [0, 0, 0])
        self.links, self.top = links, top
        self.by_name = {j.name: j for j in self.joints}
        room = {j.name: self.room(j) for j in self.joints}
        self.held = {j.name: hold.get(j.name, min(max(0.0, room[j.name][0]), room[j.name][1])) for j in self.joints}
        self.read_shapes(root, meshes)
        self.find_bodies()
        self.find_pairs(srdf)

    def leader(self, joint):
        """The joint that one follows."""
        while joint.mimic:
            joint = self.by_name[joint.mimic[0]]
        return joint

    def room(self, joint):
        """Where a joint and all that mimic it are within their limits."""
        low, high = joint.hard
        for other in self.joints:
            factor, offset, one = 1.0, 0.0, other
            while one.mimic and one is not joint:
                factor, offset, one = factor * one.mimic[1], offset + factor * one.mimic[2], self.by_name[one.mimic[0]]
            if one is not joint or other is joint or factor == 0:
                continue
            ends = sorted((limit - offset) / factor for limit in other.hard)
            low, high = max(low, ends[0]), min(high, ends[1])
        return low, high

    def values(self, joint, q):
        if joint.mimic:
            other, factor, offset = joint.mimic
            return factor * self.values(self.by_name[other], q) + offset
        if joint.name in self.names:
            return q[:, self.names.index(joint.name)]
        return np.full(len(q), self.held[joint.name])

    def frames(self, q):
        """Of each link, for configurations k x n: k x 4 x 4."""
        found = {self.top: np.tile(self.base, (len(q), 1, 1))}
        for joint in self.joints:
            frame = found[joint.parent] @ joint.origin
            if joint.type == "prismatic":
                slide = np.tile(np.eye(4), (len(q), 1, 1))
                slide[:, :3, 3] = self.values(joint, q)[:, None] * joint.axis
                frame = frame @ slide
            elif joint.type != "fixed":
                frame = frame @ about(joint.axis, self.values(joint, q))
            found[joint.child] = frame
        return found

    def read_shapes(self, root, meshes):
        """(link, kind, numbers, frame) and a rough cover by spheres (link, centre, radius)."""
        self.shapes, self.rough = [], []
        for link in root.findall("link"):
            name = link.get("name")
            for collision in link.findall("collision"):
                frame, shape = origin_of(collision), collision.find("geometry")[0]
                if shape.tag == "sphere":
                    radius = float(shape.get("radius"))
                    self.shapes.append((name, "sphere", [radius], frame))
                    self.rough.append((name, frame[:3, 3], radius))
                elif shape.tag in ("cylinder", "capsule"):
                    radius, length = float(shape.get("radius")), float(shape.get("length"))
                    self.shapes.append((name, shape.tag, [radius, length], frame))
                    self.cover(name, frame, 2, length, radius)
                elif shape.tag == "box":
                    size = numbers(shape.get("size"))
                    self.shapes.append((name, "box", list(size), frame))
                    longest = int(np.argmax(size))
                    self.cover(name, frame, longest, size[longest], np.linalg.norm(np.delete(size, longest)) / 2)
                else:
                    scale = numbers(shape.get("scale", "1 1 1"))
                    for kind, vertices, faces in meshes[os.path.basename(shape.get("filename"))]:
                        scaled = vertices * scale
                        turned = faces if np.prod(scale) > 0 else [[a, c, b] for a, b, c in faces]
                        self.shapes.append((name, kind, [scaled, turned], frame))
                        self.rough += [(name, frame[:3, :3] @ v + frame[:3, 3], 0.02) for v in scaled]

    def cover(self, link, frame, axis, length, radius):
        for t in np.linspace(-0.5, 0.5, 5):
            self.rough.append((link, frame[:3, 3] + t * length * frame[:3, axis], radius))

    def find_bodies(self):
        """What moves as one has the name of the link that its joint moves."""
        self.body = {self.top: self.top}
        for joint in self.joints:
            moves = joint.type != "fixed" and self.leader(joint).name in self.names
            self.body[joint.child] = joint.child if moves else self.body[joint.parent]

    def find_pairs(self, srdf):
        """Of shapes that must not meet: on links that move against each other."""
        shaped = {self.body[link] for link, *_ in self.shapes}
        parents = {j.child: self.body[j.parent] for j in self.joints if self.body[j.child] == j.child}

        def above(body):
            """The next body towards the root that has a shape."""
            body = parents.get(body)
            while body is not None and body not in shaped:
                body = parents.get(body)
            return body

        off = set() if srdf is None else {frozenset((p.get("link1"), p.get("link2")))
                                          for p in srdf.findall("disable_collisions")}
        self.pairs = []
        for i, (a, *_) in enumerate(self.shapes):
            for j, (b, *_) in enumerate(self.shapes[:i]):
                one, two = self.body[a], self.body[b]
                if one == two or frozenset((a, b)) in off:
                    continue
                if srdf is None and (above(one) == two or above(two) == one):
                    continue
                self.pairs.append((i, j))

    def rough_gaps(self, q, obstacles):
        """Roughly the least gap in configurations, to choose ends by."""
        frames = self.frames(q)
        at = np.stack([frames[link][:, :3, :3] @ c + frames[link][:, :3, 3] for link, c, _ in self.rough], axis=1)
        radii = np.array([r for *_, r in self.rough])
        gap = np.full(len(q), math.inf)
        moved = [k for k, (link, *_) in enumerate(self.rough) if self.body[link] != self.top]
        for kind, size, frame in obstacles:
            if moved:
                local = (at[:, moved] - frame[:3, 3]) @ frame[:3, :3]
                gap = np.minimum(gap, (rough_distance(kind, size, local) - radii[moved]).min(axis=1))
        links = {(self.shapes[i][0], self.shapes[j][0]) for i, j in self.pairs}
        for a, b in links:
            i = [k for k, s in enumerate(self.rough) if s[0] == a]
            j = [k for k, s in enumerate(self.rough) if s[0] == b]
            apart = np.linalg.norm(at[:, i, None] - at[:, None, j], axis=-1) - radii[i][:, None] - radii[j][None, :]
            gap = np.minimum(gap, apart.min(axis=(1, 2)))
        return gap


def rough_distance(kind, size, local):
    if kind == "half_space":
        return local @ np.array(size[:3]) - size[3]
    if kind == "sphere":
        return np.linalg.norm(local, axis=-1) - size[0]
    if kind in ("capsule", "cylinder", "cone"):
        half = np.array([size[0], size[0], size[1] / 2])
    elif kind == "box":
        half = np.array(size) / 2
    else:
        low, high = np.min(size[0], axis=0), np.max(size[0], axis=0)
        local, half = local - (low + high) / 2, (high - low) / 2
    beyond = np.abs(local) - half
    return np.linalg.norm(np.maximum(beyond, 0), axis=-1) + np.minimum(beyond.max(axis=-1), 0)


def words_of(kind, size, frame):
    if kind in ("hull", "faces"):
        vertices, faces = size
        text = f"{kind} {len(vertices)} " + " ".join(repr(float(x)) for v in vertices for x in v)
        text += f" {len(faces)} " + " ".join(str(k) for face in faces for k in face)
    else:
        text = kind + " " + " ".join(repr(float(x)) for x in size)
    return text + " " + " ".join(repr(float(x)) for x in frame[:3].ravel()) + "\n"


def between(robot, path):
    """Places so near to each other that no point of the robot goes farther than APART, and the largest such motion."""
    centres, reaches = {}, {}
    for link, c, r in robot.rough:
        reaches[link] = max(reaches.get(link, 0), np.linalg.norm(c) + r)

    def motion(q):
        frames, most = robot.frames(q), np.zeros(len(q) - 1)
        for link, reach in reaches.items():
            step = np.linalg.norm(np.diff(frames[link][:, :3, 3], axis=0), axis=1)
            turn = np.linalg.norm(np.diff(frames[link][:, :3, :3], axis=0), axis=(1, 2)) / math.sqrt(2)
            most = np.maximum(most, step + turn * reach)
        return most

    if len(path) < 2:
        return path, 0.0
    counts = np.maximum(1, np.ceil(1.05 * motion(path) / APART)).astype(int)
    # A chord is shorter than the way of a point on a long move.
    joint_steps = np.abs(np.diff(path, axis=0)).sum(axis=1)
    counts = np.maximum(counts, np.ceil(joint_steps / 0.05).astype(int))
    for _ in range(4):
        pieces = [path[:1]] + [a + (b - a) * (np.arange(1, n + 1) / n)[:, None]
                               for a, b, n in zip(path[:-1], path[1:], counts)]
        places = np.concatenate(pieces)
        moved = motion(places)
        if moved.max() <= APART:
            break
        counts = np.ceil(counts * 1.05 * np.maximum(1, np.maximum.reduceat(
            moved, np.concatenate([[0], np.cumsum(counts)[:-1]])) / APART)).astype(int)
    return places, float(moved.max())


def collisions(program, robot, obstacles, clearance, q, left_out):
    """What meets somewhere, as texts. Spheres and capsules keep (nearly) the clearance from obstacles."""
    bodies = list(dict.fromkeys(link for link, *_ in robot.shapes))
    shapes = [(bodies.index(link), kind, size, frame) for link, kind, size, frame in robot.shapes]
    enlarged = [(link, kind, [size[0] + PART_OF_CLEARANCE * clearance, *size[1:]] if kind in ("sphere", "capsule")
                 else size, frame) for link, kind, size, frame in shapes]
    moved = [i for i, (link, *_) in enumerate(robot.shapes) if robot.body[link] != robot.top]
    pairs = [(i, j) for i, j in robot.pairs
             if frozenset((robot.shapes[i][0], robot.shapes[j][0])) not in left_out]
    text = f"links {len(bodies)}\nshapes {2 * len(shapes)}\n"
    text += "".join(f"{link} " + words_of(kind, size, frame) for link, kind, size, frame in shapes + enlarged)
    text += f"obstacles {len(obstacles)}\n" + "".join(words_of(*o) for o in obstacles)
    text += f"walls {len(moved) * len(obstacles)}\n"
    text += "".join(f"{i + len(shapes)} {k}\n" for i in moved for k in range(len(obstacles)))
    text += f"pairs {len(pairs)}\n" + "".join(f"{i} {j}\n" for i, j in pairs) + f"places {len(q)}\n"
    frames = robot.frames(q)
    poses = np.ascontiguousarray(np.stack([frames[link][:, :3] for link in bodies], axis=1), dtype="<f8")
    done = subprocess.run([program], input=text.encode() + poses.tobytes(), capture_output=True)
    if done.returncode != 0:
        raise RuntimeError(done.stderr.decode())
    found = []
    for line in done.stdout.decode().splitlines():
        word, *rest = line.split()
        if word == "judged":
            continue
        first, second, place, count = map(int, rest)
        shape = robot.shapes[first % len(shapes)]
        other = f"obstacle {second} ({obstacles[second][0]})" if word == "wall" else \
            "{} ({})".format(*robot.shapes[second][:2])
        found.append(f"{shape[0]} ({shape[1]}) meets {other} at {count} of {len(q)} places, first at {place}")
    return found


def left_out_pairs(notes):
    """Of links, that a note says are not kept apart."""
    found = set()
    for note in notes:
        if "pairs of parts that touch" in note:
            listed = note.split("configuration tried are ignored:")[1].split(";")[0]
            found |= {frozenset(re.split(" and ", pair.strip())) for pair in listed.split(",")}
    return found
