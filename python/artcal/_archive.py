"""Many recordings, what changed between them, and reports.

Options have the names and meanings of the command line (artcal help).
"""

from __future__ import annotations

import os
import tempfile
from pathlib import Path
from typing import Any, Sequence

from . import _native
from ._program import Progress, run
from .recording import PathLike
from .result import Result


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
    return run("batch", [os.fspath(path) for path in recordings], options, progress)


def history(arm: str, store: PathLike, *, all_changes: bool = False) -> Result:
    """What changed between the calibrations of an arm.

    Args:
        arm: its name, as its file states it.
        all_changes: not only the significant ones.

    Raises:
        UsageError, BadInputError, NoSolutionError.
    """
    return run("history", [arm], {"store": store, "all": all_changes})


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
