#!/usr/bin/python3
"""What each shape of work costs, beside another build of the program in the same run (docs/benchmarks.md, "All of it").

    bench/speed/speed.py PROGRAM [--against OTHER] [--folder FOLDER] [--times N] [LINE …]

Prints a table: user CPU time of all threads and wall time in seconds, medians of N runs in turns, and the ratio of CPU
times. Lines are chosen by the beginnings of their names; none: all but those of a million readings ("huge").
Recordings are made in FOLDER by PROGRAM and kept there.
"""
import argparse
import os
import tempfile

from measuring import side_by_side
from recordings import ROOT, Maker


def lines(make, folder):
    """Name, and a function that makes the input and returns the arguments."""
    store = os.path.join(folder, "store.sqlite")

    def batch(kind, count):
        def arguments():
            for ending in ("", "-wal", "-shm"):
                if os.path.exists(store + ending):
                    os.remove(store + ending)
            return ["batch", make.archive(kind, count), "--store", store, "-q"]
        return arguments

    def identify(recording, *options):
        return ["identify", recording, "-q", *options]

    def segment(points):
        cloud, artefact = make.scan(points)
        return ["segment", cloud, "--unit", "mm", "--artefact", artefact, "-q"]

    bar_noise = "first_harmonic = \"3 arcsec\"\nsecond_harmonic = \"1 arcsec\""
    seven_axes = ROOT / "examples" / "two-socket-bar" / "recording.toml"
    alone = "--no-leave-out"
    yield "start", lambda: ["--version"]
    for count in (100, 1000, 10000, 100000):
        yield f"poses {count}", lambda count=count: identify(make.poses(count), alone)
    yield "groups 491 pairs", lambda: identify(make.pairs(491))
    yield "groups plate of 300 balls, 7 placements", lambda: identify(make.plate(20, 15))
    for placements in (100, 300, 1000):
        yield f"groups ball bar, {placements} placements", lambda count=placements: identify(make.bar(count))
        yield (f"groups ball bar, {placements} placements, none left out",
               lambda count=placements: identify(make.bar(count), alone))
    yield "leave-out ball bar, 7 placements", lambda: identify(make.bar(7, 25))
    yield "leave-out seven axes", lambda: identify(seven_axes)
    yield "leave-out seven axes, none left out", lambda: identify(seven_axes, alone)
    yield "model auto, ball bar of 7 placements", lambda: identify(make.bar(7, 25, errors=bar_noise), "--model", "auto")
    yield "batch 200 ball bars", lambda: batch("ball-bar", 200)
    yield "batch 60 seven axes", lambda: batch("two-socket-bar", 60)
    yield "batch 100 verifications", lambda: batch("iso10360-12", 100)
    yield ("monte carlo 10000 trials, seven axes",
           lambda: ["uncertainty", seven_axes, "--monte-carlo", "--trials", "10000", "-q"])
    yield "scan 5 million points, segment", lambda: segment(5000000)
    for criterion, options in (("", []), (" robust", ["--robust"])):
        yield (f"scan 5 million points, fit sphere{criterion}",
               lambda options=options: ["fit", make.ball_cloud(5000000, 0.01), "--shape", "sphere", "--unit", "mm", "-q",
                                        *options])
    yield "huge million readings, 1 placement, none left out", lambda: identify(make.bar(1, 250, 1000), alone)
    yield "huge million readings, 1000 placements, none left out", lambda: identify(make.bar(1000, 25, 10), alone)
    yield "huge million readings, 1000 placements", lambda: identify(make.bar(1000, 25, 10))


def in_a_child(work):
    """A program's most memory counts from that of the process that starts it, which must therefore have made no cloud."""
    child = os.fork()
    if child == 0:
        work()
        os._exit(0)
    os.waitpid(child, 0)


def row(name, costs):
    cells = [name]
    for cost in costs:
        cells += [f"{cost.cpu:.3f}", f"{cost.wall:.3f}", f"{cost.memory:.0f}"] if cost else ["–", "–", "–"]
    if len(costs) == 2:
        cells.append(f"{costs[0].cpu / costs[1].cpu:.2f}" if costs[0] and costs[1] and costs[1].cpu > 0 else "–")
    return "| " + " | ".join(cells) + " |"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--against", help="another build: the state before")
    parser.add_argument("--folder")
    parser.add_argument("--times", type=int, default=5)
    parser.add_argument("--limit", type=float, default=900, help="seconds that a run may take")
    parser.add_argument("line", nargs="*")
    options = parser.parse_intermixed_args()
    folder = options.folder or tempfile.mkdtemp(prefix="speed-")
    make = Maker(os.path.abspath(options.program), folder)
    programs = ([os.path.abspath(options.against)] if options.against else []) + [os.path.abspath(options.program)]
    head = ["CPU, s", "wall, s", "MB"]
    titles = [f"before: {head[0]}", *head[1:], f"now: {head[0]}", *head[1:], "ratio"] if options.against else head
    print("| " + " | ".join(["", *titles]) + " |\n|---|" + "---|" * len(titles))
    for name, arguments in lines(make, folder):
        if any(name.startswith(asked) for asked in options.line) or (not options.line and not name.startswith("huge")):
            in_a_child(arguments)
            made = arguments()
            print(row(name, side_by_side(programs, made, options.times, options.limit)), flush=True)


if __name__ == "__main__":
    main()
