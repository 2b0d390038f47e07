# SPDX-FileCopyrightText: 2026 The leastcost authors
# SPDX-License-Identifier: MIT
"""Least-cost paths with certificates.

    import leastcost as lc

    result = lc.run("brachistochrone.yaml")      # what the command line program does
    print(result.cost, "+-", result.error, result.scope)

    mesh = lc.Mesh.read("hill.obj")              # or lc.Mesh(V, F), arrays
    geodesic = mesh.geodesic(0, 80)              # the shortest path of all, with its proof
    distances = mesh.distances([0, 12])

    chute = lambda a, b: 2 * ((b - a) ** 2).sum(0) / ((-a[1]) ** 0.5 + (-b[1]) ** 0.5) ** 2
    fastest = lc.find_path(lc.Plane(), chute, (0, 0), (3, -2), unit="s", additive=True)
    isochrones = lc.field(lc.Plane(), (100, 200), cost=lc.CostMap(costs, cell=30)).values
    over_land = lc.find_path(lc.Terrain(heights, cell=30), lc.CostMap(costs, cell=30), (100, 200), (4000, 900))
    by_air = lc.find_path(lc.Plane(), lc.Wind(u, v, speed=12, cell=1000), (5000, 2000), (90000, 40000))
    arm = lc.Robot.read("panda.urdf", srdf="panda.srdf", group="panda_arm", tool="panda_hand")
    motion = arm.find_path("ready", "extended", scene="scene.yaml", clearance=0.01).trajectory(acceleration=5)
    result = lc.run({"manifold": mesh, "cost": "euclidean", "ends": ends})  # objects in a configuration

Arrays of results have one point per row. Searches release the GIL and end within 50 ms of Ctrl-C.
"""

from typing import TYPE_CHECKING

from ._cost import Cost, CostMap, Wind
from ._domains import Cloud, Plane, Space, Terrain
from ._errors import ConfigError, Error, InputError, NoPathError, OutputError, TimeLimitError
from ._field import Field, Way, field
from ._find_path import find_path
from ._leastcost import version as __version__
from ._mesh import Geodesic, Mesh
from ._options import Option, option
from ._pairs import PairResult, solve_pairs
from ._reference import describe, schema
from ._register import Chain, SearchEnded, register_cost, register_initializer, register_solver
from ._result import Failure, Result, Trajectory
from ._robot import Joint, Pose, Robot
from ._run import run, validate
from ._study import Study, run_study

if TYPE_CHECKING:
    from ._plugins import cost, initializer, kernel, manifold, obstacle, post_processor, robot, solver
else:

    def __getattr__(name: str) -> object:
        """The kinds of plug-ins are many functions, a quarter of the time of an import: loaded when one is asked for."""
        if name in ("cost", "initializer", "kernel", "manifold", "obstacle", "post_processor", "robot", "solver"):
            from . import _plugins

            return globals().setdefault(name, getattr(_plugins, name))
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")

    def __dir__() -> list[str]:
        return sorted({*globals(), *__all__})


__all__ = [
    "Chain",
    "Cloud",
    "ConfigError",
    "Cost",
    "CostMap",
    "Error",
    "Failure",
    "Field",
    "Geodesic",
    "InputError",
    "Joint",
    "Mesh",
    "NoPathError",
    "Option",
    "OutputError",
    "PairResult",
    "Plane",
    "Pose",
    "Result",
    "Robot",
    "SearchEnded",
    "Space",
    "Study",
    "Terrain",
    "TimeLimitError",
    "Trajectory",
    "Way",
    "Wind",
    "cost",
    "describe",
    "field",
    "find_path",
    "initializer",
    "kernel",
    "manifold",
    "obstacle",
    "option",
    "post_processor",
    "register_cost",
    "register_initializer",
    "register_solver",
    "robot",
    "run",
    "run_study",
    "schema",
    "solve_pairs",
    "solver",
    "validate",
]
