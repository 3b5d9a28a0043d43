"""Builds the compiled part with CMake; everything else stands in pyproject.toml."""

import os
import re
import subprocess
import sys
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = Path(__file__).parent.resolve()
VERSION = re.search(r"project\(artcal VERSION ([0-9.]+)", (ROOT / "CMakeLists.txt").read_text())[1]


class CMakeBuild(build_ext):
    """Builds artcal._native by CMake into the place where setuptools expects it."""

    def build_extension(self, extension):
        target = Path(self.get_ext_fullpath(extension.name)).resolve()
        build = Path(self.build_temp).resolve()
        build.mkdir(parents=True, exist_ok=True)
        configure = ["cmake", "-S", ROOT, "-B", build, "-DCMAKE_BUILD_TYPE=Release", "-DARTCAL_BUILD_PYTHON=ON"]
        configure += ["-DCMAKE_UNITY_BUILD=ON", "-DARTCAL_WARNINGS_AS_ERRORS=OFF"]
        configure += ["-DARTCAL_BUILD_TESTS=OFF", "-DARTCAL_INSTALL=OFF", f"-DPython3_EXECUTABLE={sys.executable}"]
        subprocess.run([*configure, "-G", "Ninja"], check=True)
        subprocess.run(["cmake", "--build", build, "--target", "artcal_python"], check=True)
        (made,) = (build / "python" / "artcal").glob("_native*.so")
        target.parent.mkdir(parents=True, exist_ok=True)
        os.replace(made, target)


setup(
    version=VERSION,
    packages=["artcal"],
    package_dir={"artcal": "python/artcal"},
    package_data={"artcal": ["*.pyi", "py.typed"]},
    ext_modules=[Extension("artcal._native", sources=[])],
    cmdclass={"build_ext": CMakeBuild},
)
