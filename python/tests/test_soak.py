# SPDX-FileCopyrightText: 2026 The leastcost authors
# SPDX-License-Identifier: MIT
"""Thousands of solves leave nothing behind: 2,000, with LEASTCOST_NIGHTLY 10,000 of each kind."""

import gc
import os
from pathlib import Path

import leastcost as lc
import pytest

SOLVES = 10_000 if "LEASTCOST_NIGHTLY" in os.environ else 1_000
MOST_GROWTH = 4.0  # MB
CHUTE = {
    "manifold": lc.manifold.euclidean(dimension=2),
    "cost": lc.cost.travel_time(gravity=1),
    "ends": {"source": {"point": [0, 0]}, "target": {"point": [3, -2]}},
    "path": {"points": 10},
    "certificate": {"refine": 0},
}


def resident() -> float:
    """MB."""
    gc.collect()
    pages = int(Path("/proc/self/statm").read_text().split()[1])
    return pages * os.sysconf("SC_PAGE_SIZE") / 1e6


def quadratic(a, b):
    return ((b - a) ** 2).sum(0) * (1 + a[1] ** 2 + b[1] ** 2)


def solve_config(_):
    assert lc.run(CHUTE).cost > 0


def solve_function(_):
    assert lc.find_path(lc.Plane(), quadratic, (0, 0), (1, 1), points=6).cost > 0


def make_mesh(i):
    mesh = lc.Mesh([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0.5]], [[0, 1, 2], [0, 2, 3]])
    assert mesh.geodesic(1, 3).proved and mesh.distances(i % 4).shape == (4,)


def refuse(_):
    with pytest.raises(lc.ConfigError):
        lc.validate("cost: {type: euclidian}\nmanifold: euclidean\n")


def register(i):
    """As a cell of a notebook that is run again."""

    @lc.register_cost("soak")
    def soak(a, b, *, weight=1.0):
        return weight * ((b - a) ** 2).sum(0)

    @lc.register_solver("soak")
    def stay(chain):
        return chain.points

    config = {**CHUTE, "cost": {"type": "soak", "weight": 1 + i % 2}, "solver": "soak"}
    assert lc.run(config).cost > 0


@pytest.mark.skipif(not Path("/proc/self/statm").exists(), reason="memory is read from /proc")
@pytest.mark.parametrize("solve, share", [(solve_config, 1), (solve_function, 0.1), (make_mesh, 1), (refuse, 1), (register, 0.2)])
def test_memory_does_not_grow(solve, share):
    count = int(SOLVES * share)
    for i in range(count // 5):
        solve(i)
    before = resident()
    for i in range(count):
        solve(i)
    assert resident() - before < MOST_GROWTH
