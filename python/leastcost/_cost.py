# SPDX-FileCopyrightText: 2026 The leastcost authors
# SPDX-License-Identifier: MIT
"""Costs: functions written in Python, and arrays."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from . import _leastcost
from ._arrays import pair, raster
from ._checks import check
from ._errors import InputError

if TYPE_CHECKING:
    from collections.abc import Callable

    from numpy.typing import ArrayLike, NDArray

    #: q(a, b): squared costs of moves, shape (n,); a, b: their ends, shape (d, n), real or complex.
    SquaredCost = Callable[[NDArray[Any], NDArray[Any]], NDArray[Any]]


class Cost:
    """A cost written with numpy. It is checked when it is used.

    q: q(a, b) returns the squared costs, shape (n,), of straight moves between the points a and b, shape (d, n), in
      ambient coordinates. NaN and negative numbers mean an infinite cost.
    unit: of the cost, in words.
    symmetric: the reverse move costs the same: q(a, b) = q(b, a).
    additive: c = q**0.5 is the exact cost of a straight move, so that its parts add up to it; the error of a path is
      then much smaller.
    derivatives: "complex": by complex steps, exact but for rounding. q is also called with complex arrays and must be
      analytic: sums, products, roots, exp, sin, ...; not abs or maximum. "differences": q is called with real arrays
      only and need not be analytic; eleven digits of a derivative are right, and kinks may keep a path from being
      certified.
    dimension: d, where nothing else tells it; None: that of the space of the manifold.

    Before a search goes on from its first path, derivatives, `symmetric` and `additive` are tried at moves near it.
    InputError says with numbers which of them is not true.
    """

    def __init__(
        self,
        q: SquaredCost,
        *,
        unit: str = "cost",
        symmetric: bool = True,
        additive: bool = False,
        derivatives: str = "complex",
        dimension: int | None = None,
    ) -> None:
        if not callable(q):
            raise TypeError(f"a cost must be a function q(a, b), not {type(q).__name__}")
        if derivatives not in ("complex", "differences"):
            raise InputError(f'derivatives must be "complex" or "differences", not {derivatives!r}')
        self.q = q
        self.unit = unit
        self.symmetric = symmetric
        self.additive = additive
        self.derivatives = derivatives
        self.dimension = dimension

    def __repr__(self) -> str:
        return f"<leastcost.Cost {getattr(self.q, '__name__', type(self.q).__name__)}>"

    @property
    def _external(self) -> _leastcost.External:
        q = checked(self.q)

        def check_first(points: NDArray[np.float64]) -> None:
            check(q, points, self.symmetric, self.additive, self.derivatives == "complex")

        differences = self.derivatives == "differences"
        dimension = self.dimension or 0
        return _leastcost.cost(q, check_first, self.unit, self.symmetric, self.additive, differences, dimension)


class CostMap:
    """The cost of a unit of length, from a raster: a path costs the integral of it over its length.

    costs: (rows, columns), above 0, at the middles of the cells. Row 0 is the northernmost one (y is largest), as in
      images and in raster files; columns go east (x grows). NaN, or masked: no data, which paths go round.
    origin: (x, y) of the outer corner of the cell of the last row and the first column: the lower left corner.
    cell: side of a cell, or (along x, along y), length units.
    interpolation: "cells": constant in each cell; in the plane without obstacles only, where the path is then exact.
      "smooth": a bicubic spline near the values, without kinks. "auto": as in a configuration, cells where that can be
      solved: between two ends in the plane, unless obstacles, a clearance, a solver or a post-processor are asked for.
      What a file or a text names is smooth then.

    In the plane, or over a Terrain, whose map it shares. Raises InputError.
    """

    def __init__(
        self, costs: ArrayLike, *, origin: ArrayLike = (0, 0), cell: ArrayLike = 1, interpolation: str = "auto"
    ) -> None:
        array = raster(costs, "costs")
        wrong = np.argwhere(array <= 0)
        if len(wrong):
            row, column = wrong[0]
            raise InputError(
                f"costs[{row}, {column}] is {array[row, column]}; costs must be above 0, or NaN for no data"
            )
        if interpolation not in ("auto", "cells", "smooth"):
            raise InputError(f'the interpolation must be "auto", "cells" or "smooth", not {interpolation!r}')
        self._state = (array, pair(origin, "origin"), pair(cell, "cell", positive=True), interpolation)
        self._read: dict[bool, _leastcost.External] = {}

    def _external_of(self, cells: bool) -> _leastcost.External:
        """Made when it is first used. cells: what "auto" means."""
        array, origin, cell, interpolation = self._state
        cells = interpolation == "cells" or (cells and interpolation == "auto")
        if cells not in self._read:
            self._read[cells] = _leastcost.cost_map(array, origin, cell, cells)
        return self._read[cells]

    def __reduce__(self) -> tuple[Any, ...]:
        return (_cost_map, self._state)

    def __repr__(self) -> str:
        rows, columns = self._state[0].shape
        return f"<leastcost.CostMap: {rows} x {columns} costs>"


class Wind:
    """The time of a vehicle that a wind or a current carries (Zermelo's problem), in the plane.

    u, v: (rows, columns), velocity along x and along y at the middles of the cells, 3 x 3 at least. Row 0 is the
      northernmost one (y is largest), as in images and in raster files; columns go east (x grows). NaN, or masked: no
      data, where no path leads.
    speed: of the vehicle through the air or the water: a number, or a formula in x and y as in a configuration.
    origin: (x, y) of the outer corner of the cell of the last row and the first column: the lower left corner.
    cell: side of a cell, or (along x, along y), length units.
    unit: of time.

    Between the middles velocities are interpolated with two continuous derivatives; beyond the outermost middles there
    is no cost. Raises InputError.
    """

    def __init__(
        self,
        u: ArrayLike,
        v: ArrayLike,
        *,
        speed: float | str,
        origin: ArrayLike = (0, 0),
        cell: ArrayLike = 1,
        unit: str = "s",
    ) -> None:
        along_x, along_y = raster(u, "u"), raster(v, "v")
        if along_x.shape != along_y.shape:
            raise InputError(f"u has the shape {along_x.shape}, and v {along_y.shape}")
        if min(along_x.shape) < 3:
            raise InputError(f"u has the shape {along_x.shape}; a wind needs at least 3 x 3 velocities")
        corner, sides = pair(origin, "origin"), pair(cell, "cell", positive=True)
        self._state = (along_x, along_y, speed, corner, sides, unit)
        rows, columns = along_x.shape
        x, y = np.meshgrid(
            corner[0] + sides[0] * (np.arange(columns) + 0.5), corner[1] + sides[1] * (rows - np.arange(rows) - 0.5)
        )
        nodes = np.column_stack([values.ravel() for values in (x, y, along_x, along_y)])
        self._external = _leastcost.wind(nodes, speed if isinstance(speed, str) else repr(float(speed)), unit)

    def __reduce__(self) -> tuple[Any, ...]:
        return (_wind, self._state)

    def __repr__(self) -> str:
        rows, columns = self._state[0].shape
        return f"<leastcost.Wind: {rows} x {columns} velocities>"


def checked(q: SquaredCost) -> SquaredCost:
    """The same with its shape checked and without warnings: outside its domain a cost may be NaN, which is infinite."""

    def call(a: NDArray[Any], b: NDArray[Any]) -> NDArray[Any]:
        with np.errstate(all="ignore"):  # what is masked is infinite, too
            values: NDArray[Any] = np.ma.filled(q(a, b), np.nan)  # type: ignore[no-untyped-call]
        if values.shape != (a.shape[1],):
            raise InputError(
                f"the cost returned the shape {values.shape}; for {a.shape[1]} moves it must be ({a.shape[1]},)"
            )
        if values.dtype.kind not in "fiuc":
            raise InputError(f"the cost returned values of the type {values.dtype}; costs must be numbers")
        if values.dtype.kind == "c" and a.dtype.kind != "c":
            raise InputError("the cost returned complex numbers for real points")
        return values

    return call


def _cost_map(costs: Any, origin: Any, cell: Any, interpolation: str) -> CostMap:
    return CostMap(costs, origin=origin, cell=cell, interpolation=interpolation)


def _wind(u: Any, v: Any, speed: Any, origin: Any, cell: Any, unit: str) -> Wind:
    return Wind(u, v, speed=speed, origin=origin, cell=cell, unit=unit)
