"""usage: verification_table.py PROGRAM TABLE

Is the table in the manual what `ringfilm verify` prints? Checks, expected numbers, tolerances and verdicts to the
letter; computed numbers to a millionth, as their last digits and errors near rounding are those of one machine."""

import re
import subprocess
import sys

import printed_table

program, path = sys.argv[1:]


def rows(text):
    """A line by its columns: two blanks or more part them."""
    return [re.split(r" {2,}", line.strip()) for line in text.splitlines() if line.strip()]


def same(shown, printed):
    if len(shown) != 6 or len(printed) != 6:
        return shown == printed
    if shown[:2] + shown[4:] != printed[:2] + printed[4:]:
        return False
    (a, *unit), (b, *other_unit) = shown[2].split(), printed[2].split()
    return unit == other_unit and (a == b or abs(float(a) - float(b)) <= max(1e-6 * abs(float(b)), 1e-9))


printed = rows(subprocess.run([program, "verify"], capture_output=True, text=True, check=True).stdout)
with open(path, encoding="utf-8") as table:
    shown = rows(table.read())
printed_table.check(shown, printed, same, "ringfilm verify", "verification-table.txt")
