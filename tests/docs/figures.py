#!/usr/bin/env python3
"""Holds the stored pictures of the documents to what their generators draw, and to the pages that show them.

usage: figures.py drawn PROJECT PROGRAM     (environment: PYTHONPATH with the module, RINGFILM_DATA)
       figures.py shown PROJECT

`drawn`: schematic pictures must have the same bytes; of computed ones the words must be the same and no place may be
farther than TOLERANCE away, since another compiler or processor rounds differently.
`shown`: each picture is on a page, and each picture of a page has words for readers who do not see it and a caption.
The stored page of each tutorial has all of its cells; script/docs compares what they print, too.
"""
import pathlib
import re
import subprocess
import sys
import tempfile

TOLERANCE = 0.6  # pixels of a picture 760 wide
PICTURE = re.compile(r"^!\[([^\]]*)\]\(([^)\s]+)\)$")
PLACE = re.compile(r"-?\d+(?:\.\d+)?")
WORDS = re.compile(r">([^<>]*)<")


def differs(stored, drawn):
    """Why two pictures differ; empty if they do not."""
    if WORDS.findall(stored) != WORDS.findall(drawn):
        return "other words"
    stored, drawn = (WORDS.sub("><", text) for text in (stored, drawn))
    if PLACE.sub("#", stored) != PLACE.sub("#", drawn):
        return "other elements"
    largest = max((abs(float(a) - float(b)) for a, b in zip(PLACE.findall(stored), PLACE.findall(drawn))), default=0)
    return f"a place is {largest:.1f} pixels away" if largest > TOLERANCE else ""


def drawn_faults(root, program):
    figures = root / "docs" / "figures"
    sys.path.insert(0, str(figures))
    import draw

    with tempfile.TemporaryDirectory() as scratch:
        scratch = pathlib.Path(scratch)
        names = draw.draw(scratch)
        overview = [sys.executable, str(figures / "overview.py"), program, str(scratch / "overview.svg")]
        subprocess.run(overview, check=True)
        for name in [*names, "overview.svg"]:
            path, text = figures / name, (scratch / name).read_text(encoding="utf-8")
            if not path.is_file():
                yield f"docs/figures/{name} is not there"
            elif name.startswith("schematic/"):
                if path.read_text(encoding="utf-8") != text:
                    yield f"docs/figures/{name} is not what its generator draws"
            elif why := differs(path.read_text(encoding="utf-8"), text):
                yield f"docs/figures/{name} is not what the program computes: {why}"
    for path in sorted(figures.glob("*/*.svg")):
        if path.relative_to(figures).as_posix() not in names:
            yield f"docs/figures/{path.relative_to(figures)} has no generator"


def shown_faults(root):
    shown = set()
    pages = [root / "README.md", *sorted((root / "docs").rglob("*.md"))]
    for page in pages:
        lines = page.read_text(encoding="utf-8").split("\n")
        pictures = 0
        for i, line in enumerate(lines):
            match = PICTURE.match(line)
            if not match:
                continue
            pictures += 1
            words, target = match.groups()
            shown.add((page.parent / target).resolve())
            where = f"{page.relative_to(root)}:{i + 1}"
            if len(words.split()) < 4:
                yield f"{where}: the picture has no words for readers who do not see it"
            following = next((text for text in lines[i + 1 :] if text.strip()), "")
            if "/tutorials/" not in str(page) and not re.match(r"^\*[^*].*[.)]\*$", following):
                yield f"{where}: the picture has no caption: a paragraph *in italics* that ends with a full stop"
        if page.parent == root / "docs" / "theory" and not pictures:
            yield f"{page.relative_to(root)} has no picture"
    for path in sorted((root / "docs" / "figures").rglob("*.svg")):
        if path.resolve() not in shown:
            yield f"{path.relative_to(root)} is on no page"


def tutorial_faults(root):
    sys.path.insert(0, str(root / "docs" / "site"))
    from tutorial_cells import cells

    for source in sorted((root / "docs" / "tutorials").glob("*.py")):
        page = source.with_suffix(".md")
        text = page.read_text(encoding="utf-8") if page.is_file() else ""
        for _, body in cells(source.read_text(encoding="utf-8")):
            if body not in text:
                yield f"docs/tutorials/{page.name} lacks what {source.name} has: {body.splitlines()[0]}"
                break
        else:
            if "](figures/" not in text:
                yield f"docs/tutorials/{page.name} has no picture"


def check_itself():
    """The comparison accepts rounding and nothing else."""
    one = '<svg><text x="10">4 N</text><path d="M1 2L3.4 -5"/></svg>'
    assert not differs(one, one.replace("3.4", "3.6"))
    assert differs(one, one.replace("3.4", "4.4"))
    assert differs(one, one.replace("4 N", "5 N"))
    assert differs(one, one.replace("L3.4 -5", ""))


def main():
    check_itself()
    root = pathlib.Path(sys.argv[2]).resolve()
    drawn = sys.argv[1] == "drawn"
    faults = list(drawn_faults(root, sys.argv[3])) if drawn else [*shown_faults(root), *tutorial_faults(root)]
    print("\n".join(faults) or "no fault")
    if faults and drawn:
        print("docs/figures/draw.py writes the pictures anew; look at each that changed")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
