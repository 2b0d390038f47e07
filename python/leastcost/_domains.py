# SPDX-FileCopyrightText: 2026 The leastcost authors
# SPDX-License-Identifier: MIT
"""Where points may be."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from . import _leastcost
from ._arrays import numbers, pair, points, raster
from ._errors import InputError

if TYPE_CHECKING:
    from collections.abc import Mapping
    from typing import Union

    from numpy.typing import ArrayLike

    from ._mesh import Mesh
    from ._robot import Robot

    #: A dict is what a configuration has under `manifold`.
    Domain = Union["Space", Mesh, "Cloud", "Terrain", Robot, Mapping[str, Any]]


@dataclass(frozen=True)
class Space:
    """The Euclidean space of some dimension."""

    dimension: int

    def config(self) -> dict[str, Any]:
        """As in a configuration."""
        return {"type": "euclidean", "dimension": self.dimension}


class Plane(Space):
    """The Euclidean plane."""

    def __init__(self) -> None:
        super().__init__(2)

    def __repr__(self) -> str:
        return "Plane()"


class Cloud:
    """The smooth surface through a point cloud. Immutable; threads may share it.

    points: (n, 3), finite; the numbers of ends are rows. Of equal points the first counts.
    normals: (n, 3), of any length above 0; None: estimated.
    neighbours: nearest neighbours of a point: its links in the graph, and what gives its local spacing; 4 to 100.
    radius: of the moving least squares fit, in local spacings; None: 4, larger where the cloud is noisy.
    max_edge: longest link of the graph, in local spacings; a larger value joins parts with a gap between them.

    Raises InputError for other shapes and types, and for too few points.
    """

    def __init__(
        self,
        points: ArrayLike,
        *,
        normals: ArrayLike | None = None,
        neighbours: int = 12,
        radius: float | None = None,
        max_edge: float = 3,
    ) -> None:
        self._state = (points, normals, neighbours, radius, max_edge)
        positions, directions = _positions(points, normals)
        kept = np.sort(np.unique(positions, axis=0, return_index=True)[1])
        self._size = len(positions)
        directions = directions[kept] if len(directions) else directions
        self._external = _leastcost.cloud(
            positions[kept], directions, kept.tolist(), self._size, neighbours, radius, max_edge
        )

    def __reduce__(self) -> tuple[Any, ...]:
        return (_cloud, self._state)

    def __repr__(self) -> str:
        return f"<leastcost.Cloud: {self._size} points>"


class Terrain:
    """A surface z(x, y): the bicubic spline through heights on a regular grid. Immutable; threads may share it.

    heights: (rows, columns), at the middles of the cells, 4 x 4 at least. Row 0 is the northernmost one (y is largest),
      as in images and in raster files; columns go east (x grows). NaN, or masked: no data, which paths go round.
    origin: (x, y) of the outer corner of the cell of the last row and the first column: the lower left corner.
    cell: side of a cell, or (along x, along y), in units of the heights.

    Points of paths are places (x, y) on the map; costs are of points (x, y, z). Raises InputError.
    """

    def __init__(self, heights: ArrayLike, *, origin: ArrayLike = (0, 0), cell: ArrayLike = 1) -> None:
        self._state = (raster(heights, "heights"), pair(origin, "origin"), pair(cell, "cell", positive=True))
        self._external = _leastcost.terrain(*self._state)

    def __reduce__(self) -> tuple[Any, ...]:
        return (_terrain, self._state)

    def __repr__(self) -> str:
        rows, columns = self._state[0].shape
        return f"<leastcost.Terrain: {rows} x {columns} heights>"


def _cloud(points: Any, normals: Any, neighbours: int, radius: float | None, max_edge: float) -> Cloud:
    return Cloud(points, normals=normals, neighbours=neighbours, radius=radius, max_edge=max_edge)


def _terrain(heights: Any, origin: Any, cell: Any) -> Terrain:
    return Terrain(heights, origin=origin, cell=cell)


def _positions(positions: ArrayLike, normals: ArrayLike | None) -> tuple[Any, Any]:
    """Both of shape (n, 3); normals of unit length, or none."""
    at = points(positions, "points", 3)
    if normals is None:
        return at, np.empty((0, 3))
    directions = numbers(normals, "normals")
    if directions.shape != at.shape:
        raise InputError(f"normals have the shape {directions.shape}, and points {at.shape}")
    length = np.linalg.norm(directions, axis=1, keepdims=True)
    wrong = np.flatnonzero(~(np.isfinite(length) & (length > 0)))
    if len(wrong):
        raise InputError(f"the normal of point {wrong[0]} has the length {length[wrong[0], 0]}; it must be above 0")
    return at, directions / length
