"""The annotations, checked by mypy; the stubs against the module."""

import importlib.util
import inspect
import subprocess
import sys
import unittest

import artcal
from artcal import _native
from support import SOURCE


class TypesTest(unittest.TestCase):
    def test_mypy_accepts_the_package(self):
        if importlib.util.find_spec("mypy") is None:
            self.skipTest("mypy is not installed")
        ended = subprocess.run(
            [sys.executable, "-m", "mypy", "--strict", "--ignore-missing-imports", "--cache-dir=/dev/null", "artcal"],
            cwd=SOURCE / "python",
            capture_output=True,
            text=True,
        )
        self.assertEqual(ended.returncode, 0, ended.stdout + ended.stderr)

    def test_the_stubs_name_what_the_module_has(self):
        stubs = (SOURCE / "python" / "artcal" / "_native.pyi").read_text()
        for name in [one for one in vars(_native.Arm) if not one.startswith("_")]:
            self.assertIn(f"def {name}(", stubs)

    def test_everything_public_is_described(self):
        for name in artcal.__all__:
            if name != "__version__":
                self.assertTrue(inspect.getdoc(getattr(artcal, name)), name)


if __name__ == "__main__":
    unittest.main()
