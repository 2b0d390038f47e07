# SPDX-FileCopyrightText: 2026 The leastcost authors
# SPDX-License-Identifier: MIT
from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Union


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


#: Where points may be; a dict is what a configuration has under `manifold`.
Domain = Union[Space, Mapping[str, Any]]
