# SPDX-FileCopyrightText: 2026 The leastcost authors
# SPDX-License-Identifier: MIT
import subprocess
import sys

import leastcost as lc
import pytest

WRONG = """manifold: {type: euclidean, dimension: 2}
cost: {type: euclidian}
ends: {source: {point: [0, 0]}, target: {point: [1, 0]}}
solver: {type: newton, tolerence: 1e-9}
"""


@pytest.mark.parametrize("ask", [lc.validate, lc.run])
def test_every_error_with_its_place(ask):
    with pytest.raises(lc.ConfigError, match="did you mean 'tolerance'") as caught:
        ask(WRONG)
    assert isinstance(caught.value, ValueError)
    assert [d["line"] for d in caught.value.diagnostics] == [2, 4]
    assert caught.value.diagnostics[1]["where"].startswith("config:4:")


def test_the_text_is_that_of_the_program(program, tmp_path):
    file = tmp_path / "wrong.yaml"
    file.write_text(WRONG)
    told = subprocess.run([program, "validate", file], capture_output=True, text=True, check=False).stderr
    # In a process of its own: messages list what other tests have registered.
    code = "import sys, leastcost as lc\ntry: lc.validate(sys.argv[1])\nexcept lc.ConfigError as error: print(error)"
    said = subprocess.run([sys.executable, "-c", code, file], capture_output=True, text=True, check=True).stdout
    assert said.strip() == told.strip() != ""


def test_valid_configurations_are_valid(configs):
    for file in sorted(configs.glob("b*.yaml")):
        lc.validate(file)


def test_an_override_is_named():
    with pytest.raises(lc.ConfigError, match="set: path.pointz=4"):
        lc.validate(WRONG, set={"path.pointz": 4})


def test_missing_file(tmp_path):
    with pytest.raises(lc.InputError, match="none.yaml"):
        lc.run(tmp_path / "none.yaml")


def test_no_path(configs):
    with pytest.raises(lc.NoPathError):
        lc.run(configs / "no_path.yaml")


@pytest.mark.parametrize("wrong", [3, None, ["a"]])
def test_what_no_configuration_is(wrong):
    with pytest.raises(TypeError, match="a path, a text or a dict"):
        lc.run(wrong)


def test_all_errors_have_one_root():
    for error in (lc.ConfigError, lc.InputError, lc.NoPathError, lc.OutputError, lc.TimeLimitError):
        assert issubclass(error, lc.Error)


def test_an_option_is_named_once():
    with pytest.raises(lc.ConfigError) as caught:
        lc.run({"manifold": {"type": "euclidean", "dimension": 2}, "path": {"points": "many"}, "clearance": -1})
    assert "config['path']['points']: error: must be a whole number" in str(caught.value)
    assert "config['clearance']: error: must be at least 0" in str(caught.value)
