"""Characters of titles and names that a terminal obeys instead of showing them."""

import unittest

import program


class HiddenCharactersTest(program.ProgramTest):
    def test_characters_that_turn_the_direction_of_writing_do_not_reach_the_terminal(self):
        (self.folder / "case.toml").write_text(program.CASE.replace("a small case", "a \u202ellams case"))
        done = self.run_program("run", "case.toml")
        self.assert_refused(done, "holds the control character U+202E")
        self.assertNotIn("\u202e", done.stderr)
        (self.folder / "case\u2067.toml").write_text(program.CASE)
        printed = self.run_well("check", "case\u2067.toml")
        self.assertIn("case\\u2067.toml: no errors", printed)
        self.assertNotIn("\u2067", printed)


if __name__ == "__main__":
    unittest.main(verbosity=2)
