# SPDX-FileCopyrightText: 2026 The leastcost authors
# SPDX-License-Identifier: MIT
"""Options of plug-ins written in Python: the parameters of a function, and what is said of them."""

from __future__ import annotations

import inspect
import math
import os
import typing
from dataclasses import dataclass
from pathlib import Path, PurePath
from typing import TYPE_CHECKING, Any

import numpy as np

from ._errors import InputError

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping

_SCALARS: dict[Any, str] = {bool: "bool", int: "int", float: "float", str: "text", Path: "file", PurePath: "file"}
_LISTS: dict[Any, str] = {list[float]: "vector", list[int]: "vector", list[str]: "texts", dict[str, float]: "numbers"}
_MATRICES = (list[list[float]], list[list[int]])
_RANGED = ("int", "float", "vector", "matrix", "numbers")
_NOTHING: dict[str, Any] = {
    "bool": False,
    "int": 0,
    "float": 0.0,
    "text": "",
    "file": "",
    "vector": np.zeros(0),
    "matrix": np.zeros((0, 0)),
    "texts": [],
    "numbers": {},
}
_TYPES = "bool, int, float, str, Path, Literal, list[float], list[list[float]], list[str] or dict[str, float]"
_LARGEST = 2**31


@dataclass(frozen=True)
class Option:
    """What describe() says of an option, and which values are refused; made by option()."""

    help: str = ""
    unit: str = ""
    minimum: float = -math.inf
    maximum: float = math.inf
    above: bool = False


def option(
    help: str, *, unit: str = "", minimum: float | None = None, maximum: float | None = None, above: float | None = None
) -> Option:
    """More about an option of what register_cost(), register_solver() or register_initializer() registers.

    help: one sentence.
    unit: "m/s^2", say.
    minimum, maximum: least and greatest number that is allowed.
    above: instead of minimum: numbers are greater than it.

    Raises InputError."""
    if minimum is not None and above is not None:
        raise InputError("an option has a minimum, or is above a number, not both")
    least = minimum if above is None else above
    out = Option(
        str(help),
        str(unit),
        -math.inf if least is None else float(least),
        math.inf if maximum is None else float(maximum),
        above is not None,
    )
    if not out.minimum <= out.maximum:  # also NaN
        raise InputError(f"the range of an option is from {out.minimum} to {out.maximum}")
    return out


@dataclass(frozen=True)
class Read:
    """The options of a function."""

    positional: int
    summary: str
    plain: list[tuple[Any, ...]]
    files: frozenset[str]

    def values(self, values: dict[str, Any]) -> dict[str, Any]:
        """As the function takes them."""
        return {key: Path(value) if key in self.files and value else value for key, value in values.items()}


def options_of(
    function: Callable[..., Any], name: str, kind: str, positional: list[int], said: Mapping[str, Option] | None
) -> Read:
    """positional: how many parameters may come before the options. Raises TypeError, InputError with the name."""
    who = f"the {kind} {name!r}"
    if not callable(function):
        raise TypeError(f"{who} is a function, not {type(function).__name__}")
    try:
        parameters = list(inspect.signature(function).parameters.values())
    except ValueError:  # of some that are written in C
        called = getattr(function, "__name__", repr(function))
        raise InputError(
            f"{who}: Python does not know the parameters of {called}; write a function around it: def f(a, b): ..."
            if kind == "cost"
            else f"{who}: Python does not know the parameters of {called}; write a function around it"
        ) from None
    count = sum(p.default is p.empty and p.kind in (p.POSITIONAL_ONLY, p.POSITIONAL_OR_KEYWORD) for p in parameters)
    if count not in positional:
        takes = {"cost": "a and b, or options alone", "solver": "a chain", "initializer": "source and target"}[kind]
        raise InputError(
            f"{who} takes {takes}; this function has {count} parameter{'' if count == 1 else 's'} without a default: "
            "write options behind a *"
        )
    known = [p.name for p in parameters[count:]]
    for key, extra in (said or {}).items():
        if key not in known:
            import difflib  # seldom needed, and an import takes its time

            near = difflib.get_close_matches(str(key), known, 1)
            hint = f" (did you mean {near[0]!r}?)" if near else ""
            raise InputError(f"{who} has no option {key!r}{hint}; its options are: {', '.join(known) or 'none'}")
        if not isinstance(extra, Option):
            raise TypeError(f"options[{key!r}] is {extra!r}; write lc.option(...)")
    hints = _hints(function)
    plain = [_option(who, p, hints.get(p.name), (said or {}).get(p.name, Option())) for p in parameters[count:]]
    text = (inspect.getdoc(function) or "") if inspect.isroutine(function) or inspect.isclass(function) else ""
    summary = " ".join(text.split("\n\n")[0].split()) or f"A {kind} written in Python."
    return Read(count, summary, plain, frozenset(row[0] for row in plain if row[1] == "file"))


def check_name(kind: str, name: Any) -> None:
    """Raises TypeError where the decorator was written without its name."""
    if not isinstance(name, str):
        raise TypeError(_by_name(kind, name))


def _by_name(kind: str, name: Any) -> str:
    return f'a {kind} is registered by its name, @lc.register_{kind}("name"), not by {name!r}'


def _hints(function: Callable[..., Any]) -> dict[str, Any]:
    try:
        return typing.get_type_hints(function)
    except (NameError, TypeError, AttributeError):  # of a name that is there for type checkers alone
        return {}


def _option(who: str, parameter: inspect.Parameter, annotation: Any, said: Option) -> tuple[Any, ...]:
    key, default = parameter.name, parameter.default
    if parameter.kind not in (parameter.KEYWORD_ONLY, parameter.POSITIONAL_OR_KEYWORD):
        raise InputError(f"{who}: every option is named, but there is {parameter}")
    if key == "type":
        raise InputError(f"{who}: no option can be called 'type', which is the key of its name")
    required = default is parameter.empty
    kind = _kind_of_annotation(annotation) or (None if required else _kind_of_value(default))
    if kind is None:
        raise InputError(f"{who}: the type of the option {key!r} is not known; annotate it with {_TYPES}")
    if kind == "choice":
        value: Any = _choice(who, key, typing.get_args(annotation), default)
    else:
        value = _NOTHING[kind] if required else _value(who, key, kind, default)
    if kind not in _RANGED and (said.minimum, said.maximum) != (-math.inf, math.inf):
        raise InputError(f"{who}: the option {key!r} is no number and has no range")
    if kind in _RANGED and not required:
        numbers = np.asarray(list(value.values()) if kind == "numbers" else value, dtype=float)
        low = numbers <= said.minimum if said.above else numbers < said.minimum
        if np.any(low | (numbers > said.maximum)):
            raise InputError(f"{who}: the default of the option {key!r}, {default!r}, is not in its range")
    help = said.help or f"The parameter {key} of the function; lc.option() describes it."
    return key, kind, value, help, said.unit, said.minimum, said.maximum, said.above, required


def _choice(who: str, key: str, words: tuple[Any, ...], default: Any) -> tuple[int, list[str]]:
    """Which of the words is the default, and all of them."""
    if not all(isinstance(word, str) and word for word in words):
        raise InputError(f"{who}: the words of the option {key!r} are texts, not {words!r}")
    if default not in words:
        raise InputError(f"{who}: the option {key!r} needs one of its words as default: {', '.join(words)}")
    return words.index(default), list(words)


def _kind_of_annotation(annotation: Any) -> str | None:
    if typing.get_origin(annotation) is typing.Literal:
        return "choice"
    try:
        if annotation in _MATRICES:
            return "matrix"
        return _SCALARS.get(annotation) or _LISTS.get(annotation)
    except TypeError:  # not hashable
        return None


def _kind_of_value(value: Any) -> str | None:
    if isinstance(value, np.generic):
        value = value.item()
    if type(value) in _SCALARS:
        return _SCALARS[type(value)]
    if isinstance(value, PurePath):
        return "file"
    if isinstance(value, dict) and value:
        return "numbers"
    if isinstance(value, (list, tuple)) and value and all(isinstance(part, str) for part in value):
        return "texts"
    if isinstance(value, (list, tuple, np.ndarray)) and len(value):
        try:
            return {1: "vector", 2: "matrix"}.get(np.asarray(value, dtype=float).ndim)
        except (TypeError, ValueError):
            return None
    return None


def _value(who: str, key: str, kind: str, default: Any) -> Any:
    """A default as the library takes it."""
    wrong = InputError(f"{who}: the default of the option {key!r}, {default!r}, is not of its type")
    if isinstance(default, np.generic):
        default = default.item()
    try:
        if kind == "bool" and isinstance(default, bool):
            return default
        if kind == "int" and isinstance(default, int) and not isinstance(default, bool):
            if abs(default) < _LARGEST:
                return default
        elif kind == "float" and isinstance(default, (int, float)) and not isinstance(default, bool):
            if math.isfinite(default):
                return float(default)
        elif kind == "text" and isinstance(default, str):
            return default
        elif kind == "file" and isinstance(default, (str, os.PathLike)):
            return os.fspath(default)
        elif kind == "texts" and not isinstance(default, str) and all(isinstance(text, str) for text in default):
            return list(default)
        elif kind == "numbers":
            numbers = {str(name): float(number) for name, number in default.items()}
            if all(map(math.isfinite, numbers.values())):
                return numbers
        elif kind in ("vector", "matrix"):
            array = np.ascontiguousarray(default, dtype=float)
            if array.ndim == (1 if kind == "vector" else 2) and np.isfinite(array).all():
                return array
    except (TypeError, ValueError, AttributeError):
        raise wrong from None
    raise wrong
