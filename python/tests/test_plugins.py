# SPDX-FileCopyrightText: 2026 The leastcost authors
# SPDX-License-Identifier: MIT
"""One function per plug-in, made from the lists of fields."""

import inspect
import subprocess
import sys
from pathlib import Path

import leastcost as lc
import numpy as np
import pytest
from leastcost import _plugins

GENERATOR = Path(__file__).parents[1] / "generate_plugins.py"
KINDS = [value for value in vars(_plugins).values() if inspect.isclass(value) and value.__module__ == _plugins.__name__]


def test_the_file_is_what_the_generator_makes(program):
    """If not: python3 python/generate_plugins.py build/release/bin/leastcost."""
    made = subprocess.run([sys.executable, GENERATOR, program, "--print"], capture_output=True, text=True, check=True)
    listed = subprocess.run([program, "list"], capture_output=True, text=True, check=True).stdout
    if "Not in this build" in listed:
        pytest.skip("this build lacks back ends, and their options")
    committed = Path(_plugins.__file__).read_text()
    assert made.stdout == committed


def test_every_kind_is_a_name_of_the_package():
    assert len(KINDS) >= 7
    for kind in KINDS:
        assert getattr(lc, kind.__name__) is kind and kind.__name__ in lc.__all__
        for name, function in inspect.getmembers(kind, inspect.isfunction):
            for parameter in inspect.signature(function).parameters.values():
                assert parameter.kind is parameter.KEYWORD_ONLY
                assert f"\n{parameter.name}: " in inspect.getdoc(function), f"{kind.__name__}.{name}"


def test_kinds_are_loaded_when_one_is_asked_for():
    """They would be a quarter of the time of an import."""
    code = "import sys, leastcost as lc\nassert 'leastcost._plugins' not in sys.modules and 'cost' in dir(lc)\nlc.cost\n"
    subprocess.run([sys.executable, "-c", code + "assert 'leastcost._plugins' in sys.modules"], check=True)
    with pytest.raises(AttributeError, match="module 'leastcost' has no attribute 'costs'"):
        lc.costs


def test_a_block_has_what_was_given_and_no_more():
    assert lc.cost.travel_time(gravity=1) == {"type": "travel_time", "gravity": 1}
    assert lc.solver.newton() == {"type": "newton"}
    with pytest.raises(TypeError, match=r"lc.cost.travel_time\(\) has no option 'gravitee' \(did you mean 'gravity'\?\)"):
        lc.cost.travel_time(gravitee=1)
    with pytest.raises(TypeError, match="no option 'vertices'; its options are: corners"):
        lc.obstacle.polygon(vertices=[[0, 0], [1, 0], [0, 1]])
    with pytest.raises(TypeError, match="it has none"):
        lc.manifold.robot(a=1)


def test_blocks_are_parts_of_configurations():
    config = {
        "manifold": lc.manifold.euclidean(dimension=2),
        "cost": lc.cost.metric_tensor(matrix=np.diag([1.0, 4.0])),
        "ends": {"source": {"point": [0, 0]}, "target": {"point": [3, 2]}},
        "solver": lc.solver.newton(max_iterations=50),
        "kernel": lc.kernel.expm1_square(),
    }
    assert lc.run(config).cost == pytest.approx(5, rel=1e-12)


def test_required_options_are_required():
    with pytest.raises(TypeError, match="center"):
        lc.obstacle.ball(radius=1)
