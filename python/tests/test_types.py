# SPDX-FileCopyrightText: 2026 The leastcost authors
# SPDX-License-Identifier: MIT
"""The stub says what the compiled part has, docstrings what the rest has. mypy is a step of its own (README.md)."""

import inspect
from pathlib import Path

import leastcost as lc
from leastcost import _leastcost

PACKAGE = Path(lc.__file__).parent


def test_the_stub_names_what_there_is():
    stub = (PACKAGE / "_leastcost.pyi").read_text()
    for name, member in vars(_leastcost).items():
        if name.startswith("_"):
            continue
        assert f"class {name}:" in stub or f"def {name}(" in stub or f"{name}:" in stub, name
        for part in vars(member) if inspect.isclass(member) else []:
            assert part.startswith("_") or f"def {part}(" in stub, f"{name}.{part}"


def test_everything_public_has_a_docstring():
    for name in lc.__all__:
        member = getattr(lc, name)
        assert inspect.getdoc(member), name
        for part, value in vars(member).items() if inspect.isclass(member) else []:
            if not part.startswith("_") and (callable(value) or isinstance(value, property)):
                assert inspect.getdoc(value), f"{name}.{part}"
