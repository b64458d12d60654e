"""Builds the wheel of the Python module by CMake (PEP 517): what `cmake --install --component python` installs, with
the program and the shipped cases and data inside.

RINGFILM_WHEEL_BUILD names a folder where the module is built already, which is used as it is; without it, build-wheel
is configured and built.
"""

import os
import pathlib
import re
import subprocess
import sys
import sysconfig
import tempfile

SOURCES = pathlib.Path(__file__).resolve().parent.parent

METADATA = """\
Metadata-Version: 2.1
Name: ringfilm
Version: {version}
Summary: Mixed lubrication of the piston ring-liner conjunction
License: Apache-2.0
Requires-Python: >=3.9
Requires-Dist: numpy
Provides-Extra: tables
Requires-Dist: xarray; extra == "tables"
Requires-Dist: pandas; extra == "tables"
Provides-Extra: figures
Requires-Dist: matplotlib; extra == "figures"
"""


def _version():
    return re.search(r"project\(ringfilm VERSION ([0-9.]+)", (SOURCES / "CMakeLists.txt").read_text()).group(1)


def _run(*words):
    subprocess.run([str(word) for word in words], check=True, cwd=SOURCES)


def get_requires_for_build_wheel(config_settings=None):
    """Nothing beside CMake, a compiler and the libraries of script/packages.txt."""
    return []


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    """Compiles what is missing, packs the wheel into the folder. Returns its name."""
    build = SOURCES / os.environ.get("RINGFILM_WHEEL_BUILD", "build-wheel")
    if "RINGFILM_WHEEL_BUILD" not in os.environ:
        if not (build / "CMakeCache.txt").exists():
            _run(
                "cmake",
                "-S",
                SOURCES,
                "-B",
                build,
                "-GNinja",
                "-DRINGFILM_PYTHON=ON",
                "-DRINGFILM_TESTS=OFF",
                f"-DPython3_EXECUTABLE={sys.executable}",
            )
        _run("cmake", "--build", build, "--target", "ringfilm_python_stubs", "ringfilm")
    version = _version()
    with tempfile.TemporaryDirectory(prefix="ringfilm-wheel-") as scratch:
        folder = pathlib.Path(scratch)
        _run("cmake", "--install", build, "--component", "python", "--prefix", folder / "installed", "--strip")
        root = folder / "wheel"
        root.mkdir()
        module = next((folder / "installed").rglob("_ringfilm*.so")).parent
        module.rename(root / "ringfilm")
        _run("cmake", "--install", build, "--component", "program", "--prefix", folder / "program", "--strip")
        _run("cmake", "-E", "copy_directory", folder / "program" / "bin", root / "ringfilm" / "share" / "bin")
        _run("cmake", "-E", "copy_directory", SOURCES / "cases", root / "ringfilm" / "share" / "cases")
        _run("cmake", "-E", "copy_directory", SOURCES / "data", root / "ringfilm" / "share" / "data")
        _run("cmake", "-E", "copy_directory", SOURCES / "verification", root / "ringfilm" / "share" / "verification")
        info = root / f"ringfilm-{version}.dist-info"
        info.mkdir()
        (info / "METADATA").write_text(METADATA.format(version=version))
        platform = sysconfig.get_platform().replace("-", "_").replace(".", "_")
        tag = f"cp{sys.version_info.major}{sys.version_info.minor}"
        (info / "WHEEL").write_text(
            f"Wheel-Version: 1.0\nGenerator: ringfilm\nRoot-Is-Purelib: false\nTag: {tag}-{tag}-{platform}\n"
        )
        _run(sys.executable, "-m", "wheel", "pack", root, "--dest-dir", wheel_directory)
    return f"ringfilm-{version}-{tag}-{tag}-{platform}.whl"
