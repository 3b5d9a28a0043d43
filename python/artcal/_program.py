"""A command of the program called from Python: its options, its inputs, its result."""

from __future__ import annotations

import os
import tempfile
from pathlib import Path
from typing import Any, Callable, Sequence, Union

from . import _native
from ._native import Arm
from .recording import PathLike, Recording
from .result import Result

Progress = Callable[[str, int, int], object]
RecordingLike = Union[Recording, PathLike]
ArmLike = Union[Arm, PathLike]


def arguments(options: dict[str, Any]) -> list[str]:
    """Options of a command line: True is a flag, None and False are left out, sequences follow commas."""
    words: list[str] = []
    for key, value in options.items():
        name = "--" + key.replace("_", "-")
        if value is None or value is False:
            continue
        if value is True:
            words.append(name)
        elif isinstance(value, (list, tuple)):
            words += [f"{name}={','.join(str(one) for one in value)}"] if value else []
        else:
            words.append(f"{name}={os.fspath(value) if isinstance(value, os.PathLike) else value}")
    return words


def run(command: str, inputs: Sequence[str], options: dict[str, Any], progress: Progress | None = None) -> Result:
    words = [command, *arguments(options), "--json=-", "--quiet", "--", *inputs]
    exit_code, json, text = _native.run(words, progress)
    return Result(json, text, exit_code)


def recording_path(recording: RecordingLike, options: dict[str, Any]) -> str:
    if isinstance(recording, Recording):
        options["allow_outside"] = options.get("allow_outside") or recording.allow_outside
        return recording.path
    return os.fspath(recording)


class ArmFile:
    """The path of an arm; one in memory is written to a temporary file while it is used."""

    def __init__(self, arm: ArmLike | None) -> None:
        self._arm = arm
        self._folder: tempfile.TemporaryDirectory[str] | None = None

    def __enter__(self) -> str | None:
        if not isinstance(self._arm, Arm):
            return None if self._arm is None else os.fspath(self._arm)
        self._folder = tempfile.TemporaryDirectory(prefix="artcal-")
        path = Path(self._folder.name) / "arm.toml"
        path.write_text(self._arm.to_toml(), encoding="utf-8")
        return str(path)

    def __exit__(self, *_: object) -> None:
        if self._folder is not None:
            self._folder.cleanup()
