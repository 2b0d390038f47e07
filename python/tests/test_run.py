# SPDX-FileCopyrightText: 2026 The leastcost authors
# SPDX-License-Identifier: MIT
import json
import pickle
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import leastcost as lc
import numpy as np
import pytest

CHUTE = """
manifold: {type: euclidean, dimension: 2}
cost: {type: travel_time, gravity: 1}
ends: {source: {point: [0, 0]}, target: {point: [3.141592653589793, -2]}}
path: {points: 40}
"""


def test_brachistochrone_takes_pi(configs):
    result = lc.run(configs / "brachistochrone.yaml")
    assert result.status == "certified" and result.certified and result.failures == []
    assert result.scope == "local"
    assert abs(result.cost - np.pi) < 3 * result.error < 1e-6
    assert result.points.shape[1] == 2 and result.points.dtype == np.float64
    assert result.curve.shape[1] == 2
    assert result.certificate == result.details["certificate"]


@pytest.mark.parametrize("name", ["brachistochrone", "snell", "plan_taut", "bunny_geodesic"])
def test_same_result_as_the_program(configs, program, tmp_path, name):
    """Every number but the times, to the last bit."""
    run = [program, "run", f"configs/{name}.yaml", "-o", tmp_path / "out"]
    subprocess.run(run, cwd=configs.parent, capture_output=True, check=False)
    theirs = json.loads((tmp_path / "out/result.json").read_text())
    ours = lc.run(configs / f"{name}.yaml").details
    for key in ("cost", "scope", "status", "failures", "points", "spacing", "notes"):
        assert ours[key] == theirs[key], key


def test_a_text_and_a_dict_are_configurations_too():
    of_text = lc.run(CHUTE)
    of_dict = lc.run(
        {
            "manifold": {"type": "euclidean", "dimension": 2},
            "cost": {"type": "travel_time", "gravity": np.int64(1)},
            "ends": {"source": {"point": np.zeros(2)}, "target": {"point": np.array([np.pi, -2])}},
            "path": {"points": 40},
        }
    )
    assert of_text.cost == of_dict.cost


def test_set_replaces_options():
    assert lc.run(CHUTE, set={"path.points": 20}).details["points"] == 20
    assert lc.run(CHUTE, set={"ends.target.point": np.array([1.0, -1.0])}).points[-1].tolist() == [1, -1]


def test_files_are_relative_to_the_folder(configs):
    text = (
        "manifold: {type: mesh, file: data/hill.obj}\ncost: euclidean\n"
        "ends: {source: {vertex: 0}, target: {vertex: 80}}\n"
    )
    assert lc.run(text, folder=configs).certified
    with pytest.raises(lc.InputError, match="hill.obj"):
        lc.run(text)


def test_written_files_hold_the_same_points(tmp_path):
    result = lc.run(CHUTE)
    folder = result.write(tmp_path / "chute")
    assert json.loads((folder / "result.json").read_text())["cost"]["value"] == result.cost
    with pytest.raises(lc.OutputError):
        result.write(tmp_path / "chute")
    assert result.write(tmp_path / "chute", replace=True) == folder


def test_pickle(tmp_path):
    result = lc.run(CHUTE)
    copy = pickle.loads(pickle.dumps(result))
    assert np.array_equal(copy.points, result.points) and np.array_equal(copy.curve, result.curve)
    assert copy.details == result.details and repr(copy) == repr(result)
    assert pickle.loads(pickle.dumps(copy)).cost == result.cost
    with pytest.raises(lc.OutputError, match="no files, no picture and no trajectory any more"):
        copy.write(tmp_path / "copy")


def test_threads_run_at_once():
    with ThreadPoolExecutor(4) as pool:
        costs = list(pool.map(lambda n: lc.run(CHUTE, set={"path.points": n}).cost, [20, 30, 40, 50] * 3))
    assert costs == [lc.run(CHUTE, set={"path.points": n}).cost for n in [20, 30, 40, 50]] * 3


def test_arrays_outlive_the_result():
    points = lc.run(CHUTE).points
    assert points.flags.owndata or points.base is not None
    assert points[0].tolist() == [0, 0] and len(points) == 42


def test_repr_says_what_is_known():
    assert repr(lc.run(CHUTE)).startswith("<leastcost.Result certified: 3.1415926")


def test_gdal_is_loaded_with_the_first_raster_that_needs_it():
    """It stands on about a hundred shared libraries, which take most of the time of an import."""
    if not Path("/proc/self/maps").exists():
        pytest.skip("the libraries of a process are not listed here")
    ask = "import leastcost; print('libgdal' in open('/proc/self/maps').read())"
    answer = subprocess.run([sys.executable, "-c", ask], capture_output=True, text=True, check=True)
    assert answer.stdout == "False\n"
