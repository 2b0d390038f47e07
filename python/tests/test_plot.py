# SPDX-FileCopyrightText: 2026 The leastcost authors
# SPDX-License-Identifier: MIT
"""Pictures: what is drawn on each kind of domain."""

import sys

import leastcost as lc
import numpy as np
import pytest

matplotlib = pytest.importorskip("matplotlib")
matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402
from matplotlib.patches import PathPatch  # noqa: E402

CHUTE = {
    "manifold": {"type": "euclidean", "dimension": 2},
    "cost": {"type": "travel_time", "gravity": 1},
    "ends": {"source": {"point": [0, 0]}, "target": {"point": [np.pi, -2]}},
    "path": {"points": 40},
}


@pytest.fixture(autouse=True)
def closed():
    yield
    pyplot.close("all")


def drawn(axes):
    """It can be rendered, too."""
    axes.get_figure().canvas.draw()
    return axes


def has_line(axes, points):
    lines = [line.get_data_3d() if axes.name == "3d" else line.get_data() for line in axes.get_lines()]
    return any(np.array_equal(np.transpose(line), points) for line in lines)


def test_a_path_in_the_plane():
    result = lc.run(CHUTE)
    axes = drawn(result.plot(color="black"))
    assert axes.name == "rectilinear" and has_line(axes, result.curve) and has_line(axes, result.points)
    assert any(line.get_color() == "black" for line in axes.get_lines())
    assert len(axes.get_images()) == 1 and axes.get_figure().axes[1].get_ylabel() == "cost per unit of length"


def test_own_axes():
    _, (left, right) = pyplot.subplots(1, 2)
    assert lc.run(CHUTE).plot(right) is right and not left.get_lines()


def test_obstacles_are_filled(configs):
    result = lc.run(configs / "plan_taut.yaml")
    patches = [p for p in drawn(result.plot()).patches if isinstance(p, PathPatch)]
    assert len(patches) == 8  # four obstacles, each with its margin
    inside = [p.get_path().contains_point((9, 4.4)) for p in patches]
    assert sum(inside) == 2  # the disc and its margin


def test_what_is_free_is_not_filled(configs):
    """Rooms of an occupancy map: the area outside them is filled, with the rooms as holes."""
    result = lc.run(configs / "map_rooms.yaml")
    axes = drawn(result.plot())
    blocked = axes.patches[0]
    pixels = np.asarray(axes.get_figure().canvas.buffer_rgba())[::-1]
    color = np.round(255 * np.array(blocked.get_facecolor()[:3]))
    for point in result.points[2:-2:7]:
        x, y = np.round(axes.transData.transform(point)).astype(int)
        assert not (pixels[y - 1 : y + 2, x - 1 : x + 2, :3] == color).all()
    assert (pixels[..., :3] == color).all(axis=-1).any()


@pytest.mark.parametrize("name", ["cost_map", "terrain"])
def test_maps_are_images(configs, name):
    result = lc.run(configs / f"{name}.yaml")
    axes = drawn(result.plot())
    assert axes.name == "rectilinear" and has_line(axes, result.curve[:, :2])
    (image,) = axes.get_images()
    assert np.ptp(image.get_array()) > 0
    left, right, bottom, top = image.get_extent()
    assert left < result.curve[:, 0].min() < result.curve[:, 0].max() < right and bottom < top


@pytest.mark.parametrize("name", ["torus_parametric", "fig3_rrt_sphere", "cloud_torus", "implicit_torus"])
def test_surfaces_are_in_space(configs, name):
    result = lc.run(configs / f"{name}.yaml")
    axes = drawn(result.plot())
    assert axes.name == "3d" and has_line(axes, result.curve)
    (surface,) = axes.collections
    path = max(line.get_zorder() for line in axes.get_lines())
    assert path > surface.get_zorder() and not axes.computed_zorder


def test_a_robot_has_poses(configs):
    result = lc.run(configs / "arm_among_balls.yaml")
    assert len(drawn(result.plot()).get_lines()) > 3


def test_seven_dimensions_have_a_line_each(configs):
    axes = drawn(lc.run(configs / "seven_dimensions_euclidean.yaml").plot())
    assert len(axes.get_lines()) == 7


def test_the_wrong_kind_of_axes_is_refused(configs):
    with pytest.raises(ValueError, match='its axes need projection="3d"'):
        lc.run(configs / "torus_parametric.yaml").plot(pyplot.figure().add_subplot())
    with pytest.raises(ValueError, match="have no projection"):
        lc.run(CHUTE).plot(pyplot.figure().add_subplot(projection="3d"))


def test_without_matplotlib_an_error_says_what_to_install(monkeypatch):
    result = lc.run(CHUTE)
    monkeypatch.setitem(sys.modules, "matplotlib.pyplot", None)
    with pytest.raises(ImportError, match="python3-matplotlib"):
        result.plot()


def test_a_geodesic_on_its_mesh(configs):
    mesh = lc.Mesh.read(configs / "data/hill.obj")
    geodesic = mesh.geodesic(0, 80)
    axes = drawn(geodesic.plot(mesh.plot(), color="red"))
    assert has_line(axes, geodesic.points)
    assert drawn(geodesic.plot()).get_xlim()[1] - geodesic.points[:, 0].max() < 0.1


def test_large_meshes_are_coarsened():
    from leastcost._plot import _coarse

    side = 200
    x, y = np.meshgrid(np.linspace(0, 1, side), np.linspace(0, 1, side))
    V = np.column_stack([x.ravel(), y.ravel(), np.sin(5 * x).ravel()])
    corner = np.arange(side * (side - 1)).reshape(side - 1, side)[:, :-1].ravel()
    F = np.vstack(
        [
            np.column_stack([corner, corner + 1, corner + side]),
            np.column_stack([corner + 1, corner + side + 1, corner + side]),
        ]
    )
    vertices, triangles = _coarse(V, F)
    assert 1000 < len(triangles) <= 6000 and triangles.max() < len(vertices)
    assert np.allclose(np.ptp(vertices[triangles.ravel()], axis=0), np.ptp(V, axis=0), atol=0.1)
