# SPDX-FileCopyrightText: 2026 The leastcost authors
# SPDX-License-Identifier: MIT
"""Comparison studies."""

from __future__ import annotations

import csv
import json
import os
from collections.abc import Mapping
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

from . import _leastcost
from ._config import externals_of, plain_of, text_of
from ._errors import ConfigError, InputError

if TYPE_CHECKING:
    from ._config import Config, Object


class Study:
    """The results of a study, which are the files of its folder (docs/studies.md)."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder

    @cached_property
    def rows(self) -> list[dict[str, Any]]:
        """One dict per run, with the columns of runs.csv: `problem`, `solver`, `outcome`, `cost`, `seconds`, ... Numbers
        are int or float, empty cells None. pandas.DataFrame(study.rows) is a table."""
        with open(self.folder / "runs.csv", newline="", encoding="utf-8") as file:
            return [{key: _cell(text) for key, text in row.items()} for row in csv.DictReader(file)]

    @cached_property
    def summary(self) -> dict[str, Any]:
        """The content of summary.json."""
        content: dict[str, Any] = json.loads((self.folder / "summary.json").read_text(encoding="utf-8"))
        return content

    def write_report(self) -> Path:
        """Writes report.html, with the figures, into the folder, and returns the file."""
        return _leastcost.write_report(self.folder)

    def __repr__(self) -> str:
        return f"<leastcost.Study {self.folder}: {len(self.rows)} runs>"


def run_study(
    study: Config,
    output: str | os.PathLike[str],
    *,
    set: Mapping[str, Any] | None = None,
    folder: str | os.PathLike[str] = "",
    replace: bool = False,
    resume: bool = False,
    parallel: int = 1,
    **objects: Object,
) -> Study:
    """Runs a grid of problems, solvers, kernels and numbers of points: the same as `leastcost study`.

    study: the path of a YAML file, its text (with a line break), or the same as a dict.
    output: the folder of the results, which is made.
    set: options that are replaced or added, as of --set.
    folder: what the files named in a text or a dict are relative to; empty: the current folder.
    replace, resume: begin anew in a folder of an earlier study, or go on where it ended.
    parallel: runs at once, each of which is a process. Fork copies this thread alone: call it while no other thread
      uses leastcost.
    objects: what problems name, `cost: {type: external, name: chute}` as chute=..., as of run(). Of a function all problems
      have points of as many coordinates. A study does not know what an object does: resume it with the same ones.

    A run that fails is a row. Ctrl-C raises KeyboardInterrupt; `resume` goes on from there. Raises ConfigError,
    InputError, OutputError."""
    if not 1 <= parallel <= 1024:
        raise InputError(f"parallel is {parallel}; it must be from 1 to 1024")
    if replace and resume:
        raise InputError("a study begins anew (replace) or goes on (resume), not both")
    assignments = [f"{key}={text_of(value, f'set[{key!r}]')}" for key, value in (set or {}).items()]
    file, text, subscripts = None, "", None
    if isinstance(study, Mapping):
        text, subscripts = _lines_of(plain_of(study, "study"))
    elif isinstance(study, str) and "\n" in study:
        text = study
    elif isinstance(study, (str, os.PathLike)):
        file = Path(study)
    else:
        raise TypeError(f"a study is a path, a text or a dict, not {type(study).__name__}")
    try:
        return Study(
            _leastcost.study(
                file, text, Path(folder), assignments, Path(output), replace, resume, parallel, externals_of(objects)
            )
        )
    except ConfigError as error:
        if subscripts is None:
            raise
        raise _in_subscripts(error, subscripts, f"{Path(folder)}/study") from None


def _lines_of(tree: dict[str, Any]) -> tuple[str, list[str]]:
    """Plain values as JSON, each on a line of its own; and, line by line, where in the dict that is."""
    lines: list[str] = []
    subscripts: list[str] = []

    def write(text: str, where: str) -> None:
        lines.append(text)
        subscripts.append(where)

    def write_all(value: Any, where: str, before: str, after: str) -> None:
        if not value or not isinstance(value, (dict, list)):
            write(before + json.dumps(value) + after, where)
            return
        parts = list(value.items()) if isinstance(value, dict) else list(enumerate(value))
        brackets = "{}" if isinstance(value, dict) else "[]"
        write(before + brackets[0], where)
        for i, (key, part) in enumerate(parts):
            name = json.dumps(key) + ": " if isinstance(key, str) else ""
            write_all(part, f"{where}[{key!r}]", name, "," if i + 1 < len(parts) else "")
        write(brackets[1] + after, where)

    write_all(tree, "study", "", "")
    return "\n".join(lines) + "\n", subscripts


def _in_subscripts(error: ConfigError, subscripts: list[str], file: str) -> ConfigError:
    """The same error with its places in the dict, instead of those in a text that nobody has seen."""
    text: list[str] = []
    for diagnostic in error.diagnostics:
        place = f"{file}:{diagnostic['line']}:{diagnostic['column']}"
        if diagnostic["where"] == place and diagnostic["line"] <= len(subscripts):
            diagnostic.update(where=subscripts[diagnostic["line"] - 1], line=0, column=0, length=1)
        text.append(f"{diagnostic['where']}: error: {diagnostic['message']}")
    count = str(error).rsplit("\n", 1)[-1].replace(file, "study")
    return ConfigError("\n".join([*text, count]), error.diagnostics)


def _cell(text: str) -> Any:
    if text == "":
        return None
    for number in (int, float):
        try:
            return number(text)
        except ValueError:
            pass
    return text
