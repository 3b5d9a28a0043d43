"""Results: the numbers of the commands, bit for bit, over all examples."""

import tempfile
import unittest
from pathlib import Path

import artcal
from support import EXAMPLES, json_of_command, same_numbers

RECORDINGS = sorted(path for path in EXAMPLES.glob("*/recording.toml"))
WITH_JOINTS = [path for path in RECORDINGS if "[[probe]]" not in path.read_text()]
VERIFIED = [path for path in RECORDINGS if "standard" in path.read_text()]


class ResultsTest(unittest.TestCase):
    def test_every_example_is_there(self):
        self.assertGreaterEqual(len(WITH_JOINTS), 3)
        self.assertGreaterEqual(len(VERIFIED), 2)

    def test_identify(self):
        for path in WITH_JOINTS:
            with self.subTest(path=path):
                result = artcal.identify(path)
                same_numbers(self, result, "identify", path)
                self.assertEqual(result.kind, "identification")
                self.assertIn("readings", result.text)

    def test_identifiability(self):
        for path in WITH_JOINTS:
            with self.subTest(path=path):
                same_numbers(self, artcal.identifiability(path), "coupling", path)

    def test_evaluate(self):
        for path in WITH_JOINTS:
            with self.subTest(path=path):
                same_numbers(self, artcal.evaluate(path), "evaluate", path)
        path = EXAMPLES / "two-socket-bar" / "recording.toml"
        with tempfile.TemporaryDirectory() as folder:
            arm = Path(folder) / "arm.toml"
            identified = artcal.identify(path, output=arm, leave_out=False)
            evaluated = artcal.evaluate(path, arm=artcal.Arm.from_file(str(arm)))
        self.assertAlmostEqual(evaluated.evaluation.overall.rms_mm, identified.after.overall.rms_mm, places=9)
        self.assertIn("was identified from 387 of these 387 readings", evaluated.warnings[0])
        self.assertEqual(len(evaluated.to_frame("readings")), 387)
        self.assertEqual(len(evaluated.to_frame("lengths")), 6)

    def test_inspect(self):
        for path in RECORDINGS:
            with self.subTest(path=path):
                result = artcal.inspect(path)
                same_numbers(self, result, "inspect", path)
                self.assertEqual((result.exit_code, result.findings), (0, []))

    def test_batch_and_history(self):
        with tempfile.TemporaryDirectory() as folder:
            store = Path(folder) / "results.sqlite"
            result = artcal.batch([EXAMPLES / "ball-bar", EXAMPLES / "two-socket-bar"], store)
            self.assertEqual((result.kind, result.exit_code), ("batch", 0))
            name = artcal.Arm.from_file(str(EXAMPLES / "ball-bar" / "arm.toml")).name
            changes = artcal.history(name, store)
            self.assertEqual((changes.kind, changes.arm), ("history", name))
            bad = Path(folder) / "bad.toml"
            bad.write_text("schema = 1")
            again = artcal.batch([EXAMPLES / "ball-bar", bad], store, resume=True)
            self.assertEqual(again.exit_code, 3)

    def test_verify(self):
        for path in VERIFIED:
            with self.subTest(path=path):
                result = artcal.verify(path)
                same_numbers(self, result, "verify", path)
                self.assertIn(result.exit_code, (0, 1))

    def test_fit_and_segment(self):
        ball = EXAMPLES / "points" / "ball.xyz"
        same_numbers(
            self, artcal.fit(ball, shape="sphere", unit="mm"), "fit", ball, "--shape", "sphere", "--unit", "mm"
        )
        scan, bar = EXAMPLES / "ball-bar-scan" / "scan.xyz", EXAMPLES / "ball-bar-scan" / "bar.toml"
        same_numbers(
            self, artcal.segment(scan, artefact=bar, unit="mm"), "segment", scan, "--artefact", bar, "--unit", "mm"
        )

    def test_uncertainty_of_an_identified_arm(self):
        with tempfile.TemporaryDirectory() as folder:
            arm = Path(folder) / "arm.toml"
            artcal.identify(EXAMPLES / "ball-bar" / "recording.toml", output=arm, leave_out=False)
            self.assertTrue(artcal.Arm.from_file(str(arm)).is_identified)
            same_numbers(self, artcal.uncertainty(arm, lengths=20), "uncertainty", arm, "--lengths", 20)
            in_memory = artcal.uncertainty(artcal.Arm.from_file(str(arm)), lengths=20)
            from_file = artcal.uncertainty(arm, lengths=20)
            ours, theirs = dict(in_memory.to_dict()), dict(from_file.to_dict())
            for result in (ours, theirs):
                result.pop("inputs")  # another path
            self.assertEqual(ours, theirs)

    def test_monte_carlo(self):
        path = EXAMPLES / "two-socket-bar" / "recording.toml"
        result = artcal.monte_carlo(path, trials=50, seed=3)
        same_numbers(self, result, "uncertainty", path, "--monte-carlo", "--trials", 50, "--seed", 3)

    def test_plan_simulate_and_report(self):
        bar = EXAMPLES / "ball-bar" / "bar.toml"
        arm = EXAMPLES / "ball-bar" / "arm.toml"
        noise = dict(encoder_noise="2 arcsec", probing_noise="3 um")
        words = ["--encoder-noise", "2 arcsec", "--probing-noise", "3 um", "--placements", 1, "--possible", 4]
        words += ["--postures", 4, "--readings", 2, "--starts", 1]
        planned = artcal.plan(arm, artefact=bar, placements=1, possible=4, postures=4, readings=2, starts=1, **noise)
        same_numbers(self, planned, "plan", arm, "--artefact", bar, *words)
        with tempfile.TemporaryDirectory() as folder:
            truth = artcal.simulate(EXAMPLES / "simulate" / "plan.toml", Path(folder) / "made")
            self.assertEqual(truth.kind, "simulation")
            result = artcal.identify(Path(folder) / "made" / "recording.toml", leave_out=False)
            page = Path(folder) / "page.html"
            artcal.report([result], page)
            self.assertIn("<html", page.read_text()[:400])

    def test_attributes_are_the_keys_of_the_json(self):
        path = EXAMPLES / "ball-bar" / "recording.toml"
        result = artcal.identify(path, leave_out=False)
        command = json_of_command("identify", path, "--no-leave-out")
        self.assertEqual(result.parameters[0].name, command["parameters"][0]["name"])
        self.assertEqual(result.after.overall.rms_mm, command["after"]["overall"]["rms_mm"])
        self.assertEqual(result["kind"], "identification")
        self.assertIn("parameters", dir(result))
        with self.assertRaisesRegex(AttributeError, "there is no 'parametres'"):
            result.parametres

    def test_frames(self):
        result = artcal.identify(EXAMPLES / "ball-bar" / "recording.toml", leave_out=False)
        self.assertEqual(result.tables(), ["parameters", "readings", "lengths"])
        parameters = result.to_frame()
        self.assertEqual(list(parameters["name"]), [parameter.name for parameter in result.parameters])
        readings = result.to_frame("readings")
        self.assertEqual(len(readings), result.after.overall.readings)
        self.assertIn("tip_mm.3", readings.columns)
        self.assertEqual(len(result.to_frame("lengths")), len(result.after.lengths))
        with self.assertRaisesRegex(ValueError, "has no table 'verdicts'"):
            result.to_frame("verdicts")
        verified = artcal.verify(EXAMPLES / "iso10360-12" / "recording.toml")
        self.assertIn("verdict", verified.to_frame("verdicts").columns)

    def test_plots(self):
        result = artcal.identify(EXAMPLES / "ball-bar" / "recording.toml", leave_out=False)
        with tempfile.TemporaryDirectory() as folder:
            for axes in (result.plot_residuals(), result.plot_correlation(), result.plot_arm()):
                path = Path(folder) / "plot.png"
                axes.figure.savefig(path)
                self.assertGreater(path.stat().st_size, 5000)

    def test_refusals_are_exceptions_with_the_programs_sentence(self):
        with self.assertRaises(artcal.BadInputError) as caught:
            artcal.identify("gone.toml")
        self.assertIn("there is no such file", str(caught.exception))
        self.assertEqual(caught.exception.file, "gone.toml")
        with self.assertRaises(artcal.UsageError) as caught:
            artcal.identify(EXAMPLES / "ball-bar" / "recording.toml", hold=["a99"])
        self.assertEqual(caught.exception.code, 2)
        with self.assertRaisesRegex(artcal.UsageError, "there is no option"):
            artcal.fit(EXAMPLES / "points" / "ball.xyz", shape="sphere", unit="mm", nonsense=3)


if __name__ == "__main__":
    unittest.main()
