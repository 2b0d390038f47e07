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

if TYPE_CHECKING:
    from typing import Union

    Config = Union[str, os.PathLike[str], Mapping[str, Any]]


def source_of(config: Config, set: Mapping[str, Any] | None, folder: str | os.PathLike[str]) -> _leastcost.Source:
    """A path is read; a text with a line break is the configuration itself, and so is a dict."""
    assignments = [f"{key}={_text(value)}" for key, value in (set or {}).items()]
    if isinstance(config, Mapping):
        return _leastcost.Source(None, _text(config, indent=1), "config", Path(folder), assignments)
    if isinstance(config, str) and "\n" in config:
        return _leastcost.Source(None, config, "config", Path(folder), assignments)
    if isinstance(config, (str, os.PathLike)):
        return _leastcost.Source(Path(config), "", "", Path(), assignments)
    raise TypeError(f"a configuration is a path, a text or a dict, not {type(config).__name__}")


def _text(value: Any, indent: int | None = None) -> str:
    """JSON, which is YAML as well."""
    return json.dumps(value, indent=indent, default=_plain)


def _plain(value: Any) -> Any:
    """Arrays and scalars of numpy, paths."""
    if isinstance(value, (np.ndarray, np.generic)):
        return value.tolist()
    if isinstance(value, os.PathLike):
        return os.fspath(value)
    raise TypeError(f"a configuration has numbers, texts, lists and dicts, not {type(value).__name__}")
