# SPDX-FileCopyrightText: 2026 The leastcost authors
# SPDX-License-Identifier: MIT
"""Costs, solvers and first paths that are registered from Python."""

import gc
import os
import signal
import threading
import time
import traceback
import weakref
from pathlib import Path
from typing import Literal

import leastcost as lc
import numpy as np
import pytest

FALL = {
    "manifold": {"type": "euclidean", "dimension": 2},
    "cost": "t_chute",
    "ends": {"source": {"point": [0, 0]}, "target": {"point": [3, -2]}},
    "path": {"points": 12},
    "certificate": {"refine": 0},
}
LINE = {**FALL, "cost": "euclidean", "ends": {"source": {"point": [0, 0]}, "target": {"point": [1, 1]}}}


def chute(a, b, *, gravity=1.0):
    """Time of a bead that slides
    down a chute.

    From rest at height 0."""
    return 2 * ((b - a) ** 2).sum(0) / (np.sqrt(-gravity * a[1]) + np.sqrt(-gravity * b[1])) ** 2


def wave(a, b):
    return ((b - a) ** 2).sum(0) * (1 + a[1] ** 2 + b[1] ** 2)


WAVE = {**FALL, "cost": "t_wave", "ends": {"source": {"point": [-1, 1]}, "target": {"point": [1, 1]}}}


def descent(chain, *, steps=1000, rate=1e-3):
    """Gradient steps of the length of Barzilai and Borwein."""
    points = chain.points
    _, gradient = chain.value_and_gradient(points)
    for _ in range(steps):
        trial = chain.retract(points, -rate * gradient)
        value, slope = chain.value_and_gradient(trial)
        if not np.isfinite(value):
            rate /= 10
            continue
        step, turn = trial - points, slope - gradient
        if not turn.any():
            break
        rate = (step**2).sum() / abs((step * turn).sum())
        points, gradient = trial, slope
    return points


def bow(source, target, *, height: float = 1):
    return [source, (source + target) / 2 + [0, height], target]


@pytest.fixture(autouse=True, scope="module")
def registered():
    """Not when the tests are collected: messages of other tests list what there is."""
    gravity = lc.option("Acceleration.", unit="m/s^2", above=0)
    assert lc.register_cost("t_chute", unit="s", additive=True, options={"gravity": gravity})(chute) is chute
    lc.register_cost("t_wave")(wave)
    lc.register_solver("t_descent")(descent)
    lc.register_initializer("t_bow")(bow)


def test_a_cost_by_its_name():
    built_in = lc.run({**FALL, "cost": {"type": "travel_time", "gravity": 1}})
    assert lc.run(FALL).cost == pytest.approx(built_in.cost, rel=1e-10)
    quick = lc.run({**FALL, "cost": {"type": "t_chute", "gravity": 4}})
    assert quick.cost == pytest.approx(built_in.cost / 2, rel=1e-10) and quick.unit == "s" and quick.certified
    text = "manifold: {type: euclidean, dimension: 2}\ncost: {type: t_chute, gravity: 4}\npath: {points: 12}\n"
    ends = "ends: {source: {point: [0, 0]}, target: {point: [3, -2]}}\ncertificate: {refine: 0}\n"
    assert lc.run(text + ends).cost == quick.cost
    assert lc.run(text + ends, set={"cost.gravity": 1}).cost == lc.run(FALL).cost
    assert lc.find_path(lc.Plane(), "t_chute", (0, 0), (3, -2), points=12).unit == "s"
    assert chute(np.zeros((2, 1)), np.array([[0], [-1.0]])) == [2]  # the function is as it was


@pytest.mark.parametrize(
    "cost, message",
    [
        ({"type": "t_chute", "gravty": 1}, "did you mean 'gravity'"),
        ({"type": "t_chute", "gravity": 0}, "gravity"),
        ({"type": "t_chute", "gravity": "much"}, "gravity"),
        ("t_shute", "did you mean 't_chute'"),
    ],
)
def test_its_options_are_checked(cost, message):
    with pytest.raises(lc.ConfigError, match=message):
        lc.validate({**FALL, "cost": cost})


def test_describe_and_schema_have_it():
    text = lc.describe("cost", "t_chute")
    assert "Time of a bead that slides down a chute." in text and "From rest" not in text
    assert "gravity  number, greater than 0 [m/s^2]" in text and "default 1" in text
    assert "t_descent" in lc.describe("solver") and "steps  whole number" in lc.describe("solver", "t_descent")
    assert "travel_time" in lc.describe("costs") and "manifold" in lc.describe() and "solvers" in lc.describe("study")
    assert "t_bow" in str(lc.schema()["definitions"]["initializer"])
    with pytest.raises(lc.InputError, match=r"there is no cost 't_shute' \(did you mean 't_chute'\?\); there are: "):
        lc.describe("cost", "t_shute")
    with pytest.raises(lc.InputError, match="there is no kind 'costt'"):
        lc.describe("costt")


def test_options_of_every_type(tmp_path):
    seen = {}

    @lc.register_cost("t_all")
    def make(
        *,
        yes=True,
        rule: Literal["chute", "midpoint"] = "midpoint",
        count=3,
        size: float = 2,
        word="a",
        file: Path = Path("weights.txt"),
        row=(1.0, 2.0),
        rows=((1.0, 2.0), (3.0, 4.0)),
        words: list[str] = ["b"],  # noqa: B006
        named: dict[str, float] = {"x": 1},  # noqa: B006
        needed: list[float],
    ):
        seen.update(locals())
        return lambda a, b: ((b - a) ** 2).sum(0)

    config = {**LINE, "cost": {"type": "t_all", "needed": [5, 6], "named": {"y": 2}, "rows": [[1, 2, 3], [4, 5, 6]]}}
    (tmp_path / "weights.txt").write_text("1")
    assert lc.run(config, folder=tmp_path).cost == pytest.approx(2**0.5)
    assert (seen["yes"], seen["count"], seen["size"], seen["word"]) == (True, 3, 2.0, "a")
    assert seen["rule"] == "midpoint"
    with pytest.raises(lc.ConfigError, match="chute, midpoint"):
        lc.validate({**config, "cost": {"type": "t_all", "needed": [1], "rule": "shute"}})
    assert seen["file"] == tmp_path / "weights.txt" and seen["words"] == ["b"] and seen["named"] == {"y": 2}
    assert seen["row"].tolist() == [1, 2] and seen["needed"].tolist() == [5, 6]
    assert seen["rows"].tolist() == [[1, 2, 3], [4, 5, 6]]
    with pytest.raises(lc.ConfigError, match="needed"):
        lc.validate({**LINE, "cost": "t_all"})


def test_a_factory_makes_other_costs():
    @lc.register_cost("t_hill")
    def hill(*, height=1.0):
        x, y = np.meshgrid(np.arange(8) + 0.5, np.arange(8) + 0.5)
        return lc.CostMap(1 + height * np.exp(-((x - 4) ** 2) - (y - 4) ** 2), interpolation="smooth")

    config = {**LINE, "cost": "t_hill", "ends": {"source": {"point": [1, 4]}, "target": {"point": [7, 4]}}}
    assert lc.run(config).cost > 6

    @lc.register_cost("t_hill")
    def nothing(*, height=1.0):
        return lc.Plane()

    with pytest.raises(lc.InputError, match="the cost 't_hill' made a Plane; it makes a Cost, a CostMap, a Wind or"):
        lc.run(config)


@pytest.mark.parametrize(
    "call, message",
    [
        (lambda: lc.register_cost("euclidean")(chute), "cannot register the cost 'euclidean': there is a cost of this name"),
        (lambda: lc.register_solver("newton")(descent), "there is a solver of this name already"),
        (lambda: lc.register_cost("Chute")(chute), "lower-case letters"),
        (lambda: lc.register_cost("external")(chute), "stands for the objects"),
        (lambda: lc.register_cost("t_bad")(lambda a: a), "the cost 't_bad' takes a and b, or options alone; .* has 1 param"),
        (lambda: lc.register_solver("t_bad")(lambda: 0), "takes a chain"),
        (lambda: lc.register_cost("t_bad")(lambda a, b, *, c: a), "type of the option 'c' is not known; annotate"),
        (lambda: lc.register_cost("t_bad")(lambda a, b, *, c=None: a), "type of the option 'c' is not known"),
        (lambda: lc.register_cost("t_bad")(lambda a, b, *, c=1j: a), "type of the option 'c' is not known"),
        (lambda: lc.register_cost("t_bad")(lambda a, b, *, c=float("nan"): a), "'c', nan, is not of its type"),
        (lambda: lc.register_cost("t_bad")(lambda a, b, *, c=2**40: a), "is not of its type"),
        (lambda: lc.register_cost("t_bad")(lambda a, b, *, type=1: a), "no option can be called 'type'"),
        (lambda: lc.register_cost("t_bad")(lambda a, b, **c: a), "every option is named"),
        (lambda: lc.register_cost("t_bad", options={"d": lc.option("D.")})(lambda a, b, *, c=1: a), "no option 'd'"),
        (
            lambda: lc.register_cost("t_bad", options={"c": lc.option("C.", maximum=0)})(lambda a, b, *, c=1: a),
            "the default of the option 'c', 1, is not in its range",
        ),
        (
            lambda: lc.register_cost("t_bad", options={"c": lc.option("C.", maximum=0)})(lambda a, b, *, c="x": a),
            "no number and has no range",
        ),
        (lambda: lc.option("X.", minimum=2, maximum=1), "range of an option is from 2.0 to 1.0"),
        (lambda: lc.option("X.", minimum=2, above=1), "not both"),
        (lambda: lc.register_cost("t_bad", derivatives="none")(chute), "derivatives must be"),
    ],
)
def test_refused_registrations(call, message):
    with pytest.raises(lc.InputError, match=message):
        call()
    assert "t_bad" not in lc.describe("cost")


def test_what_is_no_function_or_name():
    with pytest.raises(TypeError, match=r'@lc.register_cost\("name"\)'):
        lc.register_cost(chute)(chute)
    with pytest.raises(TypeError, match="the cost 't_bad' is a function, not int"):
        lc.register_cost("t_bad")(3)
    with pytest.raises(TypeError, match=r"write lc.option\(...\)"):
        lc.register_cost("t_bad", options={"gravity": 3})(chute)


def test_registered_again_it_is_the_new_one():
    def define(factor, sentence):
        def q(a, b):
            return factor**2 * ((b - a) ** 2).sum(0)

        q.__doc__ = sentence
        lc.register_cost("t_again")(q)
        return weakref.ref(q)

    first = define(1, "The first.")
    config = {**LINE, "cost": "t_again"}
    kept = lc.run(config)
    second = define(2, "The first.")
    assert lc.run(config).cost == pytest.approx(2 * kept.cost)
    del kept
    gc.collect()
    assert first() is None and second() is not None
    define(3, "Another sentence.")
    gc.collect()
    assert second() is None
    assert "Another sentence." in lc.describe("cost", "t_again") and "The first." not in lc.describe("cost")
    assert lc.run(config).cost == pytest.approx(3 * 2**0.5)


def test_what_a_cost_raises_comes_out():
    @lc.register_cost("t_raises")
    def raises(a, b):
        raise ZeroDivisionError("on purpose")

    with pytest.raises(ZeroDivisionError, match="on purpose") as caught:
        lc.run({**LINE, "cost": "t_raises"})
    assert "in raises" in "".join(traceback.format_exception(None, caught.value, caught.tb))

    @lc.register_cost("t_raises")
    def cannot_be_made(*, size=1):
        raise OSError("no such weights")

    with pytest.raises(OSError, match="no such weights"):
        lc.run({**LINE, "cost": "t_raises"})


@pytest.mark.parametrize(
    "q, message",
    [(lambda a, b: np.ones(3), "the cost returned the shape"), (lambda a, b: -((b - a) ** 2).sum(0), "")],
)
def test_wrong_costs(q, message):
    lc.register_cost("t_wrong")(q)
    with pytest.raises(lc.Error, match=message):
        lc.run({**LINE, "cost": "t_wrong"})


def test_a_solver_by_its_name():
    newton = lc.run(WAVE)
    own = lc.run({**WAVE, "solver": {"type": "t_descent", "steps": 500}})
    assert own.certified and own.cost == pytest.approx(newton.cost, rel=1e-9)
    solver = own.details["solver"]
    assert (solver["name"], solver["termination"]) == ("t_descent", "converged") and solver["iterations"] > 3
    short = lc.run({**WAVE, "solver": {"type": "t_descent", "steps": 2}})
    assert not short.certified and short.details["solver"]["termination"] == "iteration_limit"
    assert "returned with a relative cost error of" in short.details["solver"]["message"]
    with pytest.raises(lc.ConfigError, match="did you mean 'steps'"):
        lc.validate({**FALL, "solver": {"type": "t_descent", "step": 1}})


@pytest.mark.parametrize("manifold", ["sphere", "round"])
def test_a_solver_on_other_domains(manifold):
    """On a surface points go along it; among obstacles they keep out."""
    config = {
        "sphere": {
            "manifold": {"type": "implicit", "surface": {"type": "sphere", "radius": 1}},
            "cost": "euclidean",
            "ends": {"source": {"point": [1, 0, 0]}, "target": {"point": [0, 0.6, 0.8]}},
            "path": {"points": 8},
        },
        "round": {
            **LINE,
            "ends": {"source": {"point": [-2, 0]}, "target": {"point": [2, 0.1]}},
            "obstacles": [{"type": "ball", "center": [0, 0], "radius": 1}],
        },
    }[manifold]
    best, own = lc.run(config), lc.run({**config, "solver": "t_descent"})
    assert own.certified and own.cost == pytest.approx(best.cost, rel=1e-9)


def test_the_best_points_are_taken():
    @lc.register_solver("t_forgets")
    def forgets(chain):
        start = chain.points
        assert chain.free == slice(1, -1) and repr(chain) == "<leastcost.Chain: 14 points>"
        best = descent(chain)
        assert chain.value(best) < chain.value(start)
        assert np.isinf(chain.value(np.full_like(start, np.nan)))
        value, gradient = chain.value_and_gradient(start)
        assert np.all(gradient[[0, -1]] == 0) and gradient.shape == start.shape
        forgets.chain = chain
        return start

    own = lc.run({**WAVE, "solver": "t_forgets"})
    assert own.certified and own.cost == pytest.approx(lc.run(WAVE).cost, rel=1e-9)
    with pytest.raises(lc.InputError, match="the search of this chain is over"):
        forgets.chain.value(forgets.chain.points)


@pytest.mark.parametrize(
    "returned, message",
    [
        (lambda points: None, "the solver 't_returns' returned None; it returns points"),
        (lambda points: points[1:], r"returned points of the shape \(13, 2\); it must be \(14, 2\)"),
        (lambda points: points * np.nan, "returned points that are not finite"),
        (lambda points: "path", "gave str, which is no array of points"),
    ],
)
def test_what_a_solver_must_return(returned, message):
    lc.register_solver("t_returns")(lambda chain: returned(chain.points))
    with pytest.raises(lc.InputError, match=message):
        lc.run({**FALL, "solver": "t_returns"})


def test_what_a_solver_raises_comes_out():
    @lc.register_solver("t_raises")
    def raises(chain):
        chain.value(chain.points[:3])

    with pytest.raises(lc.InputError, match=r"points have the shape \(3, 2\); it must be \(14, 2\)") as caught:
        lc.run({**FALL, "solver": "t_raises"})
    assert "in raises" in "".join(traceback.format_exception(None, caught.value, caught.tb))


def test_what_a_cost_raises_comes_through_a_solver():
    calls = []

    @lc.register_cost("t_raises")
    def raises(a, b):
        calls.append(1)
        if len(calls) == 30:
            raise ZeroDivisionError("on purpose")
        return wave(a, b)

    with pytest.raises(ZeroDivisionError, match="on purpose") as caught:
        lc.run({**WAVE, "cost": "t_raises", "solver": "t_descent"})
    text = "".join(traceback.format_exception(None, caught.value, caught.tb))
    assert "in raises" in text and "in descent" in text and len(calls) == 30


def test_a_solver_on_a_mesh_is_refused(configs):
    mesh = lc.Mesh.read(configs / "data/hill.obj")
    ends = {"source": {"vertex": 0}, "target": {"vertex": 80}}
    result = lc.run({"manifold": mesh, "cost": "euclidean", "ends": ends, "solver": "t_descent", "path": {"points": 9}})
    assert "written in Python" in str(result.details)
    assert [note for note in result.notes if note.startswith("the solver t_descent was not used: ")]


def test_a_solver_that_goes_on_after_the_end_is_told():
    def stubborn(chain):
        points = chain.points
        for _ in range(3):
            try:
                while True:
                    chain.value(points)
            except lc.SearchEnded:
                pass
        return points

    lc.register_solver("t_stubborn")(stubborn)
    with pytest.warns(RuntimeWarning, match="has caught leastcost.SearchEnded and goes on"):
        result = lc.run({**FALL, "solver": "t_stubborn"}, max_seconds=0.2)
    assert result.status == "interrupted"


@pytest.mark.parametrize("name", ["true", "null", "no"])
def test_words_of_yaml_are_no_names(name):
    with pytest.raises(lc.InputError, match="YAML takes this word for a value"):
        lc.register_cost(name)(lambda a, b: ((b - a) ** 2).sum(0))


def test_a_function_without_parameters_that_python_knows():
    with pytest.raises(lc.InputError, match="the cost 'c': Python does not know the parameters of max"):
        lc.register_cost("c")(max)


def endless(chain):
    points = chain.points
    while True:
        value, gradient = chain.value_and_gradient(points)
        points = points - 1e-6 * gradient


def test_a_budget_ends_a_solver():
    lc.register_solver("t_endless")(endless)
    start = time.monotonic()
    result = lc.run({**FALL, "solver": "t_endless"}, max_seconds=0.3)
    assert time.monotonic() - start < 5 and result.status == "interrupted" and len(result.points) == 14


def test_ctrl_c_ends_a_solver():
    """Heard by the chain, or raised within the function."""
    lc.register_solver("t_endless")(endless)
    timer = threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT))
    timer.start()
    start = time.monotonic()
    try:
        assert lc.run({**FALL, "solver": "t_endless"}).status == "interrupted"
    except KeyboardInterrupt:
        pass
    assert time.monotonic() - start < 5


def test_a_first_path_by_its_name():
    ends = {"source": {"point": [-2, 0]}, "target": {"point": [2, 0]}}
    config = {**LINE, "ends": ends, "obstacles": [{"type": "ball", "center": [0, 0], "radius": 1}]}
    over = lc.run({**config, "initializer": {"type": "t_bow", "height": 2}})
    under = lc.run({**config, "initializer": {"type": "t_bow", "height": -2}})
    assert over.points[:, 1].max() > 0.9 and under.points[:, 1].min() < -0.9
    for returned, message in [([], "returned points of the shape"), ([[0, 0]] * 2, "no points between the ends")]:
        lc.register_initializer("t_no_path")(_returning(returned))
        with pytest.raises(lc.InputError, match=message):
            lc.run({**LINE, "initializer": "t_no_path"})


def _returning(points):
    return lambda source, target: points


def test_pairs_in_threads():
    pairs = [((-1, 1), (x, 1)) for x in (0, 0.5, 1, 1.5)]
    config = {**WAVE, "solver": "t_descent"}
    one = lc.solve_pairs(config, pairs)
    assert [pair.outcome for pair in one].count("certified") >= 3
    assert [pair.cost for pair in lc.solve_pairs(config, pairs, threads=3)] == [pair.cost for pair in one]


def test_a_study(tmp_path):
    @lc.register_cost("t_raises")
    def raises(a, b):
        raise ZeroDivisionError("on purpose")

    stop = threading.Event()

    def keep_busy():  # has the GIL at one fork or another
        while not stop.is_set():
            sum(range(1000))

    thread = threading.Thread(target=keep_busy)
    thread.start()
    study = {
        "problems": [{"name": "wave", "config": WAVE}, {"name": "bad", "config": {**WAVE, "cost": "t_raises"}}],
        "solvers": ["newton", {"type": "t_descent", "steps": 500}],
        "points": [8, 12],
    }
    try:
        rows = lc.run_study(study, tmp_path / "study", parallel=2).rows
    finally:
        stop.set()
        thread.join()
    good = [row for row in rows if row["problem"] == "wave"]
    assert [row["outcome"] for row in good] == ["ok"] * 4 and all(row["status"] == "certified" for row in good)
    assert {row["solver"] for row in good} == {"newton", "t_descent"}
    assert good[0]["cost"] == pytest.approx(good[2]["cost"], rel=1e-6)
    assert all("ZeroDivisionError: on purpose" in row["message"] for row in rows if row["problem"] == "bad")


def test_a_solver_without_a_path_is_a_failed_cell_of_a_study(tmp_path):
    @lc.register_solver("t_gives_up")
    def gives_up(chain):
        raise ArithmeticError("on purpose")

    @lc.register_solver("t_not_finite")
    def not_finite(chain):
        return np.full_like(chain.points, np.nan)

    study = {"problems": [{"name": "wave", "config": WAVE}], "solvers": ["t_gives_up", "t_not_finite"], "points": [8]}
    rows = lc.run_study(study, tmp_path / "study").rows
    assert [row["outcome"] for row in rows] == ["error", "error"]
    assert "ArithmeticError: on purpose" in rows[0]["message"] and "not finite" in rows[1]["message"]
    assert all(row["status"] in (None, "") and (row["cost"] is None or np.isnan(row["cost"])) for row in rows)
