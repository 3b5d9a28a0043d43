"""The notebooks run from top to bottom, and show the figures that they are for."""

import json
import os
import re
import sys
import tempfile
import unittest
from pathlib import Path

from support import EXAMPLES

NOTEBOOKS = EXAMPLES / "notebooks"


def printed_by(name):
    """Everything that the executed notebook printed or showed as text."""
    import nbformat
    from jupyter_client.kernelspec import KernelSpecManager
    from nbclient import NotebookClient

    with tempfile.TemporaryDirectory() as folder:
        # A kernel of this very interpreter, whatever kernels the machine has.
        kernel = Path(folder) / "kernels" / "artcal"
        kernel.mkdir(parents=True)
        arguments = [sys.executable, "-W", "ignore", "-m", "ipykernel_launcher", "-f", "{connection_file}"]
        (kernel / "kernel.json").write_text(
            json.dumps({"argv": arguments, "display_name": "artcal", "language": "python"})
        )
        os.environ["JUPYTER_PATH"] = folder
        os.environ["JUPYTER_RUNTIME_DIR"] = folder
        os.environ["IPYTHONDIR"] = folder
        book = nbformat.read(NOTEBOOKS / name, as_version=4)
        nbformat.validate(book)
        client = NotebookClient(
            book, timeout=300, kernel_name="artcal", resources={"metadata": {"path": str(NOTEBOOKS)}}
        )
        client.km = client.create_kernel_manager()
        client.km.kernel_spec_manager = KernelSpecManager(kernel_dirs=[str(kernel.parent)])
        client.execute()
    outputs = [output for cell in book.cells for output in cell.get("outputs", [])]
    return "\n".join(output.get("text") or output.get("data", {}).get("text/plain", "") for output in outputs)


def scatter_by_numpy():
    """Of the readings in socket 0 of the first placement about their mean, mm, with the published arm."""
    import numpy as np
    import pandas as pd

    frame = pd.read_csv(EXAMPLES / "two-socket-bar" / "readings.csv", comment="#")
    frame = frame[(frame["placement"] == "backcenter") & (frame["feature"] == 0)]
    quarter = np.pi / 2
    chain = list(zip([0, 0, 0, 82.5, -82.5, 0, 88], [0, -quarter, quarter, quarter, -quarter, quarter, quarter],
                     [333, 0, 316, 0, 384, 0, 0]))

    def tip(q):
        pose = np.eye(4)
        for (a, alpha, d), angle in zip(chain, q):
            ca, sa, c, s = np.cos(alpha), np.sin(alpha), np.cos(angle), np.sin(angle)
            pose = pose @ [[c, -s, 0, a], [s * ca, c * ca, -sa, -d * sa], [s * sa, c * sa, ca, d * ca], [0, 0, 0, 1]]
        return (pose @ [0, 0, 245, 1])[:3]

    tips = np.array([tip(q) for q in frame[[f"q{i}" for i in range(1, 8)]].to_numpy()])
    return np.sqrt(((tips - tips.mean(axis=0)) ** 2).sum(axis=1).mean())


class NotebooksTest(unittest.TestCase):
    def test_every_notebook_is_run_here(self):
        names = {path.name for path in NOTEBOOKS.glob("*.ipynb")}
        self.assertEqual(names, {"founding-paper.ipynb", "seven-axis-arm.ipynb", "where-to-measure-next.ipynb"})

    def test_no_outputs_are_stored(self):
        # They would go stale, and carry the paths of whoever ran them.
        for path in NOTEBOOKS.glob("*.ipynb"):
            for cell in json.loads(path.read_text())["cells"]:
                self.assertFalse(cell.get("outputs"), path.name)

    def test_founding_paper(self):
        text = printed_by("founding-paper.ipynb")
        self.assertIn("rank 23 of 25", text)
        self.assertIn("largest difference, mm: 0.0\n", text)
        self.assertIn("largest difference, rad: 0.0\n", text)
        self.assertIn("cells that agree to 1 um: 55 of 60", text)
        self.assertIn("largest error before 6.955 mm, after 0.0215 mm", text)
        off = float(re.search(r"from the set errors, mm or rad: (\S+)", text)[1])
        self.assertLess(off, 1e-11)

    def test_seven_axis_arm(self):
        text = printed_by("seven-axis-arm.ipynb")
        self.assertIn("25 of 31 parameters are identifiable", text)
        # By numpy alone from the arm's published parameters: a, d, alpha of its modified Denavit-Hartenberg chain.
        self.assertIn(f"backcenter   socket 0: readings of one point scatter by {scatter_by_numpy():.2f} mm", text)
        figures = re.findall(r"rms (\d\.\d+) mm, of placements left out (\d\.\d+) mm", text)
        self.assertEqual(len(figures), 2, text)
        for inside, elsewhere in figures:
            self.assertLess(float(inside), float(elsewhere))
        self.assertRegex(text, r"report.html has \d{3,} KiB")

    def test_where_to_measure_next(self):
        text = printed_by("where-to-measure-next.ipynb")
        self.assertIn("a6 alone is not; a6 is fixed", text)
        spread = [[float(x) for x in re.search(rf"{row} +(\S+)", text).groups()] for row in
                  ("as measured so far", "with this plan")]
        self.assertLess(spread[1], spread[0])


if __name__ == "__main__":
    unittest.main()
