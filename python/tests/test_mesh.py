# SPDX-FileCopyrightText: 2026 The leastcost authors
# SPDX-License-Identifier: MIT
import pickle
from concurrent.futures import ThreadPoolExecutor

import leastcost as lc
import numpy as np
import pytest

# A cube from -1 to 1; vertex 8 belongs to no face.
CUBE_V = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)] + [[9, 9, 9]], dtype=float)
CUBE_F = np.array([[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]])


@pytest.fixture(scope="module")
def cube():
    return lc.Mesh(CUBE_V, CUBE_F)


def test_over_two_faces_of_a_cube(cube):
    geodesic = cube.geodesic(0, 7)
    assert geodesic.proved and geodesic.length == pytest.approx(np.sqrt(20), rel=1e-12)
    assert geodesic.lower_bound <= geodesic.length * (1 + 1e-12)
    assert geodesic.points.shape == (3, 3) or len(geodesic.points) > 3
    assert geodesic.points[0].tolist() == [-1, -1, -1] and geodesic.points[-1].tolist() == [1, 1, 1]
    steps = np.linalg.norm(np.diff(geodesic.points, axis=0), axis=1)
    assert steps.sum() == pytest.approx(geodesic.length, rel=1e-12)
    assert len(geodesic.faces) == len(steps)


def test_between_points(cube):
    geodesic = cube.geodesic((0, 0, 1), [0, 0, -1.0])
    assert geodesic.length == pytest.approx(4, rel=1e-12)
    assert cube.geodesic(np.array([0, 0, 3]), 7).points[0].tolist() == [0, 0, 1]  # the nearest one of the surface


def test_places_on_faces(configs):
    mesh = lc.Mesh.read(configs / "data/hill.obj")
    corners = mesh.V[mesh.F[7]]
    weights = np.array([0.2, 0.3, 0.5])
    on_face = mesh.geodesic((7, weights), (3, (1, 0, 0)))
    assert np.allclose(on_face.points[0], weights @ corners, atol=1e-12)
    assert on_face.length == pytest.approx(mesh.geodesic(weights @ corners, int(mesh.F[3][0])).length, rel=1e-9)
    distances = mesh.distances((7, (0.2, 0.3, 0.5)))
    assert distances[mesh.F[7][0]] == pytest.approx(np.linalg.norm(weights @ corners - corners[0]), rel=1e-9)
    assert np.array_equal(mesh.distances([(7, weights)]), distances)
    assert mesh.distances([7, (0.2, 0.3, 0.5)])[7] == 0  # a list: a vertex and a point
    with pytest.raises(lc.InputError, match="sum 1, not 0.9"):
        mesh.geodesic((7, (0.2, 0.3, 0.4)), 0)


def test_faces_are_numbered_as_given():
    """A square and a triangle; the square is cut in two."""
    V = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [2, 0, 0]], dtype=float)
    mesh = lc.Mesh(V[[0, 1, 2, 3, 4, 4]], [[0, 1, 2, 3], [1, 4, 5, 2]])
    assert set(mesh.geodesic(0, 4).faces.tolist()) <= {0, 1}
    triangles = lc.Mesh(V, [[0, 1, 2], [0, 2, 3], [1, 4, 2]])
    assert triangles.geodesic((2, (0, 1, 0)), 0).length == pytest.approx(2, rel=1e-12)


def test_distances_in_the_order_of_v(cube):
    distances = cube.distances(0)
    assert distances.shape == (9,)
    expected = [0, 2, 2, np.sqrt(8), 2, np.sqrt(8), np.sqrt(8), np.sqrt(20), np.inf]
    assert np.allclose(distances, expected, rtol=1e-12)
    lower, upper = cube.distances(0, bounds=True)
    assert (lower <= distances).all() and (distances <= upper).all() and np.allclose(lower, upper, rtol=1e-9)


def test_distances_from_several_places(cube):
    assert cube.distances([0, 7])[:8].max() == pytest.approx(2)
    assert np.allclose(cube.distances([[0, 0, 1.0]])[[1, 3, 5, 7]], np.sqrt(2))
    assert np.allclose(cube.distances([0.0, 0, 1]), cube.distances(np.array([[0, 0, 1.0]])))
    assert np.isinf(cube.distances(0, max_distance=2.5)[7])


def test_many_pairs(cube):
    pairs = np.array([[0, 7], [1, 6], [0, 1]])
    lengths = [g.length for g in cube.geodesics(pairs)]
    assert lengths == [cube.geodesic(int(s), int(t)).length for s, t in pairs]


def test_read_numbers_vertices_as_the_file(configs):
    file = configs / "data/hill.obj"
    mesh = lc.Mesh.read(file)
    rows = [line.split()[1:] for line in file.read_text().splitlines() if line.startswith("v ")]
    assert np.array_equal(mesh.V, np.array(rows, dtype=float))
    again = lc.Mesh(mesh.V, mesh.F)
    assert again.geodesic(0, 80).length == mesh.geodesic(0, 80).length
    assert np.array_equal(mesh.F, again.F)


def test_threads_share_a_mesh(configs):
    mesh = lc.Mesh.read(configs / "data/hill.obj")
    alone = [mesh.geodesic(0, t).length for t in range(1, 81)]
    with ThreadPoolExecutor(4) as pool:
        assert list(pool.map(lambda t: mesh.geodesic(0, t).length, range(1, 81))) == alone


def test_pickle(cube, configs):
    copy = pickle.loads(pickle.dumps(cube))
    assert copy.geodesic(0, 7).length == cube.geodesic(0, 7).length
    assert np.array_equal(copy.V, cube.V) and np.array_equal(copy.F, cube.F) and copy.notes == cube.notes
    with pytest.raises(lc.InputError, match="polygon"):  # faces are still those of F
        copy.geodesic((0, (1, 0, 0)), 3)
    geodesic = pickle.loads(pickle.dumps(cube.geodesic(0, 7)))
    assert geodesic.proved and geodesic.length == pytest.approx(np.sqrt(20), rel=1e-12)


def test_pickle_keeps_what_was_welded():
    V = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]], dtype=float)
    welded = lc.Mesh(V, [[0, 1, 2], [3, 5, 4]], weld=True)
    assert pickle.loads(pickle.dumps(welded)).geodesic(0, 5).length == welded.geodesic(0, 5).length > 1


@pytest.mark.parametrize(
    "V, F, message",
    [
        (CUBE_V[:, :2], CUBE_F, r"V has the shape \(9, 2\)"),
        (CUBE_V[0], CUBE_F, r"V has the shape \(3,\)"),
        (CUBE_V + 1j, CUBE_F, "V has the type complex128"),
        (CUBE_V, CUBE_F.astype(float), "F has the type float64; faces must be whole numbers"),
        (CUBE_V, CUBE_F[:, :2], r"F has the shape \(6, 2\)"),
        (CUBE_V, CUBE_F + 3, r"F\[1, 1\] is 9; V has the rows 0 to 8"),
        (CUBE_V, -CUBE_F, r"F\[0, 1\] is -1"),
        (CUBE_V * np.nan, CUBE_F, "finite"),
        (CUBE_V, np.zeros((0, 3), dtype=int), "face"),
    ],
)
def test_arrays_are_refused_in_words(V, F, message):
    with pytest.raises(lc.InputError, match=message):
        lc.Mesh(V, F)


@pytest.mark.parametrize(
    "place, message",
    [
        (9, "no vertex 9: vertices are numbered from 0 to 8"),
        (-1, "no vertex -1"),
        (8, "vertex 8 belongs to no face"),
        ((0, 0), "number of a vertex"),
        ("a", "number of a vertex"),
        ((0, 0, np.nan), "finite"),
        (True, "number of a vertex"),
        ((2.0, (1, 0, 0)), "the number of a face is a whole number, a row of F, not 2.0"),
        ((2, (1, 0)), "barycentric coordinates are three real numbers"),
        ((0, (1, 0, 0)), "polygon"),
        ((6, (1, 0, 0)), "faces 0 to 5, not 6"),
        ((-1, (1, 0, 0)), "faces 0 to 5, not -1"),
        ([[0, 1], [2]], "the number of a face is a whole number"),
        ([[0, 1], 2], "number of a vertex"),
    ],
)
def test_places_are_refused_in_words(cube, place, message):
    with pytest.raises(lc.InputError, match=message):
        cube.geodesic(0, place)


def test_two_components_have_no_path():
    V = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0]], dtype=float)
    two = lc.Mesh(np.vstack([V, V + 5]), [[0, 1, 2], [3, 4, 5]])
    with pytest.raises(lc.NoPathError, match="from vertex 0 to vertex 3"):
        two.geodesic(0, 3)
    assert np.isinf(two.distances(0)[3:]).all()


def test_a_missing_file_is_named(tmp_path):
    with pytest.raises(lc.InputError, match="none.obj"):
        lc.Mesh.read(tmp_path / "none.obj")


def test_a_place_far_off_the_mesh_is_told_by_a_note(cube):
    result = lc.find_path(cube, cost="euclidean", source=CUBE_V[0] + [-3, 0, 0], target=CUBE_V[6])
    assert any("the source is 3 from the domain" in note for note in result.notes)
    near = lc.find_path(cube, cost="euclidean", source=CUBE_V[0], target=CUBE_V[6])
    assert not any("from the domain" in note for note in near.notes)
