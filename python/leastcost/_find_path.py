# SPDX-FileCopyrightText: 2026 The leastcost authors
# SPDX-License-Identifier: MIT
from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from . import _leastcost
from ._arrays import seconds
from ._config import source_of
from ._cost import Cost
from ._domains import Cloud, Space, Terrain
from ._errors import InputError
from ._mesh import Mesh
from ._places import is_number, is_on_face, on_face, point
from ._result import Result
from ._robot import Robot, end_of_robot

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import ArrayLike

    from ._cost import CostMap, SquaredCost, Wind
    from ._domains import Domain
    from ._places import Place
    from ._robot import Pose


def find_path(
    domain: Domain,
    cost: str | Mapping[str, Any] | Cost | CostMap | Wind | SquaredCost | None,
    source: Place | Mapping[str, Any] | str,
    target: Place | Mapping[str, Any] | str | Pose,
    *,
    points: int | None = None,
    obstacles: Sequence[Mapping[str, Any]] = (),
    clearance: float = 0,
    initializer: str | Mapping[str, Any] | ArrayLike | None = None,
    unit: str = "cost",
    symmetric: bool = True,
    additive: bool = False,
    derivatives: str = "complex",
    set: Mapping[str, Any] | None = None,
    max_seconds: float | None = None,
) -> Result:
    """The path of least cost from one place to another.

    domain: Plane(), Space(d), a Mesh, Cloud, Terrain or Robot, or a dict as under `manifold` in a configuration.
    cost: a Cost, CostMap or Wind; a name or a dict as under `cost` in a configuration; or a function q(a, b) that
      returns the squared costs, shape (n,), of straight moves between the points a and b, shape (d, n). None: length.
    source, target: (d,), points; on a Mesh or Cloud also numbers of vertices; on a Mesh also tuples
      (face, (b0, b1, b2)); or dicts as under `ends` in a configuration. A point means the nearest one of a Mesh.
      Of a Robot: configurations (d,), or names of its states; as targets also (k, d), several goals, or a Pose of its
      tool: the goal that is cheapest to reach is taken.
    points: free points of the path, n >= 1; None: 64, of a Robot as many as a configuration has without `path`.
    obstacles, clearance: as in a configuration: [{"type": "ball", "center": [1, 0], "radius": 0.5}], length units.
    initializer: where the first path comes from, a name or a dict as in a configuration; or the points that it goes
      through, (n, d). A cost that is a function starts from a straight line, or from the least-cost path along the
      edges of a mesh.
    unit, symmetric, additive, derivatives: of a function, see Cost.
    set: any other option of a configuration: {"certificate.refine": 0}.
    max_seconds: wall time, s.

    Ctrl-C and errors: as of run(). What the function raises comes out as it is; so does KeyboardInterrupt within it.
    """
    robot = domain if isinstance(domain, Robot) else None
    refuse_mistaken(cost, obstacles)
    if cost is None:
        cost = "euclidean"
    if callable(cost):
        cost = Cost(cost, unit=unit, symmetric=symmetric, additive=additive, derivatives=derivatives)
    elif (unit, symmetric, additive, derivatives) != ("cost", True, False, "complex"):
        raise InputError(
            "unit, symmetric, additive and derivatives are of a function; those of a Cost are given to it, and names, "
            "dicts, CostMap and Wind have their own"
        )
    config: dict[str, Any] = {
        "manifold": domain.config() if isinstance(domain, Space) else domain,
        "cost": cost,
        "ends": {"source": _end(source, "source", domain), "target": _end(target, "target", domain)},
    }
    if robot is not None:
        config.update(manifold="robot", robot=robot)
    if points is not None or robot is None:
        config["path"] = {"points": 64 if points is None else points}
    if len(obstacles) > 0:
        config["obstacles"] = list(obstacles)
    if clearance != 0:
        config["clearance"] = clearance
    if initializer is not None:
        config["initializer"] = initializer
    return Result(_leastcost.run(source_of(config, set=set), seconds(max_seconds)))


def refuse_mistaken(cost: Any, obstacles: Any) -> None:
    """Says what was meant by an array of costs and by an obstacle alone."""
    if isinstance(cost, np.ndarray):
        raise InputError(f"cost is an array of shape {cost.shape}; costs per cell are lc.CostMap(values, cell=30)")
    if isinstance(obstacles, Mapping):
        raise InputError("obstacles is one obstacle; give a list of them: [lc.obstacle.ball(...)]")


#: Tolerance of points beside a mesh: the nearest point of it is meant, however far; a note of the result says how far.
FAR = 1e300


def _end(place: Any, name: str, domain: Domain) -> Mapping[str, Any]:
    """As in a configuration."""
    if isinstance(place, Mapping):
        return place
    if isinstance(domain, Robot):
        return end_of_robot(place, name, domain)
    if is_number(place):
        if isinstance(domain, (Space, Terrain)):
            raise InputError(f"{name} is {place!r}, but {domain!r} has no vertices: give a point")
        return {"vertex": int(place)}
    if is_on_face(place):
        if isinstance(domain, (Space, Terrain, Cloud)):
            raise InputError(f"{name} is {place!r}, but {domain!r} has no faces: give a point")
        face, barycentric = on_face(place, name)
        return {"face": face, "barycentric": list(barycentric)}
    x = point(place)
    if x is None:
        raise InputError(f"{name} must be a point: real numbers of shape (d,), not {place!r}")
    wanted = _coordinates(domain)
    if wanted is not None and len(x) != wanted:
        raise InputError(f"{name} has {len(x)} coordinate{'s' * (len(x) != 1)}; points of {domain!r} have {wanted}")
    if isinstance(domain, Mesh):
        return {"point": x, "tolerance": FAR}
    return {"point": x}


def _coordinates(domain: Domain) -> int | None:
    """Of a point, where it is known."""
    if isinstance(domain, Space):
        return domain.dimension
    if isinstance(domain, (Mesh, Cloud)):
        return 3
    return 2 if isinstance(domain, Terrain) else None
