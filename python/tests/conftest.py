# SPDX-FileCopyrightText: 2026 The leastcost authors
# SPDX-License-Identifier: MIT
import os
from pathlib import Path

import pytest

PROJECT = Path(__file__).parents[2]


@pytest.fixture
def configs() -> Path:
    return PROJECT / "configs"


@pytest.fixture
def program() -> Path:
    """The command line program of the same build: LEASTCOST_PROGRAM."""
    if "LEASTCOST_PROGRAM" not in os.environ:
        pytest.skip("LEASTCOST_PROGRAM names no program to compare with")
    return PROJECT / os.environ["LEASTCOST_PROGRAM"]
