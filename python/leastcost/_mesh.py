# SPDX-FileCopyrightText: 2026 The leastcost authors
# SPDX-License-Identifier: MIT
from __future__ import annotations

import os
import warnings
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from . import _leastcost
from ._arrays import numbers
from ._errors import InputError
from ._places import is_number, is_on_face, number, on_face, point

if TYPE_CHECKING:
    from collections.abc import Iterable

    from matplotlib.axes import Axes
    from numpy.typing import ArrayLike, NDArray

    from ._places import Place


@dataclass(frozen=True, eq=False)
class Geodesic:
    """The shortest path between two places of a mesh."""

    points: NDArray[np.float64] = field(repr=False)
    """(m + 1, 3): corners of the path; each segment lies in one face."""
    faces: NDArray[np.int32] = field(repr=False)
    """(m,): the face of each segment, as a row of F as it was given."""
    length: float
    """Length of the path, in units of V."""
    lower_bound: float
    """No path on the mesh is shorter."""
    outcome: str
    """"proved"; "improved": proved, of a path shorter than the first guess; "bounded" or "blocked": only lower_bound
    holds."""
    reason: str = field(repr=False)
    """Why it is blocked; else empty."""

    @property
    def proved(self) -> bool:
        """Whether no path on the mesh is shorter, within 1e-9 of the length."""
        return self.outcome in ("proved", "improved")

    def plot(self, ax: Axes | None = None, **style: Any) -> Axes:
        """Draws the path with matplotlib, and returns the axes: `geodesic.plot(mesh.plot())` with the mesh below it.

        ax: None makes new ones; else they need projection="3d". style: as for Axes.plot."""
        from ._plot import plot_geodesic

        return plot_geodesic(self, ax, style)


class Mesh:
    """A triangle mesh in space, ready for many queries. Immutable; threads may share it.

    V: (n, 3), positions. F: (m, 3), rows of V, from 0; (m, k) for polygons, which are cut into triangles.
    weld: merge vertices with equal positions.

    A place on it is the number of a vertex, its row in V; a tuple (face, (b0, b1, b2)), a row of F as it was given and
    barycentric coordinates with the sum 1; or a point (x, y, z), which means the nearest one of the surface.

    Raises InputError for other shapes and types, vertices that do not exist, positions that are not finite.
    """

    def __init__(self, V: ArrayLike, F: ArrayLike, *, weld: bool = False) -> None:
        vertices = _vertices(V)
        self._core = _leastcost.Mesh(vertices, _faces(F, len(vertices)), weld)

    @classmethod
    def read(cls, file: str | os.PathLike[str], *, weld: bool = False) -> Mesh:
        """A mesh of an OBJ, OFF, PLY or STL file. Raises InputError with file and line."""
        mesh = cls.__new__(cls)
        mesh._core = _leastcost.Mesh(Path(file), weld)
        return mesh

    @property
    def V(self) -> NDArray[np.float64]:
        """(n, 3): the vertices, a copy."""
        return self._core.V()

    @property
    def F(self) -> NDArray[np.int32]:
        """(m, 3): the triangles, rows of V, a copy."""
        return self._core.F()

    @property
    def notes(self) -> list[str]:
        """What was done to the mesh: polygons cut, vertices merged, ..."""
        return self._core.notes()

    def geodesic(self, source: Place, target: Place) -> Geodesic:
        """The shortest path between two places, with a proof. Raises NoPathError, InputError."""
        return Geodesic(*self._core.geodesic(self._place(source), self._place(target)))

    def geodesics(self, pairs: Iterable[tuple[Place, Place]] | NDArray[np.integer[Any]]) -> list[Geodesic]:
        """The shortest path of each pair: an integer array of shape (k, 2), or pairs of places."""
        return [self.geodesic(source, target) for source, target in pairs]

    def distances(
        self, sources: Place | Iterable[Place], *, max_distance: float = float("inf"), bounds: bool = False
    ) -> Any:
        """(n,): distance of each vertex, in the order of V, from the nearest source, in units of V.

        sources: a place, or several; an array of shape (k, 3) is points, and a face is in a tuple. Infinite: no path, or
        no face, or
        farther than max_distance. bounds: return (lower, upper) instead, between which the distances are proved to
        lie. Warns where a distance is known from above alone.
        """
        if not max_distance >= 0:
            raise InputError(f"max_distance is {max_distance}; it must be at least 0")
        places = [self._place(place) for place in _several(sources)]
        distance, lower, upper, blocked, out_of_memory = self._core.distances(places, max_distance)
        if blocked or out_of_memory:
            why = "memory ran out" if out_of_memory else "paths run over faces without height"
            warnings.warn(f"{why}: some distances are upper bounds", RuntimeWarning, stacklevel=2)
        return (lower, upper) if bounds else distance

    def plot(self, ax: Axes | None = None, **style: Any) -> Axes:
        """Draws the mesh with matplotlib, a large one coarsened, and returns the axes.

        ax: None makes new ones; else they need projection="3d". style: as for Axes3D.plot_trisurf."""
        from ._plot import plot_mesh

        return plot_mesh(self, ax, style)

    def _place(self, place: Place) -> _leastcost.SurfacePoint:
        if is_number(place):
            return self._core.vertex(number(place, "a place"))
        if is_on_face(place):
            return self._core.on_face(*on_face(place, "a place"))
        x = point(place)
        if x is None or x.shape != (3,):
            raise InputError(
                f"a place on a mesh is the number of a vertex, (face, (b0, b1, b2)) or a point (x, y, z), not {place!r}"
            )
        return self._core.nearest(*x.tolist())

    @property
    def _external(self) -> _leastcost.External:
        return self._core.external()

    def __repr__(self) -> str:
        return f"<leastcost.Mesh: {len(self.V)} vertices, {len(self.F)} triangles>"


def _vertices(V: ArrayLike) -> NDArray[np.float64]:
    array = numbers(V, "V")
    if array.ndim != 2 or array.shape[1] != 3:
        raise InputError(f"V has the shape {array.shape}; positions must have the shape (n, 3)")
    return np.ascontiguousarray(array)


def _faces(F: ArrayLike, vertices: int) -> NDArray[np.int32]:
    try:
        array = np.asarray(F)
    except ValueError:
        raise InputError("F has rows of different lengths; cut its polygons into triangles") from None
    if array.ndim != 2 or array.shape[1] < 3:
        raise InputError(f"F has the shape {array.shape}; faces must have the shape (m, 3)")
    if array.dtype.kind not in "iu":
        raise InputError(f"F has the type {array.dtype}; faces must be whole numbers, rows of V")
    wrong = np.argwhere((array < 0) | (array >= vertices))
    if len(wrong):
        row, column = wrong[0]
        raise InputError(f"F[{row}, {column}] is {array[row, column]}; V has the rows 0 to {vertices - 1}")
    return np.ascontiguousarray(array, dtype=np.int32)


def _several(sources: Place | Iterable[Place]) -> list[Any]:
    """One place as a list of one. Three numbers are a point only if they are not all integers."""
    if isinstance(sources, (int, np.integer)) or (isinstance(sources, tuple) and is_on_face(sources)):
        return [sources]
    listed = list(sources)
    if len(listed) == 3 and all(np.ndim(x) == 0 for x in listed) and np.asarray(listed).dtype.kind == "f":
        return [listed]
    return listed
