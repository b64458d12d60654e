"""`ringfilm serve --stdio`: a line of JSON for each line of JSON, whatever it holds."""

import json
import shutil
import unittest

import program


class ServeTest(program.ProgramTest):
    def setUp(self):
        super().setUp()
        shutil.copy(program.SOURCES / "cases" / "inverse" / "slider.toml", self.folder)

    def answers(self, *requests):
        lines = "".join((one if isinstance(one, str) else json.dumps(one)) + "\n" for one in requests)
        done = self.run_program("serve", "--stdio", "slider.toml", input=lines)
        self.assertEqual(done.returncode, 0, done.stderr)
        answers = [json.loads(line) for line in done.stdout.splitlines()]
        self.assertEqual(len(answers), len(requests))
        return answers

    def test_values_are_those_of_run(self):
        expected = json.loads(self.run_well("run", "slider.toml", "--set", "pad.speed='3 m/s'", "--json"))
        answer = self.answers({"id": 7, "set": {"pad.speed": "3 m/s"}})[0]
        self.assertEqual(answer["id"], 7)
        self.assertEqual(answer["values"]["load"], expected["load"])

    def test_bad_lines_are_answered_and_do_not_end_it(self):
        answers = self.answers(
            "this is not JSON",
            "[1, 2]",
            {"set": {"pad.sped": "3 m/s"}},
            {"set": {"pad.speed": "3 kg"}},
            {"case": "missing.toml"},
            {"quantities": ["laod"]},
            {"sett": {}},
            {"quantities": ["load"]},
        )
        for answer in answers[:-1]:
            self.assertTrue(answer["errors"][0]["message"], answer)
        self.assertEqual(list(answers[-1]["values"]), ["load"])

    def test_case_as_text_and_curves(self):
        answer = self.answers({"toml": program.CASE, "curves": ["total_friction"], "quantities": ["fmep"]})[0]
        self.assertEqual(len(answer["curves"]["total_friction"]), len(answer["crank_angle"]))
        self.assertGreater(answer["values"]["fmep"], 0)
        self.assertNotIn(".ringfilm-serve", " ".join(self.names()))

    def test_it_has_one_way_to_take_requests(self):
        self.assert_refused(self.run_program("serve", "slider.toml"), "add --stdio")


if __name__ == "__main__":
    unittest.main()
