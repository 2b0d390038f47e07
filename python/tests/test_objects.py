# SPDX-FileCopyrightText: 2026 The leastcost authors
# SPDX-License-Identifier: MIT
"""Objects of Python in configurations."""

import gc
import weakref
from pathlib import Path

import leastcost as lc
import numpy as np
import pytest

PI = [np.pi, -2]
CHUTE = """
manifold: {type: euclidean, dimension: 2}
cost: {type: external, name: chute}
ends: {source: {point: [0, 0]}, target: {point: [3.141592653589793, -2]}}
path: {points: 40}
"""


def chute(a, b):
    """Squared time of a bead on a straight chute, from rest at height 0, gravity 1."""
    return 2 * ((b - a) ** 2).sum(0) / (np.sqrt(-a[1]) + np.sqrt(-b[1])) ** 2


def fall(**options):
    return {
        "manifold": {"type": "euclidean", "dimension": 2},
        "cost": {"type": "travel_time", "gravity": 1},
        "ends": {"source": {"point": [0, 0]}, "target": {"point": PI}},
        "path": {"points": 40},
        **options,
    }


@pytest.fixture
def hill(configs):
    return lc.Mesh.read(configs / "data/hill.obj")


def over_the_hill(**options):
    return {"cost": "euclidean", "ends": {"source": {"vertex": 0}, "target": {"vertex": 80}}, **options}


def test_a_cost_that_a_text_names():
    own = lc.run(CHUTE, chute=lc.Cost(chute, unit="s", additive=True))
    assert own.certified and own.unit == "s"
    assert own.cost == pytest.approx(lc.run(fall()).cost, rel=1e-11)


def test_a_cost_in_a_dict_and_in_a_file(tmp_path):
    named = lc.run(CHUTE, chute=chute)
    assert lc.run(fall(cost=chute)).cost == named.cost
    file = tmp_path / "fall.yaml"
    file.write_text(CHUTE)
    assert lc.run(file, chute=chute, set={"path.points": 20}).details["points"] == 20


def test_a_mesh_has_the_recipe_of_a_mesh(configs, hill):
    """The same defaults, and the same proof, as of the file."""
    of_file = lc.run(over_the_hill(manifold={"type": "mesh", "file": configs / "data/hill.obj"}))
    of_mesh = lc.run(over_the_hill(manifold=hill))
    assert of_mesh.certified and of_mesh.scope == of_file.scope == "global_on_polyhedron"
    assert of_mesh.cost == of_file.cost
    assert lc.run(over_the_hill(manifold={"type": "external", "name": "hill"}), hill=hill).cost == of_file.cost


def test_a_function_on_a_mesh(hill):
    """Three times the length: the shortest path again."""
    own = lc.run(over_the_hill(manifold=hill, cost=lambda a, b: 9 * ((b - a) ** 2).sum(0)))
    length = hill.geodesic(0, 80).length
    assert 3 * length * (1 - 1e-9) <= own.cost <= 3 * length * 1.01


def test_points_are_a_first_path():
    through = np.array([[1.0, -1.5], [2.0, -2.5]])
    result = lc.run(fall(initializer=through))
    assert result.certified and result.cost == pytest.approx(np.pi, abs=1e-5)
    named = lc.run(fall(initializer={"type": "external", "name": "start"}), start=through)
    assert named.cost == result.cost
    assert lc.run(fall(initializer=through.tolist())).cost == result.cost


def test_numbers_and_paths_of_a_dict(configs, tmp_path):
    result = lc.run(
        {
            "manifold": {"type": "euclidean", "dimension": np.int32(2)},
            "cost": {"type": "travel_time", "gravity": np.float32(1)},
            "ends": {"source": {"point": (np.float64(0), 0)}, "target": {"point": np.array(PI)}},
            "path": {"points": np.uint8(40), "cascade": np.bool_(False)},
            "certificate": {"refine": np.array(1)},
        }
    )
    assert result.cost == lc.run(fall(certificate={"refine": 1})).cost
    lc.validate(over_the_hill(manifold={"type": "mesh", "file": Path("data/hill.obj")}), folder=configs)


def test_set_in_a_dict():
    assert lc.run(fall(), set={"path.points": 20}).details["points"] == 20
    assert lc.run(fall(), set={"ends.target.point": np.array([1.0, -1.0])}).points[-1].tolist() == [1, -1]
    assert lc.run(fall(solver="newton"), set={"solver.tolerance": 1e-8}).certified
    config = fall()
    lc.run(config, set={"path.points": 20})
    assert config == fall()  # not changed


def test_errors_of_a_dict_have_places():
    with pytest.raises(lc.ConfigError, match="did you mean 'tolerance'") as caught:
        lc.validate(fall(solver={"type": "newton", "tolerence": 1e-9}))
    assert "config['solver']['tolerence']" in str(caught.value)
    assert [d["where"] for d in caught.value.diagnostics] == ["config['solver']['tolerence']"]


@pytest.mark.parametrize(
    "options, message",
    [
        ({"cost": {"type": "travel_time", "gravity": 1j}}, r"config\['cost'\]\['gravity'\]: .*not complex"),
        ({"path": {3: 4}}, r"config\['path'\]: keys are texts, not 3"),
        ({"ends": {"source": {"point": [0, {1, 2}]}}}, r"config\['ends'\]\['source'\]\['point'\]\[1\]: .*not set"),
    ],
)
def test_what_no_configuration_holds(options, message):
    with pytest.raises(TypeError, match=message):
        lc.run(fall(**options))


def test_too_large_a_number():
    with pytest.raises(lc.ConfigError, match=r"config\['seed'\]: 9223372036854775808 is too large"):
        lc.run(fall(seed=2**63))


def test_objects_are_refused_in_words(hill):
    with pytest.raises(TypeError, match="chute cannot be a .*: give a Mesh"):
        lc.run(CHUTE, chute=3)
    with pytest.raises(lc.ConfigError, match="chute"):
        lc.run(CHUTE)
    with pytest.raises(lc.ConfigError, match="cost"):
        lc.run(CHUTE, chute=hill)
    with pytest.raises(lc.InputError, match=r"start has the shape \(2,\); points must have the shape \(n, d\)"):
        lc.run(fall(initializer={"type": "external", "name": "start"}), start=np.zeros(2))


def test_validate_sees_objects(hill):
    lc.validate(CHUTE, chute=chute)
    lc.validate(over_the_hill(manifold=hill))
    with pytest.raises(lc.ConfigError):
        lc.validate(over_the_hill(manifold=hill, path={"pointz": 3}))


def test_the_dimension_of_a_cost(configs):
    """On every kind of domain a function gets points of the space in which it lies."""
    seen = []

    def q(a, b):
        seen.append(a.shape[0])
        return ((b - a) ** 2).sum(0)

    sphere = {
        "manifold": {"type": "parametric", "surface": "sphere"},
        "ends": {"source": {"point": [0.1, 0.2]}, "target": {"point": [1, 0.5]}},
        "path": {"points": 10},
    }
    assert lc.run({**sphere, "cost": q}).cost > 0
    assert set(seen) == {3}
    with pytest.raises(lc.Error):
        lc.run({**sphere, "cost": lc.Cost(q, dimension=2)})


def test_results_of_objects_are_written(tmp_path, hill):
    folder = lc.run(over_the_hill(manifold=hill)).write(tmp_path / "hill")
    assert "external" in (folder / "config.resolved.yaml").read_text()


def test_a_result_that_its_cost_keeps_is_garbage_without_them():
    """The cycle goes through the libraries, where the collector sees it only if the result says so."""

    class Uphill:
        def __call__(self, a, b):
            return ((b - a) ** 2).sum(0) * (1 + a[0] ** 2 + b[0] ** 2)

    uphill = Uphill()
    uphill.results = [lc.find_path(lc.Plane(), uphill, (0, 0), (1, 1), points=n) for n in (8, 9)]
    gone, kept = weakref.ref(uphill), uphill.results[0]
    del uphill
    gc.collect()
    assert gone() is not None  # a result is still there
    assert kept.cost > 0 and len(kept.points) == 10
    del kept
    gc.collect()
    assert gone() is None
