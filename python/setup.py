# SPDX-FileCopyrightText: 2026 The leastcost authors
# SPDX-License-Identifier: MIT
"""`pip install ./python`: CMake builds the compiled part. What Debian has needs no network:

    pip install --no-build-isolation --no-index ./python

It compiles the libraries, with all cores, in python/build, which a later build reuses. `pip -v` shows the progress.
LEASTCOST_BUILD_DIR: another build folder, from the root of the tree, such as build/release, whose options stay as they
are. CMAKE_ARGS: options for CMake. LEASTCOST_JOBS: compilers at a time.

A new build leaves out Ceres, OMPL and GDAL, which would bring tens of libraries into a wheel, and the 3D view of
reports, which needs a network: CMAKE_ARGS="-DLEASTCOST_WITH_CERES=ON" and so on has them.
"""

import os
import shlex
import shutil
import subprocess
import sys
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

PROJECT = Path(__file__).resolve().parents[1]
NEW_BUILD = [
    "-DCMAKE_BUILD_TYPE=Release",
    "-DCMAKE_CXX_FLAGS_RELEASE=-O2",
    "-DCMAKE_UNITY_BUILD=ON",
    "-DLEASTCOST_BUILD_TESTS=OFF",
    "-DLEASTCOST_INSTALL=OFF",
    "-DLEASTCOST_VIEWER=OFF",
    "-DLEASTCOST_WITH_CERES=OFF",
    "-DLEASTCOST_WITH_OMPL=OFF",
    "-DLEASTCOST_WITH_GDAL=OFF",
    "-DLEASTCOST_WITH_OCTOMAP=OFF",
]


class CMakeBuild(build_ext):
    def build_extension(self, ext: Extension) -> None:
        given = os.environ.get("LEASTCOST_BUILD_DIR")
        build = PROJECT / given if given else Path(self.build_temp).resolve()
        jobs = os.environ.get("LEASTCOST_JOBS") or str(len(os.sched_getaffinity(0)))
        options = ["-DLEASTCOST_BUILD_PYTHON=ON", f"-DPython_EXECUTABLE={sys.executable}"]
        if not (build / "CMakeCache.txt").exists():
            options += [*NEW_BUILD, *(["-G", "Ninja"] if shutil.which("ninja") else [])]
        options += shlex.split(os.environ.get("CMAKE_ARGS", ""))
        say(f"configuring {build}")
        subprocess.check_call(["cmake", "-S", PROJECT, "-B", build, *options])
        say(f"compiling in {build}, {jobs} at a time; what is compiled there already is reused")
        subprocess.check_call(["cmake", "--build", build, "--target", "leastcost_python", "--parallel", jobs])
        file = Path(self.get_ext_fullpath(ext.name))
        file.parent.mkdir(parents=True, exist_ok=True)
        module = next((build / "python/leastcost").glob("_leastcost.*so"))
        subprocess.check_call(["cmake", "-E", "copy", module, file])
        copied = [file]
        for back_end in (build / "lib/leastcost").glob("leastcost_*.so"):  # loaded when they are first asked for
            subprocess.check_call(["cmake", "-E", "copy", back_end, file.parent])
            copied.append(file.parent / back_end.name)
        if shutil.which("strip"):
            subprocess.check_call(["strip", "--strip-unneeded", *copied])
        say(f"built {file.name}, {file.stat().st_size / 1e6:.1f} MB")


def say(words: str) -> None:
    print("leastcost:", words, flush=True)


setup(ext_modules=[Extension("leastcost._leastcost", [])], cmdclass={"build_ext": CMakeBuild}, zip_safe=False)
