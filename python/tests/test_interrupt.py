# SPDX-FileCopyrightText: 2026 The leastcost authors
# SPDX-License-Identifier: MIT
"""Ctrl-C, and what other threads do meanwhile."""

import os
import signal
import threading
import time

import leastcost as lc
import numpy as np
import pytest


def interrupt_after(seconds: float) -> list:
    """Sends SIGINT to this process once it has used so much CPU time; the list then holds the CPU time of it. On a busy
    machine nothing else is comparable."""
    sent: list = []
    start = time.process_time()

    def send() -> None:
        while time.process_time() < start + seconds:
            time.sleep(0.005)
        sent.append(time.process_time())
        os.kill(os.getpid(), signal.SIGINT)

    threading.Thread(target=send).start()
    return sent


def large_mesh(side: int) -> lc.Mesh:
    x, y = np.meshgrid(np.linspace(0, 1, side), np.linspace(0, 1, side))
    z = 0.02 * np.sin(40 * x) * np.cos(37 * y)
    corner = np.arange(side * (side - 1)).reshape(side - 1, side)[:, :-1].ravel()
    F = np.vstack(
        [
            np.column_stack([corner, corner + 1, corner + side]),
            np.column_stack([corner + 1, corner + side + 1, corner + side]),
        ]
    )
    return lc.Mesh(np.column_stack([x.ravel(), y.ravel(), z.ravel()]), F)


def test_distances_stop_at_once():
    mesh = large_mesh(300)
    sent = interrupt_after(0.1)
    with pytest.raises(KeyboardInterrupt):
        mesh.distances(0)
    assert time.process_time() - sent[0] < 0.05
    assert mesh.geodesic(0, 1).proved  # the mesh is as good as before


def test_a_run_returns_the_best_so_far(configs):
    sent = interrupt_after(0.1)
    result = lc.run(configs / "brachistochrone.yaml", set={"path.points": 20_000})
    assert time.process_time() - sent[0] < 0.1
    assert result.status == "interrupted" and not result.certified


def interrupted_within(work, after: float) -> float:
    """Seconds of CPU time from the signal until KeyboardInterrupt."""
    sent = interrupt_after(after)
    with pytest.raises(KeyboardInterrupt):
        work()
    return time.process_time() - sent[0]


def test_a_mesh_in_the_making_is_given_up():
    mesh = large_mesh(400)
    V, F = mesh.V, mesh.F
    assert interrupted_within(lambda: lc.Mesh(V, F), 0.05) < 0.4
    assert interrupted_within(lambda: mesh.geodesic((0.2, 0.3, 0.0), 7), 0.05) < 0.1  # the search tree
    assert mesh.distances((0.2, 0.3, 0.0), max_distance=0.01).min() < 0.01  # which is made again


def test_a_cloud_in_the_making_is_given_up():
    x = np.random.default_rng(0).normal(size=(30_000, 3))
    points = x / np.linalg.norm(x, axis=1)[:, None]
    assert interrupted_within(lambda: lc.Cloud(points), 0.1) < 0.3


def test_a_file_is_not_read_to_its_end(tmp_path):
    mesh = large_mesh(500)
    file = tmp_path / "mesh.obj"
    with file.open("w") as out:
        np.savetxt(out, mesh.V, fmt="v %.9g %.9g %.9g")
        np.savetxt(out, mesh.F + 1, fmt="f %d %d %d")
    assert interrupted_within(lambda: lc.Mesh.read(file), 0.05) < 0.4


def test_a_run_with_a_cost_in_python():
    """It is raised within the function, which is not called any more."""
    calls = []

    def slow(a, b):
        calls.append(time.monotonic())
        if len(calls) == 20:
            os.kill(os.getpid(), signal.SIGINT)
        time.sleep(0.001)
        return ((b - a) ** 2).sum(0) * (1 + a[0] ** 2) * (1 + b[0] ** 2)

    with pytest.raises(KeyboardInterrupt):
        lc.find_path(lc.Plane(), slow, (0, 0), (1, 0.3))
    assert len(calls) == 20
    assert time.monotonic() - calls[-1] < 0.5  # on a busy machine


def test_own_handlers_are_heard():
    mesh = large_mesh(300)

    def handler(*_):
        raise RuntimeError("enough")

    before = signal.signal(signal.SIGINT, handler)
    try:
        interrupt_after(0.1)
        with pytest.raises(RuntimeError, match="enough"):
            mesh.distances(0)
    finally:
        signal.signal(signal.SIGINT, before)


def test_other_threads_run_meanwhile():
    mesh = large_mesh(150)
    ticks = 0
    done = threading.Event()

    def count() -> None:
        nonlocal ticks
        while not done.is_set():
            ticks += 1
            time.sleep(0.001)

    thread = threading.Thread(target=count)
    thread.start()
    mesh.distances(0)
    done.set()
    thread.join()
    assert ticks > 10


def test_a_time_budget_ends_within_a_pass_over_second_derivatives():
    """In 50 dimensions that of 32 moves takes seconds, by differences of differences."""
    start = time.process_time()
    result = lc.find_path(
        lc.Space(50),
        lambda a, b: ((b - a) ** 2).sum(0) * (1 + ((a + b) ** 2).sum(0)),
        [0] * 50,
        [1] * 50,
        derivatives="differences",
        max_seconds=0.3,
    )
    assert result.status == "interrupted" and len(result.points) == 66
    assert time.process_time() - start < 2
