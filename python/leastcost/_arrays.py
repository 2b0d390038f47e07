# SPDX-FileCopyrightText: 2026 The leastcost authors
# SPDX-License-Identifier: MIT
"""Arrays as they are given, refused in words where they do not fit."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ._errors import InputError

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray


def numbers(values: ArrayLike, name: str) -> NDArray[np.float64]:
    """Real numbers of any shape; what is masked is NaN."""
    try:
        array = np.asanyarray(values)
    except ValueError:  # numpy says "inhomogeneous"
        raise InputError(f"{name} has rows of different lengths") from None
    if array.dtype.kind not in "fiu":
        raise InputError(f"{name} has the type {array.dtype}; it must have real numbers")
    plain = np.array(array, dtype=np.float64, order="C", subok=False)
    plain[np.ma.getmaskarray(array)] = np.nan  # type: ignore[no-untyped-call]
    return plain


def seconds(value: float | None) -> float | None:
    """A time budget, s."""
    if value is None:
        return None
    if isinstance(value, bool) or not isinstance(value, (int, float, np.integer, np.floating)):
        raise InputError(f"max_seconds is {value!r}; it must be a number of seconds, or None")
    if not 0 < value <= 1e9:
        raise InputError(f"max_seconds is {value}; it must be above 0 and at most 1e9, or None for no limit")
    return float(value)


def points(values: ArrayLike, name: str, dimension: int | None = None) -> NDArray[np.float64]:
    """(n, d), finite."""
    array = numbers(values, name)
    d = "d" if dimension is None else str(dimension)
    if array.ndim != 2 or (dimension is not None and array.shape[1] != dimension):
        raise InputError(f"{name} has the shape {array.shape}; points must have the shape (n, {d})")
    wrong = np.argwhere(~np.isfinite(array))
    if len(wrong):
        row, column = wrong[0]
        raise InputError(f"{name}[{row}, {column}] is {array[row, column]}; points must be finite")
    return array


def largest(values: ArrayLike | None, name: str) -> NDArray[np.float64] | None:
    """One number, or (d,), above 0."""
    if values is None:
        return None
    array = np.atleast_1d(numbers(values, name))
    if array.ndim != 1 or not len(array):
        raise InputError(f"{name} has the shape {array.shape}; it must be one number for all coordinates, or (d,)")
    return array


def raster(values: ArrayLike, name: str) -> NDArray[np.float64]:
    """(rows, columns)."""
    array = numbers(values, name)
    if array.ndim != 2:
        raise InputError(f"{name} has the shape {array.shape}; a raster must have the shape (rows, columns)")
    return array


def pair(value: ArrayLike, name: str, *, positive: bool = False) -> tuple[float, float]:
    """Two finite numbers; of sides, one stands for both."""
    array = numbers(value, name)
    if positive and array.ndim == 0:
        array = np.repeat(array, 2)
    if array.shape != (2,):
        raise InputError(f"{name} has the shape {array.shape}; it must be two numbers, along x and along y")
    if not np.isfinite(array).all() or (positive and not (array > 0).all()):
        raise InputError(f"{name} is {array.tolist()}; its numbers must be finite{' and above 0' if positive else ''}")
    return float(array[0]), float(array[1])
