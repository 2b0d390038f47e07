# SPDX-FileCopyrightText: 2026 The leastcost authors
# SPDX-License-Identifier: MIT
"""Pictures in matplotlib, which is imported only here. What surrounds a path is what the program writes as scene.json
(docs/reports.md)."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from numpy.typing import NDArray

    from ._mesh import Geodesic, Mesh
    from ._result import Result

    Scene = dict[str, Any]
    Style = dict[str, Any]

_PATH = {"color": "#0072B2", "linewidth": 2.0, "zorder": 6}
_FIRST = {"color": "#6b6b6b", "linewidth": 1.0, "linestyle": "--", "zorder": 4}
_OTHER = {"color": "#D55E00", "linewidth": 1.2, "zorder": 5}
_SOLID, _PALE = "#bcbab6", "#ebeae7"
_MOST_POINTS = 60  # more of them hide the path
_MOST_TRIANGLES = 6000  # of a surface: matplotlib sorts them all whenever the view turns


def plot(result: Result, scene: Scene, ax: Axes | None, style: Style) -> Axes:
    """The picture that suits the domain: a plane, a map from above, space, poses of a robot, or coordinates."""
    if "strip" in scene:
        ax = _axes(ax)
        _draw_poses(scene["strip"], ax, style)
    elif scene["dimension"] == 2 or "relief" in scene:
        ax = _axes(ax)
        _draw_plane(result, scene, ax, style)
    elif scene["dimension"] == 3:
        ax = _axes(ax, space=True)
        _draw_space(result, scene, ax, style)
    else:
        ax = _axes(ax)
        _draw_coordinates(result, ax, style)
    return ax


def plot_mesh(mesh: Mesh, ax: Axes | None, style: Style) -> Axes:
    ax = _axes(ax, space=True)
    _draw_surface(mesh.V, mesh.F, ax, style)
    _equal(ax, mesh.V)
    return ax


def plot_geodesic(geodesic: Geodesic, ax: Axes | None, style: Style) -> Axes:
    new = ax is None
    ax = _axes(ax, space=True)
    ax.plot(*geodesic.points.T, **{**_PATH, **style})
    ax.plot(*geodesic.points[[0, -1]].T, "o", color="#222", markersize=4, zorder=7)
    if new:
        _equal(ax, geodesic.points)
    return ax


def _axes(ax: Axes | None, space: bool = False) -> Axes:
    try:
        import matplotlib.pyplot as plt
    except ImportError as error:
        raise ImportError(
            "plot() draws with matplotlib, which is not installed: apt-get install python3-matplotlib, or "
            "pip install matplotlib; figure() makes an SVG without it"
        ) from error
    if ax is None:
        options = {"projection": "3d", "computed_zorder": False} if space else {}
        ax = plt.figure().add_subplot(**options)
    if (ax.name == "3d") != space:
        raise ValueError(
            'this is a picture in space: its axes need projection="3d"'
            if space
            else "this is a picture in the plane: its axes have no projection"
        )
    if space:
        ax.computed_zorder = False  # the path lies on its surface: it would be hidden by half
    return ax


# --- the plane ---------------------------------------------------------------------------------------------------


def _draw_plane(result: Result, scene: Scene, ax: Axes, style: Style) -> None:
    _draw_rasters(scene, ax)
    _draw_obstacles(scene, ax)
    for line in _lines(scene, "curves"):
        ax.plot(*line.T[:2], color="#6b6b6b", linewidth=1, zorder=3)
    _draw_paths(result, scene, ax, style, 2)
    _draw_box(scene, ax)
    ax.set_aspect("equal")
    ax.set_xlabel("x")
    ax.set_ylabel("y")


def _draw_rasters(scene: Scene, ax: Axes) -> None:
    if "relief" in scene:
        values, extent = _raster(scene["relief"])
        ax.imshow(values, extent=extent, origin="lower", cmap="gray", vmin=-0.4, vmax=1.1, zorder=0)
    if "cost" in scene:
        values, extent = _raster(scene["cost"])
        most = float(np.nanpercentile(values, 98))  # beside a singularity the rest would have one shade
        clipped = float(np.nanmax(values)) > 2 * most
        options = {"vmax": most} if clipped else {}
        image = ax.imshow(values, extent=extent, origin="lower", cmap="YlOrBr", zorder=0, **options)
        extend = "max" if clipped else "neither"
        ax.get_figure().colorbar(image, ax=ax, label="cost per unit of length", extend=extend)
    if "potential" in scene:
        values, extent = _raster(scene["potential"])
        x, y = (np.linspace(extent[2 * i], extent[2 * i + 1], values.shape[1 - i]) for i in (0, 1))
        ax.contour(x, y, values, 12, colors="#6b6b6b", linewidths=0.5, zorder=1)


def _raster(raster: Scene) -> tuple[NDArray[np.float64], tuple[float, float, float, float]]:
    """Its values as an image whose first row is the lowest, and (left, right, bottom, top) of the pixels: samples are
    at the corners of the rectangle as well, pixels reach half a step beyond."""
    values = np.array(raster["values"], dtype=float).reshape(raster["rows"], raster["columns"])
    (left, bottom), (right, top) = raster["lower"], raster["upper"]
    dx, dy = (right - left) / (values.shape[1] - 1) / 2, (top - bottom) / (values.shape[0] - 1) / 2
    return values, (left - dx, right + dx, bottom - dy, top + dy)


def _draw_obstacles(scene: Scene, ax: Axes) -> None:
    free = _lines(scene, "free")
    if free:  # everything outside is blocked
        _fill([_frame(ax, scene, free), *free], ax, _SOLID, 1.0)
    for line in _lines(scene, "margins"):
        _fill([line], ax, _PALE, 1.1)
    for line in _lines(scene, "obstacles"):
        _fill([line], ax, _SOLID, 1.2)


def _fill(outlines: list[NDArray[np.float64]], ax: Axes, color: str, zorder: float) -> None:
    """The area between closed outlines, those within others as holes."""
    from matplotlib.patches import PathPatch
    from matplotlib.path import Path

    outlines = [_turned(line[:, :2], i == 0) for i, line in enumerate(outlines)]
    closed = [np.vstack([line, line[:1]]) for line in outlines]
    codes = np.concatenate([[Path.MOVETO, *[Path.LINETO] * (len(line) - 2), Path.CLOSEPOLY] for line in closed])
    ax.add_patch(PathPatch(Path(np.concatenate(closed), codes), facecolor=color, edgecolor="none", zorder=zorder))
    ax.autoscale_view()


def _turned(line: NDArray[np.float64], left: bool) -> NDArray[np.float64]:
    """Matplotlib fills by winding: an outline runs to the left, its holes to the right."""
    x, y = line.T
    area = np.dot(x, np.roll(y, -1)) - np.dot(y, np.roll(x, -1))
    return line if (area > 0) == left else line[::-1]


def _frame(ax: Axes, scene: Scene, free: list[NDArray[np.float64]]) -> NDArray[np.float64]:
    """A rectangle around what is free and around the path."""
    points = np.vstack([*free, _line(scene, scene["lines"]["path"])])[:, :2]
    lower, upper = np.nanmin(points, axis=0), np.nanmax(points, axis=0)
    room = 0.03 * max(upper - lower)
    (a, b), (c, d) = lower - room, upper + room
    return np.array([[a, b], [c, b], [c, d], [a, d]])


def _draw_box(scene: Scene, ax: Axes) -> None:
    """Its sides that lie within the picture."""
    if "box" not in scene:
        return
    (left, right), (bottom, top) = ax.get_xlim(), ax.get_ylim()
    for side in ("lower", "upper"):
        x, y = scene["box"][side][:2]
        if x is not None and left <= x <= right:
            ax.axvline(x, color="#222", linewidth=1, zorder=2)
        if y is not None and bottom <= y <= top:
            ax.axhline(y, color="#222", linewidth=1, zorder=2)


# --- space -------------------------------------------------------------------------------------------------------


def _draw_space(result: Result, scene: Scene, ax: Axes, style: Style) -> None:
    if "surface" in scene:
        vertices = np.array(scene["surface"]["vertices"], dtype=float).reshape(-1, 3)
        triangles = np.array(scene["surface"]["triangles"], dtype=int).reshape(-1, 3)
        _draw_surface(vertices, triangles, ax, {})
        _turn(ax, scene, vertices, result.curve)
        shown = vertices
    elif "points" in scene:
        shown = np.array(scene["points"]["positions"], dtype=float).reshape(-1, 3)
        ax.scatter(*shown.T, s=2, color=_SOLID, depthshade=False, zorder=1)
        _turn(ax, scene, shown, result.curve)
    else:
        shown = result.curve
    for name, color in (("curves", "#6b6b6b"), ("obstacles", "#8a8884"), ("margins", _PALE)):
        for line in _lines(scene, name):
            ax.plot(*line.T, color=color, linewidth=0.8, zorder=2)
            shown = np.vstack([shown, line])
    _draw_paths(result, scene, ax, style, 3)
    _equal(ax, np.vstack([shown, result.curve]))


def _draw_surface(vertices: NDArray[np.float64], triangles: NDArray[Any], ax: Axes, style: Style) -> None:
    vertices, triangles = _coarse(vertices, triangles)
    options: Style = {"color": "#f1efe9", "linewidth": 0, "antialiased": False, "shade": True, "zorder": 1}
    ax.plot_trisurf(*vertices.T, triangles=triangles, **{**options, **style})


def _coarse(vertices: NDArray[np.float64], triangles: NDArray[Any]) -> tuple[NDArray[np.float64], NDArray[Any]]:
    """With at most _MOST_TRIANGLES: vertices of one cell of a grid become their mean."""
    lower = vertices.min(axis=0)
    size = np.linalg.norm(np.ptp(vertices, axis=0))
    cells = 40
    while len(triangles) > _MOST_TRIANGLES:
        keys = ((vertices - lower) * (cells / size)).astype(np.int64) @ [1, 1 << 20, 1 << 40]
        _, cell = np.unique(keys, return_inverse=True)
        count = np.bincount(cell)
        vertices = np.column_stack([np.bincount(cell, weights=x) / count for x in vertices.T])
        corners = cell[triangles]
        a, b, c = corners.T
        triangles = np.unique(corners[(a != b) & (b != c) & (c != a)], axis=0)
        cells = cells * 4 // 5
    return vertices, triangles


def _turn(ax: Axes, scene: Scene, vertices: NDArray[np.float64], curve: NDArray[np.float64]) -> None:
    """The up of the scene upwards, and the side on which the path lies in front."""
    up = int(np.argmax(np.abs(scene["up"])))
    way = np.roll(curve.mean(axis=0) - vertices.mean(axis=0), 2 - up) if len(curve) else np.zeros(3)
    x, y, z = way
    flat = float(np.hypot(x, y))
    turned = flat > 1e-3 * float(np.linalg.norm(np.ptp(vertices, axis=0)))
    azimuth = float(np.degrees(np.arctan2(y, x))) if turned else -60.0
    elevation = float(np.clip(np.degrees(np.arctan2(z, flat)), 15, 45))
    ax.view_init(elev=elevation, azim=azimuth, vertical_axis="xyz"[up])


def _equal(ax: Axes, points: NDArray[np.float64]) -> None:
    """One unit is as long on all three axes."""
    lower, upper = np.nanmin(points, axis=0), np.nanmax(points, axis=0)
    room = 0.02 * max(upper - lower)
    ax.set_xlim(lower[0] - room, upper[0] + room)
    ax.set_ylim(lower[1] - room, upper[1] + room)
    ax.set_zlim(lower[2] - room, upper[2] + room)
    ax.set_box_aspect(upper - lower + 2 * room)


# --- both --------------------------------------------------------------------------------------------------------


def _draw_paths(result: Result, scene: Scene, ax: Axes, style: Style, axes: int) -> None:
    """First path, others of the family, the path with its points and ends; `axes`: coordinates that are drawn."""
    if len(result.curve) == 0:
        return
    first = _line(scene, scene["lines"]["first"])
    ax.plot(*first.T[:axes], **_FIRST)
    for other in scene["lines"]["others"]:
        ax.plot(*_line(scene, other).T[:axes], **_OTHER)
    (line,) = ax.plot(*result.curve.T[:axes], **{**_PATH, **style})
    points = result.points
    if points.shape[1] == result.curve.shape[1]:  # else they are coordinates of a chart
        if len(points) <= _MOST_POINTS:
            ax.plot(*points.T[:axes], ".", color=line.get_color(), markersize=4, zorder=7)
    if not result.details["ring"]:
        ax.plot(*result.curve[[0, -1]].T[:axes], "o", color="#222", markersize=4, zorder=8)


def _draw_poses(strip: Scene, ax: Axes, style: Style) -> None:
    """An arm or a body on its way, from pale to dark, and the path of its hand."""
    for flat in strip["obstacles"]:
        _fill([np.reshape(flat, (-1, 2))], ax, _SOLID, 1.0)
    for i, pose in enumerate(strip["poses"]):
        share = i / max(1, len(strip["poses"]) - 1)
        for part in pose:
            x, y = np.reshape(part, (-1, 2)).T
            ax.plot(x, y, color="#222", alpha=0.2 + 0.8 * share, linewidth=1.2, zorder=3)
    if strip.get("hand"):
        ax.plot(*np.reshape(strip["hand"], (-1, 2)).T, **{**_PATH, **style})
    ax.set_aspect("equal")


def _draw_coordinates(result: Result, ax: Axes, style: Style) -> None:
    share = np.linspace(0, 1, len(result.points))
    for i, values in enumerate(result.points.T):
        ax.plot(share, values, **{"label": f"coordinate {i}", **style})
    ax.set_xlabel("share of the cost")
    ax.legend()


def _line(scene: Scene, flat: list[float | None]) -> NDArray[np.float64]:
    """(m, d) of a flat list, whose gaps become NaN."""
    return np.array(flat, dtype=float).reshape(-1, scene["dimension"])


def _lines(scene: Scene, name: str) -> list[NDArray[np.float64]]:
    return [_line(scene, flat) for flat in scene.get(name, [])]
