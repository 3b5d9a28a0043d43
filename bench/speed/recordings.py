"""Recordings and clouds that speed is measured on, made once in a folder and kept there: by the virtual arm, or copies of
the examples."""
import pathlib
import shutil
import subprocess

import numpy

ROOT = pathlib.Path(__file__).resolve().parents[2]
SIMULATED = ROOT / "examples" / "simulate"

COORDINATES = """schema = "artcal-artefact/1"
name = "reference coordinates"
frame = "base"
units = { length = "mm" }
[[feature]]
name = "tip"
kind = "coordinates"
U = 0.02
k = 2
"""


def plan(artefacts, probings, errors="", seed=3):
    files = ", ".join(f'"{name}"' for name in artefacts)
    return f"""schema = "artcal-plan/1"
name = "speed"
arm = "arm.toml"
artefacts = [{files}]
seed = {seed}
units = {{ length = "mm", angle = "deg" }}
[errors]
length = "0.3 mm"
angle = "0.1 deg"
exact = ["a6", "d6", "d1", "theta1"]
{errors}
[noise]
encoder = "2 arcsec"
probing = "3 um"
""" + "\n".join(probings)


def probing(artefact, placements, points, repeats=1):
    """`placements` are drawn; 0: the artefact's coordinates stand in the base."""
    drawn = f"random = {placements}\n" if placements else ""
    return f"""[[placement]]
artefact = "{artefact}"
name = "{artefact}"
{drawn}[[probing]]
artefact = "{artefact}"
pattern = "spread"
points = {points}
repeats = {repeats}
"""


def pair(name, length):
    return f"""schema = "artcal-artefact/1"
name = "{name}"
units = {{ length = "mm" }}
[[feature]]
name = "0"
kind = "point"
[[feature]]
name = "1"
kind = "point"
[[distance]]
between = ["0", "1"]
value = {length:.3f}
U = 0.002
k = 2
"""


def plate(name, columns, rows, step):
    random = numpy.random.default_rng(5)
    text = f"""schema = "artcal-artefact/1"
name = "{name}"
type = "sphere plate"
units = {{ length = "mm" }}
expansion_per_K = 11.5e-6
[uncertainty]
at = {{ rule = "sqrt(a^2 + (b*L)^2)", a = "0.6 um", b = "1.0 um/m", k = 2 }}
"""
    for i in range(columns):
        for j in range(rows):
            x, y, z = numpy.array([i * step, j * step, 0.0]) + random.uniform(-0.02, 0.02, 3)
            text += f'\n[[feature]]\nname = "{i}.{j}"\nkind = "sphere"\ndiameter = {0.6 * step:g}\n'
            text += f"at = [{x:.4f}, {y:.4f}, {z:.4f}]\n"
    return text


class Maker:
    """Makes what is asked for in `folder` with `program`; what is there already is used as it is."""

    def __init__(self, program, folder):
        self.program = program
        self.folder = pathlib.Path(folder)
        self.folder.mkdir(parents=True, exist_ok=True)

    def simulated(self, name, artefacts, probings, errors="", options=()):
        made = self.folder / name
        if not made.exists():
            where = self.folder / "plans" / name
            where.mkdir(parents=True, exist_ok=True)
            shutil.copy(SIMULATED / "arm.toml", where)
            for file, text in artefacts.items():
                (where / file).write_text(text)
            (where / "plan.toml").write_text(plan(list(artefacts), probings, errors=errors))
            subprocess.run([self.program, "simulate", where / "plan.toml", "-q", "-o", made, *options], check=True)
        return made / "recording.toml"

    def poses(self, count):
        """Known coordinates of random postures."""
        artefacts = {"coordinates.toml": COORDINATES}
        return self.simulated(f"poses-{count}", artefacts, [probing("reference coordinates", 0, count)])

    def bar(self, placements, points=5, repeats=1, errors=""):
        """A ball bar of four balls."""
        artefacts = {"bar.toml": (SIMULATED / "bar.toml").read_text()}
        name = f"bar-{placements}-{4 * points * repeats}" + ("-harmonics" if errors else "")
        return self.simulated(name, artefacts, [probing("ball bar 1000", placements, points, repeats)], errors)

    def pairs(self, count):
        artefacts = {f"{i}.toml": pair(str(i), 100 + 7919 * i % 500 + 0.001 * (i % 10)) for i in range(count)}
        return self.simulated(f"pairs-{count}", artefacts, [probing(str(i), 1, 2) for i in range(count)])

    def plate(self, columns, rows, placements=7, points=5):
        artefacts = {"plate.toml": plate("plate", columns, rows, 450 / columns)}
        return self.simulated(f"plate-{columns * rows}", artefacts, [probing("plate", placements, points)])

    def archive(self, kind, count):
        """A folder of so many different recordings: simulated ball bars of 400 readings, or copies of an example."""
        made = self.folder / f"archive-{kind}-{count}"
        if made.exists():
            return made
        made.with_suffix(".part").mkdir(exist_ok=True)
        for i in range(count):
            if kind == "ball-bar":
                where = self.folder / "plans" / "archive"
                where.mkdir(parents=True, exist_ok=True)
                for file in ("arm.toml", "bar.toml"):
                    shutil.copy(SIMULATED / file, where)
                text = (SIMULATED / "plan.toml").read_text().replace("random = 7", "random = 4")
                (where / "plan.toml").write_text(text)
                subprocess.run([self.program, "simulate", where / "plan.toml", "--seed", str(i + 1), "-q", "-o",
                                made.with_suffix(".part") / str(i)], check=True)
            else:
                shutil.copytree(ROOT / "examples" / kind, made.with_suffix(".part") / str(i))
                recording = made.with_suffix(".part") / str(i) / "recording.toml"
                recording.write_text(recording.read_text() + f"\n# copy {i}\n")
        made.with_suffix(".part").rename(made)
        return made

    def scan(self, points):
        """A ball bar of three balls on a table as a scanner sees it, doubles in a binary PCD, mm; and its artefact file.
        A third of the points are on the balls, one in fifty is a mixed pixel."""
        cloud = self.folder / f"scan-{points}.pcd"
        artefact = self.folder / "bar-300.toml"
        if not cloud.exists():
            shutil.copy(ROOT / "examples" / "ball-bar-scan" / "bar.toml", artefact)
            random = numpy.random.default_rng(1)
            of_ball = points // 9
            parts = []
            for x in (0.0, 180.0213, 300.0307):
                direction = random.normal(size=(2 * of_ball, 3))
                direction /= numpy.linalg.norm(direction, axis=1)[:, None]
                direction = direction[direction[:, 2] > -0.3][:of_ball]
                parts.append(numpy.array([x, 0.0, 60.0]) + 12.7 * direction)
            rest = points - sum(len(part) for part in parts)
            table = numpy.zeros((rest, 3))
            table[:, :2] = random.uniform([-150, -150], [450, 150], size=(rest, 2))
            mixed = random.random(rest) < 0.02
            table[mixed, 2] = random.uniform(0, 60, mixed.sum())
            xyz = numpy.vstack([*parts, table])
            xyz += random.normal(scale=0.02, size=xyz.shape)
            write_pcd(cloud, xyz)
        return cloud, artefact

    def ball_cloud(self, points, outliers):
        cloud = self.folder / f"ball-{points}-{outliers}.pcd"
        if not cloud.exists():
            random = numpy.random.default_rng(2)
            direction = random.normal(size=(points, 3))
            direction /= numpy.linalg.norm(direction, axis=1)[:, None]
            direction[:, 2] = numpy.abs(direction[:, 2])
            xyz = 12.7 * direction + random.normal(scale=0.01, size=(points, 3))
            far = random.random(points) < outliers
            xyz[far] += random.normal(scale=1.0, size=(far.sum(), 3))
            write_pcd(cloud, xyz + [300.0, 200.0, 100.0])
        return cloud


def write_pcd(path, xyz):
    header = (f"# .PCD v0.7\nVERSION 0.7\nFIELDS x y z\nSIZE 8 8 8\nTYPE F F F\nCOUNT 1 1 1\nWIDTH {len(xyz)}\nHEIGHT 1\n"
              f"VIEWPOINT 0 0 0 1 0 0 0\nPOINTS {len(xyz)}\nDATA binary\n")
    with open(path, "wb") as file:
        file.write(header.encode())
        file.write(numpy.ascontiguousarray(xyz, dtype="<f8").tobytes())
