# SPDX-FileCopyrightText: 2026 The leastcost authors
# SPDX-License-Identifier: MIT
"""Least-cost paths with certificates.

    import leastcost as lc

    result = lc.run("brachistochrone.yaml")      # what the command line program does
    print(result.cost, "+-", result.error, result.scope)

    mesh = lc.Mesh.read("hill.obj")              # or lc.Mesh(V, F), arrays
    geodesic = mesh.geodesic(0, 80)              # the shortest path of all, with its proof
    distances = mesh.distances([0, 12])

Arrays have one point per row. Searches release the GIL and end within 50 ms of Ctrl-C.
"""

from ._errors import ConfigError, Error, InputError, NoPathError, OutputError, TimeLimitError
from ._mesh import Geodesic, Mesh
from ._result import Failure, Result
from ._run import run, validate

__all__ = [
    "ConfigError",
    "Error",
    "Failure",
    "Geodesic",
    "InputError",
    "Mesh",
    "NoPathError",
    "OutputError",
    "Result",
    "TimeLimitError",
    "run",
    "validate",
]
