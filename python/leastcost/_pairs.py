# SPDX-FileCopyrightText: 2026 The leastcost authors
# SPDX-License-Identifier: MIT
"""Many pairs of ends in one domain."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np

from . import _leastcost
from ._config import source_of
from ._errors import InputError
from ._places import end_tuple

if TYPE_CHECKING:
    import os
    from collections.abc import Iterable

    from numpy.typing import NDArray

    from ._config import Config, Object
    from ._places import Place


@dataclass(frozen=True, eq=False)
class PairResult:
    """The path of one pair of ends, or why there is none."""

    outcome: str
    """"certified", "uncertified", "collapsed" or "interrupted"; "no_path", "bad_pair", "error": there is no path."""
    message: str
    """Why there is no path; else empty."""
    cost: float
    """Cost of the path; NaN without one."""
    error: float
    """Its estimated error; NaN if not measured."""
    lower_bound: float
    """No path costs less; NaN where no proof was tried."""
    scope: str | None
    """What the certificate speaks of, as of Result.scope."""
    failures: list[str] = field(repr=False)
    """Names of what keeps the path from being certified (docs/failures.md)."""
    notes: list[str] = field(repr=False)
    """What a user should know about the search."""
    points: NDArray[np.float64] = field(repr=False)
    """(n, d): the points of the path in ambient coordinates; empty where they were not asked for."""
    seconds: float = field(repr=False)
    """Wall time, s."""

    @property
    def certified(self) -> bool:
        """Whether every check of the certificate has passed."""
        return self.outcome == "certified"


def solve_pairs(
    config: Config,
    pairs: Iterable[tuple[Place, Place]] | None = None,
    *,
    threads: int = 1,
    points: bool = True,
    set: Mapping[str, Any] | None = None,
    folder: str | os.PathLike[str] = "",
    **objects: Object,
) -> list[PairResult]:
    """One path for each pair of ends, in a domain that is made once; in the order of the pairs, whatever the threads.

    config, set, folder, objects: as of run(). The configuration needs ends, as for one path; the
      pairs take their place.
    pairs: (source, target) each; an end is a vertex number, (face, (b0, b1, b2)) or a point (d,). None: the pairs of
      the file that the configuration names, `ends: {pairs: FILE}`.
    threads: at once. A cost written in Python keeps them waiting for each other.
    points: whether results have the points of their paths.

    A pair that has no path, or cannot have one, is a result with a message. Ctrl-C raises KeyboardInterrupt before the
    next pair. Raises ConfigError, InputError."""
    if isinstance(threads, bool) or not isinstance(threads, (int, np.integer)) or not 1 <= threads <= 1024:
        raise InputError(f"threads is {threads!r}; it must be a whole number from 1 to 1024")
    ends = None if pairs is None else [_pair(pair, f"pairs[{i}]") for i, pair in enumerate(pairs)]
    source = source_of(config, set=set, folder=folder, objects=objects)
    return [PairResult(**result) for result in _leastcost.pairs(source, ends, threads, points)]


def _pair(pair: Any, name: str) -> tuple[Any, ...]:
    if not isinstance(pair, (tuple, list, np.ndarray)) or len(pair) != 2:
        raise InputError(f"{name} is (source, target), not {pair!r}")
    return end_tuple(pair[0], f"{name}[0]"), end_tuple(pair[1], f"{name}[1]")
