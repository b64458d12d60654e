"""ringfilm run, check, fields, new: what they print and write."""

import csv
import json
import math
import os
import pty
import re
import subprocess
import unittest

import program

CONTRACT_COLUMNS = (
    "crank_angle [degree],piston_velocity [m/s],gas_pressure [Pa],applied_load [N],min_film_thickness [m],"
    "lambda_ratio,hydrodynamic_load [N],asperity_load [N],asperity_contact_area [m2],boundary_friction [N],"
    "viscous_friction [N],viscous_friction_ring [N],total_friction [N],friction_on_liner [N],friction_coefficient,"
    "power_loss [W],oil_flow_middle [kg/s],peak_film_pressure [Pa],cavitated_fraction,sliding_distance [m]"
)


class Run(program.ProgramTest):
    def values(self, *words):
        return json.loads(self.run_well("run", "case.toml", "--json", *words))

    def curves(self, *words):
        self.run_well("run", "case.toml", "--csv", "curves.csv", *words)
        with open(self.folder / "curves.csv", newline="") as stream:
            rows = list(csv.reader(stream))
        return rows[0], [[float(cell) for cell in row] for row in rows[1:]]

    def test_prints_a_screen_with_a_verdict_and_the_values_that_decide(self):
        for name, most, heads in (("mine.toml", 30, ()), ("pack.toml", 45, ("ring 1", "ring 2", "3 upper", "3 lower"))):
            self.run_well("new", name, *(("--pack", "passenger-car") if heads else ()))
            printed = self.run_well("run", name)
            lines = printed.splitlines()
            self.assertLessEqual(sum(max(1, math.ceil(len(line) / 100)) for line in lines), most, printed)
            self.assertIn("verdict: limited by: ", printed)
            self.assertIn("friction mean effective pressure", printed)
            self.assertRegex(printed, r"[1-9]\d* default inputs, [1-9]\d* modelling assumptions, [1-9]\d* crank steps")
            self.assertEqual([head for head in heads if head not in printed], [])
            self.assertGreater(len(self.run_well("run", name, "--all").splitlines()), 2 * len(lines))

    def test_prints_everything_in_engineers_units_and_writes_nothing_unasked(self):
        before = self.names()
        printed = self.run_well("run", "case.toml", "--all")
        for fragment in (
            "a small case",
            "1500 rpm",
            "kPa",
            " W ",
            "um ",
            "mg/s",
            "boundary",
            "Newton iterations",
            "film.cavitation = mass-conserving",
            "default inputs:",
        ):
            self.assertIn(fragment, printed)
        self.assertEqual(self.names(), before)

    def test_csv_has_the_columns_of_the_contract_and_a_row_per_degree(self):
        header, rows = self.curves()
        self.assertEqual(",".join(header[:20]), CONTRACT_COLUMNS)
        self.assertEqual([row[0] for row in rows], list(range(720)))
        self.assertTrue(all(len(row) == len(header) for row in rows))
        self.assertTrue((self.folder / "curves.csv").read_text().splitlines()[1].startswith("0,"))

    def test_csv_rows_balance_the_load_and_add_up(self):
        header, rows = self.curves()
        column = {name.split(" [")[0]: i for i, name in enumerate(header)}
        width, bore, p_e = 1.2e-3, 0.089, 0.2e6
        for row in rows:
            at = {name: row[i] for name, i in column.items()}
            # Newton stops at 1e-8 of film and pressure; 1e-6 leaves room for the slope of the load.
            self.assertAlmostEqual(
                at["hydrodynamic_load"] + at["asperity_load"], at["applied_load"], delta=1e-6 * at["applied_load"]
            )
            load = (p_e + at["gas_pressure"]) * 3.141592653589793 * bore * width
            self.assertAlmostEqual(at["applied_load"], load, delta=1e-9 * load)
            self.assertAlmostEqual(at["total_friction"], at["boundary_friction"] + at["viscous_friction"], places=9)
            self.assertAlmostEqual(at["power_loss"], at["total_friction"] * abs(at["piston_velocity"]), places=6)

    def test_regimes_of_lubrication_share_the_cycle_by_the_load_of_asperities(self):
        header, rows = self.curves()
        share = header.index("asperity_load_share")
        self.assertTrue(all(0 <= row[share] <= 1 for row in rows))
        values = self.values()
        regimes = ("boundary_regime", "mixed_regime", "full_film")
        for whole in ("cycle", "distance", "energy"):
            self.assertAlmostEqual(sum(values[f"{regime}_{whole}_share"] for regime in regimes), 1, places=9)
        full = sum(row[share] < 0.01 for row in rows) / len(rows)
        self.assertAlmostEqual(values["full_film_cycle_share"], full, delta=0.02)  # crossings within a degree
        boundary = sum(row[share] > 0.9 for row in rows) / len(rows)
        self.assertAlmostEqual(values["boundary_regime_cycle_share"], boundary, delta=0.02)
        self.assertGreater(values["full_film_lambda_ratio"], 3)
        self.assertRegex(
            self.run_well("run", "case.toml", "--all"),
            r"% +share of the cycle in boundary lubrication \(mixed \d+ %, full film \d+ %; of the friction energy ",
        )

    def test_json_agrees_with_the_curves(self):
        header, rows = self.curves()
        column = {name.split(" [")[0]: i for i, name in enumerate(header)}
        values = self.values()
        power = sum(row[column["power_loss"]] for row in rows) / len(rows)
        self.assertAlmostEqual(
            values["mean_power_loss"], power, delta=0.005 * power
        )  # 720 points against the integration
        swept = 3.141592653589793 / 4 * 0.089**2 * 0.0795
        self.assertAlmostEqual(values["fmep"], values["energy_per_cycle"] / swept, delta=1e-6 * values["fmep"])
        self.assertLessEqual(values["min_film_thickness"], 1.0001 * min(r[column["min_film_thickness"]] for r in rows))
        self.assertEqual(values["units"]["fmep"], "Pa")
        self.assertIs(values["complete"], True)
        self.assertIn("film.cavitation", values["assumed"])

    def test_json_holds_the_ledger_where_it_is_asked_for(self):
        self.assertNotIn("ledger", self.values())
        values = self.values("--ledger")
        entries = {entry["topic"]: entry for entry in values["ledger"]}
        self.assertTrue(entries["cavitation-model"]["statement"])
        variants = entries["cavitation-model"]["variants"]
        changed = {variant["setting"]: variant["changed"] for variant in variants}
        exit_model = changed['film.cavitation = "reynolds-exit"']
        self.assertNotEqual(exit_model["mean_power_loss"], values["mean_power_loss"])
        self.assertNotIn("peak_gas_pressure", exit_model, "the trace is the same")

    def test_values_and_curves_carry_their_error_where_it_is_asked_for(self):
        self.assertNotIn("errors", self.values())
        coarse = ("--error-estimate", "--set", "solver.cells=40", "--set", "solver.crank_step=2 degree")
        printed = self.run_well("run", "case.toml", *coarse)
        self.assertRegex(printed, r"\d \+- [0-9.]+ kPa +friction mean effective pressure")
        self.assertIn("80 cells at 2 degree", " ".join(printed.split()))
        values = self.values(*coarse)
        fine = self.values(
            "--set", "solver.cells=160", "--set", "solver.crank_step=0.5 degree", "--set", "solver.step_error=6.25e-5"
        )
        for name in ("fmep", "mean_absolute_oil_flow", "max_film_thickness"):
            self.assertLessEqual(abs(values[name] - fine[name]), values["errors"][name], name)
        self.assertEqual([run["cells"] for run in values["error_estimate"]["runs"]], [40, 80, 20, 40, 40])
        header, rows = self.curves(*coarse)
        self.assertGreater(header.index("piston_velocity_error [m/s]"), header.index("load_residual"))
        self.assertTrue(all(row[header.index("total_friction_error [N]")] > 0 for row in rows))

    def test_the_number_of_threads_changes_no_digit(self):
        words = ("run", "case.toml", "--json", "--ledger", "--error-estimate", "--set", "solver.cells=40", "--jobs")
        self.assertEqual(self.run_well(*words, "1"), self.run_well(*words, "3"))

    def test_set_replaces_a_key_as_toml_or_as_text(self):
        # Mean piston speed is 2 x stroke x revolutions per second.
        twice = self.values("--set", "operating.speed=3000 rpm", "--set", "title=as text")
        self.assertAlmostEqual(twice["mean_piston_speed"], 2 * 0.0795 * 50, places=9)
        self.assertEqual(twice["title"], "as text")
        quoted = self.values("--set", 'operating.speed="3000 rpm"', "solver.cells=40")
        self.assertAlmostEqual(quoted["mean_piston_speed"], 2 * 0.0795 * 50, places=9)

    def test_imep_is_that_of_the_trace_and_compared_with_the_stated_one(self):
        # Work of the trace on the piston over the swept volume, by trapezia of its own samples: within 1e-3.
        samples = [tuple(map(float, line.split(","))) for line in program.TRACE.splitlines()[1:]]
        r, rod = 0.0795 / 2, 0.1381

        def place(degree):
            phi = math.radians(degree)
            return (r + rod - r * math.cos(phi) - math.sqrt(rod**2 - (r * math.sin(phi)) ** 2)) / (2 * r)

        following = samples[1:] + samples[:1]
        imep = sum((p + q) / 2 * 1e5 * (place(b) - place(a)) for (a, p), (b, q) in zip(samples, following))
        values = self.values()
        self.assertAlmostEqual(values["imep"] / imep, 1, delta=1e-3)
        self.assertNotIn("compression_index", values)
        self.assertIn("compression_index", self.values("--set", "gas.compression_ratio=10"))
        self.assertIn(f"IMEP {imep / 1e5:.2f}", self.run_well("run", "case.toml"))
        for stated, is_noted in ((1.2 * imep, True), (imep, False)):
            notes = self.values("--set", f"gas.imep={stated / 1e5:.4f} bar")["notes"]
            self.assertEqual(any(note["topic"] == "gas-imep-differs" for note in notes), is_noted)

    def test_a_viscosity_index_is_the_second_viscosity(self):
        # The first example of ASTM D2270: 73.30 mm2/s at 40 degC and 8.86 mm2/s at 100 degC have the index 92. It is
        # rounded, which moves the viscosity at 100 degC by up to 0.5 %.
        def with_oil(*words):
            stated = "lubricant.kinematic_viscosity=" + "[" + ", ".join(words) + "]"
            return ("--set", "operating.oil_temperature=100 degC", "--set", stated)

        cold = '{ temperature = "40 degC", value = "73.30 mm2/s" }'
        both = self.values(*with_oil(cold, '{ temperature = "100 degC", value = "8.86 mm2/s" }'))
        one = self.values(*with_oil(cold), "--set", "lubricant.viscosity_index=92")
        self.assertAlmostEqual(one["oil_viscosity"] / both["oil_viscosity"], 1, delta=5e-3)
        self.assert_refused(self.run_program("run", "case.toml", *with_oil(cold)), "or lubricant.viscosity_index")

    def test_output_angles_are_those_asked_for(self):
        _, rows = self.curves("--set", 'output.crank_angles=["0 degree", "12.5 degree", "700 degree"]')
        self.assertEqual([row[0] for row in rows], [0, 12.5, 700])

    def test_same_case_gives_same_bytes(self):
        for name in ("a.nc", "b.nc"):
            self.run_well("run", "case.toml", "--output", name, "--set", 'output.fields="all"')
        self.assertEqual((self.folder / "a.nc").read_bytes(), (self.folder / "b.nc").read_bytes())

    def test_resolved_case_in_the_result_gives_the_same_curves_again(self):
        try:
            import netCDF4
        except ImportError:
            program.skip_loudly(self, "python3-netcdf4 is not installed")
        self.run_well("run", "case.toml", "--output", "a.nc", "--csv", "a.csv")
        with netCDF4.Dataset(self.folder / "a.nc") as file:
            (self.folder / "again.toml").write_text(str(file["resolved_case"][...]))
        self.run_well("run", "again.toml", "--csv", "b.csv")
        self.assertEqual((self.folder / "a.csv").read_bytes(), (self.folder / "b.csv").read_bytes())

    def test_result_opens_in_xarray(self):
        try:
            import netCDF4  # noqa: F401
            import xarray
        except ImportError:
            program.skip_loudly(self, "python3-xarray and python3-netcdf4 are not installed")
        self.run_well(
            "run",
            "case.toml",
            "--output",
            "a.nc",
            "--csv",
            "a.csv",
            "--ledger",
            "--set",
            'output.fields=["0 degree", "20 degree"]',
        )
        with open(self.folder / "a.csv", newline="") as stream:
            curves = list(csv.DictReader(stream))
        with xarray.open_dataset(self.folder / "a.nc") as data:
            self.assertEqual(data.power_loss.dims, ("crank_angle",))
            self.assertEqual(data.power_loss.attrs["units"], "W")
            self.assertTrue(data.power_loss.attrs["long_name"])
            self.assertTrue(data.power_loss.attrs["symbol"])
            self.assertTrue(data.power_loss.attrs["source_equation"])
            self.assertEqual(data.crank_angle.attrs["units"], "degree")
            self.assertEqual(data.film_pressure.dims, ("field_crank_angle", "x"))
            self.assertEqual(data.power_loss.values.tolist(), [float(row["power_loss [W]"]) for row in curves])
            film = data.film_thickness.sel(field_crank_angle=20).min().item()
            self.assertAlmostEqual(film * 1e6, data.min_film_thickness.sel(crank_angle=20).item() * 1e6, places=3)
            self.assertIn("engine.bore", data.input_key.values.tolist())
            self.assertEqual(data.attrs["title"], "a small case")
            self.assertEqual(data.attrs["Conventions"], "CF-1.10")
            self.assertRegex(data.attrs["commit"], "^(unknown|[0-9a-f]{7,}.*)$")
            self.assertRegex(data.attrs["kernels"], "^[a-z0-9]+, 1 lane; other grids and choices [0-9]+ lanes$")
            self.assertGreater(data.sizes["ledger_variant"], 0)
            trace = data.file_role.values.tolist().index("gas.cylinder_pressure")
            self.assertRegex(data.file_sha256.values[trace], "^[0-9a-f]{64}$")

    def test_cycle_without_a_balance_is_exit_code_3_and_keeps_the_old_files(self):
        (self.folder / "a.nc").write_text("old")
        # Asperities of a rubber-like modulus carry at most some bar, and a film that hardly moves carries nothing.
        done = self.run_program(
            "run",
            "case.toml",
            "--output",
            "a.nc",
            "--csv",
            "a.csv",
            "--set",
            "contact.composite_modulus=0.1 GPa",
            "--set",
            "operating.speed=1e-6 rpm",
        )
        self.assertEqual(done.returncode, 3, done.stdout + done.stderr)
        self.assertIn("exit code 3", done.stderr)
        self.assertIn("nothing was written", done.stderr)
        self.assertEqual(done.stderr.count("degree"), 1, "the crank angle is reported once")
        self.assertIn("STOPPED after 0 cycles, before the cycle repeated itself; 0 crank angles", done.stdout)
        self.assertNotIn("wrote", done.stdout)
        for word in ("nan", "inf)", "cycles until"):
            self.assertNotIn(word, done.stdout)
        self.assertEqual(self.names(), ["a.nc", "case.toml", "trace.csv"])
        self.assertEqual((self.folder / "a.nc").read_text(), "old")

    def test_an_integration_that_stops_writes_what_it_had_solved_and_reports_that_it_is_a_part(self):
        # So few asperities carry nothing, and a face that is lowest at its edge has a wedge in one direction only.
        done = self.run_program(
            "run",
            "case.toml",
            "--output",
            "a.nc",
            "--csv",
            "a.csv",
            "--set",
            "operating.speed=30 rpm",
            "--set",
            "contact.asperity_density=1e-4 um-2",
            "--set",
            "ring.face.apex=1",
        )
        self.assertEqual(done.returncode, 3, done.stdout + done.stderr)
        self.assertIn("neither the film nor the asperities carry", done.stderr)
        load = float(re.search(r"carry the load of (\S+) N per mm", done.stderr).group(1))
        asperities = float(re.search(r"asperities carry at most ([^,]+),", done.stderr).group(1))
        self.assertGreater(load, 10 * asperities)
        with open(self.folder / "a.csv", newline="") as stream:
            rows = list(csv.reader(stream))[1:]
        self.assertGreater(len(rows), 30)
        self.assertLess(len(rows), 720)
        self.assertIn(f"holds the {len(rows)} crank angles", done.stderr)
        page = self.run_well("report", "a.nc", "--output", "a.html")
        self.assertIn("wrote", page)

    def test_progress_is_shown_on_a_terminal_only(self):
        command = [
            program.PROGRAM,
            "run",
            "case.toml",
            "--ledger",
            "--jobs",
            "1",
            "--set",
            "solver.cells=800",
            "--set",
            "solver.crank_step=0.5 degree",
        ]
        try:
            main, side = pty.openpty()
        except OSError as none:
            program.skip_loudly(self, f"no pseudo-terminal here ({none})")
        child = subprocess.Popen(command, cwd=self.folder, stdout=subprocess.DEVNULL, stderr=side)
        os.close(side)
        shown = b""
        try:
            while part := os.read(main, 4096):
                shown += part
        except OSError:  # the other end is closed
            pass
        self.assertEqual(child.wait(), 0)
        os.close(main)
        self.assertRegex(shown.decode(), r"\d+ of \d+ other grids and choices")
        self.assertTrue(shown.decode().endswith("\x1b[K"), "the line is gone at the end")
        self.assertEqual(self.run_program(*command[1:]).stderr, "")


class OtherCommands(program.ProgramTest):
    def test_check_lists_default_inputs(self):
        printed = self.run_well("check", "case.toml", "--all")
        self.assertIn("no errors", printed)
        self.assertIn("\n  film.cavitation = mass-conserving  (", printed)

    def test_new_writes_a_case_that_runs_and_replaces_nothing(self):
        self.run_well("new", "mine.toml")
        self.run_well("run", "mine.toml")
        text = (self.folder / "mine.toml").read_text()
        self.assert_refused(self.run_program("new", "mine.toml"), "mine.toml", "exists already")
        self.assertEqual((self.folder / "mine.toml").read_text(), text)

    def test_fields_understands_words_of_data_sheets(self):
        for word, key in (("vi", "viscosity_index"), ("kv40", "kinematic_viscosity"), ("preload", "tangential_force")):
            self.assertRegex(self.run_well("fields", word), rf"(?m)^ +{key} ")

    def test_fields_lists_every_key_of_the_starting_case(self):
        table = self.run_well("fields")
        self.run_well("new", "mine.toml", "--all")
        section = ""
        for line in (self.folder / "mine.toml").read_text().splitlines():
            if match := re.match(r"\[([a-z.]+)\]", line):
                section = match[1] + "."
            elif match := re.match(r"([a-z_]+) =", line):
                self.assertIn(match[1], table, section + match[1])

    def test_shells_complete_commands_options_and_keys(self):
        (self.folder / "ringfilm.bash").write_text(self.run_well("completion", "bash"))

        def completed(*words):
            typed = " ".join(f"'{word}'" for word in words)
            script = f"""
                . ./ringfilm.bash; compopt() {{ :; }}
                COMP_WORDS=({typed}); COMP_CWORD={len(words) - 1}; _ringfilm; printf '%s\\n' "${{COMPREPLY[@]}}"
            """
            done = subprocess.run(
                ["bash", "-c", script], cwd=self.folder, capture_output=True, text=True, check=True, timeout=60
            )
            self.assertEqual(done.stderr, "")
            return done.stdout.split()

        self.assertEqual(completed("ringfilm", "swe"), ["sweep"])
        self.assertEqual(completed("ringfilm", "run", "--err"), ["--error-estimate"])
        self.assertEqual(completed("ringfilm", "run", "case.toml", "--set", "engine.bo"), ["engine.bore="])
        self.assertIn("-n __fish_use_subcommand -a run", self.run_well("completion", "fish"))
        self.assertIn(".SS ringfilm run", self.run_well("completion", "man"))
        self.assert_refused(self.run_program("completion", "tcsh"), "bash, zsh, fish, man")

    def test_help_and_version_state_what_there_is(self):
        printed = self.run_well("--help")
        for command in ("run", "check", "fields", "new", "report", "reproduce"):
            self.assertIn(command, printed)
            self.assertRegex(self.run_well(command, "--help"), "Examples:\n  ringfilm " + command)
        self.assertIn("--set KEY=", self.run_well("run", "--help"))
        self.assertIn("Examples:", printed)
        self.assertRegex(self.run_well("--version"), r"^ringfilm \d+\.\d+\.\d+ \(commit ")


HEAD = """
title = "pack"
[engine]
bore = "89 mm"
stroke = "79.5 mm"
connecting_rod_length = "138.1 mm"
[operating]
speed = "1500 rpm"
oil_temperature = "120 degC"
[gas]
model = "wiebe"
[contact]
asperity_density = "0.097 um-2"
asperity_radius = "1.56 um"
roughness = "0.48 um"
boundary_shear_strength_coefficient = 0.3581
[lubricant]
file = "data/lubricants/styles2014.toml"
[solver]
cells = 40
crank_step = "4 degree"
[output]
crank_angles = "4 degree"
fields = ["20 degree"]
"""
TOP = """
name = "top"
face_width = "1.2 mm"
elastic_pressure = "0.2 MPa"
face = { form = "parabola", crown_height = "15 um" }
pressure_below = "2.5 bar"
"""
SECOND = """
name = "second"
face_width = "1.5 mm"
tangential_force = "9 N"
face = { form = "parabola", crown_height = "10 um", apex = 0.6 }
"""
SECOND_CONTACT = 'contact = { roughness = "0.6 um" }\n'


STUDY = """
title = "speeds"
[[base]]
case = "pack.toml"
[plan]
method = "grid"
[[factor]]
key = "operating.speed"
values = ["1000 rpm", "2000 rpm"]
"""


RING_OIL = ("replenished", "scraped_up", "scraped_down")


class Pack(program.ProgramTest):
    def setUp(self):
        super().setUp()
        self.write("pack.toml", HEAD + "[[ring]]" + TOP + "[[ring]]" + SECOND + SECOND_CONTACT)
        self.write("top.toml", HEAD + "[ring]" + TOP)
        second = HEAD.replace('roughness = "0.48 um"', 'roughness = "0.6 um"')
        self.write("second.toml", second + "[ring]" + SECOND + 'pressure_above = "2.5 bar"\n')

    def write(self, name, text):
        (self.folder / name).write_text(text)

    def refused(self, *words):
        done = self.run_program(*words)
        self.assert_refused(done)
        return done.stderr

    def rows(self, name):
        self.run_well("run", name, "--csv", "curves.csv")
        with open(self.folder / "curves.csv", newline="") as stream:
            return list(csv.reader(stream))

    def test_each_ring_has_the_bits_of_its_own_case(self):
        pack = self.rows("pack.toml")
        self.assertEqual(pack[0][0], "ring")
        singles = [self.rows("top.toml"), self.rows("second.toml")]
        self.assertEqual(pack[0][1:], singles[0][0])
        for ring, single in enumerate(singles, start=1):
            self.assertEqual([row[1:] for row in pack[1:] if row[0] == str(ring)], single[1:])

    def test_a_pack_of_one_ring_has_the_bits_of_the_single_ring(self):
        given = 'pressure_above = "3 bar"\npressure_below = "1.4 bar"\n'
        self.write("one.toml", HEAD + "[[ring]]" + SECOND + given)
        self.write("single.toml", HEAD + "[ring]" + SECOND + given)
        rows, single = self.rows("one.toml"), self.rows("single.toml")
        self.assertEqual(rows[0], ["ring"] + single[0])
        self.assertEqual([row[1:] for row in rows[1:]], single[1:])

    def test_json_has_each_ring_and_the_sum(self):
        pack = json.loads(self.run_well("run", "pack.toml", "--json"))
        singles = [json.loads(self.run_well("run", name, "--json")) for name in ("top.toml", "second.toml")]
        for ring, single in zip(pack["rings"], singles, strict=True):
            self.assertEqual(ring["fmep"], single["fmep"])
            self.assertEqual(ring["effort"], single["effort"])
        self.assertEqual([ring["ring"] for ring in pack["rings"]], [1, 2])
        self.assertEqual(pack["rings"][1]["title"], "pack: ring 2 (second)")
        self.assertAlmostEqual(pack["all_rings"]["fmep"], sum(single["fmep"] for single in singles), places=9)

    def test_summary_shows_each_ring_and_the_sum(self):
        printed = self.run_well("run", "pack.toml")
        self.assertIn("ring 1: top, ring 2: second", printed)
        self.assertRegex(printed, r"friction mean effective pressure \[kPa\] +[\d.]+ +[\d.]+ +[\d.]+\n")
        printed = self.run_well("run", "pack.toml", "--all")
        for fragment in ("pack: ring 1 (top)", "pack: ring 2 (second)", "all 2 rings:"):
            self.assertIn(fragment, printed)

    def test_report_of_the_file_shows_each_ring(self):
        self.run_well("run", "pack.toml", "--output", "pack.nc")
        self.run_well("report", "pack.nc", "--output", "pack.html")
        page = (self.folder / "pack.html").read_text()
        self.assertIn("pack: ring 1 (top)", page)
        self.assertIn("pack: ring 2 (second)", page)

    def test_keys_of_one_ring_are_set_on_the_command_line(self):
        before = json.loads(self.run_well("run", "pack.toml", "--json"))
        after = json.loads(self.run_well("run", "pack.toml", "--json", "--set", "ring.2.tangential_force=18 N"))
        self.assertEqual(before["rings"][0]["fmep"], after["rings"][0]["fmep"])
        self.assertGreater(after["rings"][1]["fmep"], 1.5 * before["rings"][1]["fmep"])

    def test_a_missing_land_pressure_and_one_that_is_stated_twice_are_refused(self):
        refused = self.refused("run", "pack.toml", "--set", "ring.1.pressure_below=")
        self.assertIn("ring.1.pressure_below is missing", refused)
        refused = self.refused("run", "pack.toml", "--set", "ring.2.pressure_above=3 bar")
        self.assertIn("ring.2.pressure_above is the pressure below ring 1", refused)

    def test_rings_that_share_the_oil_are_computed_together(self):
        shared = [
            "film.cavitation=mass-conserving",
            "film.chamber_edge=gas",
            "film.crankcase_edge=gas",
            "film.supply=film-on-liner",
            "supply.film=2 um",
            "supply.reach=10 mm",
        ]
        settings = [word for setting in shared for word in ("--set", setting)]
        with_default = json.loads(self.run_well("run", "pack.toml", "--json", *settings))
        topics = [[note["topic"] for note in ring["notes"]] for ring in with_default["rings"]]
        self.assertEqual(["ring-distance-assumed" in of_ring for of_ring in topics], [True, False])
        land = ["--set", "ring.1.land_below=3.5 mm"]
        pack = json.loads(self.run_well("run", "pack.toml", "--json", *settings, *land))
        laid, up, down = (sum(ring[f"oil_{name}"] for ring in pack["rings"]) for name in RING_OIL)
        self.assertAlmostEqual(laid / (up + down), 1, delta=1e-3)
        alone = json.loads(self.run_well("run", "second.toml", "--json", *settings))
        self.assertNotAlmostEqual(pack["rings"][1]["fmep"] / alone["fmep"], 1, places=3)
        self.assertIn("computes each ring by itself", self.refused("run", "pack.toml", "--ledger", *settings))
        for file, key in (("pack.toml", "ring.2.land_below"), ("second.toml", "ring.land_below")):
            refused = self.refused("run", file, *settings, "--set", key + "=3 mm")
            self.assertIn(key + " is the height of a piston land between two rings", refused)

    def test_unknown_keys_rings_and_mixtures_are_refused(self):
        self.assertIn(
            "did you mean ring.2.face_width?", self.refused("run", "pack.toml", "--set", "ring.2.face_widht=1 mm")
        )
        self.assertIn("there are 3 rings", self.refused("run", "pack.toml", "--set", "ring.4.face_width=1 mm"))
        self.assertIn(
            "a key of one ring is ring.1.face_width", self.refused("run", "pack.toml", "--set", "ring.face_width=1 mm")
        )
        refused = self.refused("run", "pack.toml", "--set", "ring.0.face_width=1 mm")
        self.assertIn("unknown key ring.0.face_width: rings count from 1", refused)
        self.assertNotIn("did you mean", refused)
        refused = self.refused("run", "pack.toml", "--set", "ring.1.gap=0.3 mm")
        self.assertIn("did you mean ring.1.end_gap?", refused)
        self.assertNotIn("[pad]", refused)

    def test_missing_keys_name_their_ring(self):
        refused = self.refused("run", "pack.toml", "--set", "ring.2.face_width=")
        self.assertIn("ring 2: the key ring.face_width is missing", refused)

    def test_a_mistake_in_a_common_key_is_reported_once(self):
        for setting, words in (
            ("engine.bore=", "the key engine.bore is missing"),
            ("contact.asperity_radius=", "the key contact.asperity_radius is missing"),
            ("engine.bore=5 m", 'engine.bore = "5 m" is out of range'),
        ):
            refused = self.refused("run", "pack.toml", "--set", setting)
            self.assertEqual(refused.count(words), 1, refused)
            self.assertNotIn("ring 1:", refused)

    def test_a_study_has_the_values_of_each_ring(self):
        self.write("study.toml", STUDY)
        self.assertIn("ring_2_fmep", self.run_well("study", "study.toml"))


if __name__ == "__main__":
    unittest.main(verbosity=2)
