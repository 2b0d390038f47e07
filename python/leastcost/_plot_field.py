# SPDX-FileCopyrightText: 2026 The leastcost authors
# SPDX-License-Identifier: MIT
"""Pictures of fields in matplotlib."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from ._plot import _axes, _equal

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from ._field import Field

_CONTOURS = 10


def plot_field(field: Field, ax: Axes | None, style: dict[str, Any]) -> Axes:
    ax = _axes(ax, space=field.axes is None)
    if field.axes is None:
        _draw_on_mesh(field, ax, style)
    else:
        _draw_lattice(field, ax, style)
    return ax


def _draw_lattice(field: Field, ax: Axes, style: dict[str, Any]) -> None:
    assert field.axes is not None
    x, y = field.axes  # in the plane
    dx, dy = (x[-1] - x[0]) / (len(x) - 1) / 2, (y[0] - y[-1]) / (len(y) - 1) / 2
    extent = (x[0] - dx, x[-1] + dx, y[-1] - dy, y[0] + dy)
    image = ax.imshow(field.values, **{"extent": extent, "cmap": "YlOrBr", "zorder": 0, **style})
    values = np.ma.masked_invalid(field.values)  # type: ignore[no-untyped-call]
    if values.count() and np.ptp(values.compressed()) > 0:
        lines = ax.contour(x, y, values, _CONTOURS, colors="#4d4d4d", linewidths=0.6, zorder=1)
        ax.clabel(lines, fontsize=7)
    ax.get_figure().colorbar(image, ax=ax, label=_label(field))
    ax.set_aspect("equal")
    ax.set_xlabel("x")
    ax.set_ylabel("y")


def _draw_on_mesh(field: Field, ax: Axes, style: dict[str, Any]) -> None:
    """A face has the mean of its corners."""
    assert field.faces is not None
    used = np.unique(field.faces)
    row = np.zeros(len(field.nodes), dtype=int)
    row[used] = np.arange(len(used))
    nodes, faces = field.nodes[used], row[field.faces]
    surface = ax.plot_trisurf(
        *nodes.T, triangles=faces, **{"cmap": "YlOrBr", "linewidth": 0, "antialiased": False, **style}
    )
    surface.set_array(np.ma.masked_invalid(field.values[field.faces].mean(axis=1)))  # type: ignore[no-untyped-call]
    surface.autoscale()
    ax.get_figure().colorbar(surface, ax=ax, label=_label(field))
    _equal(ax, nodes)


def _label(field: Field) -> str:
    unit = field.unit
    return "cost" if unit == "cost" else f"cost ({unit})"
