"""Points and features fitted to them.

Options have the names and meanings of the command line (artcal help).
"""

from __future__ import annotations

import os
from typing import Any

from ._program import ArmFile, ArmLike, RecordingLike, recording_path, run
from .recording import PathLike
from .result import Result


def fit(points: PathLike, *, shape: str, unit: str, **options: Any) -> Result:
    """Fits one feature to a file of points.

    Args:
        points: PCD, PLY or a table of x y z.
        shape: sphere, plane, line, circle, cylinder or cone.
        unit: of the coordinates in the file: mm, um, m or in.
        options: of `artcal fit`, such as criterion="minimum-zone", robust=True, diameter="25.4 mm".

    Raises:
        UsageError, BadInputError, NoSolutionError.
    """
    return run("fit", [os.fspath(points)], dict(shape=shape, unit=unit, **options))


def segment(scan: PathLike, *, artefact: PathLike, **options: Any) -> Result:
    """Finds an artefact's spheres and planes in a scan. Options are those of `artcal segment`, such as unit="mm"."""
    return run("segment", [os.fspath(scan)], dict(artefact=artefact, **options))


def points(recording: RecordingLike, *, arm: ArmLike | None = None, **options: Any) -> Result:
    """Coordinates of a recording's tips, by an arm. Options are those of `artcal points`."""
    with ArmFile(arm) as path:
        options["arm"] = path
        return run("points", [recording_path(recording, options)], options)
