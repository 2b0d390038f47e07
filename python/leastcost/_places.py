# SPDX-FileCopyrightText: 2026 The leastcost authors
# SPDX-License-Identifier: MIT
"""Ends of paths, as they are given."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from ._errors import InputError

if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Union

    from numpy.typing import NDArray

    #: A vertex, by its row in V; a place on a face, (face, (b0, b1, b2)); or a point, which means the nearest one of
    #: the surface.
    Place = Union[int, tuple[int, Sequence[float]], Sequence[float], NDArray[Any]]


def is_number(place: Any) -> bool:
    """A whole number: that of a vertex."""
    return isinstance(place, (int, np.integer)) and not isinstance(place, bool)


def number(place: Any, name: str) -> int:
    """Of a vertex or a face. Raises InputError for one that no mesh has."""
    if not -(2**31) <= int(place) < 2**31:
        raise InputError(f"{name} is {place}; numbers of vertices and faces are below 2**31")
    return int(place)


def is_on_face(place: Any) -> bool:
    """A pair whose second part is three weights, whatever the first is."""
    return isinstance(place, (tuple, list)) and len(place) == 2 and np.ndim(_array(place[1])) == 1


def on_face(place: Any, name: str) -> tuple[int, tuple[float, float, float]]:
    """Face and barycentric coordinates. Raises InputError."""
    face, weights = place[0], _array(place[1])
    if not is_number(face):
        raise InputError(f"{name} is {place!r}: the number of a face is a whole number, a row of F, not {face!r}")
    if weights.shape != (3,) or weights.dtype.kind not in "fiu":
        raise InputError(f"{name} is {place!r}: barycentric coordinates are three real numbers with the sum 1")
    return number(face, name), (float(weights[0]), float(weights[1]), float(weights[2]))


def point(place: Any) -> NDArray[np.float64] | None:
    """(d,); None where it is not one."""
    array = _array(place)
    return array.astype(np.float64) if array.ndim == 1 and array.dtype.kind in "fiu" else None


def end_tuple(place: Any, name: str) -> tuple[Any, ...]:
    """A place as the compiled part takes it: ("vertex", v), ("face", f, (b0, b1, b2)) or ("point", [x, y, ...]). Raises
    InputError."""
    if is_number(place):
        return "vertex", number(place, name)
    if is_on_face(place):
        face, weights = on_face(place, name)
        return "face", face, weights
    array = np.asarray(place)
    if array.ndim != 1 or array.dtype.kind not in "fiu" or not np.isfinite(array).all():
        raise InputError(f"{name} is a vertex, (face, (b0, b1, b2)) or a point of finite numbers, not {place!r}")
    return "point", [float(x) for x in array]


def _array(place: Any) -> NDArray[Any]:
    try:
        return np.asarray(place)
    except ValueError:  # of rows of different lengths
        return np.empty((0, 0))
