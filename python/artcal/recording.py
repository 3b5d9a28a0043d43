"""Recordings: files, or readings in memory."""

from __future__ import annotations

import csv
import math
import os
import tempfile
from pathlib import Path
from typing import TYPE_CHECKING, Any, Mapping, Sequence, Union

import numpy as np
from numpy.typing import ArrayLike

from ._native import Arm
from .errors import UsageError

if TYPE_CHECKING:
    import pandas

PathLike = Union[str, "os.PathLike[str]"]


def _toml(text: str) -> str:
    escaped = "".join(f"\\u{ord(c):04x}" if ord(c) < 32 or c in '"\\' or ord(c) == 127 else c for c in text)
    return f'"{escaped}"'


def _field(value: Any) -> str:
    """A field of readings.csv. repr() of a float reads back to the same bits."""
    if isinstance(value, (float, np.floating)):
        return "" if math.isnan(value) else repr(float(value))
    return str(value)


class Recording:
    """Readings of one session: a recording.toml, or the same made from arrays.

    What is made from arrays lies in a temporary folder as long as the object lives: every check of files holds for it,
    and errors name its lines. Numbers are written so that they read back to the same bits.
    """

    def __init__(self, path: PathLike) -> None:
        """Names a recording.toml. It is read where it is used."""
        self.path = os.fspath(path)
        self.allow_outside = False
        self._folder: tempfile.TemporaryDirectory[str] | None = None

    @classmethod
    def from_arrays(
        cls,
        arm: Arm,
        joints: ArrayLike,
        *,
        artefacts: Sequence[PathLike] = (),
        columns: Mapping[str, Sequence[Any]] | None = None,
        noise: Mapping[str, str] | None = None,
        name: str = "recording from arrays",
        date: str | None = None,
    ) -> "Recording":
        """Makes a recording from arrays.

        Args:
            arm: the nominal arm.
            joints: joint readings as the encoders gave them, rad, shape (readings, joints).
            artefacts: paths of artefact files (docs/files.md, artefact.toml).
            columns: other columns of readings.csv, each of shape (readings,): placement, feature, orientation, repeat,
                probe, artefact, temperature, length, ref_x, ... Lengths in mm, temperatures in degC; NaN is an empty
                field.
            noise: such as {"encoder": "2 arcsec", "probing": "3 um"} or {"reading": "15 um"}; else it is estimated.
            date: of the measurement, such as "2026-03-10".

        Raises:
            UsageError: shapes that do not agree.
        """
        q = np.asarray(joints, dtype=float)
        if q.ndim != 2 or q.shape[1] != arm.joint_count:
            raise UsageError(f"joints: expected shape (readings, {arm.joint_count}), found {q.shape}")
        table: dict[str, Sequence[Any]] = dict(columns or {})
        for key, values in table.items():
            if len(values) != len(q):
                raise UsageError(f"columns[{key!r}]: expected {len(q)} values, found {len(values)}")
        table.update({f"q{i + 1}": list(q[:, i]) for i in range(q.shape[1])})
        made = cls("")
        made._folder = tempfile.TemporaryDirectory(prefix="artcal-")
        made.allow_outside = True  # artefacts stay where they are
        folder = Path(made._folder.name)
        made.path = str(folder / "recording.toml")
        (folder / "arm.toml").write_text(arm.to_toml(), encoding="utf-8")
        with open(folder / "readings.csv", "w", encoding="utf-8", newline="") as file:
            writer = csv.writer(file, lineterminator="\n")
            writer.writerow(table)
            writer.writerows([_field(value) for value in row] for row in zip(*table.values()))
        lines = ['schema = "artcal-recording/1"', f"name = {_toml(name)}", 'arm = "arm.toml"']
        lines += [f"date = {_toml(date)}"] if date else []
        paths = ", ".join(_toml(os.path.abspath(path)) for path in artefacts)
        lines += [f"artefacts = [{paths}]"] if artefacts else []
        lines += ['readings = ["readings.csv"]', 'units = { joint = "rad", length = "mm" }']
        lines += ["", "[noise]", *(f"{key} = {_toml(value)}" for key, value in noise.items())] if noise else []
        Path(made.path).write_text("\n".join(lines) + "\n", encoding="utf-8")
        return made

    @classmethod
    def from_frame(cls, arm: Arm, frame: "pandas.DataFrame", **options: Any) -> "Recording":
        """Makes a recording from a pandas frame with the columns of readings.csv; q1 ... qn in rad, lengths in mm.

        Options are those of from_arrays().
        """
        names = [f"q{i + 1}" for i in range(arm.joint_count)]
        missing = [name for name in names if name not in frame.columns]
        if missing:
            raise UsageError(f"the frame has no column {missing[0]!r}, expected {', '.join(names)}")
        others = {str(key): list(frame[key]) for key in frame.columns if key not in names}
        return cls.from_arrays(arm, frame[names].to_numpy(dtype=float), columns=others, **options)

    def __repr__(self) -> str:
        return f"<artcal.Recording {self.path!r}>"
