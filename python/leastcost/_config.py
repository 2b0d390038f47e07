# SPDX-FileCopyrightText: 2026 The leastcost authors
# SPDX-License-Identifier: MIT
"""What a configuration may be in Python, and how the library takes it."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from . import _leastcost
from ._arrays import points
from ._cost import Cost, CostMap, Wind
from ._domains import Cloud, Space, Terrain
from ._errors import ConfigError
from ._mesh import Mesh
from ._robot import Robot

if TYPE_CHECKING:
    from typing import Union

    from numpy.typing import NDArray

    from ._cost import SquaredCost

    Config = Union[str, os.PathLike[str], Mapping[str, Any]]
    #: What a configuration can name, or a dict can hold: a manifold, a cost, the points of a first path.
    Object = Union[Mesh, Cloud, Terrain, Robot, Cost, CostMap, Wind, SquaredCost, NDArray[Any]]

_OBJECTS = (Mesh, Cloud, Terrain, Robot, Cost, CostMap, Wind)
_MOST = 2**63  # of a whole number
_DEEPEST = 50  # the deepest configuration has eight levels


def source_of(
    config: Config,
    *,
    set: Mapping[str, Any] | None = None,
    folder: str | os.PathLike[str] = "",
    objects: Mapping[str, Object] | None = None,
) -> _leastcost.Source:
    """A path is read; a text with a line break is the configuration itself, and so is a dict."""
    if not isinstance(set or {}, Mapping) or not all(isinstance(key, str) for key in set or {}):
        raise TypeError(f"set must be a dict of options, {{'path.points': 200}}, not {set!r}")
    reader = _Reader(objects or {}, isinstance(config, Mapping) and _reads_cells(config, set or {}))
    assignments = [f"{key}={json.dumps(reader.plain(value, f'set[{key!r}]'))}" for key, value in (set or {}).items()]
    if isinstance(config, Mapping):
        return _leastcost.Source(None, "", reader.plain(config, "config"), Path(folder), assignments, reader.externals)
    if isinstance(config, str) and "\n" in config:
        return _leastcost.Source(None, config, None, Path(folder), assignments, reader.externals)
    if isinstance(config, (str, os.PathLike)):
        return _leastcost.Source(Path(config), "", None, Path(), assignments, reader.externals)
    raise TypeError(f"a configuration must be a path, a text or a dict, not {type(config).__name__}")


def plain_block(block: Mapping[str, Any], where: str) -> dict[str, Any]:
    """Plain values of a part of a configuration. Raises TypeError for objects."""
    reader = _Reader({}, False)
    plain: dict[str, Any] = reader.plain(block, where)
    if reader.externals:
        raise TypeError(f"{where} has numbers, texts, lists and dicts, no objects")
    return plain


def text_of(value: Any, where: str) -> str:
    """Plain values as JSON on one line, which is YAML as well. Raises TypeError for objects."""
    return json.dumps(plain_of(value, where))


def plain_of(value: Any, where: str) -> Any:
    """Plain values of a part of a study. Raises TypeError for objects."""
    reader = _Reader({}, False)
    plain = reader.plain(value, where)
    if reader.externals:
        raise TypeError(
            f"{where}: a study has numbers, texts, lists and dicts, no objects; name it, "
            "{'type': 'external', 'name': 'mine'}, and give it to run_study as mine=..., or register it under a name: "
            "lc.register_cost, lc.register_solver"
        )
    return plain


def externals_of(objects: Mapping[str, Object]) -> dict[str, _leastcost.External]:
    """Objects by the names that a study has for them."""
    return _Reader(objects, False).externals


class _Reader:
    """Plain values of a configuration; objects get names."""

    def __init__(self, objects: Mapping[str, Object], cells: bool) -> None:
        self._cells = cells
        self.externals = {name: _external(value, name, cells) for name, value in objects.items()}
        self._names: dict[int, str] = {}

    def plain(self, value: Any, where: str, depth: int = 0) -> Any:
        """With None, bool, int, float, str, list and dict alone. Raises TypeError and ConfigError with the place."""
        if depth > _DEEPEST:
            raise ConfigError(f"{where[:80]}...: lies below more than {_DEEPEST} others")
        if isinstance(value, np.generic):
            value = value.item()
        if value is None or isinstance(value, (bool, float)):
            return value
        if isinstance(value, int):
            if not -_MOST <= value < _MOST:
                raise ConfigError(f"{where}: {value} is too large for a whole number; write it as a float")
            return int(value)
        if isinstance(value, (str, os.PathLike)):
            return self._text(str(os.fspath(value)), where)
        if isinstance(value, Mapping):
            return {self._key(key, where): self._entry(key, part, f"{where}[{key!r}]", depth + 1) for key, part in value.items()}
        if isinstance(value, np.ndarray) and value.dtype.kind in "fiub":
            return value.tolist()
        if isinstance(value, (list, tuple, np.ndarray)):
            return [self.plain(part, f"{where}[{i}]", depth + 1) for i, part in enumerate(value)]
        if isinstance(value, Space):
            return value.config()
        if isinstance(value, type):
            raise TypeError(f"{where} is the class {value.__name__}; write {value.__name__}(...)")
        if isinstance(value, _OBJECTS) or callable(value):
            return self._named(value)
        raise TypeError(
            f"{where}: a configuration has numbers, texts, lists, dicts and objects of leastcost, not "
            f"{type(value).__name__}"
        )

    def _key(self, key: Any, where: str) -> str:
        if not isinstance(key, str):
            raise TypeError(f"{where}: keys are texts, not {key!r}")
        return self._text(str(key), where)

    def _text(self, text: str, where: str) -> str:
        try:
            text.encode()
        except UnicodeEncodeError:
            raise ConfigError(f"{where}: {text!r} is not a text in Unicode") from None
        return text

    def _entry(self, key: str, value: Any, where: str, depth: int) -> Any:
        """Under `initializer`, points are a first path."""
        if key == "initializer" and isinstance(value, (np.ndarray, list, tuple)):
            return self._named(points(value, where), "path")
        if key == "manifold" and isinstance(value, Robot):
            raise ConfigError(f"{where}: a robot goes under 'robot', and its configurations are 'manifold': 'robot'")
        return self.plain(value, where, depth)

    def _named(self, value: Object, kind: str | None = None) -> dict[str, str]:
        if id(value) not in self._names:
            stem = kind or ("cost" if callable(value) else type(value).__name__.lower())
            name = next(name for i in range(1, 2 + len(self.externals)) if (name := f"{stem}_{i}") not in self.externals)
            self.externals[name] = _external(value, name, self._cells)
            self._names[id(value)] = name
        return {"type": "external", "name": self._names[id(value)]}


def _reads_cells(config: Mapping[str, Any], set: Mapping[str, Any]) -> bool:
    """What interpolation="auto" of a cost map means: the rule of configurations (docs/domains.md)."""
    domain, path = config.get("manifold"), config.get("path")
    plane = isinstance(domain, Mapping) and domain.get("type") == "euclidean" and _dimension_of(domain) == 2
    ring = isinstance(path, Mapping) and bool(path.get("ring"))
    asked = {key.split(".")[0] for key in (*config, *set)}
    return plane and not ring and not asked & {"obstacles", "robot", "clearance", "solver", "post_process"}


def _dimension_of(space: Mapping[str, Any]) -> Any:
    """Without the key it is that of the box, else 2."""
    given: list[Any] = [space.get(key) for key in ("lower", "upper")]
    sides = [side for side in given if np.ndim(side) == 1]
    return space.get("dimension", len(sides[0]) if sides else 2)


def _external(value: Object, name: str, cells: bool) -> _leastcost.External:
    if isinstance(value, CostMap):
        return value._external_of(cells)
    if isinstance(value, (Mesh, Cloud, Terrain, Robot, Cost, Wind)):
        return value._external
    if isinstance(value, np.ndarray):
        return _leastcost.waypoints(points(value, name))
    if callable(value):
        return Cost(value)._external
    raise TypeError(
        f"{name} cannot be a {type(value).__name__}: give a Mesh, Cloud, Terrain, Robot, Cost, CostMap, Wind, a function "
        "that is a cost, or an array of points"
    )
