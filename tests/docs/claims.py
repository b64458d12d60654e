#!/usr/bin/env python3
"""Checks that no page denies what the program computes, and that each job has a page with all its parts.

usage: claims.py FOLDER      the folder of the project

A claim is refused as long as the keys that contradict it are in docs/manual/case-keys.txt. Exit code 1 if a page has
one.
"""
import re
import sys
from pathlib import Path

# (claim, section of the keys that contradict it, key)
CLAIMS = [
    (r"\bthere is no (blow-by|starvation)|no blow-by and no starvation", "gas_path", "model"),
    (r"\bno gas passes the ring|[Gg]as flow past the ring is not modelled", "gas_path", "model"),
    (r"\bno gas blows through it\b|\bthe gas does not pass where\b", "gas_path", "film"),
    (r"\b[Oo]il consumption: no\b|\bno oil consumption is computed\b", "oil_transport", "land_film"),
    (r"\bboth edges always (see|have) a full film\b(?!: oil)", "film", "supply"),
    (r"\bthe model (omits|has no) edges that starve|\bno oil starvation\b", "film", "supply"),
    (r"\bside clearance (is )?not modelled|\bno gas through the gap\b", "ring", "side_clearance"),
    (r"\bno distortion, twist or flutter\b|\brings do not twist\b", "ring", "section"),
    (r"\brings do not exchange oil or gas\b", "gas_path", "model"),
    (r"\bone tension all around\b(?!.*pressure_orders)(?<!else one tension all around)", "ring", "pressure_orders"),
]
# What a page of a job has, and in which order.
PARTS = ("# ", "**Question.**", "**Inputs.**", "```sh", "![", "**How far to trust it.**")


def keys_of(listed):
    """{section: its keys} of case-keys.txt."""
    sections = re.split(r"^\[([\w.]+)\]$", listed, flags=re.M)
    return {name: set(re.findall(r"^  (\w+) ", text, re.M)) for name, text in zip(sections[1::2], sections[2::2])}


def faults(root):
    keys = keys_of((root / "docs/manual/case-keys.txt").read_text(encoding="utf-8"))
    for claim, section, key in CLAIMS:
        if key not in keys.get(section, ()):
            yield f"tests/docs/claims.py: {section}.{key} is not a key, so that nothing contradicts {claim}"
    for page in [root / "README.md", *sorted((root / "docs").rglob("*.md"))]:
        for number, line in enumerate(page.read_text(encoding="utf-8").split("\n"), 1):
            for claim, section, key in CLAIMS:
                if hit := re.search(claim, line, re.I):
                    yield f'{page.relative_to(root)}:{number}: "{hit.group()}" is not so: {section}.{key}'
    gallery = (root / "docs/manual/gallery.md").read_text(encoding="utf-8")
    navigation = (root / "docs/site/navigation.py").read_text(encoding="utf-8")
    jobs = sorted((root / "docs/manual/jobs").glob("*.md"))
    if len(jobs) < 12:
        yield f"docs/manual/jobs has {len(jobs)} pages, not the 12 of the gallery"
    for job in jobs:
        name, text = job.relative_to(root), job.read_text(encoding="utf-8")
        places = [text.find(part) for part in PARTS]
        missing = [part for part, place in zip(PARTS, places) if place < 0]
        if missing:
            yield f"{name} lacks {', '.join(missing)}"
        elif places[-1] != max(places):
            yield f"{name}: how far to trust it comes last"
        if len(text.split()) > 400:
            yield f"{name} has {len(text.split())} words; half a page is at most 400"
        if gallery.count(f"](jobs/{job.name})") != 2:
            yield f"docs/manual/gallery.md lacks a picture and a title that lead to {name}"
        if f'"docs/manual/jobs/{job.stem}"' not in navigation:
            yield f"docs/site/navigation.py lacks {name}"


def check_itself():
    """Each claim of the list is found, and what is true is not."""
    assert re.search(CLAIMS[0][0], "There is no blow-by and no starvation", re.I)
    assert not any(re.search(claim, "Blow-by requires a ring pack", re.I) for claim, _, _ in CLAIMS)


def main():
    check_itself()
    found = list(faults(Path(sys.argv[1]).resolve()))
    print("\n".join(found) or "no claim")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
