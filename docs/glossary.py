"""Writes the quantities of results into docs/glossary.md as the tables of the program describe them.

usage: PYTHONPATH=$PWD/build-ci/python python3 docs/glossary.py [--check]

Below a line `<!-- quantities: TABLE ... -->` the glossary has a row for each quantity of these tables of
`ringfilm.quantities()`. Word, symbol, unit and meaning are those of the program; remarks and synonyms are written by
hand, in the glossary, and are kept. --check writes nothing; the exit code is 1 if the glossary is not up to date.
"""

import difflib
import pathlib
import re
import sys

import ringfilm

PAGE = pathlib.Path(__file__).resolve().with_name("glossary.md")
HEAD = "| word | symbol | unit | meaning | remarks | also called |\n|---|---|---|---|---|---|\n"
TABLE = re.compile(r"(<!-- quantities: (.*) -->\n)((?:\|.*\n)*)")
BY_HAND = re.compile(r"^\| (`\w+`) \|(?:[^|]*\|){3}(.*)$", re.M)
COMMANDS = set("alpha beta gamma delta Delta eta theta vartheta lambda mu phi varphi psi rho sigma".split())
COMMANDS |= set("bar dot int max min".split())
RAISED = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


def places():
    """{label of an equation: link to it} of the theory."""
    pages = PAGE.parent.glob("theory/*.md")
    labels = {page.name: re.findall(r'<a id="(eq-.*?)">', page.read_text(encoding="utf-8")) for page in pages}
    return {label: f"theory/{page}#{label}" for page, found in labels.items() for label in found}


def formula(symbol):
    """The symbol in LaTeX: names of Greek letters and operators as commands, other words upright."""

    def word(name):
        return f"\\{name}" if name in COMMANDS else name if len(name) == 1 else f"\\mathrm{{{name}}}"

    grouped = re.sub(r"_(\w[\w,]+)", r"_{\1}", symbol.replace("*", "^*"))
    return symbol and "$" + re.sub("[A-Za-z]+", lambda name: word(name.group()), grouped) + "$"


def table(quantities, before, links):
    """Head and rows; what is written by hand comes from the rows before."""
    by_hand = dict(BY_HAND.findall(before))
    text = HEAD
    for quantity in quantities:
        word, meaning = f"`{quantity.name}`", quantity.long_name.replace("degC", "°C")
        if quantity.equation:
            meaning = f"[{meaning}]({links[quantity.equation]})"
        unit = re.sub(r"(?<=[a-z])-?\d", lambda power: power.group().translate(RAISED), quantity.unit)
        cells = (word, formula(quantity.symbol), unit, meaning)
        text += "".join(f"| {cell} " if cell else "| " for cell in cells) + f"|{by_hand.get(word, ' | |')}\n"
    return text


def renewed(text):
    """The glossary with its tables of quantities as they are now."""
    tables, links = ringfilm.quantities(), places()

    def written(match):
        line, names, before = match.groups()
        quantities = {quantity.name: quantity for name in names.split() for quantity in tables.pop(name)}
        return line + table(quantities.values(), before, links)

    text = TABLE.sub(written, text)
    if tables:
        sys.exit(f"{PAGE.name} has no line <!-- quantities: ... --> with {', '.join(tables)}")
    return text


before = PAGE.read_text(encoding="utf-8")
now = renewed(before)
if "--check" not in sys.argv:
    PAGE.write_text(now, encoding="utf-8")
elif now != before:
    sys.stdout.writelines(difflib.unified_diff(before.splitlines(True), now.splitlines(True), n=0))
    sys.exit("the glossary is not up to date: PYTHONPATH=$PWD/build-ci/python python3 docs/glossary.py renews it")
