#!/usr/bin/env python3
"""Checks the syntax of the bibliography: every entry is closed, has the fields of its type, and a key of its own.

usage: bibliography.py FILE      docs/references.bib

Prints each fault as file:line; exit code 1 if there is one.
"""
import re
import sys

REQUIRED = {
    "article": ("author", "title", "journal", "year"),
    "book": ("author", "title", "publisher", "year"),
    "incollection": ("author", "title", "booktitle", "publisher", "year"),
    "inproceedings": ("author", "title", "booktitle", "year"),
    "mastersthesis": ("author", "title", "school", "year"),
    "phdthesis": ("author", "title", "school", "year"),
    "techreport": ("author", "title", "institution", "year"),
    "misc": ("author", "title"),
}
HEAD = re.compile(r"@(\w+)\{(\w+),\n")
FIELD = re.compile(r" +(\w+) *= *\{")


def end_of_braces(text, start):
    """Place behind the brace that closes the one before `start`; None where none does."""
    depth = 1
    for place in range(start, len(text)):
        depth += {"{": 1, "}": -1}.get(text[place], 0)
        if depth == 0:
            return place + 1
    return None


def fields(text, place):
    """(fields of the entry that begins at `place`, its end, fault)."""
    found = {}
    while not text.startswith("}", place):
        head = FIELD.match(text, place)
        if not head:
            return found, place, "expected a field, NAME = {...}, or the brace that closes the entry"
        name, end = head.group(1).lower(), end_of_braces(text, head.end())
        if end is None or "\n" in text[head.end() : end]:
            return found, place, f"the braces of {name} do not close on its line"
        if name in found:
            return found, place, f"{name} is given twice"
        found[name] = text[head.end() : end - 1]
        rest = re.compile(r",?\n").match(text, end)
        if not rest:
            return found, place, f"expected a comma and a new line behind {name}"
        if rest.group() == "\n" and not text.startswith("}", rest.end()):
            return found, place, f"{name} is the last field, as it ends without a comma: the closing brace is missing"
        place = rest.end()
    return found, place + 1, None


def faults(text):
    """(line, fault) for each fault of a bibliography."""
    keys, place = set(), 0
    while place < len(text):
        blank = re.compile(r"(%[^\n]*)?\n").match(text, place)
        if blank:
            place = blank.end()
            continue
        line = text.count("\n", 0, place) + 1
        head = HEAD.match(text, place)
        if not head or head.group(1) not in REQUIRED:
            yield line, "expected an entry, @TYPE{KEY, with a type of " + ", ".join(sorted(REQUIRED))
            return
        found, place, fault = fields(text, head.end())
        if fault:
            yield text.count("\n", 0, place) + 1, f"{head.group(2)}: {fault}"
            return
        for name in REQUIRED[head.group(1)]:
            if not found.get(name):
                yield line, f"{head.group(2)}: {name} is missing"
        if head.group(2) in keys:
            yield line, f"{head.group(2)} is a key twice"
        keys.add(head.group(2))


def check_itself():
    """The faults that a bibliography can have are found."""
    whole = "% a comment\n\n@book{a1,\n  author = {A {B}},\n  title = {T},\n  publisher = {P},\n  year = {2003}\n}\n"
    for text, hits in (
        (whole, 0),
        (whole.replace("}\n}\n", "}\n\n") + whole.replace("a1", "b1"), 1),  # the brace that closes the entry
        (whole.replace("{A {B}}", "{A {B}"), 1),
        (whole.replace("{T},", "{T}"), 1),
        (whole.replace("  year = {2003}\n", ""), 1),
        (whole + whole, 1),
        (whole.replace("@book", "@boook"), 1),
    ):
        assert len(list(faults(text))) == hits, (text, list(faults(text)))


def main():
    check_itself()
    with open(sys.argv[1], encoding="utf-8") as file:
        found = list(faults(file.read()))
    for line, fault in found:
        print(f"{sys.argv[1]}:{line}: {fault}")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
