"""The commands of the program as functions. Options have the names and meanings of the command line (artcal help)."""

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


def _arguments(options: dict[str, Any]) -> list[str]:
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


def _run(command: str, inputs: Sequence[str], options: dict[str, Any], progress: Progress | None = None) -> Result:
    words = [command, *_arguments(options), "--json=-", "--quiet", "--", *inputs]
    exit_code, json, text = _native.run(words, progress)
    return Result(json, text, exit_code)


def _recording(recording: RecordingLike, options: dict[str, Any]) -> str:
    if isinstance(recording, Recording):
        options["allow_outside"] = options.get("allow_outside") or recording.allow_outside
        return recording.path
    return os.fspath(recording)


class _ArmFile:
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
        _native.run(["arm", "import", *_arguments(options), "--", os.fspath(path)])
        return Arm.from_file(made)


def export_urdf(arm: ArmLike, path: PathLike, *, digits: int | None = None, steps: str | None = None) -> None:
    """Writes an arm as a URDF with the same tips.

    Args:
        digits: decimals of a mm and of a degree to round to.
        steps: to round to, such as "length=0.001in,angle=19.8arcsec".

    Raises:
        UsageError, BadInputError: what a URDF cannot express is named by its joint.
    """
    with _ArmFile(arm) as source:
        options = dict(urdf=True, output=path, digits=digits, steps=steps, quiet=True)
        _native.run(["arm", "export", *_arguments(options), "--", str(source)])


def identify(
    recording: RecordingLike,
    *,
    output: PathLike | None = None,
    hold: Sequence[str] = (),
    free: Sequence[str] = (),
    model: str | None = None,
    loss: str | None = None,
    noise: str | None = None,
    encoder_noise: str | None = None,
    probing_noise: str | None = None,
    accept_misfit: bool = False,
    leave_out: bool = True,
    threads: int = 0,
    report: PathLike | None = None,
    allow_outside: bool = False,
    progress: Progress | None = None,
) -> Result:
    """Identifies an arm's parameters from its readings on artefacts.

    Args:
        recording: a recording.toml or a Recording.
        output: file for the identified arm with its covariance; Arm.from_file() reads it.
        hold, free: names of parameters to fix, or to identify although they are fixed by default.
        model: such as "dh+eccentricity+gravity" or "auto".
        noise, encoder_noise, probing_noise: such as "15 um", "2 arcsec"; else the recording's or estimated.
        progress: called with what is done, how much of it, and of how much (0 where that is not known).

    Returns: result.parameters, .covariance, .after, .residuals, ... in mm and rad (docs/result-schema.md,
    identification).

    Raises:
        UsageError, BadInputError, NoSolutionError.
    """
    options: dict[str, Any] = dict(
        output=output,
        hold=tuple(hold),
        free=tuple(free),
        model=model,
        loss=loss,
        noise=noise,
        encoder_noise=encoder_noise,
        probing_noise=probing_noise,
        accept_misfit=accept_misfit,
        no_leave_out=not leave_out,
        threads=threads,
        report=report,
        allow_outside=allow_outside,
    )
    return _run("identify", [_recording(recording, options)], options, progress)


def evaluate(recording: RecordingLike, *, arm: ArmLike | None = None, allow_outside: bool = False) -> Result:
    """Evaluates an arm as it is on readings, such as an identified one on new readings.

    Args:
        arm: the arm to evaluate; else the recording's.

    Returns: result.evaluation, .readings, .warnings, in mm (docs/result-schema.md, evaluation_result). A warning says
    where the arm was identified from these readings.

    Raises:
        UsageError, BadInputError, NoSolutionError.
    """
    with _ArmFile(arm) as path:
        options: dict[str, Any] = dict(arm=path, allow_outside=allow_outside)
        return _run("evaluate", [_recording(recording, options)], options)


def inspect(recording: RecordingLike, *, fit: bool = True, allow_outside: bool = False) -> Result:
    """Looks for mistakes of measuring in a recording before anything is solved.

    Args:
        fit: also try what needs a quick fit: orders, signs, units, labels, radii.

    Returns: result.findings, .remarks, ...; .exit_code is 1 where a mistake is found.

    Raises:
        UsageError, BadInputError, NoSolutionError.
    """
    options: dict[str, Any] = dict(no_fit=not fit, allow_outside=allow_outside)
    return _run("inspect", [_recording(recording, options)], options)


def batch(
    recordings: Sequence[PathLike],
    store: PathLike,
    *,
    resume: bool = False,
    jobs: int = 0,
    leave_out: bool = False,
    report: PathLike | None = None,
    progress: Progress | None = None,
) -> Result:
    """Identifies and verifies many recordings and keeps the results in a store.

    Args:
        recordings: recordings, or folders of them.
        store: an SQLite file or a postgresql:// address.
        resume: pass over what the store has a result of.
        jobs: recordings at once; 0: one a core. The store is the same with any.

    Returns: counts and failures; .exit_code is 1 where conformity was not shown, 3 or 4 where a recording was refused
    or had no solution.

    Raises:
        UsageError, BadInputError, NoSolutionError.
    """
    options: dict[str, Any] = dict(store=store, resume=resume, jobs=jobs, leave_out=leave_out, report=report)
    return _run("batch", [os.fspath(path) for path in recordings], options, progress)


def history(arm: str, store: PathLike, *, all_changes: bool = False) -> Result:
    """What changed between the calibrations of an arm.

    Args:
        arm: its name, as its file states it.
        all_changes: not only the significant ones.

    Raises:
        UsageError, BadInputError, NoSolutionError.
    """
    return _run("history", [arm], {"store": store, "all": all_changes})


def identifiability(
    subject: RecordingLike | Arm,
    *,
    kind: str | None = None,
    readings: int | None = None,
    features: int | None = None,
    seed: int | None = None,
    hold: Sequence[str] = (),
    free: Sequence[str] = (),
    model: str | None = None,
    allow_outside: bool = False,
) -> Result:
    """Which parameters the readings determine, and which they do not: the command `artcal coupling`.

    Args:
        subject: a recording, or an arm alone with the kind of readings to think of.
        kind: for an arm: base, frame, plate, point, distance, sphere, sphere-unknown-radius, plane,
            plane-perpendicular or length.

    Raises:
        UsageError, BadInputError, NoSolutionError.
    """
    options: dict[str, Any] = dict(
        kind=kind,
        readings=readings,
        features=features,
        seed=seed,
        hold=tuple(hold),
        free=tuple(free),
        model=model,
        allow_outside=allow_outside,
    )
    if isinstance(subject, Arm):
        with _ArmFile(subject) as path:
            return _run("coupling", [str(path)], options)
    return _run("coupling", [_recording(subject, options)], options)


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
    return _run("fit", [os.fspath(points)], dict(shape=shape, unit=unit, **options))


def segment(scan: PathLike, *, artefact: PathLike, **options: Any) -> Result:
    """Finds an artefact's spheres and planes in a scan. Options are those of `artcal segment`, such as unit="mm"."""
    return _run("segment", [os.fspath(scan)], dict(artefact=artefact, **options))


def uncertainty(arm: ArmLike, **options: Any) -> Result:
    """Measurement uncertainty of an identified arm: points, lengths, volume.

    Options are those of `artcal uncertainty`, such as encoder_noise="2 arcsec", probing_noise="3 um", lengths=200.
    """
    with _ArmFile(arm) as path:
        return _run("uncertainty", [str(path)], options)


def monte_carlo(
    recording: RecordingLike,
    *,
    trials: int | str = "auto",
    seed: int | None = None,
    threads: int = 0,
    progress: Progress | None = None,
    **options: Any,
) -> Result:
    """Identifies again and again from readings and certificates drawn anew (JCGM 101).

    Args:
        trials: how many; "auto": until the standard uncertainties are stable to their digits.

    Raises:
        UsageError, BadInputError, NoSolutionError.
    """
    more: dict[str, Any] = dict(monte_carlo=True, trials=trials, seed=seed, threads=threads, **options)
    return _run("uncertainty", [_recording(recording, more)], more, progress)


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
    with _ArmFile(arm) as path:
        options: dict[str, Any] = dict(
            standard=standard,
            arm=path,
            specification=specification,
            against=against,
            report=report,
            allow_outside=allow_outside,
        )
        return _run("verify", [_recording(recording, options)], options)


def points(recording: RecordingLike, *, arm: ArmLike | None = None, **options: Any) -> Result:
    """Coordinates of a recording's tips, by an arm. Options are those of `artcal points`."""
    with _ArmFile(arm) as path:
        options["arm"] = path
        return _run("points", [_recording(recording, options)], options)


def plan(subject: ArmLike, *, encoder_noise: str, probing_noise: str, **options: Any) -> Result:
    """Proposes placements and postures of the next readings.

    Args:
        subject: an arm (with artefact=...), or a plan.toml.
        options: of `artcal plan`, such as artefact="bar.toml", placements=4, floor="-700 mm".
    """
    with _ArmFile(subject) as path:
        return _run("plan", [str(path)], dict(encoder_noise=encoder_noise, probing_noise=probing_noise, **options))


def simulate(plan: PathLike, folder: PathLike, *, force: bool = False, **options: Any) -> Result:
    """Writes a recording made by a virtual arm into a folder, with its true values; returns the truth."""
    return _run("simulate", [os.fspath(plan)], dict(output=folder, force=force, **options))


def report(results: Result | PathLike | Sequence[Result | PathLike], path: PathLike) -> None:
    """Writes a report (HTML, prints on A4) of results of one arm."""
    several = results if isinstance(results, (list, tuple)) else [results]
    with tempfile.TemporaryDirectory(prefix="artcal-") as folder:
        files = []
        for i, result in enumerate(several):
            if isinstance(result, Result):
                files.append(str(Path(folder) / f"{i}.json"))
                result.save(files[-1])
            else:
                files.append(os.fspath(result))
        _native.run(["report", f"--output={os.fspath(path)}", "--quiet", "--", *files])
