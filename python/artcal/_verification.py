"""Verification of an arm.

Options have the names and meanings of the command line (artcal help).
"""

from __future__ import annotations

from typing import Any

from ._program import ArmFile, ArmLike, RecordingLike, recording_path, run
from .recording import PathLike
from .result import Result


def verify(
    recording: RecordingLike,
    *,
    standard: str | None = None,
    arm: ArmLike | None = None,
    specification: PathLike | None = None,
    against: PathLike | None = None,
    report: PathLike | None = None,
    allow_outside: bool = False,
) -> Result:
    """Verifies an arm: ISO 10360-12, ASME B89.4.22, sphere plate.

    Args:
        standard: iso10360-12, b89.4.22 or sphere-plate; else the recording's.
        arm: the arm to judge; else the recording's.

    Returns: result.conclusion, .values, ...; .exit_code is 1 where conformity is not shown.

    Raises:
        UsageError, BadInputError, NoSolutionError.
    """
    with ArmFile(arm) as path:
        options: dict[str, Any] = dict(
            standard=standard,
            arm=path,
            specification=specification,
            against=against,
            report=report,
            allow_outside=allow_outside,
        )
        return run("verify", [recording_path(recording, options)], options)
