# SPDX-FileCopyrightText: 2026 The leastcost authors
# SPDX-License-Identifier: MIT
"""The stub says what the compiled part has, docstrings what the rest has. mypy is a step of its own (README.md)."""

import ast
import inspect
import re
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
            known = f"def {part}(" in stub or f"    {part}: " in stub  # a method, or an attribute
            assert part.startswith("_") or known, f"{name}.{part}"


def parameters(function) -> list:
    """Names of the parameters in each signature that pybind11 writes."""
    lines = [line for line in function.__doc__.splitlines() if re.match(r"(\d+\. )?\w+\(.*\) -> ", line)]
    return [[name for name in re.findall(r"(\w+): ", line) if name not in ("self", "arg0")] for line in lines]


def test_the_stub_has_the_parameters():
    """Of every function and method, in their order."""
    tree = ast.parse((PACKAGE / "_leastcost.pyi").read_text())
    declared: dict = {}
    for part in tree.body:
        for function in part.body if isinstance(part, ast.ClassDef) else [part]:
            if isinstance(function, ast.FunctionDef):
                owner = part.name + "." if isinstance(part, ast.ClassDef) else ""
                names = [a.arg for a in function.args.args if a.arg != "self"]
                declared.setdefault(owner + function.name, []).append(names)
    assert len(declared) > 15
    for name, signatures in declared.items():
        owner, _, method = name.rpartition(".")
        function = getattr(getattr(_leastcost, owner) if owner else _leastcost, method)
        assert [names for names in parameters(function) if names or len(signatures) == 1] == signatures, name


def test_everything_public_has_a_docstring():
    for name in lc.__all__:
        member = getattr(lc, name)
        assert inspect.getdoc(member), name
        for part, value in vars(member).items() if inspect.isclass(member) else []:
            if not part.startswith("_") and (callable(value) or isinstance(value, property)):
                assert inspect.getdoc(value), f"{name}.{part}"
