# SPDX-FileCopyrightText: 2026 The leastcost authors
# SPDX-License-Identifier: MIT
"""`pip install ./python`: CMake builds the compiled part. What Debian has needs no network:

    pip install --no-build-isolation --no-index ./python

LEASTCOST_BUILD_DIR: a build folder to use (and to keep); CMAKE_ARGS: options for CMake.
"""

import os
import shlex
import subprocess
import sys
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

PROJECT = Path(__file__).resolve().parents[1]
NEW_BUILD = [
    "-DCMAKE_BUILD_TYPE=Release",
    "-DCMAKE_UNITY_BUILD=ON",
    "-DLEASTCOST_BUILD_APP=OFF",
    "-DLEASTCOST_BUILD_TESTS=OFF",
]


class CMakeBuild(build_ext):
    def build_extension(self, ext: Extension) -> None:
        given = os.environ.get("LEASTCOST_BUILD_DIR")
        build = Path(given or self.build_temp).resolve()
        options = ["-DLEASTCOST_BUILD_PYTHON=ON", f"-DPython_EXECUTABLE={sys.executable}"]
        if not given:
            options += NEW_BUILD
        options += shlex.split(os.environ.get("CMAKE_ARGS", ""))
        subprocess.check_call(["cmake", "-S", PROJECT, "-B", build, "-G", "Ninja", *options])
        subprocess.check_call(["cmake", "--build", build, "--target", "leastcost_python"])
        file = Path(self.get_ext_fullpath(ext.name))
        file.parent.mkdir(parents=True, exist_ok=True)
        self.copy_file(next((build / "python/leastcost").glob("_leastcost.*so")), file)


setup(ext_modules=[Extension("leastcost._leastcost", [])], cmdclass={"build_ext": CMakeBuild}, zip_safe=False)
