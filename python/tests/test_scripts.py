# SPDX-FileCopyrightText: 2026 The leastcost authors
# SPDX-License-Identifier: MIT
"""Scripts that no test runs are at least Python."""
import pathlib

import pytest

PROJECT = pathlib.Path(__file__).resolve().parents[2]
SCRIPTS = sorted(p for folder in ("benchmarks", "tests", "docs") for p in (PROJECT / folder).rglob("*.py"))


@pytest.mark.parametrize("script", SCRIPTS, ids=lambda p: p.relative_to(PROJECT).as_posix())
def test_script_compiles(script):
    compile(script.read_text(), str(script), "exec")
