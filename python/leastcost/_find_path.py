# SPDX-FileCopyrightText: 2026 The leastcost authors
# SPDX-License-Identifier: MIT
from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from . import _leastcost
from ._config import source_of
from ._cost import check_analytic, checked
from ._domains import Space
from ._errors import InputError
from ._result import Result

if TYPE_CHECKING:
    from collections.abc import Mapping

    from numpy.typing import ArrayLike, NDArray

    from ._cost import SquaredCost
    from ._domains import Domain


def find_path(
    domain: Domain,
    cost: str | Mapping[str, Any] | SquaredCost,
    source: ArrayLike,
    target: ArrayLike,
    *,
    points: int = 64,
    unit: str = "cost",
    symmetric: bool = True,
    additive: bool = False,
    max_seconds: float | None = None,
) -> Result:
    """The path of least cost from one point to another.

    domain: Plane(), Space(d), or a dict as under `manifold` in a configuration. On a mesh: Mesh.geodesic().
    cost: a name or a dict as under `cost` in a configuration; or, in Plane and Space, a function q(a, b) that returns
      the squared costs, shape (n,), of straight moves between the points a and b, shape (d, n). It is called with real
      and with complex arrays and must be analytic: sums, products, roots, exp, sin, ...; not abs or maximum. NaN and
      negative numbers mean an infinite cost.
    source, target: (d,), the ends.
    points: free points of the path, n >= 1.
    unit, symmetric, additive: of a function. symmetric: q(a, b) = q(b, a). additive: c = q**0.5 is the exact cost of a
      straight move, so that its parts add up to it; the error is then much smaller.
    max_seconds: wall time, s.

    Ctrl-C and errors: as of run(). What the function raises comes out as it is; so does KeyboardInterrupt within it.
    """
    ends = _point(source, "source"), _point(target, "target")
    config: dict[str, Any] = {
        "manifold": domain.config() if isinstance(domain, Space) else domain,
        "cost": cost,
        "ends": {"source": {"point": ends[0]}, "target": {"point": ends[1]}},
        "path": {"points": points},
    }
    if not callable(cost):
        return Result(_leastcost.run(source_of(config, None, ""), max_seconds, None))
    if not isinstance(domain, Space):
        raise InputError("a cost that is a function needs Plane() or Space(d)")
    for end, name in zip(ends, ("source", "target")):
        if len(end) != domain.dimension:
            raise InputError(f"{name} has {len(end)} coordinates; {domain} has {domain.dimension}")
    q = checked(cost)
    check_analytic(q, *ends)
    config.update(cost="euclidean", initializer="straight", solver="newton")
    own = _leastcost.Cost(q, domain.dimension, unit, symmetric, additive)
    return Result(_leastcost.run(source_of(config, None, ""), max_seconds, own))


def _point(point: ArrayLike, name: str) -> NDArray[np.float64]:
    array = np.asarray(point)
    if array.ndim != 1 or array.dtype.kind not in "fiu":
        raise InputError(f"{name} is a point: real numbers of shape (d,), not {point!r}")
    return array.astype(np.float64)
