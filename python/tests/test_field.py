# SPDX-FileCopyrightText: 2026 The leastcost authors
# SPDX-License-Identifier: MIT
"""Fields: the least cost from a place to everywhere."""

import pickle

import leastcost as lc
import numpy as np
import pytest

BOX = lc.manifold.euclidean(lower=[0, 0], upper=[4, 2])


def test_distances_in_a_box():
    field = lc.field(BOX, (1, 1), resolution=0.1)
    x, y = field.axes
    assert field.values.shape == (21, 41) == (len(y), len(x)) and y[0] > y[-1]
    assert field.nodes.shape == (21, 41, 2) and field.faces is None
    assert np.allclose(field.values, np.hypot(field.nodes[..., 0] - 1, field.nodes[..., 1] - 1), atol=1e-4)
    assert 0 < field.error < 1e-3 and field.mean_error <= field.error
    assert field.method == "isotropic march" and field.unit == "length" and not field.directed
    assert "21 x 41" in repr(field)


def test_several_places_and_a_way_back():
    field = lc.field(BOX, [(0, 0), (4, 2)], resolution=0.1)
    assert field.values[-1, 0] == 0 and field.values[0, -1] == 0
    way = field.way((3, 1))
    assert way.cost == pytest.approx(np.sqrt(2), rel=1e-6)
    assert np.array_equal(way.points[0], [4, 2]) and np.array_equal(way.points[-1], [3, 1])


def test_around_an_obstacle():
    """Two tangents and an arc; nothing inside."""
    disc = lc.obstacle.ball(center=[2, 1], radius=0.5)
    field = lc.field(BOX, (1, 1), obstacles=[disc], resolution=0.05)
    x, y = field.axes
    assert np.isnan(field.values[np.argmin(abs(y - 1)), np.argmin(abs(x - 2))])
    exact = 2 * np.sqrt(0.75) + 0.5 * (np.pi - 2 * np.arccos(0.5))
    way = field.way((3, 1))
    assert exact <= way.cost <= 1.005 * exact
    with pytest.raises(lc.InputError, match=r"to=\(2, 1\): .*inside the ball"):
        field.way((2, 1))


def test_a_corridor():
    field = lc.field(BOX, (1, 1), to=(3, 1), corridor=True, resolution=0.1)
    assert np.nanmin(field.values) == 0
    x, y = field.nodes[..., 0], field.nodes[..., 1]
    assert np.allclose(field.values, np.hypot(x - 1, y - 1) + np.hypot(x - 3, y - 1) - 2, atol=1e-4)
    other = lc.field(BOX, (1, 1), resolution=0.1).corridor((3, 1))
    assert np.array_equal(other.values, field.values)
    for what in (lambda: field.way((3, 1)), field.corridor):
        with pytest.raises(lc.InputError, match="corridor"):
            what()


def test_a_map_of_costs():
    costs = np.full((12, 16), 3.0)
    costs[:, 9] = np.nan
    field = lc.field(lc.Plane(), (3, 5), cost=lc.CostMap(costs, cell=2))
    assert field.values.shape == costs.shape
    assert field.values[-3, 1] == pytest.approx(0, abs=1e-6)
    assert field.values[-3, 7] == pytest.approx(36, abs=1e-6)
    assert np.isnan(field.values[:, 9:]).all() and field.unit == "cost"
    with pytest.raises(lc.InputError, match="no path leads to the place"):
        field.way((25, 5))


def test_a_terrain_is_walked_up_and_down():
    y = 20 - np.arange(20) - 0.5
    hill = lc.Terrain(np.repeat(y[:, None], 20, axis=1) * 0.3)
    up = lc.field(hill, (10, 3), cost=lc.cost.walking())
    down = lc.field(hill, (10, 3), cost=lc.cost.walking(), to_here=True)
    assert up.directed and up.values[0, 10] > 1.2 * down.values[0, 10]


def test_a_function_of_python():
    def twice(a, b):
        return 4 * ((b - a) ** 2).sum(0)

    field = lc.field(BOX, (1, 1), cost=twice, resolution=0.25)
    assert field.values[0, -1] == pytest.approx(2 * np.sqrt(10), rel=0.05)

    def fails(a, b):
        raise ZeroDivisionError("mine")

    with pytest.raises(ZeroDivisionError, match="mine"):
        lc.field(BOX, (1, 1), cost=fails, resolution=0.25)


def test_a_configuration(configs):
    field = lc.field(configs / "cost_map.yaml")
    assert field.values.shape == (30, 40)
    assert field.way((1, 1)).cost > 0
    assert np.nanmin(field.corridor().values) == 0
    elsewhere = lc.field(configs / "cost_map.yaml", (10, 10), resolution=2)
    assert elsewhere.values.size < 400
    block = {"manifold": BOX, "cost": "euclidean", "ends": {"source": {"point": [1, 1]}, "target": {"point": [3, 1]}}}
    assert lc.field(block, resolution=0.5).values[0, 0] == pytest.approx(np.sqrt(2), rel=1e-4)
    aside = lc.field(block, to=(1, 2), corridor=True, resolution=0.5)
    assert aside.values[0, 2] == pytest.approx(0, abs=1e-9)


def test_a_mesh_has_exact_distances(configs):
    mesh = lc.Mesh.read(configs / "data/hill.obj")
    field = lc.field(mesh, [0, 80])
    assert np.allclose(field.values, mesh.distances([0, 80]), rtol=1e-12)
    assert field.axes is None and np.array_equal(field.nodes, mesh.V) and np.array_equal(field.faces, mesh.F)
    assert field.method == "exact windows" and field.error < 1e-9
    way = field.way(40)
    assert way.cost == pytest.approx(min(mesh.geodesic(v, 40).length for v in (0, 80)), rel=1e-12)
    assert way.points.shape[1] == 3
    corridor = lc.field(mesh, 0, to=80, corridor=True)
    assert np.allclose(corridor.values, mesh.distances(0) + mesh.distances(80) - mesh.geodesic(0, 80).length, atol=1e-9)
    near = lc.field(mesh, mesh.V[12] + [0, 0, 1e-3])
    assert np.argmin(near.values) == 12


def test_files(tmp_path, configs):
    field = lc.field(BOX, (1, 1), resolution=0.5)
    assert field.save(tmp_path / "f.npy") == tmp_path / "f.npy"
    assert np.array_equal(np.load(tmp_path / "f.npy"), field.values)
    field.save(str(tmp_path / "f.CSV"))
    assert np.loadtxt(tmp_path / "f.CSV", delimiter=",", skiprows=1).shape == (45, 3)
    on_mesh = lc.field(lc.Mesh.read(configs / "data/hill.obj"), 0)
    on_mesh.save(tmp_path / "f.ply")
    on_mesh.save(tmp_path / "v.npy")
    assert np.array_equal(np.load(tmp_path / "v.npy"), on_mesh.values)
    with pytest.raises(lc.InputError, match=r"on a mesh as \.csv, \.npy, \.vtp or \.ply"):
        field.save(tmp_path / "f.txt")
    with pytest.raises(lc.InputError, match="over a lattice"):
        field.save(tmp_path / "f.ply")
    with pytest.raises(lc.OutputError, match="cannot write"):
        field.save(tmp_path / "none" / "f.csv")


@pytest.mark.parametrize(
    "make, message",
    [
        (lambda: lc.field(lc.Plane(), (1, 1)), "has no box"),
        (lambda: lc.field(BOX), "source is missing"),
        (lambda: lc.field(BOX, []), "source has no places"),
        (lambda: lc.field(BOX, (9, 9)), "must have x between 0 and 4"),
        (lambda: lc.field(BOX, (np.nan, 1)), "finite numbers"),
        (lambda: lc.field(lc.Plane(), (1, 1, 1), to=(2, 2)), r"it is a point \(x, y\)"),
        (lambda: lc.field(BOX, (1, 1), resolution=-1), "resolution"),
        (lambda: lc.field(lc.Space(3), (1, 1, 1), to=(2, 2, 2)), "two coordinates|point"),
    ],
)
def test_refused_in_words(make, message):
    with pytest.raises(lc.Error, match=message):
        make()


def test_refused_on_a_mesh_and_of_a_configuration(configs):
    mesh = lc.Mesh.read(configs / "data/hill.obj")
    with pytest.raises(lc.Error, match="on a mesh the nodes are its vertices"):
        lc.field(mesh, 0, resolution=1)
    with pytest.raises(lc.Error, match="three coordinates"):
        lc.field(mesh, (0.5, 0.5))
    with pytest.raises(lc.InputError, match="has its own cost"):
        lc.field(configs / "cost_map.yaml", cost="euclidean")


def test_pictures(configs):
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    from matplotlib import pyplot

    disc = lc.obstacle.ball(center=[2, 1], radius=0.5)
    axes = lc.field(BOX, (1, 1), obstacles=[disc], resolution=0.1).plot()
    axes.get_figure().canvas.draw()
    assert len(axes.get_images()) == 1 and axes.get_figure().axes[1].get_ylabel() == "cost (length)"
    solid = lc.field(lc.Mesh.read(configs / "data/hill.obj"), 0).plot()
    solid.get_figure().canvas.draw()
    assert solid.name == "3d"
    pyplot.close("all")


def test_a_pickled_field_keeps_its_numbers():
    field = lc.field(BOX, (1, 1), resolution=0.5)
    copy = pickle.loads(pickle.dumps(field))
    assert np.array_equal(copy.values, field.values)
    assert all(np.array_equal(a, b) for a, b in zip(copy.axes, field.axes))
    assert np.array_equal(copy.nodes, field.nodes)
    assert copy.faces is None
    for name in ("error", "mean_error", "method", "unit", "directed"):
        assert getattr(copy, name) == getattr(field, name)
    assert repr(copy) == repr(field)
    assert np.array_equal(pickle.loads(pickle.dumps(copy)).values, field.values)
    with pytest.raises(lc.InputError, match="pickled has no way any more"):
        copy.way((3, 1))
    with pytest.raises(lc.InputError, match="pickled has no corridor any more"):
        copy.corridor((3, 1))
    with pytest.raises(lc.OutputError, match="pickled has no files any more"):
        copy.save("f.npy")
    detour = field.corridor((3, 1))
    assert "corridor" in repr(pickle.loads(pickle.dumps(detour)))


def test_a_pickled_field_of_a_mesh_keeps_it(configs):
    field = lc.field(lc.Mesh.read(configs / "data/hill.obj"), 0)
    copy = pickle.loads(pickle.dumps(field))
    assert np.array_equal(copy.values, field.values)
    assert np.array_equal(copy.nodes, field.nodes)
    assert np.array_equal(copy.faces, field.faces)
    assert copy.axes is None and copy.error == field.error


def test_a_configuration_without_ends():
    config = {"manifold": {"type": "euclidean", "lower": [0, 0], "upper": [4, 2]}, "cost": "euclidean"}
    with_ends = {**config, "ends": {"source": {"point": [1, 1]}, "target": {"point": [3, 1]}}}
    field = lc.field(config, (1, 1), resolution=0.5)
    assert np.array_equal(field.values, lc.field(with_ends, resolution=0.5).values)
    there = lc.field(config, (1, 1), to=(3, 1), corridor=True, resolution=0.5)
    assert np.array_equal(there.values, lc.field(with_ends, corridor=True, resolution=0.5).values)
    with pytest.raises(lc.InputError, match="nothing says where it is from"):
        lc.field(config)
    with pytest.raises(lc.InputError, match="nothing says where it leads"):
        field.corridor()


def test_geotiff(tmp_path):
    field = lc.field(BOX, (1, 1), resolution=0.5)
    try:
        file = field.save(tmp_path / "f.tif")
    except lc.InputError as e:
        assert "GDAL" in str(e)
        pytest.skip("this build is without GDAL")
    assert file.read_bytes()[:2] in (b"II", b"MM")


def test_a_field_in_space(tmp_path):
    cube = {"type": "euclidean", "dimension": 3, "lower": [0, 0, 0], "upper": [2, 1, 1]}
    ball = lc.obstacle.ball(center=[1, 0.5, 0.5], radius=0.2)
    field = lc.field(cube, (0.5, 0.5, 0.5), obstacles=[ball], resolution=0.1)
    assert field.values.shape == (21, 11, 11) and [len(axis) for axis in field.axes] == [21, 11, 11]
    apart = np.linalg.norm(field.nodes - [0.5, 0.5, 0.5], axis=-1)
    reached = np.isfinite(field.values)
    assert not reached[10, 5, 5] and (field.values[reached] >= apart[reached] - 3e-3).all()
    assert field.values[5, 9, 2] == pytest.approx(0.5, abs=0.005) and field.error > 0
    assert field.way((1.5, 0.5, 0.5)).cost == pytest.approx(1.08, abs=0.01)
    assert np.nanmin(field.corridor((1.5, 0.5, 0.5)).values) == 0
    field.save(tmp_path / "f.npy")
    assert np.array_equal(np.load(tmp_path / "f.npy"), field.values, equal_nan=True)
    with pytest.raises(lc.InputError, match="save it as .vti"):
        field.plot()


def test_a_fault_is_said_of_the_place_that_has_it():
    with pytest.raises(lc.InputError, match=r"^source\[1\]=\(2,\) must have 2 coordinates \(x, y; found 1\)"):
        lc.field(BOX, [(1, 1), (2,)])
    with pytest.raises(lc.InputError, match=r"^source\[1\]=.* must have y between 0 and 2 \(found 9\)"):
        lc.field(BOX, [(1, 1), (2, 9), (3, 1)])


def test_a_space_has_as_many_dimensions_as_its_box():
    room = lc.manifold.euclidean(lower=[0, 0, 0], upper=[1, 1, 1])
    field = lc.field(room, (0, 0, 0), resolution=0.25)
    assert field.values.shape == (5, 5, 5)
    assert field.values[-1, -1, -1] == pytest.approx(np.sqrt(3), rel=1e-3)
