"""What the tests share."""

import json
import os
import subprocess
import tempfile
from pathlib import Path

SOURCE = Path(os.environ["ARTCAL_SOURCE"])
EXAMPLES = SOURCE / "examples"
PROGRAM = os.environ["ARTCAL_PROGRAM"]


def json_of_command(*words):
    """What the command writes with --json."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "result.json"
        subprocess.run([PROGRAM, *map(str, words), "--json", path, "--quiet"], check=False)
        return json.loads(path.read_text())


def without_times(result):
    """Wall-clock times are all that differs from run to run."""
    return {key: value for key, value in result.items() if key != "timings_s"}


def same_numbers(test, result, *words):
    """That a result is, bit for bit, what the command writes."""
    # repr() of a dict shows every float with all its digits.
    test.assertEqual(repr(without_times(result.to_dict())), repr(without_times(json_of_command(*words))))
