# SPDX-FileCopyrightText: 2026 The leastcost authors
# SPDX-License-Identifier: MIT
"""What leastcost raises. An exception means that the question could not be asked; a path that is found and not proved
is a result (Result.failures)."""

from __future__ import annotations

from typing import Any


class Error(Exception):
    """Root of everything below."""


class ConfigError(Error, ValueError):
    """A configuration is not valid. The text is that of the command line program, every error with its place.

    diagnostics: one dict per error with where ("torus.yaml:12:5"), line and column (from 1), length (bytes), message.
    """

    def __init__(self, text: str, diagnostics: list[dict[str, Any]] | None = None) -> None:
        super().__init__(text)
        self.diagnostics = diagnostics or []


class InputError(Error, ValueError):
    """A file, a mesh, a point or an array is unreadable or invalid; the text says what was found."""


class NoPathError(Error):
    """There is no path between the ends, or none was found to begin with; the text says what was tried."""


class TimeLimitError(Error, TimeoutError):
    """The time was up before there was a path."""


class OutputError(Error, OSError):
    """Files cannot be written; the text says why."""
