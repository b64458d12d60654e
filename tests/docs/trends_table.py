"""usage: trends_table.py PROGRAM TABLE

Is the table in the manual what `ringfilm verify --trends` prints, and is each outcome the recorded one? Words to the
letter; numbers, which are shown with three digits, within 2 %: the oil on the liner settles to about 1 %."""

import re
import subprocess
import sys

import printed_table

program, path = sys.argv[1:]
NUMBER = re.compile(r"(?<![\w.-])\d+(?:\.\d+)?(?:e[+-]?\d+)?(?![\w-])")
CHANGE = re.compile(r" \([+-][\d.]+ %\)$")  # follows from the numbers before it


def parts(line):
    line = CHANGE.sub("", line)
    return NUMBER.sub("#", line), [float(number) for number in NUMBER.findall(line)]


def same(shown, printed):
    (words, numbers), (other_words, others) = parts(shown), parts(printed)
    return words == other_words and all(abs(a - b) <= 0.02 * abs(b) for a, b in zip(numbers, others))


done = subprocess.run([program, "verify", "--trends"], capture_output=True, text=True)
printed = done.stdout.splitlines()
with open(path, encoding="utf-8") as table:
    shown = table.read().splitlines()
print(done.stdout[-200:], done.stderr)
printed_table.check(shown, printed, same, "ringfilm verify --trends", "trends-table.txt")
sys.exit(done.returncode)
