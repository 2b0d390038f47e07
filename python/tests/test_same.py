# SPDX-FileCopyrightText: 2026 The leastcost authors
# SPDX-License-Identifier: MIT
"""Every configuration gives the same from Python as from the program. Without LEASTCOST_NIGHTLY: those that take less
than a second, as the program measures it."""

import json
import os
import subprocess
from pathlib import Path

import leastcost as lc
import pytest

CONFIGS = sorted((Path(__file__).parents[2] / "configs").glob("*.yaml"))
NIGHTLY = "LEASTCOST_NIGHTLY" in os.environ
ALLOWED = 300 if NIGHTLY else 1  # s


def program_says(program: Path, config: Path, folder: Path) -> dict:
    """result.json, or {"error": what is printed}."""
    call = [program, "run", config, "-o", folder, "-q"]
    try:
        done = subprocess.run(call, cwd=config.parents[1], capture_output=True, text=True, timeout=ALLOWED, check=False)
    except subprocess.TimeoutExpired:
        pytest.skip(f"takes more than {ALLOWED} s")
    if not (folder / "result.json").exists():
        return {"error": done.stderr}
    return json.loads((folder / "result.json").read_text())


@pytest.mark.parametrize("config", CONFIGS, ids=lambda config: config.stem)
def test_same_as_the_program(program, tmp_path, config, monkeypatch):
    text = config.read_text()
    if "pairs:" in text:
        pytest.skip("many pairs have files of their own")
    theirs = program_says(program, config, tmp_path / "out")
    monkeypatch.chdir(config.parents[1])
    if "error" in theirs:
        with pytest.raises(lc.Error) as caught:
            lc.run(config)
        assert str(caught.value).splitlines()[0] in theirs["error"]
        return
    ours = lc.run(config).details
    for key in ("cost", "scope", "status", "failures", "points", "spacing", "certificate", "notes", "global"):
        assert without_seconds(ours[key]) == without_seconds(theirs[key]), key


def without_seconds(value):
    if isinstance(value, dict):
        return {key: without_seconds(inner) for key, inner in value.items() if key != "seconds"}
    return value
