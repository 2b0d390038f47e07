# SPDX-FileCopyrightText: 2026 The leastcost authors
# SPDX-License-Identifier: MIT
"""Arguments that mean nothing are refused in words, and nothing ends the process."""

import pickle
import subprocess
import sys

import numpy as np
import pytest

import leastcost as lc

STRAIGHT = {
    "manifold": lc.Plane(),
    "cost": "euclidean",
    "ends": {"source": {"point": [0, 0]}, "target": {"point": [3, -2]}},
}
V = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0.5]])
F = [[0, 1, 2], [0, 2, 3]]


def length(a, b):
    return ((b - a) ** 2).sum(0)


def itself() -> dict:
    tree: dict = {}
    tree["name"] = tree
    return tree


@pytest.mark.parametrize("derivatives", ["complex", "differences"])
def test_a_cost_that_is_not_squared(derivatives):
    with pytest.raises(lc.InputError, match="returns costs, not their squares"):
        lc.find_path(lc.Plane(), lambda a, b: length(a, b) ** 0.5, (0, 0), (1, 2), derivatives=derivatives)


def test_masked_costs_are_infinite():
    def masked(a, b):
        return np.ma.masked_array(length(a, b), np.ones(a.shape[1], bool))

    with pytest.raises(lc.NoPathError, match="infinite"):
        lc.find_path(lc.Plane(), masked, (0, 0), (3, -2))


@pytest.mark.parametrize("seconds", [float("inf"), 1e300, -1, 0, float("nan"), "3"])
def test_time_budgets(seconds):
    with pytest.raises(lc.InputError, match="max_seconds is"):
        lc.run(STRAIGHT, max_seconds=seconds)


def test_a_domain_in_a_dict():
    assert lc.run(STRAIGHT).cost == pytest.approx(13**0.5)


@pytest.mark.parametrize(
    "config, error, words",
    [
        ({**STRAIGHT, "manifold": lc.Plane}, TypeError, r"config\['manifold'\] is the class Plane; write Plane\(...\)"),
        (itself(), lc.ConfigError, "lies below more than 50 others"),
        ({**STRAIGHT, "name": "\ud800"}, lc.ConfigError, r"config\['name'\]: .* is not a text in Unicode"),
    ],
)
def test_configurations(config, error, words):
    with pytest.raises(error, match=words):
        lc.run(config)


@pytest.mark.parametrize("options", [{5: 1}, "path.points=3", [1]])
def test_what_set_is_not(options):
    with pytest.raises(TypeError, match="set must be a dict of options"):
        lc.run(STRAIGHT, set=options)


@pytest.mark.parametrize(
    "ask, words",
    [
        (lambda: lc.Mesh(V, F).geodesic(10**30, 0), r"below 2\*\*31"),
        (lambda: lc.Mesh(V, F).geodesic((10**20, (1, 0, 0)), 0), r"below 2\*\*31"),
        (lambda: lc.Mesh(V, F).distances(0, max_distance=np.nan), "max_distance is nan"),
        (lambda: lc.Mesh(V, [[0, 1], [0, 1, 2]]), "F has rows of different lengths"),
        (lambda: lc.Mesh([[0, 0], [0, 1, 2]], F), "V has rows of different lengths"),
        (lambda: lc.Mesh(np.ma.masked_array(V, V > 0.9), F), "finite"),
        (lambda: lc.solve_pairs(STRAIGHT, [((0, 0), (1, 1))], threads=200_000), "threads is 200000"),
        (lambda: lc.run_study({}, "nowhere", parallel=0), "parallel is 0"),
    ],
)
def test_arguments(ask, words):
    with pytest.raises(lc.InputError, match=words):
        ask()


def test_a_notebook_shows_a_result_that_was_pickled():
    copy = pickle.loads(pickle.dumps(lc.run(STRAIGHT)))
    assert "3.605551275" in copy._repr_html_() and "no trajectory any more" in copy._repr_html_()


@pytest.mark.parametrize("cost", ["'euclidean'", "lambda a, b: ((b - a) ** 2).sum(0) * (1 + a[0] ** 2 + b[0] ** 2)"])
def test_the_interpreter_may_end_while_a_daemon_thread_searches(cost):
    """Such a thread cannot come back into Python: the process was aborted."""
    script = f"""
import threading, time
import leastcost as lc

def search():
    while True:
        lc.find_path(lc.Plane(), {cost}, (0, 0), (3, -2), points=2000, max_seconds=5)

threading.Thread(target=search, daemon=True).start()
time.sleep(0.2)
"""
    assert subprocess.run([sys.executable, "-c", script], timeout=60).returncode == 0


FIRST_TO_THIRD = {"source": {"vertex": 0}, "target": {"vertex": 2}}


@pytest.mark.parametrize("size", [1e-77, 1e-170, 1e-300, 1e77, 1e160])
def test_data_whose_squares_vanish_or_overflow(size, tmp_path):
    """They were answered with the length 0, with a path without a proof, or ended the process."""
    corners, grid = size * np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]), np.ones((8, 8))
    points = size * np.random.default_rng(0).uniform(size=(500, 3)) * [1, 1, 0]
    near, far = (2 * size, 2 * size), (5 * size, 6 * size)
    file = tmp_path / "square.off"
    file.write_text("OFF 4 2 0\n" + "".join(f"{x} {y} {z}\n" for x, y, z in corners) + "3 0 1 2\n3 0 2 3\n")
    calls = [
        lambda: lc.Mesh(corners, [[0, 1, 2], [0, 2, 3]]),
        lambda: lc.run({"manifold": {"type": "mesh", "file": file}, "cost": "euclidean", "ends": FIRST_TO_THIRD}),
        lambda: lc.Cloud(points),
        lambda: lc.Terrain(size * grid, cell=size),
        lambda: lc.find_path(lc.Plane(), lc.CostMap(grid, cell=size), near, far),
        lambda: lc.find_path(lc.Plane(), lc.CostMap(grid, cell=size, interpolation="smooth"), near, far),
        lambda: lc.find_path(lc.Plane(), lc.Wind(grid, grid, speed=9, cell=size), near, far),
        lambda: lc.find_path(lc.Plane(), None, near, far),
        lambda: lc.find_path(lc.Space(5), None, [0] * 5, [size] * 5),
    ]
    for call in calls:
        with pytest.raises(lc.Error, match=r"(below 1e-75|beyond 1e75|finite)"):
            call()
