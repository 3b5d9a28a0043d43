"""Identification of an arm, and what is known of it before and after.

Options have the names and meanings of the command line (artcal help).
"""

from __future__ import annotations

import os
from typing import Any, Sequence

from ._native import Arm
from ._program import ArmFile, ArmLike, Progress, RecordingLike, recording_path, run
from .recording import PathLike
from .result import Result


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
    return run("identify", [recording_path(recording, options)], options, progress)


def evaluate(recording: RecordingLike, *, arm: ArmLike | None = None, allow_outside: bool = False) -> Result:
    """Evaluates an arm as it is on readings, such as an identified one on new readings.

    Args:
        arm: the arm to evaluate; else the recording's.

    Returns: result.evaluation, .readings, .warnings, in mm (docs/result-schema.md, evaluation_result). A warning says
    where the arm was identified from these readings.

    Raises:
        UsageError, BadInputError, NoSolutionError.
    """
    with ArmFile(arm) as path:
        options: dict[str, Any] = dict(arm=path, allow_outside=allow_outside)
        return run("evaluate", [recording_path(recording, options)], options)


def inspect(recording: RecordingLike, *, fit: bool = True, allow_outside: bool = False) -> Result:
    """Looks for mistakes of measuring in a recording before anything is solved.

    Args:
        fit: also try what needs a quick fit: orders, signs, units, labels, radii.

    Returns: result.findings, .remarks, ...; .exit_code is 1 where a mistake is found.

    Raises:
        UsageError, BadInputError, NoSolutionError.
    """
    options: dict[str, Any] = dict(no_fit=not fit, allow_outside=allow_outside)
    return run("inspect", [recording_path(recording, options)], options)


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
        with ArmFile(subject) as path:
            return run("coupling", [str(path)], options)
    return run("coupling", [recording_path(subject, options)], options)


def uncertainty(arm: ArmLike, **options: Any) -> Result:
    """Measurement uncertainty of an identified arm: points, lengths, volume.

    Options are those of `artcal uncertainty`, such as encoder_noise="2 arcsec", probing_noise="3 um", lengths=200.
    """
    with ArmFile(arm) as path:
        return run("uncertainty", [str(path)], options)


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
    return run("uncertainty", [recording_path(recording, more)], more, progress)


def plan(subject: ArmLike, *, encoder_noise: str, probing_noise: str, **options: Any) -> Result:
    """Proposes placements and postures of the next readings.

    Args:
        subject: an arm (with artefact=...), or a plan.toml.
        options: of `artcal plan`, such as artefact="bar.toml", placements=4, floor="-700 mm".
    """
    with ArmFile(subject) as path:
        return run("plan", [str(path)], dict(encoder_noise=encoder_noise, probing_noise=probing_noise, **options))


def simulate(plan: PathLike, folder: PathLike, *, force: bool = False, **options: Any) -> Result:
    """Writes a recording made by a virtual arm into a folder, with its true values; returns the truth."""
    return run("simulate", [os.fspath(plan)], dict(output=folder, force=force, **options))
