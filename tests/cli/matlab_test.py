"""matlab/ringfilm_read.m in Octave, against the tables and the JSON that the program writes of the same runs."""

import csv
import json
import shutil
import subprocess
import unittest

import program

OCTAVE = shutil.which("octave-cli")

SLIDER = """\
[pad]
length = "10 mm"
gap = "gap.csv"
speed = "1 m/s"
left_pressure = "0 bar"
right_pressure = "0 bar"
separation = "10 um"
[lubricant]
viscosity = "20 mPa.s"
density = "850 kg/m3"
[solver]
cells = 20
"""

STUDY = """\
title = "two tensions"
kind = "map"
[[base]]
name = "base"
case = "case.toml"
[[factor]]
name = "tension"
key = "ring.elastic_pressure"
values = ["0.1 MPa", "0.2 MPa", "0.3 MPa"]
[plan]
method = "grid"
"""


class TheReaderForMatlab(program.ProgramTest):
    def setUp(self):
        super().setUp()
        if OCTAVE is None:
            program.skip_loudly(self, "octave is not installed (Debian: octave-cli and octave-netcdf)")
        if self.octave("pkg load netcdf").returncode != 0:
            program.skip_loudly(self, "Octave's package netcdf is not installed (Debian: octave-netcdf)")

    def octave(self, script):
        words = f"addpath('{program.SOURCES / 'matlab'}');\n{script}\n"
        (self.folder / "reads.m").write_text(words)
        return subprocess.run(
            [OCTAVE, "--quiet", "--no-init-file", "--no-history", "reads.m"],
            cwd=self.folder,
            capture_output=True,
            text=True,
            timeout=120,
        )

    def reported(self, script):
        done = self.octave(script)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return done.stdout.splitlines()

    def columns(self, name):
        with open(self.folder / name, newline="") as file:
            rows = list(csv.DictReader(file))
        return {name.split(" [")[0]: [row[name] for row in rows] for name in rows[0]}

    def assert_numbers(self, line, texts):
        self.assertEqual([float(word) for word in line.split()], [float(text) for text in texts])

    def test_a_result_has_the_curves_of_the_table_and_the_values_of_the_json(self):
        values = json.loads(
            self.run_well(
                "run", "case.toml", "--set", "output.fields=all", "--output", "r.nc", "--csv", "r.csv", "--json"
            )
        )
        lines = self.reported(
            """
r = ringfilm_read('r.nc');
printf('%s %s %s\\n', r.kind, r.attributes.title, r.about.min_film_thickness.units);
printf('%s\\n', r.about.min_film_thickness.long_name);
printf('%s ', r.about.film_pressure.dimensions{:}); printf('\\n');
printf('%d %d %d\\n', size(r.film_pressure, 1) == numel(r.x), size(r.film_pressure, 2) == ...
  numel(r.field_crank_angle), iscolumn(r.min_film_thickness));
printf('%.17g\\n', r.cycle_mean_power_loss);
printf('%.17g ', r.min_film_thickness); printf('\\n');
printf('%.17g ', r.crank_angle); printf('\\n');"""
        )
        self.assertEqual(lines[0], "result a small case m")
        self.assertEqual(lines[1], "minimum film thickness")
        self.assertEqual(lines[2].split(), ["x", "field_crank_angle"])
        self.assertEqual(lines[3], "1 1 1")
        self.assertEqual(float(lines[4]), values["mean_power_loss"])
        table = self.columns("r.csv")
        self.assert_numbers(lines[5], table["min_film_thickness"])
        self.assert_numbers(lines[6], table["crank_angle"])

    def test_what_cannot_be_read_is_named(self):
        self.run_well("run", "case.toml", "--output", "r.nc")
        lines = self.reported(
            """
r = ringfilm_read('r.nc');
texts = {'input_key', 'resolved_case', 'note_message'};
for k = 1:numel(texts)
  printf('%d\\n', xor(isfield(r, texts{k}), any(strcmp(r.unread, texts{k}))));
end
printf('%d\\n', isfield(r.about, 'input_key'), any(strcmp(r.unread, 'min_film_thickness')));"""
        )
        self.assertEqual(lines, ["1", "1", "1", "1", "0"])

    def test_a_pad(self):
        (self.folder / "gap.csv").write_text("x [mm],h [um]\n0,10\n10,0\n")
        (self.folder / "pad.toml").write_text(SLIDER)
        values = json.loads(self.run_well("run", "pad.toml", "--output", "p.nc", "--json"))
        lines = self.reported(
            """
p = ringfilm_read('p.nc');
printf('%s %s %.17g\\n', p.kind, p.about.load.units, p.load);"""
        )
        self.assertEqual(lines, [f"pad N/m {values['load']:.17g}"])

    def run_study(self):
        done = self.run_program("study", "study.toml", "--output", "s.nc")  # it reports its progress on standard error
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_a_study(self):
        (self.folder / "study.toml").write_text(STUDY)
        self.run_study()
        lines = self.reported(
            """
s = ringfilm_read('s.nc');
printf('%s %d\\n', s.kind, numel(s.mean_power_loss));
printf('%.17g ', s.mean_power_loss); printf('\\n');"""
        )
        self.assertEqual(lines[0], "study 3")
        self.assert_numbers(lines[1], self.columns("s.csv")["mean_power_loss"])

    def test_what_is_not_a_file_of_ours_is_refused(self):
        lines = self.reported(
            """
function reported(file)
  try
    ringfilm_read(file);
  catch reason
    disp(reason.identifier);
  end
end
reported('nothing.nc');
reported('case.toml');
ncid = netcdf_create('foreign.nc', 'CLOBBER'); netcdf_endDef(ncid); netcdf_close(ncid);
reported('foreign.nc');""".replace(
                "function reported", "pkg load netcdf\nfunction reported", 1
            )
        )
        self.assertEqual(lines, ["ringfilm_read:file", "ringfilm_read:file", "ringfilm_read:foreign"])


if __name__ == "__main__":
    unittest.main()
