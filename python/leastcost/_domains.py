# SPDX-FileCopyrightText: 2026 The leastcost authors
# SPDX-License-Identifier: MIT
from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from collections.abc import Mapping
    from typing import Union

    #: Where points may be; a dict is what a configuration has under `manifold`.
    Domain = Union["Space", Mapping[str, Any]]


@dataclass(frozen=True)
class Space:
    """The Euclidean space of some dimension."""

    dimension: int

    def config(self) -> dict[str, Any]:
        """As in a configuration."""
        return {"type": "euclidean", "dimension": self.dimension}


class Plane(Space):
    """The Euclidean plane."""

    def __init__(self) -> None:
        super().__init__(2)

    def __repr__(self) -> str:
        return "Plane()"
