"""Builds the Python module by CMake, with the libraries of this project in it; the rest is in pyproject.toml"""

import os
import pathlib
import re
import subprocess
import sys

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = pathlib.Path(__file__).resolve().parent


class BuildByCMake(build_ext):
    """Calls CMake in place of a compiler"""

    def build_extension(self, ext):
        folder = pathlib.Path(self.build_temp).resolve()
        folder.mkdir(parents=True, exist_ok=True)
        options = [
            "-DCMAKE_BUILD_TYPE=Release",
            "-DCMAKE_POSITION_INDEPENDENT_CODE=ON",
            "-DBUILD_SHARED_LIBS=OFF",
            "-DOMPL_CERTIFICATES_BUILD_PYTHON=ON",
            f"-DPython_EXECUTABLE={sys.executable}",
        ]
        options += [f"-DOMPL_CERTIFICATES_BUILD_{part}=OFF" for part in ("DEMOS", "TESTS", "BENCHMARKS")]
        subprocess.run(["cmake", "-S", str(ROOT), "-B", str(folder), "-G", "Ninja", *options], check=True)
        target = "ompl_certificates_python"
        subprocess.run(
            ["cmake", "--build", str(folder), "--target", target, "-j", str(os.cpu_count() or 1)], check=True
        )
        (built,) = (folder / "python" / "ompl_certificates").glob("_core*.so")
        self.copy_file(str(built), self.get_ext_fullpath(ext.name))


version = re.search(r"project\(\w+\s+VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text(encoding="utf-8"))
setup(
    version=version.group(1) if version else "0",
    ext_modules=[Extension("ompl_certificates._core", sources=[])],
    cmdclass={"build_ext": BuildByCMake},
    # Not in build/, which is CMake's.
    options={"build": {"build_base": "build-python"}},
)
