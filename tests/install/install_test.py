"""What `cmake --install` leaves: a program that finds its data wherever it lies, and a library on which the programs of
examples/cpp are built with find_package and with pkg-config."""

import json
import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

SOURCES = pathlib.Path(__file__).resolve().parents[2]
BUILD = os.environ.get("RINGFILM_BUILD", "")
CMAKE = os.environ.get("CMAKE", "cmake")

# The installed program and library alone are to be found: nothing of the checkout.
ENVIRONMENT = {name: value for name, value in os.environ.items() if name not in ("RINGFILM_DATA", "XDG_DATA_DIRS")}

STUDY = """
kind = "compare"
base = [{{ name = "new", case = "{case}" }}]
factor = [{{ key = "operating.speed", values = ["1000 rpm", "2000 rpm"] }}]
plan = {{ method = "grid" }}
"""

AS_ONE = """
cmake_minimum_required(VERSION 3.25)
project(as_one LANGUAGES CXX)
find_package(ringfilm 0.2 REQUIRED)
add_executable(as_one as_one.cpp)
target_link_libraries(as_one PRIVATE ringfilm::ringfilm)
"""


class TheInstalledPackage(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        if not BUILD:
            raise AssertionError("set RINGFILM_BUILD to the build folder")
        scratch = tempfile.TemporaryDirectory(prefix="ringfilm-install-")
        cls.addClassCleanup(scratch.cleanup)
        cls.folder = pathlib.Path(scratch.name)
        first = cls.folder / "first"
        for component in ("program", "library"):
            subprocess.run(
                [CMAKE, "--install", BUILD, "--component", component, "--prefix", str(first)],
                check=True,
                stdout=subprocess.DEVNULL,
                timeout=120,
            )
        cls.prefix = cls.folder / "elsewhere" / "prefix"  # all of it can be moved
        cls.prefix.parent.mkdir()
        first.rename(cls.prefix)
        cls.program = cls.prefix / "bin" / "ringfilm"
        cls.case = cls.prefix / "share" / "ringfilm" / "cases" / "styles2014" / "new.toml"

    def done(self, *words, **how):
        done = subprocess.run(
            [str(word) for word in words],
            cwd=self.folder,
            capture_output=True,
            text=True,
            timeout=500,
            **{"env": ENVIRONMENT, **how},
        )
        self.assertEqual(done.returncode, 0, f"{words}\n{done.stdout}{done.stderr}")
        return done.stdout

    def values(self, *options):
        return json.loads(self.done(self.program, "run", self.case, "--json", *options))

    def built(self, example):
        build = self.folder / example
        self.done(
            CMAKE,
            "-S",
            SOURCES / "examples" / "cpp" / example,
            "-B",
            build,
            "-G",
            "Ninja",
            f"-DCMAKE_PREFIX_PATH={self.prefix}",
        )
        self.done(CMAKE, "--build", build)
        return build / example

    def test_the_program_finds_its_data_from_its_own_place(self):
        self.assertGreater(self.values()["mean_power_loss"], 0)  # the case takes its oil from data/
        reported = self.done(self.program, "verify", "--list")
        self.assertIn("barus1893_slider", reported)

    def test_no_header_leads_outside(self):
        headers = self.prefix / "include" / "ringfilm"
        self.assertTrue((headers / "ringfilm.hpp").is_file())
        self.assertFalse((headers / "io" / "toml_scan.hpp").exists())  # what no public header leads to

    def test_one_cycle(self):
        program = self.built("one_cycle")
        reported = self.done(
            program,
            self.case,
            "result.nc",
            "page.html",
            env={**ENVIRONMENT, "XDG_DATA_DIRS": str(self.prefix / "share")},
        )
        row = next(line for line in reported.splitlines() if line.startswith("mean_power_loss"))
        self.assertEqual(row.split()[1], f"{self.values('--set', 'operating.speed=2000 rpm')['mean_power_loss']:.5g}")
        self.assertIn("the film is thinnest", reported)
        self.done(self.program, "report", self.folder / "result.nc", "--output", self.folder / "again.html")
        page = (self.folder / "page.html").read_text()
        self.assertIn("new ring", page)
        self.assertEqual(page, (self.folder / "again.html").read_text())

    def test_an_oil_of_ones_own(self):
        reported = self.done(
            self.built("own_oil"),
            self.case,
            env={**ENVIRONMENT, "RINGFILM_DATA": str(self.prefix / "share" / "ringfilm")},
        )
        lines = reported.splitlines()
        of_the_case, own = (float(lines[1].split(word)[1].split()[0]) for word in ("the case", "own law"))
        self.assertAlmostEqual(of_the_case, self.values()["mean_power_loss"], delta=1e-4)  # as it is printed
        self.assertNotEqual(of_the_case, own)
        self.assertLess(abs(own / of_the_case - 1), 0.1)  # stiffer in pressure, equal at none
        self.assertIn("inner loop: yes", lines[2])
        self.assertIn("Doolittle on Tait's volume", reported)
        first = next(line for line in lines if line.startswith("scenario 0:"))
        # Lanes of a vector add in another order than a case that is integrated alone.
        self.assertAlmostEqual(float(first.split()[2]), own, delta=1e-3)

    def test_a_batch(self):
        reported = self.done(
            self.built("batch"),
            self.case,
            "20",
            env={**ENVIRONMENT, "RINGFILM_DATA": str(self.prefix / "share" / "ringfilm")},
        )
        self.assertIn("20 scenarios, 0 not solved", reported)
        self.assertIn("scenario 18:", reported)

    def test_the_other_examples(self):
        folders = SOURCES / "examples" / "cpp"
        cases = self.prefix / "share" / "ringfilm" / "cases"
        (self.folder / "study.toml").write_text(STUDY.format(case=self.case))
        arguments = {
            "assumptions": [self.case],
            "gas": [cases / "ring-pack" / "two_rings.toml"],
            "life": [cases / "life" / "styles2014.toml"],
            "pack": [cases / "ring-pack" / "three_rings.toml"],
            "study": ["study.toml"],
            "surface": [cases / "measured" / "ring_new.x3p", cases / "measured" / "liner.sur"],
            "sweep": [self.case],
        }
        self.assertEqual({folder.name for folder in folders.iterdir()}, {"batch", "one_cycle", "own_oil", *arguments})
        project = (folders / "one_cycle" / "CMakeLists.txt").read_text()
        for name in arguments:
            with self.subTest(name):
                expected = project.replace("one_cycle", name)
                self.assertEqual((folders / name / "CMakeLists.txt").read_text(), expected)
        program = self.built_as_one([folders / name / f"{name}.cpp" for name in arguments])
        env = {**ENVIRONMENT, "RINGFILM_DATA": str(self.prefix / "share" / "ringfilm")}
        for name, words in arguments.items():
            with self.subTest(name):
                self.assertRegex(self.done(program, name, *words, env=env), r"\d (kPa|MPa|bar)\b")

    def built_as_one(self, sources):
        """A program whose first argument names the example. The headers of the library are compiled once for all."""
        folder = self.folder / "as_one"
        folder.mkdir()
        lines = [line for source in sources for line in source.read_text().splitlines()]
        text = sorted({line for line in lines if line.startswith("#include <")} | {"#include <string_view>"})
        text += ['#include "ringfilm/ringfilm.hpp"']
        for source in sources:  # each in a namespace of its own: all of them have a function main
            text += [
                f"namespace example_{source.stem} {{",
                "#define main run",
                f'#include "{source}"',
                "#undef main",
                "}",
            ]
        text += ["int main(int argc, char** argv) {", '  const std::string_view name = argc > 1 ? argv[1] : "";']
        for name in (source.stem for source in sources):
            text += [f'  if (name == "{name}") return example_{name}::run(argc - 1, argv + 1);']
        (folder / "as_one.cpp").write_text("\n".join([*text, "  return 2;", "}", ""]))
        (folder / "CMakeLists.txt").write_text(AS_ONE)
        build = folder / "build"
        self.done(CMAKE, "-S", folder, "-B", build, "-G", "Ninja", f"-DCMAKE_PREFIX_PATH={self.prefix}")
        self.done(CMAKE, "--build", build)
        return build / "as_one"

    def test_by_pkg_config(self):
        if shutil.which("pkg-config") is None:
            print(f"\nSKIPPED {self.id()}: pkg-config is not installed", flush=True)
            self.skipTest("no pkg-config")
        pc = next(self.prefix.rglob("ringfilm.pc"))
        env = {**ENVIRONMENT, "PKG_CONFIG_PATH": str(pc.parent)}
        flags = self.done("pkg-config", "--cflags", "--libs", "ringfilm", env=env).split()
        source = SOURCES / "examples" / "cpp" / "one_cycle" / "one_cycle.cpp"
        self.done(
            os.environ.get("CXX", "g++"),
            "-std=c++20",
            *os.environ.get("CXXFLAGS", "").split(),
            source,
            *flags,
            "-o",
            "by_pkg_config",
            env=env,
        )
        reported = self.done(
            self.folder / "by_pkg_config",
            self.case,
            "p.nc",
            "p.html",
            env={**ENVIRONMENT, "RINGFILM_DATA": str(self.prefix / "share" / "ringfilm")},
        )
        self.assertIn("mean_power_loss", reported)


class ThePackages(unittest.TestCase):
    def configured(self, *options):
        with tempfile.TemporaryDirectory(prefix="ringfilm-packages-") as folder:
            return subprocess.run(
                [CMAKE, "-G", "Ninja", "-S", str(SOURCES), "-B", folder, "-DCMAKE_BUILD_TYPE=Release"]
                + [
                    "-DRINGFILM_TESTS=OFF",
                    "-DRINGFILM_PACKAGES=ON",
                    "-DCMAKE_DISABLE_FIND_PACKAGE_pybind11=ON",
                    *options,
                ],
                capture_output=True,
                text=True,
                timeout=300,
            )

    def test_without_what_the_python_module_needs_they_are_not_made(self):
        done = self.configured("-DRINGFILM_PYTHON=ON")
        self.assertNotEqual(done.returncode, 0)
        words = " ".join(done.stderr.split())
        self.assertIn("python3-ringfilm cannot be made: pybind11-dev or python3-dev is missing", words)
        self.assertEqual(self.configured("-DRINGFILM_PYTHON=OFF").returncode, 0)
        # The remedy is one that exists.
        self.assertIn("script/bootstrap --python", words)
        listed = subprocess.run(
            [SOURCES / "script" / "bootstrap", "--python", "--list"], capture_output=True, text=True, timeout=60
        )
        self.assertIn(listed.returncode, (0, 1), listed.stderr)


if __name__ == "__main__":
    unittest.main()
