# SPDX-FileCopyrightText: 2026 The leastcost authors
# SPDX-License-Identifier: MIT
"""Many pairs of ends, and studies."""

import os
import signal
import subprocess
import threading

import numpy as np
import pytest

import leastcost as lc

PLANE = {"manifold": {"type": "euclidean", "dimension": 2}, "cost": "euclidean"}
ENDS = {"source": {"point": [0, 0]}, "target": {"point": [1, 0]}}
STUDY = """name: two
problems:
  - name: line
    config:
      manifold: {type: euclidean, dimension: 2}
      cost: {type: metric_tensor, matrix: [[2, 0], [0, 1]]}
      ends: {source: {point: [0, 0]}, target: {point: [3, 4]}}
solvers: [newton, lbfgs]
points: [10, 20]
"""


def test_pairs_are_solved_in_their_order(configs):
    mesh = lc.Mesh.read(configs / "data/hill.obj")
    pairs = [(0, 80), (3, (12, (0.2, 0.3, 0.5))), (mesh.V[5], 40)]
    config = {"manifold": mesh, "cost": "euclidean", "ends": {"source": {"vertex": 0}, "target": {"vertex": 1}}}
    results = lc.solve_pairs(config, pairs, threads=2)
    for pair, result in zip(pairs, results):
        assert result.certified and not result.message and result.scope == "global_on_polyhedron"
        assert result.cost == pytest.approx(mesh.geodesic(*pair).length, rel=1e-9)
        assert result.lower_bound <= result.cost and result.points.shape[1] == 3
    alone = lc.run({**config, "ends": {"source": {"vertex": 0}, "target": {"vertex": 80}}})
    assert results[0].cost == alone.cost
    assert not lc.solve_pairs(config, pairs[:1], points=False)[0].points.size


def test_a_pair_without_a_path_is_a_result():
    wrong, right = lc.solve_pairs({**PLANE, "ends": ENDS}, [((0, 0), (1, 2, 3)), ((0, 0), (3, 4))])
    assert wrong.outcome == "bad_pair" and wrong.message and np.isnan(wrong.cost)
    assert right.certified and right.cost == pytest.approx(5)


def test_pairs_of_a_file(tmp_path):
    (tmp_path / "pairs.csv").write_text("source_x,source_y,target_x,target_y\n0,0,3,4\n0,0,6,8\n")
    config = {**PLANE, "ends": {"pairs": str(tmp_path / "pairs.csv")}}
    assert [r.cost for r in lc.solve_pairs(config)] == pytest.approx([5, 10])


def test_pairs_of_a_cost_in_python():
    twice = lc.Cost(lambda a, b: 4 * ((b - a) ** 2).sum(0), additive=True)
    config = {**PLANE, "cost": twice, "ends": ENDS}
    costs = [r.cost for r in lc.solve_pairs(config, [((0, 0), (3, 4)), ((0, 0), (0, 1))], threads=2)]
    assert costs == pytest.approx([10, 2])


def test_pairs_that_are_none_are_refused():
    config = {**PLANE, "ends": ENDS}
    with pytest.raises(lc.InputError, match=r"pairs\[1\] is \(source, target\)"):
        lc.solve_pairs(config, [((0, 0), (1, 1)), (0, 1, 2)])
    with pytest.raises(lc.InputError, match=r"pairs\[0\]\[1\] is a vertex"):
        lc.solve_pairs(config, [((0, 0), (1, np.nan))])
    with pytest.raises(lc.InputError, match="threads is 0; it must be a whole number from 1 to 1024"):
        lc.solve_pairs(config, [], threads=0)


def test_pairs_stop_at_once():
    many = [((0, 0), (3, 4 + i / 1e5)) for i in range(100_000)]
    threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT)).start()
    with pytest.raises(KeyboardInterrupt):
        lc.solve_pairs({**PLANE, "ends": ENDS}, many)


def test_a_study_is_that_of_the_program(tmp_path, program):
    study = lc.run_study(STUDY, tmp_path / "ours", parallel=2)
    (tmp_path / "two.yaml").write_text(STUDY)
    subprocess.run([program, "study", tmp_path / "two.yaml", "-o", tmp_path / "theirs", "-q"], check=True)
    theirs = lc.run_study(tmp_path / "two.yaml", tmp_path / "theirs", resume=True)
    key = ("problem", "solver", "points", "outcome", "cost")
    assert len(study.rows) == 4
    assert sorted([r[k] for k in key] for r in study.rows) == sorted([r[k] for k in key] for r in theirs.rows)
    assert {r["outcome"] for r in study.rows} == {"ok"}
    assert study.summary.keys() == theirs.summary.keys()
    assert "<html" in study.write_report().read_text()
    assert "4 runs" in repr(study)


def test_a_study_as_a_dict_and_its_errors(tmp_path):
    tree = {
        "problems": [{"name": "line", "config": {**PLANE, "ends": ENDS}}],
        "solvers": ["newton"],
        "points": np.array([10]),
    }
    assert len(lc.run_study(tree, tmp_path / "one").rows) == 1
    with pytest.raises(lc.OutputError):
        lc.run_study(tree, tmp_path / "one")
    assert len(lc.run_study(tree, tmp_path / "one", replace=True, set={"points": [10, 20]}).rows) == 2
    with pytest.raises(lc.ConfigError, match="did you mean 'solvers'"):
        lc.run_study({**tree, "solver": ["newton"]}, tmp_path / "no")
    wrong = {"name": "other", "config": {**PLANE, "ends": {**ENDS, "target": {"pont": [1, 1]}}}}
    with pytest.raises(lc.ConfigError) as raised:
        lc.run_study({**tree, "problems": [*tree["problems"], wrong]}, tmp_path / "no")
    assert "study['problems'][1]['config']['ends']['target']['pont']: error: " in str(raised.value)
    assert str(raised.value).endswith(" in study") and "study:" not in str(raised.value)
    assert all(d["where"].startswith("study['problems'][1]") for d in raised.value.diagnostics)
    with pytest.raises(lc.ConfigError, match=r"^set: repetitions=0: error: 'repetitions' must be at least 1"):
        lc.run_study(tree, tmp_path / "no", set={"repetitions": 0})


def test_a_study_of_objects_from_memory(tmp_path):
    calls = []

    def falling(a, b):
        calls.append(len(a))
        return ((b - a) ** 2).sum(0) * (1 + (a[1] + b[1]) ** 2)

    ends = {"source": {"point": [0, 0]}, "target": {"point": [3, 0]}}
    plane = {"manifold": {"type": "euclidean", "dimension": 2}, "ends": ends, "initializer": "straight"}
    space = {
        "manifold": {"type": "external", "name": "hill"},
        "ends": {"source": {"vertex": 0}, "target": {"vertex": 2}},
        "cost": "euclidean",
    }
    hill = lc.Mesh([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)], [(0, 1, 2), (0, 2, 3)])
    study = {
        "problems": [
            {"name": "own", "config": {**plane, "cost": {"type": "external", "name": "falling"}}},
            {"name": "mesh", "config": space},
        ],
        "points": [8, 12],
    }
    rows = lc.run_study(study, tmp_path / "a", falling=falling, hill=hill).rows
    assert [row["outcome"] for row in rows] == ["ok"] * 4 and all(row["status"] == "certified" for row in rows)
    alone = lc.run({**plane, "cost": falling, "path": {"points": 8}})
    assert rows[0]["cost"] == pytest.approx(alone.cost, rel=1e-9)
    assert rows[2]["cost"] == pytest.approx(2**0.5, rel=1e-9)
    with pytest.raises(lc.ConfigError, match="falling") as raised:
        lc.run_study(study, tmp_path / "b", hill=hill)
    assert "study['problems'][0]['config']['cost']" in str(raised.value)
    with pytest.raises(lc.ConfigError, match="fallin"):
        lc.run_study(study, tmp_path / "b", falling=falling, hill=hill, set={"set.cost.name": "fallin"})
    with pytest.raises(TypeError, match="falling cannot be a str"):
        lc.run_study(study, tmp_path / "b", falling="q", hill=hill)


def test_a_function_of_a_study_gets_points_of_its_problems(tmp_path):
    def length(a, b):
        assert len(a) == 3
        return ((b - a) ** 2).sum(0)

    study = {
        "problems": [
            {
                "name": "space",
                "config": {
                    "manifold": {"type": "euclidean", "dimension": 3},
                    "cost": {"type": "external", "name": "length"},
                    "ends": {"source": {"point": [0, 0, 0]}, "target": {"point": [1, 2, 2]}},
                },
            }
        ],
        "points": [8],
    }
    rows = lc.run_study(study, tmp_path / "a", length=length).rows
    assert [row["outcome"] for row in rows] == ["ok"] and rows[0]["cost"] == pytest.approx(3)
