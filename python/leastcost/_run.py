# SPDX-FileCopyrightText: 2026 The leastcost authors
# SPDX-License-Identifier: MIT
from __future__ import annotations

from typing import TYPE_CHECKING, Any

from . import _leastcost
from ._arrays import seconds
from ._config import source_of
from ._result import Result

if TYPE_CHECKING:
    import os
    from collections.abc import Mapping

    from ._config import Config, Object


def run(
    config: Config,
    *,
    set: Mapping[str, Any] | None = None,
    folder: str | os.PathLike[str] = "",
    max_seconds: float | None = None,
    **objects: Object,
) -> Result:
    """The path that a configuration asks for: the same as of `leastcost run`, without files.

    config: the path of a YAML file, its text (with a line break), or the same as a dict. A dict may have numbers and
      arrays of numpy, paths of files, and objects: {"manifold": mesh, "cost": q}.
    set: options that are replaced or added, as of --set: {"path.points": 200}.
    folder: what the files named in a text or a dict are relative to; empty: the current folder.
    max_seconds: wall time for the search, s; None: as the configuration says.
    objects: not named config, set, folder or max_seconds; what the configuration names, `cost: {type: external, name: chute}` as chute=...: a Mesh, Cloud or Terrain
      as a manifold; a Cost, a CostMap, a Wind or a function q(a, b) (see Cost) as a cost; an array of points, (n, d), as
      a first path. They are checked as what a configuration describes.

    Ctrl-C ends the search within 50 ms; long paths must then still be measured. The best path so far is returned, its
    status is "interrupted"; KeyboardInterrupt is raised if there is none yet. What a function raises comes out as it
    is, and so does KeyboardInterrupt within it.

    Raises ConfigError, InputError, NoPathError, TimeLimitError.
    """
    return Result(_leastcost.run(source_of(config, set=set, folder=folder, objects=objects), seconds(max_seconds)))


def validate(
    config: Config, *, set: Mapping[str, Any] | None = None, folder: str | os.PathLike[str] = "", **objects: Object
) -> None:
    """Checks a configuration without solving it. Raises ConfigError with the text of `leastcost validate`, InputError
    for a file that cannot be read. Errors of a dict have places like config['solver']['tolerence']. Arguments as of
    run()."""
    _leastcost.validate(source_of(config, set=set, folder=folder, objects=objects))
