"""Recordings from arrays: what they give is what the files give."""

import csv
import math
import tempfile
import unittest
from pathlib import Path

import numpy as np

import artcal
from support import EXAMPLES

FOLDER = EXAMPLES / "ball-bar"


def readings():
    with open(FOLDER / "readings.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    joints = np.radians([[float(row[f"q{i}"]) for i in range(1, 7)] for row in rows])
    labels = {key: [row[key] for row in rows] for key in ("placement", "feature", "orientation", "repeat")}
    return joints, labels


class RecordingTest(unittest.TestCase):
    def setUp(self):
        self.arm = artcal.Arm.from_file(str(FOLDER / "arm.toml"))
        self.joints, self.labels = readings()
        self.options = dict(
            artefacts=[FOLDER / "bar.toml"], noise={"encoder": "2 arcsec", "probing": "3 um"}, name="simulated arm"
        )

    def made(self):
        return artcal.Recording.from_arrays(self.arm, self.joints, columns=self.labels, **self.options)

    def test_arrays_identify_as_the_file_does(self):
        of_arrays = artcal.identify(self.made(), leave_out=False)
        of_file = artcal.identify(FOLDER / "recording.toml", leave_out=False)
        for ours, theirs in zip(of_arrays.parameters, of_file.parameters):
            # Degrees of the file and radians here round differently: 2e-14 rad, less than a nanometre.
            self.assertAlmostEqual(ours.identified, theirs.identified, delta=1e-8, msg=ours.name)
            self.assertEqual(ours.state, theirs.state)

    def test_the_joints_arrive_with_the_same_bits(self):
        result = artcal.identify(self.made(), leave_out=False)
        np.testing.assert_array_equal(np.array(result.to_dict()["residuals"]["joints_rad"]).T, self.joints)

    def test_a_frame_does_too(self):
        import pandas

        frame = pandas.DataFrame({**self.labels, **{f"q{i + 1}": self.joints[:, i] for i in range(6)}})
        of_frame = artcal.identify(artcal.Recording.from_frame(self.arm, frame, **self.options), leave_out=False)
        of_arrays = artcal.identify(self.made(), leave_out=False)
        self.assertEqual(of_frame.to_dict()["parameters"], of_arrays.to_dict()["parameters"])
        with self.assertRaisesRegex(artcal.UsageError, "no column 'q3'"):
            artcal.Recording.from_frame(self.arm, frame.drop(columns="q3"))

    def test_shapes_that_do_not_agree_are_refused(self):
        with self.assertRaisesRegex(artcal.UsageError, r"expected shape \(readings, 6\)"):
            artcal.Recording.from_arrays(self.arm, self.joints[:, :5])
        with self.assertRaisesRegex(artcal.UsageError, "expected 700 values, found 3"):
            artcal.Recording.from_arrays(self.arm, self.joints, columns={"feature": ["a", "b", "c"]})

    def test_errors_name_the_line(self):
        self.joints[4, 2] = math.inf
        with self.assertRaises(artcal.BadInputError) as caught:
            artcal.identify(self.made())
        self.assertEqual(caught.exception.line, 6)
        self.assertTrue(caught.exception.file.endswith("readings.csv"))

    def test_the_folder_goes_with_the_object(self):
        recording = self.made()
        folder = Path(recording.path).parent
        self.assertTrue(folder.is_dir())
        del recording
        self.assertFalse(folder.exists())


if __name__ == "__main__":
    unittest.main()
