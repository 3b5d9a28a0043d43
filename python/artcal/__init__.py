"""artcal: artefact-based calibration of articulated-arm coordinate measuring machines.

Lengths are in mm, angles in rad, temperatures in degrees Celsius. Every function gives the numbers of the program's
command of the same name, bit for bit.
"""

from ._archive import batch, history, report
from ._arms import export_urdf, import_arm
from ._identification import (
    evaluate,
    identifiability,
    identify,
    inspect,
    monte_carlo,
    plan,
    simulate,
    uncertainty,
)
from ._native import Arm, __version__
from ._points import fit, points, segment
from ._verification import verify
from .errors import BadInputError, Error, NoSolutionError, UsageError
from .recording import Recording
from .result import Result, Table

__all__ = [
    "Arm",
    "BadInputError",
    "Error",
    "NoSolutionError",
    "Recording",
    "Result",
    "Table",
    "UsageError",
    "__version__",
    "batch",
    "evaluate",
    "export_urdf",
    "fit",
    "history",
    "identifiability",
    "identify",
    "import_arm",
    "inspect",
    "monte_carlo",
    "plan",
    "points",
    "report",
    "segment",
    "simulate",
    "uncertainty",
    "verify",
]
