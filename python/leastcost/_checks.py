# SPDX-FileCopyrightText: 2026 The leastcost authors
# SPDX-License-Identifier: MIT
"""What is promised of a cost written in Python, tried at moves near the first path of a search."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from ._errors import InputError

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from ._cost import SquaredCost

_STEP = 1e-150  # of a complex step
_TOLERANCE = 1e-4  # between derivatives by complex steps and by differences, relative
_ROUNDING = 1e-8  # between costs that are equal, relative
_MOVES = 9


def check(q: SquaredCost, points: NDArray[np.float64], symmetric: bool, additive: bool, analytic: bool) -> None:
    """points: (d, m), a path. Raises InputError for a promise that is not kept: the search would go astray, or its
    certificate would be wrong. Where the cost is infinite nothing is known."""
    a, b = _moves(points)
    _check_squared(q, a, b)
    if symmetric:
        _check_symmetric(q, a, b)
    if additive:
        _check_additive(q, a, b)
    if analytic:
        _check_analytic(q, a, b)


def _moves(points: NDArray[np.float64]) -> tuple[NDArray[Any], NDArray[Any]]:
    """Long moves along the path, a little off it."""
    known = np.arange(points.shape[1])
    at = np.linspace(0.05, 0.95, _MOVES + 1) * known[-1]
    along = np.array([np.interp(at, known, row) for row in points])
    size = np.linalg.norm(points.max(axis=1) - points.min(axis=1))
    along += np.random.default_rng(1).normal(scale=0.02 * size, size=along.shape)
    return along[:, :-1], along[:, 1:]


def _check_squared(q: SquaredCost, a: NDArray[Any], b: NDArray[Any]) -> None:
    """Of a move of half the length, a quarter is left of a square, and half of what was not squared."""
    with np.errstate(all="ignore"):
        ratios = q(a, a + 1e-4 * (b - a)) / q(a, a + 5e-5 * (b - a))
    ratios = ratios[np.isfinite(ratios)]
    if len(ratios) and np.all(np.abs(ratios - 2) < 0.02):
        raise InputError(
            "the function returns costs, not their squares: of short moves, one of half the length has half of it, where "
            "a square has a quarter; return the square, q = cost**2"
        )


def _check_symmetric(q: SquaredCost, a: NDArray[Any], b: NDArray[Any]) -> None:
    there, back = _costs(q, a, b), _costs(q, b, a)
    i = _worst(there, back)
    if i is not None:
        raise InputError(
            f"the cost is not symmetric: the move from {_text(a[:, i])} to {_text(b[:, i])} costs {there[i]:.9g}, "
            f"and the reverse move {back[i]:.9g}; pass symmetric=False"
        )


def _check_additive(q: SquaredCost, a: NDArray[Any], b: NDArray[Any]) -> None:
    middle = (a + b) / 2
    whole, parts = _costs(q, a, b), _costs(q, a, middle) + _costs(q, middle, b)
    i = _worst(whole, parts)
    if i is not None:
        raise InputError(
            f"the cost is not additive: the move from {_text(a[:, i])} to {_text(b[:, i])} costs {whole[i]:.9g}, "
            f"and its two halves {parts[i]:.9g}; pass additive=False"
        )


def _check_analytic(q: SquaredCost, a: NDArray[Any], b: NDArray[Any]) -> None:
    """Compares derivatives by complex steps with differences."""
    with np.errstate(all="ignore"):
        h = 1e-5 * float(np.linalg.norm(b - a, axis=0).mean())
    for end, name in ((0, "a"), (1, "b")):
        for axis in range(len(a)):
            exact = _moved(q, a, b, end, axis, 1j * _STEP).imag / _STEP
            difference = (_moved(q, a, b, end, axis, h) - _moved(q, a, b, end, axis, -h)) / (2 * h)
            largest = np.max(np.abs(difference), initial=0, where=np.isfinite(difference))
            wrong = np.abs(exact - difference) > _TOLERANCE * largest
            if wrong.any():  # NaN is not: outside the domain
                i = int(np.argmax(wrong))
                raise InputError(
                    f"the cost is not analytic: its derivative by {name}[{axis}] is {exact[i]:.6g} by a complex step "
                    f"and {difference[i]:.6g} by differences, for the move from {_text(a[:, i])} to "
                    f"{_text(b[:, i])}; write it without abs, maximum, conj or conditions on complex numbers "
                    '(abs(x): (x**2)**0.5), or pass derivatives="differences"'
                )


def _costs(q: SquaredCost, a: NDArray[Any], b: NDArray[Any]) -> NDArray[Any]:
    with np.errstate(all="ignore"):
        return np.sqrt(q(a, b))


def _worst(one: NDArray[Any], other: NDArray[Any]) -> int | None:
    """Where two costs differ most, if they do; not where one is NaN."""
    with np.errstate(all="ignore"):
        off = np.abs(one - other) - _ROUNDING * np.maximum(one, other)
    off[np.isnan(off)] = -1
    i = int(np.argmax(off))
    return i if off[i] > 0 else None


def _text(x: NDArray[Any]) -> str:
    return "(" + ", ".join(f"{value:.6g}" for value in x) + ")"


def _moved(q: SquaredCost, a: NDArray[Any], b: NDArray[Any], end: int, axis: int, by: complex) -> NDArray[Any]:
    ends = [a.astype(np.result_type(a, by)), b.astype(np.result_type(b, by))]
    ends[end][axis] += by
    return q(*ends)
