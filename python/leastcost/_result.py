# SPDX-FileCopyrightText: 2026 The leastcost authors
# SPDX-License-Identifier: MIT
from __future__ import annotations

import json
import os
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from . import _leastcost

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from numpy.typing import NDArray


@dataclass(frozen=True)
class Failure:
    """Why a path is not certified: a name (docs/failures.md says of each what to do) and a sentence."""

    name: str
    message: str


class Result:
    """A path, and what is known about it."""

    def __init__(self, outcome: _leastcost.Outcome) -> None:
        self._outcome = outcome

    @cached_property
    def points(self) -> NDArray[np.float64]:
        """(n, d): the points, equally spaced in cost, in coordinates of the domain. The first and the last are the
        ends; a ring has none. Empty if the search was interrupted before there was a path."""
        return self._outcome.points()

    @cached_property
    def curve(self) -> NDArray[np.float64]:
        """(m, d): the path as a polyline on the domain, in ambient coordinates."""
        return self._outcome.curve()

    @cached_property
    def report(self) -> dict[str, Any]:
        """The content of result.json."""
        content: dict[str, Any] = json.loads(self._outcome.json())
        return content

    @property
    def status(self) -> str:
        """"certified", "uncertified", "collapsed" or "interrupted"."""
        return str(self.report["status"])

    @property
    def certified(self) -> bool:
        """Whether every check of the certificate has passed."""
        return bool(self.report["certified"])

    @property
    def cost(self) -> float:
        """Cost of the path, in `unit`; NaN if there is no path."""
        return _number(self.report["cost"]["value"])

    @property
    def error(self) -> float:
        """Estimated error of the cost, in `unit`; NaN if not measured."""
        return _number(self.report["cost"]["error_estimate"])

    @property
    def unit(self) -> str:
        """Unit of the cost, in words: "length", "s"."""
        return str(self.report["cost"]["unit"])

    @property
    def scope(self) -> str | None:
        """What the certificate speaks of: "local", "global_on_polyhedron", ... (docs/theory/certificate.md)."""
        scope: str | None = self.report["scope"]
        return scope

    @property
    def failures(self) -> list[Failure]:
        """Why the path is not certified; empty if it is."""
        return [Failure(failure["name"], failure["message"]) for failure in self.report["failures"]]

    @property
    def certificate(self) -> dict[str, Any]:
        """What was measured, as in result.json."""
        certificate: dict[str, Any] = self.report["certificate"]
        return certificate

    @property
    def notes(self) -> list[str]:
        """What a user should know about the search."""
        return list(self.report["notes"])

    def write(self, folder: str | os.PathLike[str], *, replace: bool = False) -> Path:
        """Writes the files that the program writes, without its report, and returns their folder.

        replace: a folder of an earlier run may be replaced. Raises OutputError."""
        return self._outcome.write(Path(folder), replace)

    def plot(self, ax: Axes | None = None, **style: Any) -> Axes:
        """Draws the curve and its points with matplotlib, and returns the axes.

        ax: None makes new ones. style: of the line, as for Axes.plot. Beyond three dimensions: each coordinate over the
        share of the cost."""
        from ._plot import plot

        return plot(self, ax, **style)

    def __repr__(self) -> str:
        error = "" if np.isnan(self.error) else f" +- {self.error:.2g}"
        return f"<leastcost.Result {self.status}: {self.cost:.10g}{error} {self.unit}, {len(self.points)} points>"


def _number(value: float | None) -> float:
    return float("nan") if value is None else float(value)
