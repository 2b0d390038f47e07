# SPDX-FileCopyrightText: 2026 The leastcost authors
# SPDX-License-Identifier: MIT
"""examples/python: each is short, certifies its path and draws it."""

import ast
import runpy
from pathlib import Path

import leastcost as lc
import pytest

matplotlib = pytest.importorskip("matplotlib")
matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402

SCRIPTS = sorted((Path(__file__).parents[2] / "examples/python").glob("*.py"))


def lines_of_code(text: str) -> int:
    docstring = ast.parse(text).body[0].end_lineno
    after = text.splitlines()[docstring:]
    return sum(bool(line.strip()) and not line.lstrip().startswith("#") for line in after)


@pytest.mark.filterwarnings("ignore:.*non-GUI backend")
@pytest.mark.parametrize("script", SCRIPTS, ids=lambda script: script.stem)
def test_example(script, configs, monkeypatch):
    monkeypatch.chdir(configs.parent)
    path = runpy.run_path(str(script))["path"]
    assert path.proved if isinstance(path, lc.Geodesic) else path.certified
    (axes, *_) = pyplot.gcf().axes
    assert axes.get_lines()
    pyplot.close("all")


def test_there_are_four_and_they_are_short():
    assert [script.stem for script in SCRIPTS] == ["brachistochrone", "geodesic", "plan", "wind"]
    assert all(lines_of_code(script.read_text()) <= 10 for script in SCRIPTS)
