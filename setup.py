"""Builds the Python module as a wheel through CMake; docs/manual/python.md."""

import pathlib
import re
import sys

from skbuild import setup

cmake = pathlib.Path("CMakeLists.txt").read_text()

setup(
    name="ringfilm",
    version=re.search(r"project\(ringfilm VERSION ([0-9.]+)", cmake).group(1),
    description="Mixed lubrication of the piston ring-liner conjunction",
    packages=["ringfilm"],
    package_dir={"": "python"},
    cmake_install_dir="",
    cmake_install_target="install-python",
    cmake_args=[
        "-GNinja",
        "-DRINGFILM_PYTHON=ON",
        "-DRINGFILM_TESTS=OFF",
        "-DRINGFILM_PYTHON_DATA=ON",
        "-DRINGFILM_PYTHON_INSTALL=python",
        f"-DPython3_EXECUTABLE={sys.executable}",
    ],
    python_requires=">=3.9",
    install_requires=["numpy"],
    extras_require={"tables": ["xarray", "pandas"], "figures": ["matplotlib"]},
)
