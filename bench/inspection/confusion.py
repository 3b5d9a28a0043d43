#!/usr/bin/python3
"""Table of confusion of `artcal inspect`: what is planted against what is named (docs/inspection.md).

    confusion.py PROGRAM FOLDER DRAWS [KIND …]

Sessions that are in FOLDER already are used as they are, and so is what was named of them (named.txt): a table that was
interrupted goes on. For another program take another folder.
"""
import collections
import json
import pathlib
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor

import sessions

EXPECTED = {"sound": "", "tip_radius_forgotten": "tip_radius", "tip_diameter_as_radius": "tip_radius",
            "ball_diameter_as_radius": "ball_diameter", "repeated_rows": "repeated_readings"}


def named(program, folder, kind, seed):
    where = pathlib.Path(folder) / f"{kind}-{seed}"
    if not (where / "recording.toml").exists():
        sessions.make(where, kind, seed)
    known = where / "named.txt"
    if known.exists():
        return known.read_text()
    done = subprocess.run([program, "inspect", str(where / "recording.toml"), "--json", "-"], capture_output=True)
    if done.returncode > 1:
        return f"exit {done.returncode}"
    names = ", ".join(sorted({finding["kind"] for finding in json.loads(done.stdout)["findings"]}))
    known.write_text(names)
    return names


def main():
    program, folder, draws = sys.argv[1], sys.argv[2], int(sys.argv[3])
    kinds = sys.argv[4:] or sessions.KINDS
    right = total = 0
    print("| planted | draws | named |\n|---|---|---|")
    for kind in kinds:
        with ThreadPoolExecutor(2) as pool:
            found = collections.Counter(pool.map(lambda seed: named(program, folder, kind, seed), range(draws)))
        right += found[EXPECTED.get(kind, kind)]
        total += draws
        print(f"| {kind} | {draws} | " + "; ".join(f"{name or 'nothing'} {n}" for name, n in found.most_common()) + " |",
              flush=True)
    print(f"\n{right} of {total} are named as what they are and nothing else.")


if __name__ == "__main__":
    main()
