# SPDX-FileCopyrightText: 2026 The leastcost authors
# SPDX-License-Identifier: MIT
"""What configurations can have."""

from __future__ import annotations

import json
from typing import Any

from . import _leastcost


def describe(kind: str = "run", type: str = "") -> str:
    """The text of `leastcost describe`: options with their types, defaults, units and ranges.

    kind: "run" or "study", the keys of a configuration; or a kind of plug-ins, "cost", whose types are listed.
    type: one of them, "travel_time", or one that was registered.

    Raises InputError for names that are not there."""
    return _leastcost.describe(kind, type)


def schema() -> dict[str, Any]:
    """The JSON schema of configurations and studies, as of `leastcost schema`, with what was registered."""
    content: dict[str, Any] = json.loads(_leastcost.schema())
    return content
