"""ringfilm report and reproduce: the files they make and what they refuse."""

import base64
import math
import re
import struct
import unittest
import xml.etree.ElementTree

import program


class Report(program.ProgramTest):
    def setUp(self):
        super().setUp()
        self.run_well("run", "case.toml", "--output", "a.nc")

    def test_page_is_one_file_that_names_its_case(self):
        self.run_well("run", "case.toml", "--output", "b.nc", "--set", "title=the second case")
        self.run_well("report", "a.nc", "b.nc", "--output", "page.html")
        page = (self.folder / "page.html").read_text()
        self.assertIn("a small case", page)
        self.assertIn("the second case", page)
        self.assertIsNone(re.search(r"<(?:script|link|img)[^>]*(?:src|href)=\"?https?:", page), "an outside request")

    def test_overlay_is_laid_over_and_named(self):
        (self.folder / "floating_liner.csv").write_text(
            "crank_angle [degree],friction_on_liner [N],min_film_thickness [um],friction_coefficient\n"
            "-20,10.5,1.25,0.01\n0,-3,0.8,0.1\n20,-50,0.7,0.15\n"
        )
        self.run_well("report", "a.nc", "--overlay", "floating_liner.csv", "--output", "page.html")
        self.assertIn("floating_liner", (self.folder / "page.html").read_text())

    def test_overlay_of_unknown_curve_or_unit_is_refused(self):
        cases = {
            "crank_angle [degree],friction_on_linr [N]\n0,1\n1,2\n": "friction_on_liner",
            "crank_angle [degree],friction_on_liner [um]\n0,1\n1,2\n": "friction_on_liner",
            "crank_angle [degree],friction_on_liner\n0,1\n1,2\n": "unit",
            "angle [degree],friction_on_liner [N]\n0,1\n1,2\n": "crank_angle",
            "crank_angle [degree]\n0\n1\n": "measured.csv",
        }
        for text, fragment in cases.items():
            with self.subTest(text):
                (self.folder / "measured.csv").write_text(text)
                done = self.run_program("report", "a.nc", "--overlay", "measured.csv", "--output", "page.html")
                self.assert_refused(done, "measured.csv", fragment)
                self.assertFalse((self.folder / "page.html").exists())

    def test_what_is_not_a_result_is_refused(self):
        (self.folder / "cut.nc").write_bytes((self.folder / "a.nc").read_bytes()[:20000])
        for name, fragment in (
            ("none.nc", "no such file"),
            ("case.toml", "not a NetCDF file"),
            ("cut.nc", "cut.nc"),
            (".", "folder"),
        ):
            with self.subTest(name):
                done = self.run_program("report", name, "--output", "page.html")
                self.assert_refused(done, fragment)
                self.assertFalse((self.folder / "page.html").exists())

    def test_the_page_is_named_by_output_or_by_html(self):
        self.run_well("report", "a.nc", "--output", "a.html")
        self.run_well("report", "a.nc", "--html", "b.html")
        self.assertEqual((self.folder / "a.html").read_bytes(), (self.folder / "b.html").read_bytes())

    def test_a_name_that_ends_like_another_kind_of_file_is_refused(self):
        before = self.names()
        self.assert_refused(
            self.run_program("report", "a.nc", "--output", "page.nc"),
            "--output page.nc: a web page is written here, and .nc is the ending of a NetCDF file",
            "the ending .html",
        )
        self.assert_refused(
            self.run_program("run", "case.toml", "-o", "X.HTML"),
            "--output X.HTML: a NetCDF file is written here",
            "the ending .nc",
        )
        self.assert_refused(
            self.run_program("run", "case.toml", "--output", "a.html", "--csv", "a.nc"),
            "--output a.html: a NetCDF file is written here",
            "the ending .nc",
            "--csv a.nc: a CSV file is written here",
            "the ending .csv",
        )
        self.assertEqual(self.names(), before)

    def test_a_result_with_one_changed_byte_is_refused_before_it_is_parsed(self):
        whole = (self.folder / "a.nc").read_bytes()
        step = len(whole) // 60
        for at in [*range(0, 120, 5), *range(120, len(whole), step), len(whole) - 1]:
            with self.subTest(at):
                (self.folder / "b.nc").write_bytes(whole[:at] + bytes([whole[at] ^ 1 << at % 8]) + whole[at + 1 :])
                self.assert_refused(self.run_program("report", "b.nc", "--output", "page.html"), "b.nc: ")
                self.assertFalse((self.folder / "page.html").exists())

    def test_a_result_that_another_program_changed_is_refused(self):
        try:
            import netCDF4  # noqa: F401
            import xarray
        except ImportError:
            program.skip_loudly(self, "python3-xarray and python3-netcdf4 are not installed")
        data = xarray.load_dataset(self.folder / "a.nc")
        data.attrs["title"] = "another title"
        data.to_netcdf(self.folder / "a.nc")
        self.assert_refused(
            self.run_program("report", "a.nc", "--output", "page.html"), "SHA-256 digest", "run its case again"
        )

    def test_page_never_replaces_what_it_is_drawn_from(self):
        result = (self.folder / "a.nc").read_bytes()
        self.assert_refused(self.run_program("report", "a.nc", "--output", "./a.nc"), "a.nc")
        self.assertEqual((self.folder / "a.nc").read_bytes(), result)


class FieldsForParaView(program.ProgramTest):
    UNROLLED = (
        "--set",
        "film.dimension=unrolled",
        "--set",
        "ring.end_gap=0.3 mm",
        "--set",
        "solver.cells=24",
        "--set",
        "solver.cells_y=32",
        "--set",
        "solver.crank_step=6 degree",
        "--set",
        "output.crank_angles=6 degree",
        "--set",
        'output.fields=["0 degree", "18 degree", "180 degree"]',
    )

    def test_a_series_and_a_page_are_drawn_from_the_result(self):
        self.run_well("run", "case.toml", *self.UNROLLED, "--output", "ring.nc")
        printed = self.run_well("report", "ring.nc", "--vts", "fields", "--output", "page.html")
        self.assertIn("fields/ring.pvd", printed)
        self.assertEqual(
            [name for name in self.names() if name.startswith("fields/")],
            ["fields/ring.pvd", "fields/ring_0000.vts", "fields/ring_0001.vts", "fields/ring_0002.vts"],
        )
        listed = xml.etree.ElementTree.parse(self.folder / "fields" / "ring.pvd")
        self.assertEqual(
            [(one.get("timestep"), one.get("file")) for one in listed.iter("DataSet")],
            [("0", "ring_0000.vts"), ("18", "ring_0001.vts"), ("180", "ring_0002.vts")],
        )
        self.assertIn('"film_pressure":{"low":', (self.folder / "page.html").read_text())

    def test_cylinder_and_plane_hold_the_same_pressures(self):
        self.run_well("run", "case.toml", *self.UNROLLED, "--output", "ring.nc")
        for shape in ("cylinder", "plane"):
            self.run_well("report", "ring.nc", "--vts", shape, "--vts-shape", shape)
        (on_bore, pressures), (flat, same) = (self.grid(shape) for shape in ("cylinder", "plane"))
        self.assertEqual(pressures, same)
        self.assertEqual(len(pressures), 25 * 33)
        self.assertGreater(max(pressures), 10e5)
        for x, y, z in on_bore:
            self.assertAlmostEqual(math.hypot(x, y), 0.0445, places=12)
            self.assertLessEqual(-0.0012 - 1e-15, z)
        # The last strip ends one gap before the circumference.
        self.assertAlmostEqual(max(y for _, y, _ in flat), math.pi * 0.089 - 0.0003, places=12)

    def test_a_ring_that_bends_has_its_separation_and_where_it_is_lifted_off(self):
        case = str(program.SOURCES / "cases" / "distorted-bore" / "not-followed.toml")
        settings = (
            ("solver.cells", "24"),
            ("solver.cells_y", "60"),
            ("solver.crank_step", "4 degree"),
            ("output.crank_angles", "4 degree"),
            ("output.fields", '["180 degree", "360 degree"]'),
            ("output.reduction", "none"),
        )
        options = [word for key, value in settings for word in ("--set", f"{key}={value}")]
        self.run_well("run", case, *options, "--output", "bent.nc")
        self.run_well("report", "bent.nc", "--vts", "fields", "--vts-shape", "plane")
        points, film = self.grid("fields", "bent_0001", "film_thickness")
        _, separation = self.grid("fields", "bent_0001", "strip_min_film_thickness")
        _, lifted_off = self.grid("fields", "bent_0001", "strip_lifted_off")
        self.assertEqual(len(points), 25 * 61)
        for j in range(61):
            strip = slice(25 * j, 25 * (j + 1))
            (lowest,) = set(separation[strip])
            # The lowest place of the face may lie between nodes.
            self.assertAlmostEqual(lowest / min(film[strip]), 1, delta=0.05)
            self.assertIn(set(lifted_off[strip]), ({0.0}, {1.0}))
        around = lifted_off[25:-25]  # but for the ends of the ring
        self.assertTrue(any(around) and not all(around))

    def grid(self, folder, name="ring_0001", field="film_pressure"):
        """Points and one field of an angle, the second one."""
        piece = xml.etree.ElementTree.parse(self.folder / folder / f"{name}.vts").find(".//Piece")

        def numbers(array, letter, size):
            data = base64.b64decode(array.text)
            self.assertEqual(struct.unpack("<Q", data[:8])[0], len(data) - 8)
            return struct.unpack(f"<{(len(data) - 8) // size}{letter}", data[8:])

        flat = numbers(piece.find("Points/DataArray"), "d", 8)
        return list(zip(flat[::3], flat[1::3], flat[2::3])), numbers(
            piece.find(f"PointData/DataArray[@Name='{field}']"), "f", 4
        )

    def test_what_has_no_such_fields_is_refused(self):
        self.run_well("run", "case.toml", "--output", "face.nc")
        before = self.names()
        self.assert_refused(
            self.run_program("report", "face.nc", "--vts", "fields", "--output", "page.html"),
            'film.dimension = "unrolled"',
        )
        self.assert_refused(self.run_program("report", "face.nc", "--vts", "case.toml"), "not a folder")
        self.assert_refused(self.run_program("report", "face.nc", "--vts", "none/fields"), "does not exist")
        self.assert_refused(self.run_program("report", "face.nc", "face.nc", "--vts", "fields"), "one result at a time")
        self.assert_refused(
            self.run_program("report", "face.nc", "--vts", "fields", "--vts-shape", "ball"), "cylinder, plane"
        )
        self.assert_refused(
            self.run_program("report", "face.nc", "--vts-shape", "plane", "--output", "page.html"),
            "--vts-shape",
            "add --vts DIR",
        )
        self.assertEqual(self.names(), before)

    def test_a_page_without_a_name_has_that_of_its_result(self):
        self.run_well("run", "case.toml", "--output", "face.nc", "--report", "run.html")
        self.assertIn("wrote face.html", self.run_well("report", "face.nc"))
        pages = [(self.folder / name).read_text() for name in ("face.html", "run.html")]
        self.assertEqual(*(re.sub(r'"file":"[^"]*"', "", page) for page in pages))
        pad = str(program.SOURCES / "verification/rayleigh1918_step/best.toml")
        self.assert_refused(self.run_program("run", pad, "--report", "pad.html"), "--report draws the cycle of rings")


class Reproduce(program.ProgramTest):
    def test_three_results_and_a_report_beside_the_paper(self):
        printed = self.run_well("reproduce", "styles2014", "--output", "paper")
        names = sorted(path.name for path in (self.folder / "paper").iterdir())
        self.assertEqual(names, ["embedded.nc", "new.nc", "report.html", "run-in.nc"])
        for fragment in (
            "SYNTHETIC",
            "paper, section 4",
            "independent implementation",
            "report.html",
            "mean friction power",
        ):
            self.assertIn(fragment, printed)
        page = (self.folder / "paper" / "report.html").read_text()
        for title in ("new ring", "run-in ring", "embedded ring"):
            self.assertIn(title, page)

    def test_agrees_with_the_independent_implementation(self):
        printed = self.run_well("reproduce", "styles2014")
        rows = re.findall(r"([+-]\d+\.\d) %   ([^(]*)\(independent implementation\)", printed)
        self.assertGreaterEqual(len(rows), 15)
        for deviation, statement in rows:
            # Values are published with three or four digits: half a per cent is their rounding (0.092 is the coarsest).
            # That implementation has values at whole degrees, and the friction coefficient peaks between two of them.
            allowed = 2.0 if "friction coefficient" in statement else 0.5
            self.assertLessEqual(abs(float(deviation)), allowed, statement)

    def test_folder_that_cannot_be_made(self):
        done = self.run_program("reproduce", "styles2014", "--output", "a/b/c")
        self.assert_refused(done, "a/b/c")


if __name__ == "__main__":
    unittest.main(verbosity=2)
