# SPDX-FileCopyrightText: 2026 The leastcost authors
# SPDX-License-Identifier: MIT
"""find_path on domains and costs that are arrays."""

import pickle

import leastcost as lc
import numpy as np
import pytest


def sphere_points(n: int) -> np.ndarray:
    """Nearly evenly spread over the unit sphere."""
    i = np.arange(n) + 0.5
    z, angle = 1 - 2 * i / n, np.pi * (1 + 5**0.5) * i
    return np.column_stack([np.cos(angle) * np.sqrt(1 - z**2), np.sin(angle) * np.sqrt(1 - z**2), z])


def middles(rows: int, columns: int, cell: float = 1.0):
    """x and y of the middles of the cells; row 0 has the largest y."""
    return np.meshgrid(cell * (np.arange(columns) + 0.5), cell * (rows - np.arange(rows) - 0.5))


def read_raster(tmp_path, values, cell=1.0):
    """The same as a file."""
    file = tmp_path / "raster.asc"
    rows, columns = values.shape
    head = f"ncols {columns}\nnrows {rows}\nxllcorner 0\nyllcorner 0\ncellsize {cell}\n"
    file.write_text(head + "\n".join(" ".join(repr(float(v)) for v in row) for row in values) + "\n")
    return file


def test_a_mesh(configs):
    mesh = lc.Mesh.read(configs / "data/hill.obj")
    corner = mesh.F[7]
    for source, target in [(0, 80), ((7, (0.2, 0.3, 0.5)), 3), (mesh.V[corner[0]], mesh.V[3] + [0, 0, 1e-3])]:
        result = lc.find_path(mesh, "euclidean", source, target)
        assert result.certified and result.scope == "global_on_polyhedron"
        assert result.cost == pytest.approx(mesh.geodesic(source, target).length, rel=1e-9)


def test_a_function_on_a_mesh(configs):
    mesh = lc.Mesh.read(configs / "data/hill.obj")

    def uphill(a, b):
        """Height costs."""
        return ((b - a) ** 2).sum(0) * (1 + ((a[2] + b[2]) / 2) ** 2)

    result = lc.find_path(mesh, uphill, 0, 80, points=40)
    assert np.isfinite(result.cost) and result.cost > mesh.geodesic(0, 80).length


def test_a_cloud():
    cloud = lc.Cloud(sphere_points(4000))
    a, b = np.array([1, 0, 0]), np.array([0, 0.8, 0.6])
    result = lc.find_path(cloud, "euclidean", a, b)
    assert result.certified and result.cost == pytest.approx(np.pi / 2, rel=1e-4)
    between = lc.find_path(cloud, "euclidean", 10, 2000)
    points = sphere_points(4000)
    assert between.cost == pytest.approx(np.arccos(points[10] @ points[2000]), rel=1e-3)
    assert repr(cloud) == "<leastcost.Cloud: 4000 points>"


def test_equal_points_of_a_cloud_count_once():
    points = sphere_points(1000)
    cloud = lc.Cloud(np.vstack([points[:1], points]))
    result = lc.find_path(cloud, "euclidean", 0, 501)  # rows of the array
    assert np.allclose(result.points[-1], points[500], atol=1e-3)
    assert any("duplicates" in note for note in result.notes)


@pytest.mark.parametrize(
    "points, options, message",
    [
        (np.zeros((5, 2)), {}, r"points has the shape \(5, 2\); points must have the shape \(n, 3\)"),
        (np.array(["a"]), {}, "points has the type <U1; it must have real numbers"),
        ([[0, 0, 0], [1, 2]], {}, "rows of different lengths|type object"),
        ([[0, 0, np.inf]], {}, r"points\[0, 2\] is inf"),
        (sphere_points(5), {}, "points"),
        (sphere_points(100), {"normals": np.zeros((100, 3))}, "normal of point 0 has the length 0"),
        (sphere_points(100), {"normals": np.zeros((9, 3))}, r"normals have the shape \(9, 3\), and points"),
        (sphere_points(100), {"neighbours": 1000}, "from 4 to 100, not 1000"),
    ],
)
def test_clouds_are_refused_in_words(points, options, message):
    with pytest.raises(lc.InputError, match=message):
        lc.Cloud(points, **options)


def test_a_terrain_equals_that_of_a_file(tmp_path):
    x, y = middles(20, 30, 10.0)
    heights = 0.02 * (x - 60) * np.sin(y / 40)
    file = read_raster(tmp_path, heights, 10.0)
    of_file = lc.find_path({"type": "terrain", "file": file}, "euclidean", (20, 20), (270, 170))
    terrain = lc.Terrain(heights, cell=10)
    own = lc.find_path(terrain, "euclidean", (20, 20), (270, 170))
    assert own.certified and own.cost == of_file.cost
    copy = pickle.loads(pickle.dumps(terrain))
    assert lc.find_path(copy, "euclidean", (20, 20), (270, 170)).cost == own.cost


def test_row_0_is_in_the_north():
    x, y = middles(8, 8)
    terrain = lc.Terrain(10.0 * (y > 4), origin=(100, 200))
    result = lc.find_path(terrain, "euclidean", (101, 207), (107, 207))
    assert result.curve[:, 2] == pytest.approx(10, abs=1)
    south = lc.find_path(terrain, "euclidean", (101, 201), (107, 201))
    assert south.curve[:, 2] == pytest.approx(0, abs=1)


def test_places_without_data():
    x, y = middles(30, 30)
    lake = np.hypot(x - 15, y - 15) < 4
    for heights in (np.where(lake, np.nan, 0.0), np.ma.masked_array(np.zeros_like(x), lake)):
        result = lc.find_path(lc.Terrain(heights), "euclidean", (3, 15), (27, 15.5), points=40)
        assert result.cost > 25
        assert np.hypot(*(result.curve[:, :2] - 15).T).min() > 4


def test_a_cost_map_equals_that_of_a_file(tmp_path):
    x, y = middles(16, 24)
    costs = 1 + np.exp(-((x - 12) ** 2 + (y - 8) ** 2) / 8)
    file = read_raster(tmp_path, costs)
    for interpolation in ("smooth", "cells"):
        block = {"type": "cost_map", "file": file, "interpolation": interpolation}
        of_file = lc.find_path(lc.Plane(), block, (2, 8), (22, 8.5))
        cost_map = lc.CostMap(costs, interpolation=interpolation)
        own = lc.find_path(lc.Plane(), cost_map, (2, 8), (22, 8.5))
        assert own.cost == of_file.cost and own.scope == of_file.scope
        assert lc.find_path(lc.Plane(), pickle.loads(pickle.dumps(cost_map)), (2, 8), (22, 8.5)).cost == own.cost


def test_a_cost_map_over_a_terrain():
    x, y = middles(16, 24)
    terrain, costs = lc.Terrain(np.zeros_like(x)), lc.CostMap(np.full_like(x, 3))
    assert lc.find_path(terrain, costs, (2, 8), (22, 8)).cost == pytest.approx(60, rel=1e-9)


def test_a_wind_from_arrays():
    """With a wind of 0.5 to the east: 10 / 1.5 with it, 10 / 0.5 against it."""
    x, y = middles(20, 20)
    wind = lc.Wind(np.full_like(x, 0.5), np.zeros_like(x), speed=1)
    there = lc.find_path(lc.Plane(), wind, (5, 10), (15, 10))
    back = lc.find_path(lc.Plane(), wind, (15, 10), (5, 10))
    assert there.cost == pytest.approx(10 / 1.5, rel=1e-9) and there.unit == "s"
    assert back.cost == pytest.approx(10 / 0.5, rel=1e-9)


def test_north_of_a_wind():
    """A jet in the north, row 0: the way there goes over it."""
    x, y = middles(20, 30)
    jet = np.zeros_like(x)
    jet[:8] = 0.6
    wind = lc.Wind(jet, np.zeros_like(x), speed=1, unit="h")
    result = lc.find_path(lc.Plane(), wind, (2, 9), (27, 9))
    assert result.points[:, 1].max() > 10 and result.cost < 25 and result.unit == "h"
    copy = pickle.loads(pickle.dumps(wind))
    assert lc.find_path(lc.Plane(), copy, (2, 9), (27, 9)).cost == result.cost


@pytest.mark.parametrize(
    "make, message",
    [
        (lambda: lc.Terrain(np.zeros(5)), r"heights has the shape \(5,\); a raster must have the shape \(rows, columns\)"),
        (lambda: lc.Terrain(np.zeros((3, 3))), "heights: 3 x 3 cells; at least 4 x 4 are needed"),
        (lambda: lc.Terrain(np.zeros((5, 5)), cell=0), "cell is .*above 0"),
        (lambda: lc.Terrain(np.zeros((5, 5)), cell=(1, 2, 3)), r"cell has the shape \(3,\)"),
        (lambda: lc.Terrain(np.zeros((5, 5)), origin=3), r"origin has the shape \(\)"),
        (lambda: lc.Terrain(np.zeros((5, 5), dtype=bool)), "heights has the type bool"),
        (lambda: lc.CostMap(np.zeros((5, 5))), r"costs\[0, 0\] is 0.0; costs must be above 0"),
        (lambda: lc.CostMap(np.ones((5, 5)), interpolation="linear"), '"auto", "cells" or "smooth", not'),
        (lambda: lc.Wind(np.zeros((5, 5)), np.zeros((5, 4)), speed=1), r"u has the shape \(5, 5\), and v \(5, 4\)"),
        (lambda: lc.Wind(np.zeros((2, 5)), np.zeros((2, 5)), speed=1), "3 x 3 velocities"),
    ],
)
def test_rasters_are_refused_in_words(make, message):
    with pytest.raises(lc.InputError, match=message):
        make()


def test_a_speed_that_is_none():
    still = np.zeros((5, 5))
    with pytest.raises(lc.Error, match="greater than 0"):
        lc.find_path(lc.Plane(), lc.Wind(still, still, speed=-1), (1, 1), (4, 4))


def test_costs_of_the_plane_are_refused_elsewhere():
    still, ones = np.zeros((5, 5)), np.ones((5, 5))
    with pytest.raises(lc.InputError, match="in the plane, but these points have 3 coordinates"):
        lc.find_path(lc.Terrain(still), lc.Wind(still, still, speed=1), (1, 1), (4, 4))
    with pytest.raises(lc.InputError, match="cost_map"):
        lc.find_path(lc.Space(4), lc.CostMap(ones), (1, 1, 1, 1), (4, 4, 4, 4))
    with pytest.raises(lc.Error, match="the points of this manifold fill space"):
        lc.find_path(lc.Space(3), lc.CostMap(ones), (1, 1, 1), (4, 4, 4))
    with pytest.raises(lc.Error, match="cells"):
        lc.find_path(lc.Terrain(still), lc.CostMap(ones, interpolation="cells"), (1, 1), (4, 4))


def test_around_obstacles():
    """Around a disc: two tangents and an arc."""
    disc = {"type": "ball", "center": [0, 0], "radius": 1}
    result = lc.find_path(lc.Plane(), "euclidean", (-2, 0), (2, 0), obstacles=[disc])
    assert result.certified
    assert result.cost == pytest.approx(2 * np.sqrt(3) + np.pi / 3, rel=1e-5)
    wider = lc.find_path(lc.Plane(), "euclidean", (-2, 0), (2, 0), obstacles=[disc], clearance=0.5)
    tangent = np.sqrt(4 - 1.5**2)
    assert wider.cost == pytest.approx(2 * tangent + 1.5 * (np.pi - 2 * np.arccos(1.5 / 2)), rel=1e-5)


def test_a_first_path_of_points():
    below = lc.find_path(
        lc.Plane(),
        "euclidean",
        (-2, 0),
        (2, 0.1),
        obstacles=[{"type": "ball", "center": [0, 0], "radius": 1}],
        initializer=[[0, -1.5]],
    )
    assert below.points[:, 1].min() < -0.9


def test_other_options():
    result = lc.find_path(lc.Plane(), "euclidean", (0, 0), (3, 4), set={"path.points": 8, "solver": "lbfgs"})
    assert result.cost == pytest.approx(5) and len(result.points) == 10


def test_obstacles_that_a_mesh_cannot_have_are_one_error(configs):
    mesh = lc.Mesh.read(configs / "data/hill.obj")
    with pytest.raises(lc.ConfigError, match="obstacles need a flat or a smooth domain") as raised:
        lc.find_path(mesh, None, 0, 80, obstacles=[lc.obstacle.ball(center=[0, 0, 0], radius=0.2)])
    assert "1 error in config" in str(raised.value) and "step" not in str(raised.value)
