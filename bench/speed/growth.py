#!/usr/bin/python3
"""How the cost grows with readings, placements, parameters, threads and recordings: one page of plots.

    bench/speed/growth.py PROGRAM [--against OTHER] [--folder FOLDER] [--times N] [-o docs/cost-growth.svg]

User CPU time, the least of N runs, of both programs in turns; wall time where threads are counted. Prints the figures as
tables too. Recordings are made in FOLDER by PROGRAM and kept there.
"""
import argparse
import os
import tempfile

import matplotlib

matplotlib.use("svg")
matplotlib.rcParams["svg.hashsalt"] = "artcal"
import matplotlib.pyplot as pyplot  # noqa: E402
from matplotlib import ticker  # noqa: E402

from measuring import side_by_side  # noqa: E402
from recordings import ROOT, Maker  # noqa: E402

HARMONICS = 'first_harmonic = "3 arcsec"\nsecond_harmonic = "1 arcsec"'
MODELS = {24: "dh", 36: "dh+eccentricity", 48: "dh+eccentricity+eccentricity2",
          54: "dh+eccentricity+eccentricity2+gain"}


def series(make, folder):
    """Title, what is on the axis, whether wall time counts, and its points: (x, arguments)."""
    store = os.path.join(folder, "growth.sqlite")

    def batch(count):
        def arguments():
            for ending in ("", "-wal", "-shm"):
                if os.path.exists(store + ending):
                    os.remove(store + ending)
            return ["batch", make.archive("ball-bar", count), "--store", store, "-q"]
        return arguments

    seven_axes = ROOT / "examples" / "two-socket-bar" / "recording.toml"
    yield "identify, known coordinates", "readings", False, [
        (count, ["identify", make.poses(count), "--no-leave-out", "-q"]) for count in (100, 1000, 10000, 100000)]
    yield "identify, 20 readings a placement", "placements", False, [
        (count, ["identify", make.bar(count), "--no-leave-out", "-q"]) for count in (10, 30, 100, 300, 1000)]
    yield "the same, each placement left out", "placements", False, [
        (count, ["identify", make.bar(count), "-q"]) for count in (10, 30, 100, 300)]
    yield "identify, a ball bar of 700 readings", "parameters", False, [
        (count, ["identify", make.bar(7, 25, errors=HARMONICS), "--no-leave-out", "-q", "--model", model])
        for count, model in MODELS.items()]
    yield "2,000 trials of the Monte Carlo, wall", "threads", True, [
        (count, ["uncertainty", seven_axes, "--monte-carlo", "--trials", "2000", "-q", "--threads", str(count)])
        for count in (1, 2)]
    yield "batch of ball bars of 400 readings", "recordings", False, [
        (count, batch(count)) for count in (1, 10, 30, 100)]


def measure(programs, points, times, wall):
    found = []
    for x, arguments in points:
        costs = side_by_side(programs, arguments, times, middle=min)
        found.append((x, [cost and (cost.wall if wall else cost.cpu) for cost in costs]))
    return found


def draw(axes, title, axis, found, names):
    for i, name in enumerate(names):
        there = [(x, seconds[i]) for x, seconds in found if seconds[i]]
        axes.plot([x for x, _ in there], [seconds for _, seconds in there], "o-", label=name)
    (x0, seconds), (x1, _) = found[-1], found[0]
    reference = seconds[-1]
    if reference:
        slope = -1 if axis == "threads" else 1
        axes.plot([x1, x0], [reference * (x1 / x0) ** slope, reference], ":", color="grey", label="in proportion")
    axes.set(title=title, xlabel=axis, ylabel="s", xscale="log", yscale="log")
    axes.set_xticks([x for x, _ in found], [f"{x:,}" for x, _ in found])
    axes.xaxis.set_minor_formatter(ticker.NullFormatter())
    axes.grid(True, alpha=0.3)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--against", help="another build: the state before")
    parser.add_argument("--folder")
    parser.add_argument("--times", type=int, default=3)
    parser.add_argument("-o", "--output", default=str(ROOT / "docs" / "cost-growth.svg"))
    options = parser.parse_args()
    folder = options.folder or tempfile.mkdtemp(prefix="growth-")
    programs = ([os.path.abspath(options.against)] if options.against else []) + [os.path.abspath(options.program)]
    names = ["before", "now"][-len(programs):]
    figure, axes = pyplot.subplots(3, 2, figsize=(9, 10), layout="constrained")
    for place, (title, axis, wall, points) in zip(axes.flat, series(Maker(programs[-1], folder), folder)):
        found = measure(programs, points, options.times, wall)
        print(f"\n{title}\n\n| {axis} | " + " | ".join(f"{name}, s" for name in names) + " |")
        print("|---|" + "---|" * len(names))
        for x, seconds in found:
            print(f"| {x:,} | " + " | ".join("–" if s is None else f"{s:.3f}" for s in seconds) + " |", flush=True)
        draw(place, title, axis, found, names)
    axes.flat[0].legend()
    figure.savefig(options.output, metadata={"Date": None})


if __name__ == "__main__":
    main()
