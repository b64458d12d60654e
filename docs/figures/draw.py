#!/usr/bin/env python3
"""Draws the pictures of the documents: drawings from their description, charts from shipped cases or stored times.

usage: docs/figures/draw.py [--only KIND] [FOLDER]    (environment: PYTHONPATH with the module ringfilm, RINGFILM_DATA)

Writes into folders below FOLDER, without FOLDER next to this file: docs/decisions/0016-pictures-are-stored-as-svg.md.
KIND is the name of one of these folders. "performance" does not require the module: its times are in a file.
"""

import argparse
import importlib
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
MODULES = {  # folder of the pictures: modules that draw them
    "schematic": ("ring_drawings", "other_drawings", "oil_drawings"),
    "cycle": ("cycle_charts",),
    "model": ("model_charts",),
    "film": ("film_charts",),
    "supply": ("supply_charts",),
    "measured": ("measured_charts",),
    "study": ("study_charts",),
    "life": ("life_charts",),
    "performance": ("performance_charts",),
}


def draw(folder, kinds=tuple(MODULES)):
    """Writes the pictures of these kinds; returns their paths below `folder`."""
    sys.path.insert(0, str(HERE))
    written = []
    for kind in kinds:
        (folder / kind).mkdir(parents=True, exist_ok=True)
        for module in MODULES[kind]:
            for name, picture in importlib.import_module(module).PICTURES.items():
                path = folder / kind / f"{name}.svg"
                path.write_text(picture().svg(), encoding="utf-8")
                written.append(path.relative_to(folder).as_posix())
    return written


def main():
    arguments = argparse.ArgumentParser(description="Draws the pictures of the documents.")
    arguments.add_argument("--only", choices=MODULES, metavar="KIND", help="only the pictures of this folder")
    arguments.add_argument("folder", nargs="?", type=pathlib.Path, default=HERE, metavar="FOLDER")
    given = arguments.parse_args()
    for name in draw(given.folder, [given.only] if given.only else tuple(MODULES)):
        if given.only:
            print(f"drawn: {name}")


if __name__ == "__main__":
    main()
