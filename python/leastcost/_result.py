# SPDX-FileCopyrightText: 2026 The leastcost authors
# SPDX-License-Identifier: MIT
from __future__ import annotations

import json
import numbers
import os
from dataclasses import dataclass, field
from functools import cached_property
from html import escape
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from . import _leastcost
from ._arrays import largest
from ._errors import InputError, OutputError

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from numpy.typing import ArrayLike, NDArray


@dataclass(frozen=True)
class Failure:
    """Why a path is not certified: a name (docs/failures.md says of each what to do) and a sentence."""

    name: str
    message: str


@dataclass(frozen=True, eq=False)
class Trajectory:
    """A path with times, from rest to rest, sampled: the quickest motion along it under limits of velocity and
    acceleration, its corners rounded by parabolas. The limits hold at every instant; the jerk has none."""

    names: list[str]
    """Of the coordinates: the joints of a robot."""
    times: NDArray[np.float64] = field(repr=False)
    """(m,): s, from 0 to the duration."""
    positions: NDArray[np.float64] = field(repr=False)
    """(m, d): in coordinates of the domain: rad, or length units."""
    velocities: NDArray[np.float64] = field(repr=False)
    """(m, d): per s."""
    accelerations: NDArray[np.float64] = field(repr=False)
    """(m, d): per s^2."""
    duration: float
    """s."""
    least_duration: float
    """No motion between these ends is quicker under these limits, whatever its path; s."""
    deviation: float
    """The curve is nowhere farther from the path, in coordinates."""
    touches: bool
    """Whether the rounded curve comes too near to an obstacle."""
    notes: list[str] = field(repr=False, default_factory=list)
    """What a user should know about the limits."""


class Page:
    """A page of its own in a cell of a notebook."""

    def __init__(self, html: str, height: str) -> None:
        self.html = html
        self.height = height

    def _repr_html_(self) -> str:
        style = f"width:100%;height:{escape(self.height)};border:0"
        return f'<iframe srcdoc="{escape(self.html)}" style="{style}"></iframe>'

    def __repr__(self) -> str:
        return f"<a page of {len(self.html) // 1000} kB: a notebook shows it>"


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
    def details(self) -> dict[str, Any]:
        """Everything that is known, as in result.json."""
        content: dict[str, Any] = json.loads(self._outcome.json())
        return content

    @property
    def status(self) -> str:
        """"certified", "uncertified", "collapsed" or "interrupted"."""
        return str(self.details["status"])

    @property
    def certified(self) -> bool:
        """Whether every check of the certificate has passed."""
        return bool(self.details["certified"])

    @property
    def cost(self) -> float:
        """Cost of the path, in `unit`; NaN if there is no path."""
        return _number(self.details["cost"]["value"])

    @property
    def error(self) -> float:
        """Estimated error of the cost, in `unit`; NaN if not measured."""
        return _number(self.details["cost"]["error_estimate"])

    @property
    def unit(self) -> str:
        """Unit of the cost, in words: "length", "s"."""
        return str(self.details["cost"]["unit"])

    @property
    def scope(self) -> str | None:
        """What the certificate speaks of: "local", "global_on_polyhedron", ... (docs/theory/certificate.md)."""
        scope: str | None = self.details["scope"]
        return scope

    @property
    def failures(self) -> list[Failure]:
        """Why the path is not certified; empty if it is."""
        return [Failure(failure["name"], failure["message"]) for failure in self.details["failures"]]

    @property
    def certificate(self) -> dict[str, Any]:
        """What was measured, as in result.json."""
        certificate: dict[str, Any] = self.details["certificate"]
        return certificate

    @property
    def notes(self) -> list[str]:
        """What a user should know about the search."""
        return list(self.details["notes"])

    def trajectory(
        self,
        *,
        velocity: ArrayLike | None = None,
        acceleration: ArrayLike | None = None,
        limits: str | os.PathLike[str] | None = None,
        interval: float = 0.01,
    ) -> Trajectory:
        """The quickest motion along the path, from rest to rest; in flat domains: the plane, space, joints of a robot.

        velocity, acceleration: largest of the coordinates, a number for all of them or (d,), per s and s^2. velocity:
          None means that of `limits`, then that of the robot's URDF; acceleration has no other default than that of
          `limits`, as no URDF has it.
        limits: the path of a joint_limits.yaml of MoveIt, for robots whose joints have names. Its scaling factors hold,
          as MoveIt moves; the trajectory's notes say so.
        interval: s, between two samples.

        Raises InputError for limits that do not fit and for other domains, OutputError for a result that was pickled.
        """
        if not 0 < interval < float("inf"):
            raise InputError(f"interval is {interval}; it must be a number of seconds above 0")
        return Trajectory(
            **self._outcome.trajectory(
                largest(velocity, "velocity"),
                largest(acceleration, "acceleration"),
                None if limits is None else Path(limits),
                interval,
            )
        )

    def write(self, folder: str | os.PathLike[str], *, replace: bool = False) -> Path:
        """Writes the files that the program writes, without its report, and returns their folder.

        replace: a folder of an earlier run may be replaced. Raises OutputError."""
        return self._outcome.write(Path(folder), replace)

    def report(self) -> str:
        """The text of report.html, as the program makes it: a page of its own, without network."""
        return _leastcost.report(self._outcome)

    def page(self, *, height: str = "45em") -> Page:
        """The report in a cell of a notebook, where it answers clicks as in a browser. height: of the cell, in CSS."""
        return Page(self.report(), height)

    def figure(self, *, width: float = 84, font_size: float = 8) -> str:
        """The picture that `leastcost figure` makes, as SVG. width: mm; font_size: pt. To restyle one, see plot().

        Raises InputError where that size leaves no room, or where there is no path."""
        for name, value in (("width", width), ("font_size", font_size)):
            if not isinstance(value, numbers.Real):
                raise TypeError(f"{name} is a number, {'mm' if name == 'width' else 'pt'}, not {value!r}")
        return _leastcost.figure(self._outcome, float(width), float(font_size))

    def plot(self, ax: Axes | None = None, **style: Any) -> Axes:
        """Draws the path and what surrounds it with matplotlib, and returns the axes.

        In the plane: obstacles and their clearance, the cost per unit of length, a terrain seen from above. In space:
        the surface or the cloud, and the path on top of it. Robots: poses, where the configuration has one. Otherwise,
        beyond three dimensions: each coordinate over the share of the cost.

        ax: None makes new axes; of a picture in space they need projection="3d". style: of the path, as for Axes.plot.
        Raises ImportError without matplotlib."""
        from ._plot import plot

        return plot(self, json.loads(_leastcost.scene(self._outcome)), ax, style)

    def __repr__(self) -> str:
        return f"<leastcost.Result {self.status}: {self._cost_in_words()}, {len(self.points)} points>"

    def _repr_html_(self) -> str:
        """For notebooks: cost, verdict and picture."""
        name = escape(str(self.details["name"]))
        lines = [f"<b>{name}</b>: {escape(self._cost_in_words())}", escape(self._verdict())]
        if len(self.points):
            try:
                lines.append(self.figure(width=120))
            except OutputError as e:  # of a result that was pickled
                lines.append(escape(str(e)))
        return '<div style="background:#fff;color:#222;max-width:40em;padding:.5em">' + "<br>".join(lines) + "</div>"

    def _cost_in_words(self) -> str:
        error = "" if np.isnan(self.error) else f" +- {self.error:.2g}"
        return f"{self.cost:.10g}{error} {self.unit}"

    def _verdict(self) -> str:
        if self.certified:
            return f"certified ({self.scope})"
        return "; ".join([self.status, *(failure.message for failure in self.failures)])


def _number(value: float | None) -> float:
    return float("nan") if value is None else float(value)
