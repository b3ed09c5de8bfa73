# SPDX-FileCopyrightText: 2026 The cvo_slam authors
# SPDX-License-Identifier: BSD-3-Clause
"""Builds the Python package with CMake.

The environment variable CVO_SLAM_BUILD_FOLDER names a CMake build folder in which the module was
built already; it is taken from there.
"""

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = Path(__file__).parent.resolve()


def version() -> str:
    found = re.search(r"VERSION (\d+\.\d+\.\d+)", (ROOT / "CMakeLists.txt").read_text())
    assert found
    return found[1]


class CMakeBuild(build_ext):
    def build_extension(self, ext: Extension) -> None:
        given = os.environ.get("CVO_SLAM_BUILD_FOLDER")
        build = Path(given or self.build_temp).resolve()
        if not given:
            self.compile(build)
        (module,) = (build / "python" / "cvo_slam").glob("_cvo_slam*.so")
        target = Path(self.get_ext_fullpath(ext.name))
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(module, target)

    def compile(self, build: Path) -> None:
        options = {
            "CMAKE_BUILD_TYPE": "Release",
            "CMAKE_UNITY_BUILD": "ON",
            "CVO_SLAM_BUILD_APPS": "OFF",
            "CVO_SLAM_BUILD_PYTHON": "ON",
            "CVO_SLAM_BUILD_TESTS": "OFF",
            "CVO_SLAM_INSTALL": "OFF",
            "Python3_EXECUTABLE": sys.executable,
        }
        arguments = [f"-D{name}={value}" for name, value in options.items()]
        subprocess.run(["cmake", "-S", ROOT, "-B", build, "-G", "Ninja", *arguments], check=True)
        subprocess.run(["cmake", "--build", build, "--target", "cvo_slam_python"], check=True)


setup(
    version=version(),
    package_dir={"": "python"},
    packages=["cvo_slam"],
    package_data={"cvo_slam": ["*.pyi", "py.typed"]},
    ext_modules=[Extension("cvo_slam._cvo_slam", sources=[])],
    cmdclass={"build_ext": CMakeBuild},
    zip_safe=False,
)
