# SPDX-FileCopyrightText: 2026 The leastcost authors
# SPDX-License-Identifier: MIT
"""Random meshes and obstacles, each as the program reads it and as the judge does."""
import json
import math
import os

import numpy as np


def flow(value):
    """As flow style of YAML, which JSON is."""
    return json.dumps(value, default=lambda v: v.tolist() if isinstance(v, np.ndarray) else float(v))


def text(values):
    return " ".join(repr(float(v)) for v in values)


def random_rotation(rng):
    q, r = np.linalg.qr(rng.normal(size=(3, 3)))
    q = q * np.sign(np.diag(r))
    return q if np.linalg.det(q) > 0 else -q


def along(direction, rng):
    """A rotation that takes z to a direction."""
    z = direction / np.linalg.norm(direction)
    x = np.cross(z, rng.normal(size=3))
    x /= np.linalg.norm(x)
    return np.column_stack([x, np.cross(z, x), z])


def rpy_of(turn):
    pitch = math.asin(max(-1, min(1, -turn[2, 0])))
    return [math.atan2(turn[2, 1], turn[2, 2]), pitch, math.atan2(turn[1, 0], turn[0, 0])]


def frame_of(turn, place):
    frame = np.eye(4)
    frame[:3, :3], frame[:3, 3] = turn, place
    return frame


BOX = [[0, 1, 3], [0, 3, 2], [4, 6, 7], [4, 7, 5], [0, 4, 5], [0, 5, 1], [2, 3, 7], [2, 7, 6], [0, 2, 6], [0, 6, 4],
       [1, 5, 7], [1, 7, 3]]


def corners_of_box(low, high):
    return np.array([[x, y, z] for x in (low[0], high[0]) for y in (low[1], high[1]) for z in (low[2], high[2])], float)


def outward(vertices, faces):
    """Corners of the faces of a convex body, counter-clockwise seen from outside."""
    middle = np.mean(vertices, axis=0)
    found = []
    for a, b, c in faces:
        normal = np.cross(vertices[b] - vertices[a], vertices[c] - vertices[a])
        found.append([a, b, c] if normal @ (vertices[a] - middle) > 0 else [a, c, b])
    return found


def random_mesh(rng, size, surfaces):
    """Vertices, faces, and the convex bodies (or the surface) that it is: about `size` (three edges) around 0."""
    kind = rng.choice(["box", "tetrahedron", "octahedron", "corner", "sheet"] if surfaces else
                      ["box", "tetrahedron", "octahedron", "corner"])
    half = np.asarray(size) / 2
    if kind == "box":
        vertices, faces = corners_of_box(-half, half), BOX
    elif kind == "tetrahedron":
        vertices = half * np.array([[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]], float)
        faces = [[0, 1, 2], [0, 1, 3], [0, 2, 3], [1, 2, 3]]
    elif kind == "octahedron":
        vertices = np.concatenate([np.diag(half * rng.uniform(0.5, 1, 3)), -np.diag(half * rng.uniform(0.5, 1, 3))])
        faces = [[a, b, c] for a in (0, 3) for b in (1, 4) for c in (2, 5)]
    elif kind == "corner":  # two boxes that share a side, as one mesh
        a, b, c, t = 2 * half[0], 2 * half[1], half[2], 0.35 * min(2 * half[0], 2 * half[1])
        flat = np.array([[0, 0], [a, 0], [a, t], [t, t], [t, b], [0, b]]) - half[:2]
        vertices = np.array([[x, y, z] for z in (-c, c) for x, y in flat])
        faces = [[0, k + 1, k] for k in range(1, 5)] + [[6, 6 + k, 7 + k] for k in range(1, 5)]
        for k in range(6):
            m = (k + 1) % 6
            faces += [[k, m, m + 6], [k, m + 6, k + 6]]
        boxes = [corners_of_box([-half[0], -half[1], -c], [a - half[0], t - half[1], c]),
                 corners_of_box([-half[0], -half[1], -c], [t - half[0], b - half[1], c])]
        return vertices, faces, [("hull", body, outward(body, BOX)) for body in boxes]
    else:
        vertices = half * np.array([[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0.3]])
        faces = [[0, 1, 2], [0, 2, 3]]
        return vertices, faces, [("faces", vertices, faces)]
    faces = outward(vertices, faces)
    return vertices, faces, [("hull", vertices, faces)]


def write_mesh(path, vertices, faces):
    with open(path, "w") as out:
        out.writelines(f"v {text(v)}\n" for v in vertices)
        out.writelines(f"f {a + 1} {b + 1} {c + 1}\n" for a, b, c in faces)


def random_obstacle(rng, folder, number, at, turn, home, world):
    """Its block in the configuration, and (kind, numbers, frame) for the judge. `at`, `turn` and
    the place of the robot's base, `home`, are in the frame of the list that it stands in: the world, or a scene."""
    kind = str(rng.choice(["ball", "box", "box_along", "capsule", "cylinder", "cone", "frustum", "half_space", "mesh",
                           "points"], p=[0.1, 0.22, 0.06, 0.1, 0.12, 0.08, 0.06, 0.06, 0.15, 0.05]))
    if kind == "points" and not world:
        kind = "ball"
    radius, frame = float(rng.uniform(0.03, 0.14)), frame_of(turn, at)
    height = float(rng.uniform(0.08, 0.5))
    pose = {"position": list(at), "rpy": rpy_of(turn)}
    if kind == "ball":
        return {"type": kind, "center": list(at), "radius": radius}, [("sphere", [radius], frame)]
    if kind in ("box", "box_along"):
        size = rng.uniform(0.02, 0.4, 3)
        if kind == "box":
            return {"type": kind, "size": list(size), "pose": pose}, [("box", list(size), frame)]
        return {"type": "box", "lower": list(at - size / 2), "upper": list(at + size / 2)}, \
            [("box", list(size), frame_of(np.eye(3), at))]
    if kind == "capsule":
        ends = [at - height / 2 * turn[:, 2], at + height / 2 * turn[:, 2]]
        return {"type": kind, "from": list(ends[0]), "to": list(ends[1]), "radius": radius}, \
            [("capsule", [radius, height], frame)]
    if kind in ("cylinder", "cone"):
        return {"type": kind, "radius": radius, "height": height, "pose": pose}, [(kind, [radius, height], frame)]
    if kind == "frustum":  # for the judge with 64 sides within it
        top = radius * float(rng.uniform(0.2, 0.8))
        sides = 64
        ring = np.array([[math.cos(2 * math.pi * k / sides), math.sin(2 * math.pi * k / sides)] for k in range(sides)])
        vertices = np.array([[r * x, r * y, z] for r, z in ((radius, -height / 2), (top, height / 2))
                             for x, y in ring])
        faces = [[0, k, k + 1] for k in range(1, sides - 1)]
        faces += [[sides, sides + k, sides + k + 1] for k in range(1, sides - 1)]
        for k in range(sides):
            m = (k + 1) % sides
            faces += [[k, m, sides + m], [k, sides + m, sides + k]]
        return {"type": "cone", "radius": radius, "top_radius": top, "height": height, "pose": pose}, \
            [("hull", [vertices, outward(vertices, faces)], frame)]
    if kind == "half_space":  # behind a place away from the base
        normal = home - at
        normal /= np.linalg.norm(normal)
        offset = float(normal @ at)
        return {"type": kind, "normal": list(normal * rng.uniform(0.5, 3)), "offset": offset}, \
            [("half_space", [*normal, offset], np.eye(4))]
    if kind == "points":
        cloud = at + rng.normal(size=(int(rng.integers(3, 25)), 3)) * 0.1
        name = f"cloud_{number}.xyz"
        open(os.path.join(folder, name), "w").writelines(f"{text(p)}\n" for p in cloud)
        return {"type": kind, "file": name, "radius": radius / 3}, \
            [("sphere", [radius / 3], frame_of(np.eye(3), p)) for p in cloud]
    vertices, faces, bodies = random_mesh(rng, rng.uniform(0.08, 0.4, 3), True)
    placed = [(k, v @ turn.T + at, f) for k, v, f in bodies]
    name = f"obstacle_{number}.obj"
    write_mesh(os.path.join(folder, name), vertices @ turn.T + at, faces)
    return {"type": "mesh", "file": name}, [(k, [v, f], np.eye(4)) for k, v, f in placed]
