"""Arms of other programs.

Options have the names and meanings of the command line (artcal help).
"""

from __future__ import annotations

import os
import tempfile
from pathlib import Path

from . import _native
from ._native import Arm
from ._program import ArmFile, ArmLike, arguments
from .recording import PathLike


def import_arm(path: PathLike, *, base: str | None = None, tip: str | None = None, own_base: bool = False) -> Arm:
    """An arm from a URDF or from a Universal Robots kinematics file (calibration.yaml), with the same tips.

    Args:
        base, tip: links of a URDF; else its root and its only leaf.
        own_base: lay the base frame on the first axis.

    Raises:
        UsageError, BadInputError: what cannot be expressed is named by its joint.
    """
    with tempfile.TemporaryDirectory(prefix="artcal-") as folder:
        made = str(Path(folder) / "arm.toml")
        options = dict(output=made, base=base, tip=tip, own_base=own_base, quiet=True)
        _native.run(["arm", "import", *arguments(options), "--", os.fspath(path)])
        return Arm.from_file(made)


def export_urdf(arm: ArmLike, path: PathLike, *, digits: int | None = None, steps: str | None = None) -> None:
    """Writes an arm as a URDF with the same tips.

    Args:
        digits: decimals of a mm and of a degree to round to.
        steps: to round to, such as "length=0.001in,angle=19.8arcsec".

    Raises:
        UsageError, BadInputError: what a URDF cannot express is named by its joint.
    """
    with ArmFile(arm) as source:
        options = dict(urdf=True, output=path, digits=digits, steps=steps, quiet=True)
        _native.run(["arm", "export", *arguments(options), "--", str(source)])
