# SPDX-FileCopyrightText: 2026 The leastcost authors
# SPDX-License-Identifier: MIT
import time
import traceback
from concurrent.futures import ThreadPoolExecutor

import leastcost as lc
import numpy as np
import pytest

PI = (np.pi, -2)


def chute(a, b):
    """Squared time of a bead on a straight chute, from rest at height 0, gravity 1."""
    return 2 * ((b - a) ** 2).sum(0) / (np.sqrt(-a[1]) + np.sqrt(-b[1])) ** 2


def test_a_cost_in_python_equals_the_built_in_one():
    built_in = lc.find_path(lc.Plane(), {"type": "travel_time", "gravity": 1}, (0, 0), PI, points=40)
    own = lc.find_path(lc.Plane(), chute, (0, 0), PI, points=40, unit="s", additive=True)
    assert own.certified and own.unit == "s"
    assert own.cost == pytest.approx(built_in.cost, rel=1e-11)
    assert abs(own.cost - np.pi) <= 3 * own.error < 1e-6


def test_a_cost_in_space():
    """Straight lines are shortest in a metric that is constant."""
    weights = np.array([[1.0], [4], [9]])

    def q(a, b):
        return (weights * (b - a) ** 2).sum(0)

    result = lc.find_path(lc.Space(3), q, (0, 0, 0), (1, 1, 1), additive=True)
    assert result.certified and result.cost == pytest.approx(np.sqrt(14), rel=1e-12)
    assert np.allclose(result.points, np.linspace(0, 1, 66)[:, None], atol=1e-9)


def test_without_additive_the_error_is_honest():
    result = lc.find_path(lc.Plane(), chute, (0, 0), PI, points=64)
    assert abs(result.cost - np.pi) <= 3 * result.error


def test_domains_and_costs_of_configurations():
    result = lc.find_path({"type": "euclidean", "dimension": 2}, "euclidean", (0, 0), (3, 4), points=8)
    assert result.cost == pytest.approx(5, rel=1e-12)
    with pytest.raises(lc.ConfigError, match="euclidian"):
        lc.find_path(lc.Plane(), "euclidian", (0, 0), (1, 0))


@pytest.mark.parametrize(
    "q, derivative",
    [
        (lambda a, b: ((b - a) ** 2).sum(0) * (1 + np.abs(a[0])), r"a\[0\]"),
        (lambda a, b: ((b - a) ** 2).sum(0) * (1 + b[1].real ** 2), r"b\[1\]"),
    ],
)
def test_a_cost_that_is_not_analytic_is_refused(q, derivative):
    with pytest.raises(lc.InputError, match="not analytic: its derivative by " + derivative):
        lc.find_path(lc.Plane(), q, (0.5, 0.5), (2, 1), symmetric=False)


def test_the_remedy_of_that_message():
    def q(a, b):
        return ((b - a) ** 2).sum(0) * (1 + (a[0] ** 2) ** 0.5) * (1 + (b[0] ** 2) ** 0.5)

    assert lc.find_path(lc.Plane(), q, (0.5, 0.5), (2, 1)).cost > 0


def test_shapes_are_refused_in_words():
    with pytest.raises(lc.InputError, match=r"returned the shape \(2, (\d+)\); for \1 moves it must be \(\1,\)"):
        lc.find_path(lc.Plane(), lambda a, b: (b - a) ** 2, (0, 0), (1, 0))
    with pytest.raises(lc.InputError, match="values of the type bool"):
        lc.find_path(lc.Plane(), lambda a, b: a[0] > 0, (0, 0), (1, 0))
    with pytest.raises(lc.InputError, match="target has 3 coordinates"):
        lc.find_path(lc.Plane(), chute, (0, 0), (1, 0, 0))
    with pytest.raises(lc.InputError, match="source must be a point"):
        lc.find_path(lc.Plane(), chute, [[0, 0]], (1, 0))
    with pytest.raises(lc.InputError, match="source is 3, but Plane.* has no vertices"):
        lc.find_path(lc.Plane(), chute, 3, (1, 0))
    with pytest.raises(lc.InputError, match="has no faces"):
        lc.find_path(lc.Plane(), chute, (3, (1, 0, 0)), (1, 0))
    with pytest.raises(lc.InputError, match=r"cost is an array of shape \(5, 5\); costs per cell are lc.CostMap"):
        lc.find_path(lc.Plane(), np.ones((5, 5)), (1, 1), (4, 4))
    with pytest.raises(lc.InputError, match="obstacles is one obstacle; give a list"):
        lc.find_path(lc.Plane(), None, (0, 0), (1, 0), obstacles=lc.obstacle.ball(center=[1, 1], radius=0.1))
    with pytest.raises(lc.InputError, match="are of a function"):
        lc.find_path(lc.Plane(), "euclidean", (0, 0), (1, 0), additive=True)


def test_a_shape_that_changes_later_is_refused():
    def q(a, b):
        values = chute(a, b)
        return values if len(values) < 30 else values[:-1]

    with pytest.raises(ValueError, match=r"the shape \(31,\); for 32 moves it must be \(32,\)"):
        lc.find_path(lc.Plane(), q, (0, 0), PI, points=40)


def test_promises_are_verified():
    def uphill(a, b):
        return (np.sqrt(((b - a) ** 2).sum(0)) + 0.3 * (b[1] - a[1])) ** 2

    with pytest.raises(lc.InputError, match="not symmetric: the move from .* costs .*, and the reverse move .*symmetric=F"):
        lc.find_path(lc.Plane(), uphill, (0, 0), (1, 1))
    there = lc.find_path(lc.Plane(), uphill, (0, 0), (1, 1), symmetric=False, additive=True)
    assert there.certified and there.cost == pytest.approx(np.sqrt(2) + 0.3, rel=1e-12)

    def middle(a, b):
        return ((b - a) ** 2).sum(0) * (1 + ((a + b) / 2)[0] ** 2) ** 2

    with pytest.raises(lc.InputError, match="not additive: the move from .* costs .*, and its two halves"):
        lc.find_path(lc.Plane(), middle, (0, 0), (1, 1), additive=True)
    assert lc.find_path(lc.Plane(), middle, (0, 0), (1, 1)).certified


def test_differences_where_a_function_is_not_analytic():
    def q(a, b):
        return ((b - a) ** 2).sum(0) * (1 + np.abs((a[0] + b[0]) / 2)) ** 2

    def analytic(a, b):
        return ((b - a) ** 2).sum(0) * (1 + (a[0] + b[0]) / 2) ** 2

    ends = (0.5, 0), (2, 1)
    own = lc.find_path(lc.Plane(), q, *ends, derivatives="differences")
    exact = lc.find_path(lc.Plane(), analytic, *ends)
    assert own.certified and own.cost == pytest.approx(exact.cost, rel=1e-10)
    with pytest.raises(lc.InputError, match='"complex" or "differences"'):
        lc.find_path(lc.Plane(), q, *ends, derivatives="forward")


def test_differences_of_the_chute():
    own = lc.find_path(lc.Plane(), chute, (0, 0), PI, points=40, additive=True, derivatives="differences")
    assert own.certified and abs(own.cost - np.pi) <= 3 * own.error < 1e-6


def test_a_function_starts_straight():
    """A search on all sides would call it for every cell."""
    calls = 0

    def q(a, b):
        nonlocal calls
        calls += 1
        return ((b - a) ** 2).sum(0) * (1 + a[0] ** 2) * (1 + b[0] ** 2)

    assert lc.find_path(lc.Plane(), q, (0.5, 0.5), (2, 1)).certified
    assert calls < 3000


def test_threads_share_a_cost():
    cost = lc.Cost(chute, unit="s", additive=True)
    alone = lc.find_path(lc.Plane(), cost, (0, 0), PI, points=40).cost
    with ThreadPoolExecutor(4) as pool:
        found = pool.map(lambda _: lc.find_path(lc.Plane(), cost, (0, 0), PI, points=40).cost, range(12))
        assert list(found) == [alone] * 12


def test_an_exception_in_one_thread_is_its_own():
    def fails(a, b):
        raise ZeroDivisionError("mine")

    def cost_of(q):
        try:
            return lc.find_path(lc.Plane(), q, (0, 0), PI, points=20).cost
        except ZeroDivisionError:
            return "mine"

    with ThreadPoolExecutor(4) as pool:
        found = list(pool.map(cost_of, [chute, fails] * 6))
    assert found[1::2] == ["mine"] * 6 and len({*found[::2]}) == 1


@pytest.mark.parametrize("calls", [10, 20, 60])
def test_an_exception_of_the_cost_keeps_its_traceback(calls):
    made = 0

    def q(a, b):
        nonlocal made
        made += 1
        if made > calls:
            raise ZeroDivisionError("mine")
        return chute(a, b)

    with pytest.raises(ZeroDivisionError, match="mine") as caught:
        lc.find_path(lc.Plane(), q, (0, 0), PI, points=40, additive=True)
    assert "in q" in "".join(traceback.format_tb(caught.value.__traceback__))


def test_time_limit():
    calls = 0

    def slow(a, b):
        nonlocal calls
        calls += 1
        time.sleep(0.01)
        return chute(a, b)

    try:
        result = lc.find_path(lc.Plane(), slow, (0, 0), PI, max_seconds=0.2)
        assert result.status == "interrupted" and not result.certified
    except lc.TimeLimitError:
        pass
    assert calls < 100
