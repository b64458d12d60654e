"""Remedies that notes of a result name: carried out as they are named, they remove their note."""

import json
import re
import unittest

import program

PAD = """\
title = "a pad whose lowest place lies between the cells"
[pad]
length = "10 mm"
gap = "gap.csv"
speed = "5 m/s"
left_pressure = "0 bar"
right_pressure = "0 bar"
separation = "0.5 um"
[lubricant]
viscosity = "0.02 Pa s"
density = "850 kg/m3"
[solver]
cells = 12
"""
GAP = "x [mm],h [um]\n0,20\n3.1,0\n10,10\n"
STEEP = {"ring.face.crown_height": '"400 um"'}


class Remedies(program.ProgramTest):
    def setUp(self):
        super().setUp()
        (self.folder / "pad.toml").write_text(PAD)
        (self.folder / "gap.csv").write_text(GAP)

    def notes(self, case, settings):
        words = [word for key, value in settings.items() for word in ("--set", f"{key}={value}")]
        return {n["topic"]: n["message"] for n in json.loads(self.run_well("run", case, "--json", *words))["notes"]}

    def test_a_remedy_that_is_carried_out_removes_its_note(self):
        for topic, case, settings, named, remedy in (
            ("coarse-grid", "case.toml", {"solver.cells": 30}, "take 50 solver.cells", {"solver.cells": 50}),
            ("cells-too-long", "case.toml", STEEP, "take more solver.cells than 60", {"solver.cells": 240}),
            ("contact-beyond-hardness", "case.toml", {}, "state contact.hardness", {"contact.hardness": '"20 GPa"'}),
            ("coarse-grid", "pad.toml", {}, "take more solver.cells", {"solver.cells": 1000}),
            ("gap-finer-than-cells", "pad.toml", {}, "take more solver.cells", {"solver.cells": 1000}),
        ):
            with self.subTest(f"{topic} of {case}"):
                self.assertIn(named, self.notes(case, settings)[topic])
                self.assertNotIn(topic, self.notes(case, {**settings, **remedy}))

    def test_every_key_that_a_note_names_is_one_of_a_case(self):
        keys = set()
        for line in self.run_well("fields").splitlines():
            section = re.match(r"\[+([a-z_.]+)\]+", line)
            if section:
                prefix = section.group(1)
                keys.add(prefix)
            elif re.match(r"  [a-z]", line) and "prefix" in locals():
                keys.add(f"{prefix}.{line.split()[0]}")
        self.assertIn("solver.cells", keys)
        sections = "|".join(sorted({key.split(".")[0] for key in keys}))
        packs = program.SOURCES / "cases" / "ring-pack"
        for case in ("case.toml", "pad.toml", str(packs / "three_rings.toml")):
            result = json.loads(self.run_well("run", case, "--json"))
            for of_ring in result.get("rings", [result]):
                for note in of_ring["notes"]:
                    for key in re.findall(rf"\b((?:{sections})\.[a-z_]+(?:\.[a-z_]+)*)", note["message"]):
                        self.assertIn(key, keys, note)


if __name__ == "__main__":
    unittest.main(verbosity=2)
