# SPDX-FileCopyrightText: 2026 The leastcost authors
# SPDX-License-Identifier: MIT
"""Paths in matplotlib, which is imported only here."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from ._result import Result


def plot(result: Result, ax: Axes | None, **style: Any) -> Axes:
    dimension = result.curve.shape[1]
    if ax is None:
        ax = _new_axes(dimension)
    if dimension in (2, 3):
        _draw_curve(result, ax, dimension, style)
    else:
        _draw_coordinates(result, ax, style)
    return ax


def _new_axes(dimension: int) -> Axes:
    import matplotlib.pyplot as plt

    axes: Axes = plt.figure().add_subplot(projection="3d" if dimension == 3 else None)
    return axes


def _draw_curve(result: Result, ax: Axes, dimension: int, style: dict[str, Any]) -> None:
    (line,) = ax.plot(*result.curve.T, **{"linewidth": 1.5, **style})
    if result.points.shape[1] == dimension:  # else they are coordinates of a chart
        ax.plot(*result.points.T, ".", color=line.get_color(), markersize=3)
    ax.set_aspect("equal")


def _draw_coordinates(result: Result, ax: Axes, style: dict[str, Any]) -> None:
    share = np.linspace(0, 1, len(result.points))
    for i, values in enumerate(result.points.T):
        ax.plot(share, values, **{"label": f"coordinate {i}", **style})
    ax.set_xlabel("share of the cost")
    ax.legend()
