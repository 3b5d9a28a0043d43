#!/usr/bin/python3
"""Sessions of an arm on a ball bar with one planted mistake of measuring each, for bench/inspection/confusion.py.

Shares no code with artcal: kinematics, inverse kinematics and files are written here anew, with numpy. The stylus
points at the ball within 30 degrees and the balls are touched on the upper part only, as a hand does it.

    sessions.py FOLDER KIND SEED        writes FOLDER/recording.toml, arm.toml, bar.toml, tables and planted.json
"""
import json
import math
import pathlib
import sys

import numpy as np

ARCSEC = math.pi / 180 / 3600
TIP, BALL = 3.0, 12.7  # radii, mm
POSITIONS = [0.0, 250.0123, 600.0045, 1000.0078]  # of the balls along the bar, mm

# Nominal arms: d, a, alpha (deg), tip along the last axis.
ARMS = {
    "gao": ([300, 65.5, 792.7, 65.5, 883.2, 0], [0] * 6, [90] * 6, 183.5),
    "mpe": ([376.5, 0, 750.7, 0, 500.5, 15], [0, 62.1, 0, 62.1, 0, 0], [-90, -90, 90, -90, 90, -90], 97.8),
    "seven": ([320, 0, 640, 0, 560, 0, 90], [0, 0, 45, 0, -30, 0, 0], [-90, 90, -90, 90, -90, 90, 0.0], 160.0),
}


def nominal(name):
    d, a, alpha, tip = ARMS[name]
    n = len(d)
    return {"d": np.array(d, float), "a": np.array(a, float), "theta": np.zeros(n),
            "alpha": np.radians(np.array(alpha, float)), "tip": float(tip)}


def with_errors(arm, rng, mm=0.3, rad=math.radians(0.1)):
    n = len(arm["d"])
    real = {k: np.copy(v) for k, v in arm.items()}
    for key, size in (("d", mm), ("a", mm), ("theta", rad), ("alpha", rad)):
        real[key] = arm[key] + size * rng.standard_normal(n)
    real["tip"] = arm["tip"] + mm * rng.standard_normal()
    return real


def tips_by_joints(arm, q):
    """Tips (m, 3) and stylus directions (m, 3) of joint angles q (m, n), standard Denavit-Hartenberg, and how both change
    with each joint, (m, 3, n): a joint turns all behind it about its axis."""
    m, n = q.shape
    r = np.tile(np.eye(3), (m, 1, 1))
    p = np.zeros((m, 3))
    axes, origins = np.empty((n, m, 3)), np.empty((n, m, 3))
    for i in range(n):
        axes[i], origins[i] = r[:, :, 2], p
        c, s = np.cos(q[:, i] + arm["theta"][i]), np.sin(q[:, i] + arm["theta"][i])
        ca, sa = math.cos(arm["alpha"][i]), math.sin(arm["alpha"][i])
        step = np.empty((m, 3, 3))
        step[:, 0] = np.stack([c, -s * ca, s * sa], 1)
        step[:, 1] = np.stack([s, c * ca, -c * sa], 1)
        step[:, 2] = np.array([0.0, sa, ca])
        shift = np.stack([arm["a"][i] * c, arm["a"][i] * s, np.full(m, arm["d"][i])], 1)
        p = p + (r @ shift[:, :, None])[:, :, 0]
        r = r @ step
    z = r[:, :, 2]
    tip = p + arm["tip"] * z
    moved = np.cross(axes, tip[None] - origins).transpose(1, 2, 0)
    turned = np.cross(axes, np.broadcast_to(z, axes.shape)).transpose(1, 2, 0)
    return tip, z, moved, turned


def tips(arm, q):
    """Tips and stylus directions alone."""
    return tips_by_joints(arm, q)[:2]


def postures(arm, target, direction, rng, within):
    """Joint angles with the tips at target and the stylus within an angle (rad) of direction; NaN where none is found."""
    m, n = len(target), len(arm["d"])
    found = np.full((m, n), np.nan)
    open_ = np.arange(m)
    for _ in range(40):
        k = len(open_)
        if k == 0:
            break
        # A direction of the stylus within the cone, and a start at random.
        side = rng.standard_normal((k, 3))
        axis = direction[open_]
        side -= axis * np.sum(side * axis, 1, keepdims=True)
        side /= np.linalg.norm(side, axis=1, keepdims=True)
        tilt = within * np.sqrt(rng.uniform(0, 1, (k, 1)))
        want = np.cos(tilt) * axis + np.sin(tilt) * side
        q = rng.uniform(-math.pi, math.pi, (k, n))
        for _ in range(40):
            tip, z, moved, turned = tips_by_joints(arm, q)
            f = np.concatenate([tip - target[open_], 300.0 * (z - want)], 1)
            jac = np.concatenate([moved, 300.0 * turned], 1)
            size = np.linalg.norm(f, axis=1)
            normal = jac.transpose(0, 2, 1) @ jac + (1e-9 + size[:, None, None] * 1.0) * np.eye(n)
            dq = -np.linalg.solve(normal, jac.transpose(0, 2, 1) @ f[:, :, None])[:, :, 0]
            q = q + dq * np.minimum(1.0, 0.5 / (np.max(np.abs(dq), 1, keepdims=True) + 1e-12))
        tip, z = tips(arm, q)
        good = np.linalg.norm(np.concatenate([tip - target[open_], 300.0 * (z - want)], 1), axis=1) < 1e-6
        found[open_[good]] = (q[good] + math.pi) % (2 * math.pi) - math.pi
        open_ = open_[~good]
    return found


def rotation(rng):
    q = rng.standard_normal(4)
    w, x, y, z = q / np.linalg.norm(q)
    return np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
                     [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
                     [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]])


def small_rotation(rng, angle):
    axis = rng.standard_normal(3)
    axis /= np.linalg.norm(axis)
    k = np.array([[0, -axis[2], axis[1]], [axis[2], 0, -axis[0]], [-axis[1], axis[0], 0]])
    return np.eye(3) + math.sin(angle) * k + (1 - math.cos(angle)) * k @ k


class Session:
    """Readings of one arm: rows of labels, and joint angles with their noise."""

    def __init__(self, real, rng, encoder=2 * ARCSEC, probing=0.003):
        self.real, self.rng, self.encoder, self.probing = real, rng, encoder, probing
        self.rows, self.q = [], np.zeros((0, len(real["d"])))

    def pose(self):
        reach = float(np.sum(np.abs(self.real["d"][1:])) + np.sum(np.abs(self.real["a"]))) + self.real["tip"]
        while True:
            u = self.rng.standard_normal(3)
            u /= np.linalg.norm(u)
            middle = reach * self.rng.uniform(0.25, 0.5) * u + np.array([0, 0, self.real["d"][0]])
            along = rotation(self.rng)[:, 0]
            ends = [middle + along * (s - 500.0) for s in (0.0, 1000.0)]
            if all(150 < np.linalg.norm(e - [0, 0, self.real["d"][0]]) < 0.8 * reach for e in ends):
                return middle - 500.0 * along, along

    def read(self, placement, names, centres, touches=16, radii=TIP + BALL, moved=None, moved_from=None):
        """Touches each ball; from touch number moved_from of the placement on the balls stand at `moved`."""
        count = 0
        targets, directions, rows = [], [], []
        for b, name in enumerate(names):
            up = self.rng.standard_normal(3)
            up[2] = abs(up[2]) + 1.0
            up /= np.linalg.norm(up)
            for t in range(touches):
                while True:
                    n = self.rng.standard_normal(3)
                    n /= np.linalg.norm(n)
                    if n @ up > -0.2:
                        break
                here = centres[b] if moved_from is None or count < moved_from else moved[b]
                targets.append(here + radii * n + self.probing * self.rng.standard_normal(3))
                directions.append(-n)
                rows.append([placement, name])
                count += 1
        q = postures(self.real, np.array(targets), np.array(directions), self.rng, math.radians(30))
        good = np.all(np.isfinite(q), axis=1)
        if np.sum(good) < 0.8 * len(good):
            return False
        q = q + self.encoder * self.rng.standard_normal(q.shape)
        self.rows += [row for row, ok in zip(rows, good) if ok]
        self.q = np.concatenate([self.q, q[good]])
        return True

    def bar(self, placement, wrong_ball=None, moved_by=None, moved_from=None):
        """One placement of the bar; wrong_ball = (as written, as read)."""
        names = ["0", "1", "2", "3"]
        while True:
            origin, along = self.pose()
            read = list(POSITIONS)
            if wrong_ball:
                read[wrong_ball[0]] = POSITIONS[wrong_ball[1]]
            centres = [origin + along * s for s in read]
            moved = None
            if moved_by is not None:
                middle = origin + along * 500.0
                moved = [middle + moved_by[0] @ (c - middle) + moved_by[1] for c in centres]
            if self.read(placement, names, centres, moved=moved, moved_from=moved_from):
                return


def arm_toml(arm, radius, tip_in_degrees=True):
    text = 'schema = "artcal-arm/1"\nname = "arm"\nconvention = "standard"\nunits = { length = "mm", angle = "deg" }\n'
    for i in range(len(arm["d"])):
        text += (f"\n[[joint]]\na = {arm['a'][i]:.9g}\nd = {arm['d'][i]:.9g}\ntheta = {math.degrees(arm['theta'][i]):.9g}\n"
                 f"alpha = {math.degrees(arm['alpha'][i]):.9g}\n")
    return text + f'\n[[probe]]\nname = "ball"\nl = {arm["tip"]:.9g}\nradius = {radius:.9g}\n'


def bar_toml(distances, diameter, certified_u=0.0008, unit="mm"):
    text = (f'schema = "artcal-artefact/1"\nname = "bar"\ntype = "ball bar"\nunits = {{ length = "{unit}" }}\n'
            '[certificate]\nnumber = "K-1001"\nlaboratory = "none: made up"\ndate = 2026-01-15\n')
    for name in "0123":
        text += f'\n[[feature]]\nname = "{name}"\nkind = "sphere"\ndiameter = {diameter:.9g}\n'
    for (i, j), value in distances.items():
        text += f'\n[[distance]]\nbetween = ["{i}", "{j}"]\nvalue = {value:.9g}\nU = {certified_u:.9g}\nk = 2\n'
    return text


def table(session, digits=9, unit=180 / math.pi, q=None):
    q = session.q if q is None else q
    text = "placement,feature," + ",".join(f"q{i + 1}" for i in range(q.shape[1])) + "\n"
    for (placement, feature), row in zip(session.rows, q):
        text += f"{placement},{feature}," + ",".join(f"{v * unit:.{digits}f}" for v in row) + "\n"
    return text


KINDS = ["sound", "joints_exchanged", "joint_sign", "joint_offset", "encoder_slipped", "artefact_moved",
         "features_exchanged", "wrong_feature", "tip_radius_forgotten", "tip_diameter_as_radius", "ball_diameter_as_radius",
         "angle_unit", "length_unit", "another_arm_state", "placement_names_reused", "repeated_rows", "positions_as_steps"]


def make(folder, kind, seed, noise_stated=None, placements=6):
    rng = np.random.default_rng([seed, KINDS.index(kind)])
    name = ["gao", "mpe", "seven"][seed % 3]
    if noise_stated is None:
        noise_stated = seed % 2 == 0
    arm = nominal(name)
    n = len(arm["d"])
    session = Session(with_errors(arm, rng), rng)
    planted = {"kind": kind, "seed": seed, "arm": name}
    special = int(rng.integers(placements))
    wrong = tuple(int(i) for i in rng.permutation(4)[:2])
    moved_by = (small_rotation(rng, 10 ** rng.uniform(-3, -1.5)), 10 ** rng.uniform(0.3, 1.5) * rotation(rng)[0])
    moved_from = int(rng.integers(8, 56))
    files = {}
    for p in range(placements):
        here = p == special
        session.bar(str(p), wrong_ball=wrong if here and kind == "wrong_feature" else None,
                    moved_by=moved_by if here and kind == "artefact_moved" else None,
                    moved_from=moved_from if here and kind == "artefact_moved" else None)
    q = np.copy(session.q)
    unit, radius, diameter = 180 / math.pi, TIP, 2 * BALL
    distances = {(i, j): abs(POSITIONS[j] - POSITIONS[i]) for i in range(4) for j in range(i + 1, 4)}
    joint = int(rng.integers(1, n - 1))  # a sign or offset of the first or last joint moves next to nothing
    if kind == "joints_exchanged":
        i, j = sorted(int(v) for v in rng.permutation(n)[:2])
        q[:, [i, j]] = q[:, [j, i]]
        planted["joints"] = [i + 1, j + 1]
    elif kind == "joint_sign":
        q[:, joint] *= -1
        planted["joint"] = joint + 1
    elif kind == "joint_offset":
        offset = float(rng.choice([-1, 1]) * rng.uniform(15, 120))
        q[:, joint] += math.radians(offset)
        planted.update(joint=joint + 1, degrees=offset)
    elif kind == "encoder_slipped":
        k = int(rng.integers(len(q) // 5, 4 * len(q) // 5))
        slip = float(rng.choice([-1, 1]) * 10 ** rng.uniform(-1, 0.7))
        q[k:, joint] += math.radians(slip)
        planted.update(joint=joint + 1, degrees=slip, line=k + 2)
    elif kind == "artefact_moved":
        planted.update(placement=str(special), touch=moved_from)
    elif kind == "features_exchanged":
        planted.update(placement=str(special), features=[str(i) for i in wrong])
        for row in session.rows:
            if row[0] == str(special) and row[1] in (str(wrong[0]), str(wrong[1])):
                row[1] = str(wrong[1]) if row[1] == str(wrong[0]) else str(wrong[0])
    elif kind == "wrong_feature":
        planted.update(placement=str(special), written=str(wrong[0]), read=str(wrong[1]))
    elif kind == "tip_radius_forgotten":
        radius = 0.0
    elif kind == "tip_diameter_as_radius":
        radius = 2 * TIP
    elif kind == "ball_diameter_as_radius":
        diameter = BALL if seed % 2 else 4 * BALL
    elif kind == "angle_unit":
        unit = 1.0
    elif kind == "length_unit":
        distances = {key: value / 25.4 for key, value in distances.items()}
        diameter /= 25.4
    elif kind == "positions_as_steps":
        distances = {(i, i + 1): POSITIONS[i + 1] for i in range(3)}
    second = None
    if kind in ("another_arm_state", "placement_names_reused"):
        other = session.real if kind == "placement_names_reused" else with_errors(arm, rng, 0.5, math.radians(0.2))
        second = Session(other, rng)
        for p in range(3):
            second.bar(str(p) if kind == "placement_names_reused" else f"B{p}")
        files["second.csv"] = table(second)
    if kind == "repeated_rows":
        half = Session(session.real, rng)
        half.rows, half.q = session.rows[: len(session.rows) // 3], session.q[: len(session.rows) // 3]
        files["second.csv"] = table(half, digits=5 if seed % 2 else 9)
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    u = 0.0008 / (25.4 if kind == "length_unit" else 1)
    files["arm.toml"] = arm_toml(arm, radius)
    files["bar.toml"] = bar_toml(distances, diameter, u)
    files["first.csv"] = table(session, unit=unit, q=q)
    tables = '"first.csv"' + (', "second.csv"' if "second.csv" in files else "")
    files["recording.toml"] = (
        f'schema = "artcal-recording/1"\nname = "{kind} {seed}"\ndate = 2026-03-10\narm = "arm.toml"\n'
        f'artefacts = ["bar.toml"]\nreadings = [{tables}]\nunits = {{ joint = "deg", length = "mm" }}\n'
        + ('\n[noise]\nencoder = "2 arcsec"\nprobing = "3 um"\n' if noise_stated else ""))
    files["planted.json"] = json.dumps(planted)
    for file, text in files.items():
        (folder / file).write_text(text)


if __name__ == "__main__":
    make(sys.argv[1], sys.argv[2], int(sys.argv[3]))
