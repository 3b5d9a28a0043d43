"""Exceptions: what went wrong, in the one sentence that the program would print, and where."""

from __future__ import annotations

import re


class Error(Exception):
    """A refusal.

    Attributes:
        message: one sentence: what was found, what was expected, what to do.
        where: file, line and column as one text; empty where none is known.
        file, line, column: the same by parts; None where not known.
        code: the exit code of the program: 2 wrong usage, 3 bad input, 4 no solution.
    """

    code: int = 3

    def __init__(self, message: str, where: str = "") -> None:
        super().__init__(f"{where}: {message}" if where else message)
        self.message = message
        self.where = where
        place = re.fullmatch(r"(.*?)(?::(\d+))?(?::(\d+))?", where)
        assert place is not None
        self.file: str | None = place[1] or None
        self.line: int | None = int(place[2]) if place[2] else None
        self.column: int | None = int(place[3]) if place[3] else None


class UsageError(Error, ValueError):
    """The request itself is wrong: an unknown parameter name, a contradictory option."""

    code = 2


class BadInputError(Error):
    """A file cannot be read or says something impossible; nothing was computed."""

    code = 3


class NoSolutionError(Error):
    """The input is sound, but the readings do not determine what was asked for."""

    code = 4


def error_of(code: int, message: str, where: str) -> Error:
    """The exception of an exit code."""
    kinds = {2: UsageError, 4: NoSolutionError}
    return kinds.get(code, BadInputError)(message, where)
