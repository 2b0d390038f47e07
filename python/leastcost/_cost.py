# SPDX-FileCopyrightText: 2026 The leastcost authors
# SPDX-License-Identifier: MIT
"""Costs written in Python."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from ._errors import InputError

if TYPE_CHECKING:
    from collections.abc import Callable

    from numpy.typing import NDArray

    #: q(a, b): squared costs of moves, shape (n,); a, b: their ends, shape (d, n), real or complex.
    SquaredCost = Callable[[NDArray[Any], NDArray[Any]], NDArray[Any]]

_STEP = 1e-150  # of a complex step
_TOLERANCE = 1e-4  # between derivatives by complex steps and by differences, relative


def checked(q: SquaredCost) -> SquaredCost:
    """The same with its shape checked and without warnings: outside its domain a cost may be NaN, which is infinite."""

    def call(a: NDArray[Any], b: NDArray[Any]) -> NDArray[Any]:
        with np.errstate(all="ignore"):
            values = np.asarray(q(a, b))
        if values.shape != (a.shape[1],):
            raise InputError(f"the cost returned the shape {values.shape}; of {a.shape[1]} moves it is ({a.shape[1]},)")
        if values.dtype.kind == "c" and a.dtype.kind != "c":
            raise InputError("the cost returned complex numbers for real points")
        return values

    return call


def check_analytic(q: SquaredCost, source: NDArray[np.float64], target: NDArray[np.float64]) -> None:
    """Compares derivatives by complex steps with differences, at moves near the straight line from source to target.
    Raises InputError where they differ: the search would go astray."""
    a, b = _moves(source, target)
    size = float(np.linalg.norm(target - source))
    for end, name in ((0, "a"), (1, "b")):
        for axis in range(len(source)):
            exact = _moved(q, a, b, end, axis, 1j * _STEP).imag / _STEP
            h = 1e-6 * size
            difference = (_moved(q, a, b, end, axis, h) - _moved(q, a, b, end, axis, -h)) / (2 * h)
            largest = np.max(np.abs(difference), initial=0, where=np.isfinite(difference))
            wrong = np.abs(exact - difference) > _TOLERANCE * largest
            if wrong.any():  # NaN is not: outside the domain
                i = int(np.argmax(wrong))
                raise InputError(
                    f"the cost is not analytic: its derivative by {name}[{axis}] is {exact[i]:.6g} by a complex step "
                    f"and {difference[i]:.6g} by differences, for the move from {a[:, i].tolist()} to "
                    f"{b[:, i].tolist()}; write it without abs, maximum, conj or conditions on complex numbers "
                    "(abs(x): (x**2)**0.5)"
                )


def _moves(source: NDArray[np.float64], target: NDArray[np.float64]) -> tuple[NDArray[Any], NDArray[Any]]:
    """Nine moves off the line, none of which ends where the path does."""
    way = (target - source)[:, None]
    aside = np.random.default_rng(1).normal(scale=0.02 * np.linalg.norm(way), size=(len(source), 10))
    points = source[:, None] + way * np.linspace(0.1, 0.9, 10) + aside
    return points[:, :-1], points[:, 1:]


def _moved(q: SquaredCost, a: NDArray[Any], b: NDArray[Any], end: int, axis: int, by: complex) -> NDArray[Any]:
    ends = [a.astype(np.result_type(a, by)), b.astype(np.result_type(b, by))]
    ends[end][axis] += by
    return q(*ends)
